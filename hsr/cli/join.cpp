#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "geometry/error.h"
#include "hsr/cli/command_context.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/fill_arguments.h"
#include "hsr/cli/format_arguments.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/model_defaults.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/page_writing.h"
#include "hsr/cli/scale_text.h"
#include "hsr/cli/tile_job.h"
#include "hsr/drawing/drawing.h"
#include "hsr/drawing/pen_order.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/json.h"
#include "hsr/tiles/drawing_numbers.h"
#include "hsr/tiles/united_lines.h"

namespace hsr::cli {

namespace {

struct JoinArguments {
  std::string job;
  std::vector<std::string> outputs;
  FillArguments fills;
  PageArguments page;
  FormatArguments formats;
  CommonArguments common;
};

const char* const examples = R"(Examples:
  hsr join job -o city.svg -o city.pdf --page A1
  hsr join job -o lines.json --exact                       of a job that was split with --json

Writes what hsr draw would, once hsr tile has done all tiles; with fills where hsr split was given --fill. Exit status 1: a part is
missing, not whole, or of another job or tile; the line says which, and hsr tile does it again once it is removed.)";

constexpr std::array formats = {Format::svg, Format::pdf,  Format::eps, Format::dxf,
                                Format::tex, Format::hpgl, Format::png, Format::json};

class JoinCommand {
 public:
  JoinCommand(const JoinArguments& a, UnfinishedFiles& unfinished)
      : a_(a), outputs_(parse_outputs(a.outputs, formats)), context_(a.common, {}, paths_of(outputs_), unfinished) {
    drawing_options_ = a.page.options();
    if (!a.page.size.empty()) size_ = parse_size(a.page.size);
    check_id_prefix(a.formats.id_prefix);
  }

  void run() {
    job_ = read_job(a_.job);
    if (wants(Format::json) && !job_.is_complete)
      throw InputError(a_.job + ": has only what is visible, expected a job that was split with --json for a file of JSON");
    if (!a_.fills.are_default() && !job_.has_fills)
      throw InputError(a_.job + ": has no fills, expected a job that was split with --fill for --shade and --merge");
    if (job_.has_fills)
      for (const std::string& text : notes_on_formats_without_fills(outputs_)) context_.note(text);
    unite();
    draw_page();
    write();
  }

 private:
  bool wants(Format format) const {
    return std::ranges::any_of(outputs_, [&](const Output& o) { return o.format == format; });
  }
  void unite();
  void draw_page();
  void write();
  Drawing drawn(const DrawingOptions& options) const {
    const View& view = job_.chosen.view;
    std::optional<Regions> fills;
    if (job_.has_fills && !options.in_frame_units)
      fills = a_.fills.regions(SceneView(scene_.mesh, view), scene_.part.model, scene_.fragments);
    Drawing drawing = draw(scene_.mesh, view, scene_.lines, options, fills ? &*fills : nullptr);
    give_numbers(drawing, scene_.part);
    return drawing;
  }
  std::string bytes_of(Format format) const;
  std::string summary_of(Format format, const std::string& bytes) const;

  const JoinArguments& a_;
  std::vector<Output> outputs_;
  CommandContext context_;
  TileJob job_;
  DrawingOptions drawing_options_;
  std::optional<PixelSize> size_;
  UnitedTiles scene_;
  SceneObjects objects_;
  std::optional<Drawing> drawing_, model_drawing_;
};

[[noreturn]] void fail(const std::string& text) {
  tell("hsr: {}\n", text);
  throw CheckFailed();
}

void JoinCommand::unite() {
  context_.progress.stage("reading");
  const auto tiles = static_cast<std::uint32_t>(job_.tiles.size());
  for (std::uint32_t t = 0; t < tiles; ++t)
    if (const auto wrong = wrong_with_part(job_, t)) {
      context_.progress.clear();
      fail(*wrong);
    }
  std::vector<TilePart> parts = context_.report.timed("read", [&] {
    std::vector<TilePart> all;
    for (std::uint32_t t = 0; t < tiles; ++t) all.push_back(read_part(job_, t));
    return all;
  });
  Model names = job_.names;
  std::swap(names.points, parts.front().model.model.points);
  std::swap(names.polygons, parts.front().model.model.polygons);
  std::swap(names.face_colour, parts.front().model.model.face_colour);
  std::swap(names.face_object, parts.front().model.model.face_object);
  std::swap(names.face_material, parts.front().model.model.face_material);
  std::swap(names.segment_object, parts.front().model.model.segment_object);
  parts.front().model.model = std::move(names);
  context_.progress.stage("uniting");
  try {
    scene_ = context_.report.timed(
        "unite", [&] { return united_tiles(std::move(parts), job_.chosen.view, job_.image, !job_.is_complete); });
  } catch (const TileMismatch& e) {
    context_.progress.clear();
    fail(
        fmt::format("{}: found a {} that goes on beyond a side of tile {}, where no other tile has it: a part is old, or of "
                    "another scene",
                    job_.part_path(e.tile), e.thing, e.tile + 1));
  }
  objects_ = objects_of(scene_.part.model, scene_.mesh);
  std::uint64_t visible = 0;
  for (const Line& line : scene_.lines.lines)
    for (std::uint32_t k = 0; k < line.intervals(); ++k) visible += line.hidden(k) ? 0U : 1U;
  context_.report.set("lines", {{"edges", scene_.lines.lines.size()}, {"visible_intervals", visible}});
  context_.report.set("pairs", scene_.lines.pairs);
}

void JoinCommand::draw_page() {
  drawing_options_.hidden = hidden_lines_named(job_.hidden);
  drawing_options_.leave_out_near = true;
  drawing_options_.objects = &objects_;
  drawing_options_.field_of_view = job_.chosen.field_of_view;
  drawing_options_.unit = unit_of(a_.page.unit.empty() ? job_.unit : a_.page.unit, scene_.part.model);
  if (std::ranges::all_of(outputs_, [](const Output& o) { return o.format == Format::json; })) return;
  context_.progress.stage("drawing");
  drawing_ = context_.report.timed("drawing", [&] { return drawn(drawing_options_); });
  if (!wants(Format::dxf)) return;
  model_drawing_ = drawn(in_model_units(drawing_options_, drawing_->scale));
  model_drawing_->pens = drawing_->pens;
}

std::string JoinCommand::bytes_of(Format format) const {
  if (format == Format::json) {
    JsonOptions options;
    options.numbers = a_.formats.exact ? Numbers::exact : Numbers::rounded;
    options.fragments = job_.has_fills ? &scene_.fragments : nullptr;
    options.objects = &objects_;
    options.point_numbers = scene_.part.points;
    options.face_numbers = scene_.part.faces;
    return lines_json(scene_.mesh, job_.chosen.view, scene_.lines, options);
  }
  ViewedModel viewed;
  viewed.model.name = job_.names.name;
  viewed.chosen = job_.chosen;
  SvgOptions captions = viewed.captions();
  captions.id_prefix = a_.formats.id_prefix;
  WriteOptions options = page_options(format, captions, scale_in_title(*drawing_, drawing_options_, a_.page), size_);
  add_dxf(options, a_.formats.dxf_release, drawing_options_.unit, drawing_->scale);
  return written(format == Format::dxf ? *model_drawing_ : *drawing_, name_of(format), options);
}

std::string JoinCommand::summary_of(Format format, const std::string& bytes) const {
  if (format == Format::json) {
    const std::string lines = counted(scene_.lines.lines.size(), "line");
    return job_.has_fills ? lines + ", " + counted(scene_.fragments.fragments.size(), "fragment") : lines;
  }
  if (format == Format::png) return pixel_size(bytes);
  const bool is_perspective = job_.chosen.view.is_perspective();
  const std::string page = fmt::format("{}, {}, {}", paper_size(drawing_->width, drawing_->height),
                                       scale_text(drawing_->scale, drawing_options_.unit, a_.page, is_perspective),
                                       counted(drawing_->polylines.size(), "polyline"));
  return job_.has_fills && shows_fills(format) ? page + ", " + counted(drawing_->fills.fills.size(), "filled area") : page;
}

void JoinCommand::write() {
  context_.progress.stage("writing");
  context_.report.timed("write", [&] {
    for (const Output& output : outputs_) {
      const std::string bytes = bytes_of(output.format);
      context_.write(output.path, bytes, summary_of(output.format, bytes));
    }
  });
  context_.finish();
}

}  // namespace

void add_join(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<JoinArguments>();
  Options options = command.add_verb("join", "Make the drawing of all tiles of what hsr split has made", examples);
  options.add("JOB", a->job, "JOB", "The directory that hsr split has made").required();
  options
      .add_one_each("-o,--output", a->outputs, "FILE",
                    "The drawing; its ending chooses svg, pdf, eps, dxf, tex, hpgl, png or json; svg:- and the like write to "
                    "standard output; may be repeated")
      .required();
  options.begin_group("Surfaces");
  a->fills.add_shade_to(options);
  a->fills.add_merge_to(options);
  a->page.add_to(options, "PNG: pixels [150 to the inch]");
  a->page.add_pens_to(options);
  a->page.add_sort_to(options);
  a->page.add_fit_arcs_to(options);
  a->formats.add_dxf_to(options);
  a->formats.add_id_prefix_to(options);
  a->formats.add_exact_to(options);
  a->common.add_threads_to(options);
  options.begin_group("Report");
  a->common.add_report_to(options, "Times and counts");
  a->common.add_quiet_to(options, "Say nothing but what is wrong");
  options.on_run([a, &unfinished] { JoinCommand(*a, unfinished).run(); });
}

}  // namespace hsr::cli
