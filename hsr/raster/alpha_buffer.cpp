#include "hsr/raster/alpha_buffer.h"

#include <algorithm>

#include "hsr/raster/compositing.h"
#include "hsr/raster/drawn_triangles.h"
#include "hsr/raster/sample_lists.h"

namespace hsr::internal {

namespace {

struct Layer {
  double nearness = 0;
  TriangleId triangle;

  bool is_behind(const Layer& other, TieRule ties) const {
    return nearness != other.nearness ? nearness < other.nearness : ties.is_above(other.triangle, triangle);
  }
};

}  // namespace

AlphaBuffer alpha_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                         double opacity, TieRule ties) {
  const DrawnTriangles<double> triangles(mesh, view, samples);
  SampleLists<Layer> lists(samples.width, samples.height);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    triangles.visit(TriangleId(k), [&](const auto& a, const auto& b, const auto& c) {
      ScannedTriangle<double> scanned;
      if (!scanned.set(a, b, c, samples.width, samples.height)) return;
      for (int j = scanned.top(); j < scanned.bottom(); ++j) {
        const auto [begin, end] = scanned.span(j);
        const auto nearness_at = scanned.row(j);
        for (int i = begin; i < end; ++i) lists.add(i, j, {nearness_at(i), TriangleId(k)});
      }
    });

  AlphaBuffer result;
  result.picture = Image<Colour>(samples.width, samples.height);
  result.nearest = Image<TriangleId>(samples.width, samples.height);
  result.layers = lists.size();
  result.bytes = triangles.memory() + lists.bytes();
  std::vector<Layer> layers;
  for (int j = 0; j < samples.height; ++j)
    for (int i = 0; i < samples.width; ++i) {
      lists.copy(i, j, layers);
      result.most_layers = std::max(result.most_layers, layers.size());
      std::sort(layers.begin(), layers.end(), [&](const Layer& a, const Layer& b) { return a.is_behind(b, ties); });
      Light light = white_light;
      for (const Layer& layer : layers) {
        const Colour& c = colours[mesh.face_of[layer.triangle].value];
        lay_over(light, c, opacity_of(c, opacity));
      }
      result.picture.at(i, j) = rounded(light);
      if (!layers.empty()) result.nearest.at(i, j) = layers.back().triangle;
    }
  return result;
}

}  // namespace hsr::internal
