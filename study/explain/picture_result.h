#pragma once

#include <algorithm>
#include <string>

#include "geometry/mesh.h"
#include "hsr/image.h"
#include "study/explain/traced_scene.h"

namespace hsr::internal {

/// The faces that samples show, by row, as JSON: [[0, -1, ...], ...].
std::string faces_json(const ScenePicture& picture, const Image<TriangleId>& triangles);
/// The same as the result of a run: {"faces": ...}.
std::string faces_result(const ScenePicture& picture, const Image<TriangleId>& triangles);
/// Of an image whose pixels have a triangle each.
template <class Pixel>
std::string faces_result(const ScenePicture& picture, const Image<Pixel>& image) {
  Image<TriangleId> triangles(image.width, image.height);
  std::transform(image.pixels.begin(), image.pixels.end(), triangles.pixels.begin(), [](const Pixel& p) { return p.triangle; });
  return faces_result(picture, triangles);
}
/// Numbers by row, as JSON: [[0.5, 255, ...], ...].
std::string numbers_json(const Image<double>& numbers);
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
