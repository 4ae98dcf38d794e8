#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/line_arguments.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/drawing/drawing.h"
#include "hsr/io/write/mesh_json.h"
#include "hsr/lines/plan.h"
#include "hsr/scene/scene_facts.h"

namespace hsr::cli {

using namespace internal;

namespace {

struct InfoArguments {
  ModelArguments models;
  std::string mesh;
  ViewOptions view;
  SceneArguments scene;
  LineArguments lines;
  bool exact = false;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr info part.stl                          what the model is, its defects, what its drawing takes
  hsr info part.stl --edges all --view top   what a drawing of all edges from above can leave out
  hsr info house.obj --mesh mesh.json        the faces as used: merged, dropped, cut into triangles
  hsr info part.stl --report facts.json      the same facts as JSON

Writes the facts to standard output, and the faces or a report to files if asked. Exit status 0 for a model with defects, too.)";

std::size_t used(const SceneFacts& f, FaceUse use) { return f.used_as[static_cast<std::size_t>(use)]; }

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole) * 100;
}

const char* yes_no(bool yes) { return yes ? "yes" : "no"; }

/// What a draughtsman would want to know before trusting the model, one line each.
std::vector<std::string> defects(const Model& model, const SceneFacts& f) {
  std::vector<std::string> list;
  const auto add = [&](std::size_t n, const char* one, const char* many) {
    if (n > 0) list.push_back(fmt::format("{} {}", n, n == 1 ? one : many));
  };
  add(used(f, FaceUse::no_area), "face without area, dropped", "faces without area, dropped");
  add(used(f, FaceUse::not_coplanar), "face not planar, cut into triangles", "faces not planar, cut into triangles");
  add(used(f, FaceUse::crosses_itself), "face crosses itself, cut into triangles",
      "faces cross themselves, cut into triangles");
  add(f.duplicate_faces, "face repeats an earlier one", "faces repeat earlier ones");
  add(f.boundary_edges, "edge with one face (a boundary)", "edges with one face (boundaries)");
  add(f.non_manifold_edges, "edge with three or more faces", "edges with three or more faces");
  add(f.flipped_edges, "edge whose two faces disagree in orientation", "edges whose two faces disagree in orientation");
  add(f.pinched_vertices, "vertex where fans of faces only touch", "vertices where fans of faces only touch");
  add(f.distinct_points - f.used_points, "point that nothing uses", "points that nothing uses");
  for (const std::string& note : model.notes) list.push_back(note);
  return list;
}

std::string hexadecimal(const Colour& c) {
  std::string text = fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
  if (c[3] != 255) text += fmt::format(" ({} % opaque)", std::lround(c[3] / 2.55));
  return text;
}

/// How many there are, and what the first ones are.
template <class Things, class Word>
std::string listed(const Things& things, const Word& word) {
  constexpr std::size_t most = 8;
  std::string text = std::to_string(things.size()) + ": ";
  for (std::size_t i = 0; i < std::min(most, things.size()); ++i) text += (i == 0 ? "" : ", ") + word(things[i]);
  return things.size() > most ? text + ", ..." : text;
}

void print(const Model& model, const SceneFacts& f) {
  fmt::print("{}: {}\n", model.name, model.format);
  fmt::print("  points      {} ({} distinct, {} used)\n", f.points, f.distinct_points, f.used_points);
  fmt::print("  faces       {} ({} triangles, {} quads, {} larger); as used {} in {} triangles\n", f.faces, f.triangular,
             f.quadrangular, f.larger, f.faces_used(), f.triangles);
  if (f.wires > 0) fmt::print("  wires       {}\n", f.wires);
  if (!model.objects.empty()) fmt::print("  objects     {}\n", model.objects.size());
  if (!model.materials.empty()) fmt::print("  materials   {}\n", model.materials.size());
  if (!model.palette.empty()) fmt::print("  colours     {}\n", listed(model.palette, hexadecimal));
  if (!model.cameras.empty())
    fmt::print("  cameras     {}\n", listed(model.cameras, [](const StoredCamera& c) { return c.name; }));
  if (model.up_axis) fmt::print("  up axis     {}, by the format\n", *model.up_axis);
  if (model.unit) fmt::print("  unit        {:g} mm, by the file or its format\n", *model.unit);
  fmt::print("  edges       {} with two faces, {} with one, {} with more\n", f.regular_edges, f.boundary_edges,
             f.non_manifold_edges);
  fmt::print("  closed      {}\n  manifold    {}\n  oriented    {}\n", yes_no(f.is_closed()), yes_no(f.is_manifold()),
             yes_no(f.is_consistently_oriented()));
  fmt::print("  components  {}\n", f.components);
  fmt::print("  coplanar    {:.1f} % of the edges with two faces lie in one plane with both\n",
             share(f.coplanar_edges, f.regular_edges));
  fmt::print("  axis        {:.1f} % of the faces are parallel to a coordinate plane\n",
             share(f.axis_parallel_faces, f.faces_used()));
  fmt::print("  box         {} {} {} to {} {} {}\n", f.lowest.x, f.lowest.y, f.lowest.z, f.highest.x, f.highest.y, f.highest.z);
  const int bits = f.coordinates.bits();
  const char* arithmetic = bits <= 18    ? "128-bit integers decide what doubles leave open"
                           : bits <= 122 ? "fixed-width integers decide what doubles and intervals leave open"
                                         : "big floats decide what doubles and intervals leave open";
  fmt::print("  bits        {}: multiples of 2^{} below 2^{}; {}\n", bits, f.coordinates.lowest, f.coordinates.highest,
             arithmetic);
  const auto list = defects(model, f);
  fmt::print("  defects     {}\n", list.empty() ? "none" : list.front());
  for (std::size_t i = 1; i < list.size(); ++i) fmt::print("              {}\n", list[i]);
}

/// What visible lines would take, stage by stage.
void print(const LinePlan& plan, const std::string& view, const std::string& edges) {
  fmt::print("  plan        view {}, edges {}: {}\n", view, edges,
             plan.method == "none" ? "no edge needs a test" : "method " + plan.method);
  for (const LeftOut& stage : plan.left_out) fmt::print("              {}: {}\n", stage.stage, stage.why);
}

void add_facts(Report& report, const Model& model, const SceneFacts& f) {
  report.set("model", {{"name", model.name}, {"format", model.format}});
  report.set("points", {{"given", f.points}, {"distinct", f.distinct_points}, {"used", f.used_points}});
  report.set("faces", {{"given", f.faces},
                       {"triangles", f.triangular},
                       {"quads", f.quadrangular},
                       {"larger", f.larger},
                       {"planar", used(f, FaceUse::planar)},
                       {"not_coplanar", used(f, FaceUse::not_coplanar)},
                       {"crosses_itself", used(f, FaceUse::crosses_itself)},
                       {"no_area", used(f, FaceUse::no_area)},
                       {"duplicate", f.duplicate_faces},
                       {"axis_parallel", f.axis_parallel_faces}});
  report.set("triangles", f.triangles);
  report.set("wires", f.wires);
  report.set("objects", model.objects);
  report.set("materials", model.materials);
  Report::Json cameras = Report::Json::array();
  for (const StoredCamera& c : model.cameras) cameras.push_back(c.name);
  report.set("cameras", std::move(cameras));
  report.set("colours", model.palette.size());
  report.set("up_axis", model.up_axis ? Report::Json(std::string(1, *model.up_axis)) : Report::Json());
  report.set("unit_mm", model.unit ? Report::Json(*model.unit) : Report::Json());
  report.set("edges", {{"regular", f.regular_edges},
                       {"boundary", f.boundary_edges},
                       {"non_manifold", f.non_manifold_edges},
                       {"flipped", f.flipped_edges},
                       {"coplanar", f.coplanar_edges}});
  report.set("closed", f.is_closed());
  report.set("manifold", f.is_manifold());
  report.set("oriented", f.is_consistently_oriented());
  report.set("components", f.components);
  report.set("pinched_vertices", f.pinched_vertices);
  const auto corner = [](const Point3& p) { return Report::Json::array({p.x, p.y, p.z}); };
  report.set("box", Report::Json::array({corner(f.lowest), corner(f.highest)}));
  report.set("bits", f.coordinates.bits());
  report.set("defects", defects(model, f));
}

void run(const InfoArguments& a, UnfinishedFiles& unfinished) {
  a.models.check();
  LineOptions line_options = a.lines.options();
  SceneOptions scene_options = a.lines.scene_options();
  scene_options.coplanar = a.scene.which_coplanar();
  scene_options.hidden_lines = false;  // as a drawing is without --hidden
  CommandContext context(a.common, a.models.models, {a.mesh}, unfinished);
  Report& report = context.report;
  const ViewedModel viewed = context.read(a.models, a.view);
  DrawingOptions drawing_options;  // the page of a drawing, unless it is told otherwise
  drawing_options.page = parse_page("A4");
  drawing_options.field_of_view = viewed.chosen.field_of_view;
  line_options.frame = frame_size(viewed.view(), drawing_options);
  context.progress.stage("facts");
  const SceneFacts facts = report.timed("facts", [&] { return scene_facts(viewed.mesh, viewed.model.polygons); });
  context.progress.stage("plan");
  const LinePlan plan = report.timed("plan", [&] { return plan_lines(viewed.prepared(scene_options), line_options); });
  context.progress.clear();
  if (a.common.report != "-") {  // the report says the same, and a program reads it
    print(viewed.model, facts);
    print(plan, viewed.chosen.title, a.lines.edges);
  }
  add_facts(report, viewed.model, facts);
  report.set("view", viewed.chosen.title);
  report.set("method", plan.method);
  for (const LeftOut& stage : plan.left_out) report.leave_out(stage.stage, stage.why);
  if (!a.mesh.empty())
    context.write(a.mesh, mesh_json(viewed.mesh, a.exact ? Numbers::exact : Numbers::rounded),
                  counted(viewed.mesh.faces.size(), "face") + ", " + counted(viewed.mesh.triangles.size(), "triangle"));
  context.finish();
}

}  // namespace

void add_info(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<InfoArguments>();
  Options options = command.add_verb(
      "info", "Say what a model is: size, topology, defects, the bits it needs, and what a drawing of it takes", examples);
  a->models.add_to(options);
  a->view.add_to(options);
  a->scene.add_to(options);
  a->lines.add_to(options);
  options.begin_group("Options");
  options.add("--mesh", a->mesh, "FILE", "Write the faces as used as JSON");
  options.add_flag("--exact", a->exact, "JSON: exact numbers as strings \"p/q\"");
  options.add("--report", a->common.report, "FILE",
              "The facts and times as JSON; - for the standard output, instead of the text");
  a->common.add_quiet_to(options, "Only the facts: no progress, nothing about files");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
