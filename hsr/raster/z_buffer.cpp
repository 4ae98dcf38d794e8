#include "hsr/raster/z_buffer.h"

#include "hsr/raster/drawn_triangles.h"

namespace hsr {

using namespace internal;

namespace {

template <class Real>
class Drawer {
 public:
  Drawer(const Mesh& mesh, const View& view, const SampleGrid& samples)
      : triangles_(mesh, view, samples), image_(samples.width, samples.height) {}

  void operator()(TriangleId t) {
    triangles_.visit(t, [&](const auto& a, const auto& b, const auto& c) { draw(t, a, b, c); });
  }
  std::size_t size() const { return triangles_.size(); }
  DepthImage<Real> image() && { return std::move(image_); }

 private:
  void draw(TriangleId t, const Seen<Real>& a, const Seen<Real>& b, const Seen<Real>& c) {
    ScannedTriangle<Real> scanned;
    if (!scanned.set(a, b, c, image_.width, image_.height)) return;
    for (int j = scanned.top(); j < scanned.bottom(); ++j) {
      const auto [begin, end] = scanned.span(j);
      DepthPixel<Real>* const pixels = image_.row(j);
      const auto nearness_at = scanned.row(j);
      for (int i = begin; i < end; ++i) {
        const Real nearness = nearness_at(i);
        if (nearness > pixels[i].nearness) pixels[i] = {nearness, t};
      }
    }
  }

  DrawnTriangles<Real> triangles_;
  DepthImage<Real> image_;
};

}  // namespace

template <class Real>
DepthImage<Real> z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties) {
  Drawer<Real> draw(mesh, view, samples);
  for (std::size_t k = 0; k < draw.size(); ++k) draw(TriangleId(ties.from_top(k, draw.size())));
  return std::move(draw).image();
}

template <class Real>
DepthImage<Real> z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples, std::span<const TriangleId> triangles,
                          TieRule ties) {
  Drawer<Real> draw(mesh, view, samples);
  for (std::size_t k = 0; k < triangles.size(); ++k) draw(triangles[ties.from_top(k, triangles.size())]);
  return std::move(draw).image();
}

template DepthImage<float> z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
template DepthImage<double> z_buffer(const Mesh&, const View&, const SampleGrid&, TieRule);
template DepthImage<float> z_buffer(const Mesh&, const View&, const SampleGrid&, std::span<const TriangleId>, TieRule);
template DepthImage<double> z_buffer(const Mesh&, const View&, const SampleGrid&, std::span<const TriangleId>, TieRule);

}  // namespace hsr
