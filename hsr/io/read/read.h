#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hsr/model.h"
#include "hsr/painter/verify/verify.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"

namespace hsr {

/// The model in a file: OBJ, OFF family, PLY, STL, each also gzipped, glTF and GLB. Decimal numbers are rounded correctly.
///
/// The format is told by the content where the content says it, else by the ending.
/// @throws InputError in one line: the file, the line or index, what was found and what was expected. Nothing is allocated by a
///   count that the file's size has not confirmed.
Model read_model(const std::string& path);

/// The model in the bytes of a file in memory; `name` is used like a path: for its ending, in messages, and to find the files
/// that the model names.
/// @throws InputError as above
Model read_model(const std::string& name, std::string_view bytes);

/// Adds what a file of "hsr-marks/1" says of the faces and edges of a model, in the place of what it knew (docs/conventions.md, J7).
/// @throws InputError in one line: the file, the edge, what was found and what was expected; the model is then of no use
void read_marks(const std::string& path, Model& model);

/// A painting order by anyone.
struct PaintingFile {
  std::vector<PaintedPolygon> far_to_near;
  std::optional<View> view;
  std::optional<Coplanar> coplanar;  ///< which of coincident faces is painted last, if the file says so
};

/// Reads "hsr-order/1" (docs/conventions.md, "JSON"): `face`, `original`, `view` and `coplanar` may be missing. A piece
/// with `wire` has two points. Coordinates are numbers,
/// rounded correctly, or strings "p/q".
/// @throws InputError in one line: the file, the piece and point, what was found and what was expected
PaintingFile read_order(const std::string& path);

}  // namespace hsr
