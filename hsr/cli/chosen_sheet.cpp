#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "geometry/error.h"
#include "hsr/cli/model_defaults.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/page_writing.h"
#include "hsr/cli/sheet_arguments.h"
#include "hsr/cli/sheet_json.h"
#include "hsr/cli/view_options.h"
#include "hsr/drawing/page.h"

namespace hsr::cli {

namespace {

/// Numbers with a separator between.
std::vector<double> numbers_of(const std::string& option, const std::string& text, const std::string& whole,
                               const std::string& expected, char separator) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    double x = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, x);
    if (error != std::errc{} || stop != text.data() + end || !std::isfinite(x))
      throw InputError(fmt::format("{}: found \"{}\", expected {}", option, whole, expected));
    numbers.push_back(x);
    begin = end + 1;
  }
  return numbers;
}

/// "front:10,0,5:4:5:1": view, middle, radius, scale.
SheetDetail parse_detail(const std::string& text) {
  const std::string expected = "VIEW:X,Y,Z:RADIUS:SCALE such as front:10,0,5:4:5:1";
  const std::size_t first = text.find(':'), second = first == std::string::npos ? first : text.find(':', first + 1);
  const std::size_t third = second == std::string::npos ? second : text.find(':', second + 1);
  if (third == std::string::npos) throw InputError("--detail: found \"" + text + "\", expected " + expected);
  const auto scale = numbers_of("--detail", text.substr(third + 1), text, expected, ':');
  const auto radius = numbers_of("--detail", text.substr(second + 1, third - second - 1), text, expected, ',');
  if (radius.size() != 1 || scale.size() != 2 || !(scale[0] > 0) || !(scale[1] > 0) || !(radius[0] > 0))
    throw InputError("--detail: found \"" + text + "\", expected " + expected);
  return {text.substr(0, first), parse_point("--detail", text.substr(first + 1, second - first - 1)), radius[0],
          scale[0] / scale[1]};
}

std::vector<std::string> parse_views(const std::string& text) {
  std::vector<std::string> views;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    views.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return views;
}

}  // namespace

SheetOptions SheetArguments::options() const {
  SheetOptions o;
  o.format = sheet_format(page);
  const bool is_american = page.starts_with("ANSI");
  o.angle = angle == "third" || (angle.empty() && is_american) ? ProjectionAngle::third : ProjectionAngle::first;
  if (scale == "fit")
    throw InputError("--scale: found \"fit\", expected standard or a ratio like 1:5, as a sheet says its scale");
  o.scale = parse_scale(scale);
  o.views = parse_views(views);
  for (const std::string& text : sections) o.sections.push_back(parse_plane(text));
  for (const std::string& text : details) o.details.push_back(parse_detail(text));
  if (!title_file.empty()) {
    std::ifstream file(title_file, std::ios::binary);
    if (!file || std::filesystem::is_directory(title_file))
      throw InputError("--title-block: " + title_file + ": cannot be read, expected a file of JSON");
    read_title_block({std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}, title_file, o.title);
  }
  for (const std::string& text : titles) set_title_field(text, o.title);
  o.has_dimensions = dimensions == "overall";
  o.has_centre_lines = centre_lines == "on";
  o.lines = lines.options();
  o.hidden = hidden_lines_named(hidden);
  o.coplanar = scene.which_coplanar();
  for (const std::string& text : pens) {
    const auto more = parse_pens(text);
    o.pens.insert(o.pens.end(), more.begin(), more.end());
  }
  if (!fit_arcs.empty()) o.fit_arcs = tolerance_of_arcs(fit_arcs);
  return o;
}

std::string SheetArguments::adopt(const Model& model, SheetOptions& options) const {
  options.unit = unit_of(unit, model);
  options.y_up = up_axis_of(up_axis, model) == 'y';
  if (options.title.title.empty()) {
    std::filesystem::path name = std::filesystem::path(model.name).filename();
    if (name.extension() == ".gz") name = name.stem();
    options.title.title = name.stem().string();
  }
  return unit.empty() ? unit_note(model) : std::string();
}

std::optional<PixelSize> SheetArguments::pixels() const {
  return size.empty() ? std::nullopt : std::optional(parse_size(size));
}

Drawing from_lower_left(const Sheet& sheet) {
  Drawing raised = sheet.drawing;
  const auto height = static_cast<std::int64_t>(std::llround(raised.height * 1000));
  for (PaperPoint& p : raised.points) p.y -= height;
  for (DrawnArc& arc : raised.arcs) arc.ellipse.centre.y -= raised.height;
  return raised;
}

std::string sheet_bytes(const Sheet& sheet, const SheetOptions& options, const SheetArguments& arguments, Format format) {
  if (format == Format::json) return json_of(sheet, options).text() + "\n";
  WriteOptions words = page_options(format, {options.title.title, "drawing sheet", {}}, "", arguments.pixels());
  add_dxf(words, arguments.formats.dxf_release, options.unit, sheet.drawing.scale);
  return written(format == Format::dxf ? from_lower_left(sheet) : sheet.drawing, name_of(format), words);
}

}  // namespace hsr::cli
