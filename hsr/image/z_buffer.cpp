#include "hsr/image/z_buffer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "hsr/image/scanned_triangle.h"

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

enum : std::uint8_t { drawn = 0, cut_away = 1, out_of_range = 2 };

}  // namespace

template <class Real>
DepthImage<Real> z_buffer(const Mesh& mesh, const View& view, const SampleGrid& samples) {
  using Scanned = ScannedTriangle<Real>;
  DepthImage<Real> image(samples.width, samples.height);
  const Projection<double> project(view, samples);
  const auto rounded = [](const Seen<double>& s) {
    return Seen<Real>{static_cast<Real>(s.x), static_cast<Real>(s.y), static_cast<Real>(s.nearness)};
  };
  std::vector<Seen<Real>> points(mesh.points.size());
  std::vector<std::uint8_t> state;  // by vertex; empty: all are drawn
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Point3& p = mesh.points[VertexId(v)];
    points[v] = rounded(project(p));
    const std::uint8_t s = view.is_perspective() && is_before_near(view, p) ? cut_away
                           : Scanned::is_drawable(points[v])                ? drawn
                                                                            : out_of_range;
    if (s == drawn) continue;
    state.resize(points.size(), drawn);
    state[v] = s;
  }

  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const TriangleId t(k);
    const auto& [a, b, c] = mesh.triangles[t];
    if (state.empty() || (state[a.value] | state[b.value] | state[c.value]) == drawn) {
      draw_triangle(image, t, points[a.value], points[b.value], points[c.value]);
      continue;
    }
    std::array<Seen<double>, 4> left;
    const int corners = seen_corners<double>(
        mesh, view, project, t, [&](VertexId v) { return state[v.value] == cut_away; },
        [&](VertexId v) { return project(mesh.points[v]); }, left);
    std::array<Seen<Real>, 4> seen;
    std::transform(left.begin(), left.end(), seen.begin(), rounded);
    if (!std::all_of(seen.begin(), seen.begin() + corners, Scanned::is_drawable)) continue;
    for (int m = 2; m < corners; ++m) draw_triangle(image, t, seen[0], seen[m - 1], seen[m]);
  }
  return image;
}

template DepthImage<float> z_buffer(const Mesh&, const View&, const SampleGrid&);
template DepthImage<double> z_buffer(const Mesh&, const View&, const SampleGrid&);

}  // namespace hsr
