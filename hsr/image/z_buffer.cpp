#include "hsr/image/z_buffer.h"

#include "hsr/image/drawn_triangles.h"

namespace hsr {

namespace {

template <class Real>
void draw_triangle(DepthImage<Real>& image, TriangleId t, const Seen<Real>& a, const Seen<Real>& b, const Seen<Real>& c) {
  ScannedTriangle<Real> scanned;
  if (!scanned.set(a, b, c, image.width, image.height)) return;
  const Real step = scanned.step();
  for (int j = scanned.top(); j < scanned.bottom(); ++j) {
    const auto [begin, end] = scanned.span(j);
    DepthPixel<Real>* const row = image.row(j);
    Real nearness = scanned.nearness(begin, j);
    for (int i = begin; i < end; ++i, nearness += step)
      if (nearness > row[i].nearness) row[i] = {nearness, t};
  }
}

}  // namespace

template <class Real>
DepthImage<Real> z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples) {
  DepthImage<Real> image(samples.width, samples.height);
  const DrawnTriangles<Real> triangles(mesh, view, samples);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const TriangleId t(k);
    triangles.visit(t, [&](const auto& a, const auto& b, const auto& c) { draw_triangle(image, t, a, b, c); });
  }
  return image;
}

template DepthImage<float> z_buffer(const Mesh&, const View&, const SampleGrid&);
template DepthImage<double> z_buffer(const Mesh&, const View&, const SampleGrid&);

}  // namespace hsr
