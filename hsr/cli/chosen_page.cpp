#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "geometry/error.h"
#include "hsr/cli/model_defaults.h"
#include "hsr/cli/page_arguments.h"

namespace hsr::cli {

namespace {

std::string contents_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path))
    throw InputError("--pens: " + path + ": cannot be read, expected a file of pens");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

HiddenLines hidden_lines_named(const std::string& name) {
  return name == "none" ? HiddenLines::none : name == "dashed" ? HiddenLines::dashed : HiddenLines::solid;
}

double tolerance_of_arcs(const std::string& text) {
  double mm = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), mm);
  if (error != std::errc{} || end != text.data() + text.size() || !(mm > 0) || !std::isfinite(mm))
    throw InputError(fmt::format("--fit-arcs: found \"{}\", expected millimetres, more than 0", text));
  return mm;
}

DrawingOptions PageArguments::options() const {
  if (!(margin >= 0)) throw InputError(fmt::format("--margin: found {}, expected millimetres, 0 or more", margin));
  DrawingOptions options;
  options.page = parse_page(page);
  options.page.margin = margin;
  if (!(min_length >= 0)) throw InputError(fmt::format("--min-length: found {}, expected millimetres, 0 or more", min_length));
  options.min_length = min_length;
  if (!fit_arcs.empty()) options.fit_arcs = tolerance_of_arcs(fit_arcs);
  options.scale = parse_scale(scale);
  options.sort_for_pen = sort == "pen";
  options.standard_scale = scale == "standard";
  if (!unit.empty()) options.unit = parse_unit(unit);
  if (!pens_file.empty()) options.pens = parse_pens_file(contents_of(pens_file), pens_file);
  for (const std::string& text : pens) {
    const auto more = parse_pens(text);
    options.pens.insert(options.pens.end(), more.begin(), more.end());
  }
  return options;
}

std::string PageArguments::adopt_unit(const Model& model, DrawingOptions& options) const {
  options.unit = unit_of(unit, model);
  return unit.empty() && (options.scale || options.standard_scale) ? unit_note(model) : std::string();
}

SampleGrid samples_for(const View& view, const Mesh& mesh, const DrawingOptions& options, int width, int height) {
  if (const auto frame = frame_size(view, options)) return sample_grid(view, *frame, width, height);
  return sample_grid(view, paper_rectangle(mesh, view), width, height);
}

}  // namespace hsr::cli
