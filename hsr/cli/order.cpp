#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>

#include "geometry/error.h"
#include "hsr/check/sample_checks.h"
#include "hsr/cli/coincident_note.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/format_arguments.h"
#include "hsr/cli/line_arguments.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/page_writing.h"
#include "hsr/cli/scale_text.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/drawing/painting.h"
#include "hsr/drawing/shading.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/json.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct OrderArguments {
  ModelArguments models;
  std::vector<std::string> outputs;
  ViewOptions view;
  SceneArguments scene;
  PageArguments page;
  std::string method = "depth-sort", cuts = "few";
  std::string edges = "outline,sharp,boundary,intersection,wire,material,section,hatching";
  std::string crease = "30", shade = "slope";
  double opacity = 1;
  std::uint64_t seed = 1;
  FormatArguments formats;
  bool check = false;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr order part.stl -o part.json                      the faces from far to near, cut only where no order is right
  hsr order part.stl -o part.svg --opacity 0.5         painted in that order; every layer is right
  hsr order part.stl -o part.png --size 1600x1200          .pdf, .eps and .tex as well
  hsr order scene.obj -o scene.json --method naive     by the middle of each face, as most software does; may be wrong
  hsr order scene.obj -o scene.svg --check             and compared with the nearest face at each of 1024 x 1024 samples

Writes each FILE, all of them or none: .json has the pieces from far to near, wires among them, which 'hsr verify' reads; .svg, .pdf,
.eps, .tex (TikZ) and .png are painted in that order, with the lines on top; where something is seen through, or the order may be wrong,
with the lines of each piece and the wires in their places, which later pieces cover. Standard error tells what was written, and the scale of a page. Exit status 1: --check found a difference.)";

/// Each cycle of faces, and a point of each overlap in it.
Report::Json json_of(const std::vector<PaintersCycle>& cycles, const Mesh& mesh, const View& view) {
  Report::Json list = Report::Json::array();
  for (const PaintersCycle& cycle : cycles) {
    Report::Json faces = Report::Json::array(), points = Report::Json::array();
    for (const FacetId facet : cycle.facets) faces.push_back(mesh.face_of[first_triangle(facet)].value);
    for (const auto& w : witnesses(mesh, view, cycle))
      points.push_back(Report::Json::array({w[0].to_double(), w[1].to_double(), w[2].to_double()}));
    list.push_back({{"faces", std::move(faces)}, {"witnesses", std::move(points)}});
  }
  return list;
}

void describe(Report& report, const DepthSort& sorted, const Mesh& mesh, const View& view) {
  const DepthSortCounts& c = sorted.counts;
  report.set("clusters", c.clusters);
  report.set("tests", {{"candidates", c.candidates},
                       {"apart", c.apart},
                       {"by_depth", c.by_depth},
                       {"by_plane", c.by_plane},
                       {"coplanar", c.coplanar},
                       {"by_overlap", c.by_overlap},
                       {"overlapping", c.overlapping},
                       {"piercing", c.piercing}});
  report.set("cuts", {{"at_intersections", c.cuts_at_intersections}, {"in_cycles", c.cuts_in_cycles}});
  report.set("cyclic_components", c.cyclic_components);
  report.set("largest_component", c.largest_component);
  report.set("cycles", json_of(sorted.cycles, mesh, view));
  if (c.clusters > 1)
    report.leave_out("relations across clusters",
                     fmt::format("planes that no face crosses part the scene into {} clusters", c.clusters));
  if (c.piercing == 0) report.leave_out("cuts at intersections", "no two faces pierce each other");
  if (c.cyclic_components == 0) report.leave_out("cuts in cycles", "the overlaps have no cycle");
}

/// The arguments, each found to be one that can be done.
struct OrderRequest {
  std::vector<Output> outputs;
  LineOptions lines;
  DrawingOptions drawing;
  PaintingOptions painting;
  std::optional<PixelSize> size;
};

OrderRequest parse(const OrderArguments& a) {
  OrderRequest request;
  a.models.check();
  request.outputs =
      parse_outputs(a.outputs, std::array{Format::svg, Format::pdf, Format::eps, Format::tex, Format::png, Format::json});
  if (!(a.opacity > 0 && a.opacity <= 1))
    throw InputError(fmt::format("--opacity: found {}, expected more than 0 and at most 1", a.opacity));
  LineArguments lines;
  lines.edges = a.edges;
  lines.crease = a.crease;
  request.lines = lines.options();
  request.drawing = a.page.options();
  request.drawing.leave_out_near = true;
  request.painting.opacity = a.opacity;
  check_id_prefix(a.formats.id_prefix);
  request.painting.paints_lines_with_pieces = a.method == "naive" || a.method == "z-sort";
  if (!a.page.size.empty()) request.size = parse_size(a.page.size);
  return request;
}

/// From the model to the files, one step after the other; each keeps what the later ones need.
class OrderCommand {
 public:
  OrderCommand(const OrderArguments& a, UnfinishedFiles& unfinished)
      : a_(a), request_(parse(a)), context_(a.common, a.models.models, paths_of(request_.outputs), unfinished) {}

  void run() {
    scene_ = context_.read(a_.models, a_.view, 0, a_.page.unit, a_.page.options());
    context_.report.set("view", cli::json_of(scene_.view()));
    prepared_ = scene_.prepared({.coplanar = a_.scene.which_coplanar()});
    request_.drawing.labels = &prepared_->labels();
    request_.drawing.field_of_view = scene_.chosen.field_of_view;
    objects_ = objects_of(scene_.model, scene_.mesh);
    request_.drawing.objects = &objects_;
    context_.say_notes_of(scene_);
    if (const std::string note = a_.page.adopt_unit(scene_.model, request_.drawing); !note.empty()) context_.note(note);
    context_.find_section(scene_, *prepared_, request_.lines.classes, request_.drawing, section_);
    find_order();
    note_coincident_faces();
    check();
    write();
    if (!is_right_) throw CheckFailed();
  }

 private:
  void find_order();
  PaintersOrder depth_sorted();
  PaintersOrder by_tree();
  bool is_opaque() const;
  void note_coincident_faces();
  void check();
  void write();
  std::string bytes_of(Format format);
  const Drawing& drawing();

  const OrderArguments& a_;
  OrderRequest request_;
  std::optional<Section> section_;
  CommandContext context_;
  ViewedModel scene_;
  SceneObjects objects_;
  std::optional<SceneView> prepared_;
  PaintersOrder order_;
  std::optional<Drawing> drawing_;  // made when a page is asked for
  bool is_right_ = true;
};

void OrderCommand::find_order() {
  Report& report = context_.report;
  context_.progress.stage("order");
  report.set("method", a_.method);
  if (a_.method == "depth-sort") {
    order_ = depth_sorted();
  } else if (a_.method == "bsp") {
    order_ = by_tree();
  } else {
    const DepthKey key = a_.method == "naive" ? DepthKey::centroid : DepthKey::farthest_vertex;
    order_ = report.timed("order", [&] { return z_sort(*prepared_, key); });
  }
  report.set("faces", scene_.mesh.faces.size());
  report.set("pieces", order_.pieces.size());
  report.set("wires", order_.wires.size());
  report.set_decisions(order_.decisions);
}

PaintersOrder OrderCommand::depth_sorted() {
  DepthSortOptions options;
  options.classic = a_.cuts == "classic";
  DepthSort sorted = context_.report.timed("order", [&] { return depth_sort(*prepared_, options); });
  if (context_.reports()) describe(context_.report, sorted, scene_.mesh, scene_.view());
  return std::move(sorted.order);
}

PaintersOrder OrderCommand::by_tree() {
  BspOptions options;
  options.seed = a_.seed;
  const BspTree tree = context_.report.timed("build", [&] { return BspTree(scene_.mesh, options); });
  PaintersOrder order = context_.report.timed("order", [&] { return tree.order(*prepared_); });
  context_.report.set("tree", {{"nodes", tree.nodes()},
                               {"depth", tree.depth()},
                               {"pieces", tree.pieces()},
                               {"splits", tree.splits()},
                               {"seed", a_.seed}});
  order.decisions += tree.decisions();
  return order;
}

bool OrderCommand::is_opaque() const {
  const std::vector<Colour>& colours = scene_.model.palette;
  return a_.opacity == 1 && std::all_of(colours.begin(), colours.end(), [](const Colour& c) { return c[3] == 255; });
}

/// Which of them is painted later was the user's to say. Through transparent faces those behind are seen, too.
void OrderCommand::note_coincident_faces() {
  if (a_.scene.asks_for_coplanar() || context_.is_quiet()) return;
  const std::string text = context_.report.timed("coincident faces", [&] {
    return coincident_note(*prepared_, scene_.model, is_opaque() ? Coincidence::seen : Coincidence::all);
  });
  if (!text.empty()) context_.note(text);
}

void OrderCommand::check() {
  if (!a_.check) return;
  context_.progress.stage("check");
  const PixelSize size = request_.size.value_or(PixelSize{1024, 1024});
  const SampleGrid samples = samples_for(scene_.view(), scene_.mesh, request_.drawing, size.width, size.height);
  const OrderCheck check =
      context_.report.timed("check", [&] { return on_samples([&] { return check_order(*prepared_, order_, samples); }); });
  context_.report.set("check", {{"samples", check.samples}, {"covered", check.covered}, {"wrong", check.wrong}});
  is_right_ = check.wrong == 0;
  context_.progress.clear();
  if (!is_right_)
    tell("hsr: check: the painting shows another face than the nearest at {} of {} samples, first at column {}, row {}\n",
         check.wrong, check.samples, check.first_wrong[0], check.first_wrong[1]);
  else if (!context_.is_quiet())
    tell("hsr: check: the painting shows the nearest face at each of {} samples, {} of them on the model\n", check.samples,
         check.covered);
}

const Drawing& OrderCommand::drawing() {
  const Shading shading = a_.shade == "none" ? Shading::none : Shading::slope;
  if (!drawing_)
    drawing_ = paint_on_page(*prepared_, order_, face_colours(scene_.model, scene_.mesh, scene_.view(), shading),
                             request_.lines, request_.drawing, request_.painting);
  return *drawing_;
}

std::string OrderCommand::bytes_of(Format format) {
  if (format == Format::json)
    return order_json(scene_.mesh, scene_.view(), order_, a_.formats.exact ? Numbers::exact : Numbers::rounded,
                      a_.scene.which_coplanar(), request_.drawing.section);
  SvgOptions captions = scene_.captions();
  captions.id_prefix = a_.formats.id_prefix;
  return written(drawing(), name_of(format),
                 page_options(format, captions, scale_in_title(drawing(), request_.drawing, a_.page), request_.size));
}

void OrderCommand::write() {
  context_.progress.stage("writing");
  context_.report.timed("write", [&] {
    for (const Output& output : request_.outputs) {
      const std::string bytes = bytes_of(output.format);
      std::string pieces = counted(order_.pieces.size(), "piece");
      if (!order_.wires.empty()) pieces += ", " + counted(order_.wires.size(), "part") + " of wires";
      std::string summary = output.format == Format::json ? pieces : pixel_size(bytes);
      if (output.format != Format::json && output.format != Format::png) {
        summary = paper_size(drawing().width, drawing().height);
        if (!order_.pieces.empty())
          summary += ", " + scale_text(drawing().scale, request_.drawing.unit, a_.page, scene_.view().is_perspective());
        summary += ", " + pieces;
      }
      context_.write(output.path, bytes, summary);
    }
  });
  context_.finish();
}

void add_order_options(OrderArguments& a, Options& options) {
  options.begin_group("Order");
  options
      .add("--method", a.method, "NAME",
           "depth-sort (exact; cuts faces only where no order of whole ones is right), bsp (exact; a tree that orders "
           "any view), or what most software does and may be "
           "wrong: z-sort (by the farthest vertex), naive (by the middle)")
      .with_default_shown()
      .one_of({"depth-sort", "bsp", "z-sort", "naive"});
  options
      .add("--cuts", a.cuts, "WHICH",
           "few, or classic: cut every pair that no plane of the two separates, as the paper of 1972 does")
      .with_default_shown()
      .one_of({"few", "classic"});
  options.add("--seed", a.seed, "N", "bsp: of the planes that are tried").with_default_shown();
  options.add_flag("--check", a.check,
                   "Compare the painting with the nearest face at each sample of --size [1024x1024]; exit status 1 if they "
                   "differ");
}

void add_picture_options(OrderArguments& a, Options& options) {
  options.begin_group("Picture");
  options.add("--opacity", a.opacity, "A", "Of every face, times its own in the file; more than 0, at most 1")
      .with_default_shown();
  options.add("--shade", a.shade, "HOW", "Faces are darker by their slope, or not: slope or none")
      .with_default_shown()
      .one_of({"slope", "none"});
  options
      .add("--edges", a.edges, "LIST",
           "Classes of edges to draw on the faces, or all: outline,sharp,boundary,wire,material,smooth,joint,section,hatching")
      .with_default_shown()
      .list_of(classes_to_choose());
  options.add("--crease", a.crease, "DEG", "An edge is sharp if its faces deviate from flat by more than this")
      .with_default_shown();
}

}  // namespace

void add_order(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<OrderArguments>();
  Options options =
      command.add_verb("order", "Painter's order: the faces from far to near, as SVG, PDF, EPS, TikZ, PNG or JSON", examples);
  a->models.add_to(options);
  options
      .add_one_each("-o,--output", a->outputs, "FILE",
                    "The order; its ending chooses svg, pdf, eps, tex, png or json; svg:- and the like write to standard "
                    "output; may be repeated")
      .required();
  a->models.add_objects_without_ghosts_to(options);
  add_order_options(*a, options);
  a->view.add_to(options);
  a->scene.add_to(options);
  add_picture_options(*a, options);
  a->page.add_to(options, "PNG: pixels [150 to the inch]; --check: samples [1024x1024]");
  a->page.add_pens_to(options);
  a->page.add_fit_arcs_to(options);
  a->formats.add_id_prefix_to(options);
  a->formats.add_exact_to(options, "JSON: all coordinates as strings \"p/q\"; those that are no doubles always are");
  a->common.add_threads_to(options);
  options.begin_group("Report");
  a->common.add_report_to(options, "Times, tests, cuts and cycles");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { OrderCommand(*a, unfinished).run(); });
}

}  // namespace hsr::cli
