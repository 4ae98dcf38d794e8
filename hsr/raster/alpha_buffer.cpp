#include "hsr/raster/alpha_buffer.h"

#include <algorithm>

#include "geometry/watched.h"
#include "hsr/raster/alpha_buffer_observer.h"
#include "hsr/raster/compositing.h"
#include "hsr/raster/drawn_triangles.h"
#include "hsr/raster/sample_lists.h"

namespace hsr::internal {

namespace {

using Layer = SampleLayer;

bool is_behind(const Layer& a, const Layer& b, TieRule ties) {
  return a.nearness != b.nearness ? a.nearness < b.nearness : ties.is_above(b.triangle, a.triangle);
}

template <class Watch>
AlphaBuffer blended(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                    double opacity, TieRule ties, [[maybe_unused]] Watch watch) {
  const DrawnTriangles<double> triangles(mesh, view, samples);
  SampleLists<Layer> lists(samples.width, samples.height);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    triangles.visit(TriangleId(k), [&](const auto& a, const auto& b, const auto& c) {
      ScannedTriangle<double> scanned;
      if (!scanned.set(a, b, c, samples.width, samples.height)) return;
      for (int j = scanned.top(); j < scanned.bottom(); ++j) {
        const auto [begin, end] = scanned.span(j);
        const auto nearness_at = scanned.row(j);
        for (int i = begin; i < end; ++i) {
          lists.add(i, j, {nearness_at(i), TriangleId(k)});
          if constexpr (Watch::is_watched) watch.observer->added(i, j, {nearness_at(i), TriangleId(k)});
        }
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
      std::sort(layers.begin(), layers.end(), [&](const Layer& a, const Layer& b) { return is_behind(a, b, ties); });
      if constexpr (Watch::is_watched) watch.observer->sorted(i, j, layers);
      Light light = white_light;
      for (const Layer& layer : layers) {
        const Colour& c = colours[mesh.face_of[layer.triangle].value];
        [[maybe_unused]] const Light before = light;
        lay_over(light, c, opacity_of(c, opacity));
        if constexpr (Watch::is_watched) watch.observer->laid_over(layer, opacity_of(c, opacity), before, light);
      }
      result.picture.at(i, j) = rounded(light);
      if constexpr (Watch::is_watched) watch.observer->blended(i, j, result.picture.at(i, j));
      if (!layers.empty()) result.nearest.at(i, j) = layers.back().triangle;
    }
  return result;
}

}  // namespace

AlphaBuffer alpha_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                         double opacity, TieRule ties) {
  return blended(mesh, view, samples, colours, opacity, ties, Unwatched{});
}

AlphaBuffer alpha_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, const std::vector<Colour>& colours,
                         double opacity, TieRule ties, AlphaBufferObserver& observer) {
  return blended(mesh, view, samples, colours, opacity, ties, Watched<AlphaBufferObserver>{&observer});
}

}  // namespace hsr::internal
