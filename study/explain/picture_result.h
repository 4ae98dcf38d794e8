#pragma once

#include <string>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "study/explain/traced_scene.h"

namespace hsr::internal {

/// The faces that samples show, by row, as JSON: [[0, -1, ...], ...].
std::string faces_json(const ScenePicture& picture, const Image<TriangleId>& triangles);
/// Colours by row, as JSON: [["#rrggbb", ...], ...].
std::string colours_json(const Image<Colour>& picture);
/// Of a scene as it is shown, the colour of each face.
std::vector<Colour> colours_of(const TracedScene& scene);
/// "columns 2 … 5", "column 2".
std::string columns_text(int begin, int end);
/// "(86, 140, 214)".
std::string colour_text(const Colour& c);
/// A frame around samples left ... right - 1 of rows top ... bottom - 1.
void mark_frame(TraceStep& step, int left, int top, int right, int bottom);

}  // namespace hsr::internal
