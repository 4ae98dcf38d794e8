#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "geometry/error.h"
#include "hsr/check/order_check.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/line_arguments.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/outputs.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/progress.h"
#include "hsr/cli/report.h"
#include "hsr/cli/view_options.h"
#include "hsr/drawing/painting.h"
#include "hsr/drawing/shading.h"
#include "hsr/io/read/read.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/image_png.h"
#include "hsr/io/write/order_json.h"
#include "hsr/io/write/painting_svg.h"
#include "hsr/io/write/png.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/painted_order.h"
#include "hsr/raster/supersampling.h"

namespace hsr::cli {

namespace {

struct OrderArguments {
  std::string model;
  std::vector<std::string> outputs;
  ViewOptions view;
  PageArguments page;
  std::string method = "depth-sort", cuts = "few";
  std::string edges = "outline,sharp,boundary,intersection,wire", report;
  double crease = 30, opacity = 1;
  std::uint64_t seed = 1;
  bool exact = false, check = false, quiet = false;
  std::optional<int> threads;
};

const char* const examples = R"(Examples:
  hsr order part.stl -o part.json                      the faces from far to near, cut only where no order is right
  hsr order part.stl -o part.svg --opacity 0.5         painted in that order; every layer is right
  hsr order part.stl -o part.png --size 1600x1200
  hsr order scene.obj -o scene.json --method naive     by the middle of each face, as most software does; may be wrong
  hsr order scene.obj -o scene.svg --check             and compared with the nearest face at each of 1024 x 1024 samples)";

void describe(Report& report, const DepthSort& sorted, const Mesh& mesh, const View& view) {
  const DepthSortCounts& c = sorted.counts;
  report["clusters"] = c.clusters;
  report["tests"] = {{"candidates", c.candidates},   {"apart", c.apart},       {"by_depth", c.by_depth},
                     {"by_plane", c.by_plane},       {"coplanar", c.coplanar}, {"by_overlap", c.by_overlap},
                     {"overlapping", c.overlapping}, {"piercing", c.piercing}};
  report["cuts"] = {{"at_intersections", c.cuts_at_intersections}, {"in_cycles", c.cuts_in_cycles}};
  report["cyclic_components"] = c.cyclic_components;
  report["largest_component"] = c.largest_component;
  Report::Json cycles = Report::Json::array();
  for (const PaintersCycle& cycle : sorted.cycles) {
    Report::Json faces = Report::Json::array();
    for (const TriangleId t : cycle.facets) faces.push_back(mesh.face_of[t].value);
    Report::Json points = Report::Json::array();
    for (const auto& w : witnesses(mesh, view, cycle)) points.push_back({w[0].to_double(), w[1].to_double(), w[2].to_double()});
    cycles.push_back({{"faces", std::move(faces)}, {"witnesses", std::move(points)}});
  }
  report["cycles"] = std::move(cycles);
  if (c.clusters > 1)
    report.leave_out("relations across clusters",
                     fmt::format("planes that no face crosses part the scene into {} clusters", c.clusters));
  if (c.piercing == 0) report.leave_out("cuts at intersections", "no two faces pierce each other");
  if (c.cyclic_components == 0) report.leave_out("cuts in cycles", "the overlaps have no cycle");
}

/// The pieces painted one over the other, with 4 x 4 samples to a pixel.
std::string painted_png(const ChosenView& chosen, const Mesh& mesh, const PaintersOrder& order,
                        const std::vector<Colour>& colours, double opacity, const DrawingOptions& options,
                        const PixelSize& size) {
  constexpr int samples = 4;
  const SampleGrid grid = samples_for(chosen.view, mesh, options, samples * size.width, samples * size.height);
  return image_png(box_filtered(paint(mesh, chosen.view, order, grid, colours, opacity), samples));
}

void run(const OrderArguments& a, UnfinishedFiles& unfinished) {
  // Everything that can be refused is refused before the long work.
  std::vector<Format> formats;
  for (const std::string& path : a.outputs)
    formats.push_back(format_of(path, std::array{Format::json, Format::svg, Format::png}));
  std::vector<std::string> files = a.outputs;
  files.push_back(a.report);
  check_outputs(a.model, files);
  if (!(a.opacity > 0 && a.opacity <= 1))
    throw InputError(fmt::format("--opacity: found {}, expected more than 0 and at most 1", a.opacity));
  LineArguments lines;
  lines.edges = a.edges;
  lines.crease = a.crease;
  const LineOptions line_options = lines.options();
  DrawingOptions drawing_options = a.page.options();
  const PixelSize size = a.page.size.empty() ? PixelSize{1024, 1024} : parse_size(a.page.size);
  if (a.threads && *a.threads < 1) throw InputError("--threads: found " + std::to_string(*a.threads) + ", expected 1 or more");
  std::optional<tbb::global_control> threads;
  if (a.threads) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(*a.threads));

  Report report;
  ProgressLine progress(a.quiet);
  progress.stage("reading");
  const Model model = report.timed("read", [&] { return read_model(a.model); });
  progress.stage("faces");
  const Mesh mesh = report.timed("mesh", [&] { return make_mesh(model.points, model.polygons); });
  const ChosenView chosen = choose_view(a.view, mesh);
  drawing_options.field_of_view = chosen.field_of_view;
  progress.clear();
  if (!a.quiet) {
    for (const std::string& note : model.notes) tell("hsr: note: {}\n", note);
    if (!chosen.note.empty()) tell("hsr: note: {}\n", chosen.note);
  }

  progress.stage("order");
  PaintersOrder order;
  report["method"] = a.method;
  if (a.method == "depth-sort") {
    DepthSortOptions options;
    options.classic = a.cuts == "classic";
    DepthSort sorted = report.timed("order", [&] { return depth_sort(mesh, chosen.view, options); });
    if (!a.report.empty()) describe(report, sorted, mesh, chosen.view);
    order = std::move(sorted.order);
  } else if (a.method == "bsp") {
    BspOptions options;
    options.seed = a.seed;
    const BspTree tree = report.timed("build", [&] { return BspTree(mesh, options); });
    order = report.timed("order", [&] { return tree.order(chosen.view); });
    report["tree"] = {{"nodes", tree.nodes()},
                      {"depth", tree.depth()},
                      {"pieces", tree.pieces()},
                      {"splits", tree.splits()},
                      {"seed", a.seed}};
    order.decisions += tree.decisions();
  } else {
    const DepthKey key = a.method == "naive" ? DepthKey::centroid : DepthKey::farthest_vertex;
    order = report.timed("order", [&] { return z_sort(mesh, chosen.view, key); });
  }
  report["faces"] = mesh.faces.size();
  report["pieces"] = order.pieces.size();
  report.set_decisions(order.decisions);

  bool is_right = true;
  if (a.check) {
    progress.stage("check");
    const SampleGrid samples = samples_for(chosen.view, mesh, drawing_options, size.width, size.height);
    const OrderCheck check =
        report.timed("check", [&] { return on_samples([&] { return check_order(mesh, chosen.view, order, samples); }); });
    report["check"] = {{"samples", check.samples}, {"covered", check.covered}, {"wrong", check.wrong}};
    is_right = check.wrong == 0;
    progress.clear();
    if (!is_right)
      tell("hsr: check: the painting shows another face than the nearest at {} of {} samples, first at column {}, row {}\n",
           check.wrong, check.samples, check.first_wrong[0], check.first_wrong[1]);
    else if (!a.quiet)
      tell("hsr: check: the painting shows the nearest face at each of {} samples, {} of them on the model\n", check.samples,
           check.covered);
  }

  progress.stage("writing");
  OutputFiles output(unfinished);
  report.timed("write", [&] {
    const std::vector<Colour> colours = face_colours(model, mesh, chosen.view);
    for (std::size_t i = 0; i < a.outputs.size(); ++i) {
      std::string bytes;
      if (formats[i] == Format::json) {
        bytes = order_json(mesh, chosen.view, order, a.exact ? Numbers::exact : Numbers::rounded);
      } else if (formats[i] == Format::svg) {
        const Painting painting = paint_on_page(mesh, chosen.view, order, colours, line_options, drawing_options);
        bytes =
            painting_svg(painting, a.opacity, {std::filesystem::path(model.name).filename().string(), "view: " + chosen.title});
      } else {
        bytes = on_samples([&] { return painted_png(chosen, mesh, order, colours, a.opacity, drawing_options, size); });
      }
      output.write(a.outputs[i], bytes);
    }
  });
  if (!a.report.empty()) output.write(a.report, report.text());
  output.commit();
  if (!is_right) throw CheckFailed();
}

}  // namespace

void add_order(CLI::App& app, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<OrderArguments>();
  CLI::App* sub = app.add_subcommand("order", "Painter's order: the faces from far to near, as SVG, PNG or JSON");
  sub->footer(examples);
  sub->add_option("MODEL", a->model, "OBJ, OFF, PLY, STL (each also .gz), glTF or GLB")->required();
  sub->add_option("-o,--output", a->outputs, "The order; its ending chooses svg, png or json; may be repeated")
      ->required()
      ->type_name("FILE");
  const std::string order = "Order";
  sub->add_option("--method", a->method,
                  "depth-sort (exact; cuts faces only where no order of whole ones is right), bsp (exact; a tree that orders "
                  "any view), or what most software does and may be "
                  "wrong: z-sort (by the farthest vertex), naive (by the middle)")
      ->capture_default_str()
      ->type_name("NAME")
      ->check(CLI::IsMember({"depth-sort", "bsp", "z-sort", "naive"}))
      ->group(order);
  sub->add_option("--cuts", a->cuts,
                  "few, or classic: cut every pair that no plane of the two separates, as the paper of 1972 does")
      ->capture_default_str()
      ->type_name("WHICH")
      ->check(CLI::IsMember({"few", "classic"}))
      ->group(order);
  sub->add_option("--seed", a->seed, "bsp: of the planes that are tried")->capture_default_str()->type_name("N")->group(order);
  sub->add_flag("--check", a->check,
                "Compare the painting with the nearest face at each sample of --size [1024x1024]; exit status 1 if they differ")
      ->group(order);
  a->view.add_to(*sub);
  const std::string surfaces = "Picture";
  sub->add_option("--opacity", a->opacity, "Of every face, times its own in the file; more than 0, at most 1")
      ->capture_default_str()
      ->type_name("A")
      ->group(surfaces);
  sub->add_option("--edges", a->edges, "SVG: classes of edges to draw on the faces: outline,sharp,boundary,wire,smooth, all")
      ->capture_default_str()
      ->type_name("LIST")
      ->group(surfaces);
  sub->add_option("--crease", a->crease, "An edge is sharp if its faces deviate from flat by more than this")
      ->capture_default_str()
      ->type_name("DEG")
      ->group(surfaces);
  a->page.add_to(*sub);
  const std::string numbers = "Numbers";
  sub->add_flag("--exact", a->exact, "JSON: all coordinates as strings \"p/q\"; those that are no doubles always are")
      ->group(numbers);
  sub->add_option("--threads", a->threads, "At most this many threads [all]; the result is the same")
      ->type_name("N")
      ->group(numbers);
  const std::string reporting = "Report";
  sub->add_option("--report", a->report, "Times, tests, cuts and cycles as JSON; - for the standard output")
      ->type_name("FILE")
      ->group(reporting);
  sub->add_flag("-q,--quiet", a->quiet, "No notes, no progress")->group(reporting);
  sub->callback([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
