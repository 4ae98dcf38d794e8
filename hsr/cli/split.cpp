#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/cli/split_model.h"
#include "hsr/cli/tile_job.h"

namespace hsr::cli {

namespace fs = std::filesystem;

namespace {

struct SplitArguments {
  ModelArguments models;
  std::string job, unit, memory = "2G";
  std::optional<int> tiles;
  ViewOptions view;
  SceneArguments scene;
  LineArguments lines;
  std::string hidden = "none";
  bool json = false, fill = false;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr split city.ply -o job --memory 2G                    so many tiles that each takes 2 GB at most
  hsr split city.ply -o job --tiles 16 --hidden dashed --view top
  hsr split city.ply -o job --fill                         with what is seen of each face, to be filled
  parallel hsr tile job ::: $(seq 16); hsr join job -o city.svg

Parts the picture of a scene into tiles and writes what each takes into the directory JOB: hsr tile finds the lines and fills of one, on any
machine that sees the directory, and hsr join makes the drawing of all, byte for byte the one that hsr draw makes. What JSON has besides,
every line with its hidden parts, is only found with --json. Sections, a tolerance and surfaces (STEP) take the whole scene at once: for
these there is hsr draw. See docs/tiles.md.)";

/// What a triangle takes while its lines are found, without hidden ones and with them, and what its fragments take more; measured on
/// cities of boxes (docs/performance.md).
constexpr double bytes_of_triangle = 800, with_hidden = 1400, more_with_fills = 800;

/// "2G"
double parse_memory(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string unit(end, text.data() + text.size());
  const double factor = unit == "G" ? 0x1p30 : unit == "M" ? 0x1p20 : 0;
  if (error != std::errc{} || !(number > 0) || factor == 0)
    throw InputError("--memory: found \"" + text + "\", expected a size such as 2G or 500M");
  return number * factor;
}

std::uint32_t count_of_tiles(const SplitArguments& a, std::size_t triangles) {
  constexpr double most = 100000;
  if (a.tiles) {
    if (*a.tiles < 1 || *a.tiles > most) throw InputError(fmt::format("--tiles: found {}, expected 1 to {}", *a.tiles, most));
    return static_cast<std::uint32_t>(*a.tiles);
  }
  const double each = (a.json || a.hidden != "none" ? with_hidden : bytes_of_triangle) + (a.fill ? more_with_fills : 0);
  const double tiles = std::ceil(static_cast<double>(triangles) * each / parse_memory(a.memory));
  return static_cast<std::uint32_t>(std::clamp(tiles, 1.0, most));
}

/// As many as the polygons are cut into, or a few more.
std::size_t count_of_triangles(const Polygons& polygons) {
  return polygons.corners.size() - std::min(polygons.corners.size(), 2 * polygons.size());
}

void check(const SplitArguments& a) {
  a.models.check();
  if (!a.view.sections.empty())
    throw InputError("--section: found with split, expected it with hsr draw: its caps are of whole bodies");
  parse_memory(a.memory);
  TileJob wanted;
  wanted.lines = a.lines;
  wanted.is_complete = a.json || a.hidden != "none";
  wanted.has_fills = a.fill;
  check_tile_request(View(), wanted.request());
  std::error_code error;
  if (fs::exists(a.job, error) && !fs::is_directory(a.job, error))
    throw InputError(a.job + ": is a file, expected a directory to make");
}

/// Tiles and parts of a job that was here before.
void remove_old_job(const std::string& directory) {
  std::error_code error;
  fs::remove(directory + "/job.json", error);
  for (const auto& entry : fs::directory_iterator(directory)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("tile-") || name.starts_with("part-")) fs::remove(entry.path(), error);
  }
}

Model read(const SplitArguments& a) {
  OpenedModels opened = a.models.open(a.unit, a.view.up_axis);
  const char* const surfaces =
      ": has surfaces or marks of edges, which are told in the whole model, expected meshes of polygons: for others "
      "there is hsr draw";
  if (opened.have_surfaces()) throw InputError(a.models.models.front() + surfaces);
  Model model = opened.model({});
  if (!model.marks.empty() || !model.face_surface.empty()) throw InputError(model.name + surfaces);
  return model;
}

void run(const SplitArguments& a, UnfinishedFiles& unfinished) {
  check(a);
  CommandContext context(a.common, a.models.models, {}, unfinished);
  context.progress.stage("reading");
  Model model = context.report.timed("read", [&] { return read(a); });
  TileJob job;
  job.directory = a.job;
  job.unit = a.unit;
  job.lines = a.lines;
  job.coplanar = a.scene.coplanar;
  job.hidden = a.hidden;
  job.is_complete = a.json || a.hidden != "none";
  job.has_fills = a.fill;
  context.progress.stage("points");
  context.report.timed("points", [&] { name_merged_points(model); });
  job.chosen = context.report.timed("view", [&] { return choose_view(a.view, bounding_mesh(model), model); });
  for (const std::string& text : model.notes) context.note(text);
  if (!job.chosen.note.empty()) context.note(job.chosen.note);
  if (!job.chosen.up_axis_note.empty()) context.note(job.chosen.up_axis_note);
  const std::size_t triangles = count_of_triangles(model.polygons);
  context.progress.stage("tiles");
  TileContents contents;
  context.report.timed("tiles", [&] {
    job.image = tiles_of(model, job.chosen.view, count_of_tiles(a, triangles));
    contents = contents_of_tiles(model, job.chosen.view, job.image);
  });
  std::error_code error;
  fs::create_directories(a.job, error);
  if (!fs::is_directory(a.job, error))
    throw InputError(a.job + ": cannot be made a directory, expected one that is there or can be made");
  remove_old_job(a.job);
  context.progress.stage("writing");
  std::uint64_t faces = 0, bytes = 0, most = 0;
  context.report.timed("write", [&] {
    for (std::uint32_t t = 0; t < job.image.count(); ++t) {
      const auto in_tile = std::exchange(contents.faces[t], {}).all(), wires = contents.segments[t].all();
      write_tile(job, t, part_of(model, {}, {in_tile, wires}), unfinished);
      faces += job.tiles[t].faces;
      bytes += job.tiles[t].bytes;
      most = std::max(most, job.tiles[t].faces);
      context.progress.show(static_cast<double>(t + 1) / job.image.count());
    }
    job.names = std::move(model);
    job.names.points = {};
    job.names.polygons = {};
    write_job(job, unfinished);
  });
  context.report.set("tiles", {{"count", job.image.count()},
                               {"triangles", triangles},
                               {"faces_in_all", faces},
                               {"most_faces", most},
                               {"bytes", bytes}});
  context.finish();
  context.progress.clear();
  if (context.is_quiet()) return;
  tell("hsr: {}: {}, up to {} each, {:.1f} MB: hsr tile {} N for each N from 1 to {}, then hsr join {} -o FILE\n", a.job,
       counted(job.image.count(), "tile"), counted(most, "face"), static_cast<double>(bytes) / 1e6, a.job, job.image.count(),
       a.job);
}

}  // namespace

void add_split(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<SplitArguments>();
  Options options = command.add_verb("split", "Part a scene into tiles, for many machines or little memory", examples);
  a->models.add_to(options);
  options.add("-o,--output", a->job, "JOB", "The directory to make; what hsr split has left in it before goes").required();
  options.add("--tiles", a->tiles, "N", "So many tiles [as --memory wants]");
  options
      .add("--memory", a->memory, "SIZE", "About what a tile may take, such as 2G or 500M; in crowded scenes it may take more")
      .with_default_shown();
  options.add_flag("--json", a->json, "Find also what JSON takes: every line, with its hidden parts");
  options.add("--unit", a->unit, "UNIT", "The model's unit: mm, cm, m or in [glTF: m, else mm]")
      .one_of({"mm", "cm", "m", "in"});
  a->models.add_objects_to(options);
  a->view.add_to(options);
  a->scene.add_to(options);
  a->lines.add_to(options);
  options.add("--hidden", a->hidden, "STYLE", "Hidden lines: none, dashed or solid")
      .with_default_shown()
      .one_of({"none", "dashed", "solid"});
  options.begin_group("Surfaces");
  options.add_flag("--fill", a->fill, "Find also the visible parts of faces, which hsr join fills; JSON: with fragments");
  options.begin_group("Report");
  a->common.add_threads_to(options);
  a->common.add_report_to(options, "Times and counts");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { run(*a, unfinished); });
}

}  // namespace hsr::cli
