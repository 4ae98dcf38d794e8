#pragma once

#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/mesh.h"
#include "hsr/cli/command_line.h"
#include "hsr/drawing/drawing.h"
#include "hsr/model.h"
#include "hsr/raster/samples.h"

namespace hsr::cli {

/// The options that say how large and on what a picture is drawn.
struct PageArguments {
  std::string page = "A4", scale = "fit", unit, size;  ///< an empty unit: the model's
  double margin = 10, min_length = 0;
  std::string fit_arcs;           ///< millimetres; empty: none
  std::vector<std::string> pens;  ///< settings, as parse_pens() has them
  std::string sort = "none";      ///< or pen
  std::string pens_file;          ///< a file of settings, before those; empty: none

  /// @param size_help what --size is the size of
  void add_to(Options& options, const std::string& size_help);
  void add_pens_to(Options& options);
  void add_sort_to(Options& options);
  void add_fit_arcs_to(Options& options);
  /// @throws InputError naming the option
  DrawingOptions options() const;
  /// Puts the unit of the model into the options, where none was given. @returns a note if that made a difference, or nothing
  std::string adopt_unit(const Model& model, DrawingOptions& options) const;
};

/// @param name none, dashed or solid
HiddenLines hidden_lines_named(const std::string& name);

/// The millimetres of --fit-arcs. @throws InputError unless they are more than 0
double tolerance_of_arcs(const std::string& text);

/// The samples of the picture: what the field of view frames, or all of the model.
SampleGrid samples_for(const View& view, const Mesh& mesh, const DrawingOptions& options, int width, int height);

/// Returns what `work` does with the samples of the picture.
/// @throws InputError where there are none: doubles are too coarse for a picture that far from the origin
template <class Work>
auto on_samples(const Work& work) {
  try {
    return work();
  } catch (const PreconditionError& e) {
    throw InputError(std::string("the picture is too far from the origin for its size to have exact samples (") + e.what() +
                     "), expected a model nearer to it, or no --check, csv or painted png");
  }
}

}  // namespace hsr::cli
