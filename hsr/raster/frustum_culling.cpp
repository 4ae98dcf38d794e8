#include "hsr/raster/frustum_culling.h"

#include <algorithm>
#include <array>

#include "geometry/error_bounded.h"
#include "hsr/raster/sample_projection.h"

namespace hsr::internal {

namespace {

using namespace projection_numbers;
using Number = ErrorBounded;

/// A half-space; outside it nothing is drawn.
struct HalfSpace {
  Vector<Number> normal;
  Vector<Number> at;
  int number;      // CullingTest::side
  Number moved{};  // the value is normal . (p - at) - moved
  Number operator()(const Vector<Number>& p) const { return dot(normal, minus(p, at)) - moved; }
};

bool is_certainly_negative(const Number& x) { return x.is_certain() && x.value < 0; }

/// The sides of the picture and the near plane. A side that doubles cannot tell is left out.
std::vector<HalfSpace> frustum(const View& view, const SampleGrid& samples) {
  std::vector<HalfSpace> all;
  const Vector<Number> from = vector<Number>(view.viewpoint.at);
  const int w = samples.width, h = samples.height;
  const std::array<std::array<int, 2>, 4> corners = {{{-1, -1}, {w, -1}, {w, h}, {-1, h}}};
  const Vector<Number> middle = vector<Number>(samples.at(w / 2, h / 2));
  for (std::size_t k = 0; k < 4; ++k) {
    const auto corner = [&](std::size_t c) { return vector<Number>(samples.at(corners[c % 4][0], corners[c % 4][1])); };
    const Vector<Number> p = corner(k), q = corner(k + 1);
    HalfSpace side{view.is_perspective() ? cross(minus(p, from), minus(q, from)) : cross(minus(q, p), from), p,
                   static_cast<int>(k)};
    const Number inside = side(middle);
    if (!inside.is_certain()) continue;
    if (inside.value < 0) side.normal = times(Number{-1}, side.normal);
    all.push_back(side);
  }
  if (view.section) {
    all.push_back({vector<Number>(view.section->normal), vector<Number>(view.section->point), 4});
  } else if (view.is_perspective()) {
    const Vector<Number> to_target = minus(vector<Number>(view.target), from);
    all.push_back({to_target, from, 4, Number{view.near} * dot(to_target, to_target)});
  }
  return all;
}

struct Box {
  Point3 low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  void add(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

bool is_outside(const HalfSpace& half, const Box& box) {
  for (const double x : {box.low.x, box.high.x})
    for (const double y : {box.low.y, box.high.y})
      for (const double z : {box.low.z, box.high.z})
        if (!is_certainly_negative(half(vector<Number>(Point3{x, y, z})))) return false;
  return true;
}

/// The radius is not less than that of any corner, squared.
struct Sphere {
  Vector<Number> middle;
  Number squared_radius{};
};

/// Farther beyond the plane than the radius: v < 0 and v^2 > r^2 n.n
bool is_outside(const HalfSpace& half, const Sphere& sphere) {
  const Number v = half(sphere.middle);
  if (!is_certainly_negative(v)) return false;
  const Number farther = v * v - sphere.squared_radius * dot(half.normal, half.normal);
  return farther.is_certain() && farther.value > 0;
}

}  // namespace

Culled frustum_culled(const Mesh& mesh, const View& view, const SampleGrid& samples, const FrustumOptions& options,
                      CullingObserver* observer) {
  Culled result;
  const std::vector<HalfSpace> sides = frustum(view, samples);
  const std::size_t n = mesh.triangles.size();
  for (std::size_t first = 0; first < n; first += options.block) {
    const std::size_t end = std::min(n, first + options.block);
    const auto visit_corners = [&](const auto& visit) {
      for (std::size_t t = first; t < end; ++t)
        for (const VertexId v : mesh.triangles[TriangleId(t)]) visit(mesh.points[v]);
    };
    Box box;
    visit_corners([&](const Point3& p) { box.add(p); });
    ++result.tests;
    auto beyond = sides.end();
    if (options.bounds == Bounds::boxes) {
      beyond = std::find_if(sides.begin(), sides.end(), [&](const HalfSpace& s) { return is_outside(s, box); });
    } else {
      Sphere sphere{
          vector<Number>({box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2, box.low.z / 2 + box.high.z / 2})};
      visit_corners([&](const Point3& p) {
        const Vector<Number> away = minus(vector<Number>(p), sphere.middle);
        const Number squared = dot(away, away);
        if (!(squared.value + squared.error <= sphere.squared_radius.value + sphere.squared_radius.error))
          sphere.squared_radius = squared;
      });
      beyond = std::find_if(sides.begin(), sides.end(), [&](const HalfSpace& s) { return is_outside(s, sphere); });
    }
    const bool is_out = beyond != sides.end();
    if (observer != nullptr) observer->tested({first, end, is_out, 0, is_out ? beyond->number : -1});
    if (is_out)
      result.culled += end - first;
    else
      for (std::size_t t = first; t < end; ++t) result.kept.push_back(TriangleId(t));
  }
  return result;
}

}  // namespace hsr::internal
