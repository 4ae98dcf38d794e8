#include "hsr/scene/input_noise.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <vector>

#include "geometry/bit_range.h"
#include "geometry/error.h"
#include "geometry/merge_points.h"
#include "geometry/parallel.h"
#include "geometry/predicates.h"
#include "geometry/vector3.h"
#include "hsr/scene/near_contact.h"
#include "hsr/scene/repeated_triangles.h"
#include "hsr/scene/space_tree.h"

namespace hsr::internal {

namespace {

constexpr std::size_t most_triangles = 200'000;

/// Whether all coordinates are whole multiples of a power of ten, as a file of so many decimals gives them.
bool has_decimals(const Mesh& mesh, double scale) {
  return std::all_of(mesh.points.begin(), mesh.points.end(), [&](const Point3& p) {
    return std::round(p.x * scale) / scale == p.x && std::round(p.y * scale) / scale == p.y &&
           std::round(p.z * scale) / scale == p.z;
  });
}

/// The digits of a number as a whole one, if it has no more than so many significant decimal digits; else 0.
double whole_digits(double x, int digits) {
  const int shift = digits - 1 - static_cast<int>(std::floor(std::log10(x)));
  if (std::abs(shift) > 22) return 0;  // a power of ten that is no double
  const double scale = std::pow(10, std::abs(shift));
  const double whole = std::round(shift >= 0 ? x * scale : x / scale);
  return (shift >= 0 ? whole / scale : whole * scale) == x ? whole : 0;
}

/// What the last of so many significant digits is worth in the largest coordinate, if "%g" (six) or "%e" (seven) may have written the
/// file: no coordinate has more, most of those that are not short have just so many, and in small ones the last is worth less by two
/// powers of ten or more, as in a file of so many decimals it never is. Else 0.
double unit_of_digits(const Mesh& mesh, double most, int digits) {
  std::size_t full = 0, partial = 0;
  for (const Point3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] == 0) continue;
      const double whole = whole_digits(std::fabs(p[axis]), digits);
      if (whole == 0) return 0;
      const bool is_full = std::fmod(whole, 10) != 0, is_short = std::fmod(whole, 1000) == 0;
      full += is_full ? 1U : 0U;
      partial += is_full || is_short ? 0U : 1U;
    }
  const double unit = std::pow(10, std::floor(std::log10(most)) + 1 - digits);
  return full > 2 * partial && !has_decimals(mesh, 10 / unit) ? unit : 0;
}

/// How far noise moves a coordinate: sixteen units in the last place of the largest one, of floats if all coordinates are floats; or
/// two of the last decimals that the file has, if these are five to nine; or two of the last of six or seven significant digits of
/// the largest one.
double noise_of_coordinates(const Mesh& mesh) {
  double most = 0;
  bool are_floats = true;
  for (const Point3& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis) {
      most = std::max(most, std::fabs(p[axis]));
      are_floats = are_floats && static_cast<double>(static_cast<float>(p[axis])) == p[axis];
    }
  const double in_last_place = 16 * std::ldexp(most, are_floats ? -23 : -52);
  if (are_floats) return in_last_place;
  for (const int digits : {6, 7})
    if (const double unit = unit_of_digits(mesh, most, digits); unit > 0) return std::max(in_last_place, 2 * unit);
  if (has_decimals(mesh, 1e4)) return in_last_place;
  for (const int digits : {5, 6, 7, 8, 9})
    if (has_decimals(mesh, std::pow(10, digits))) return std::max(in_last_place, 2 * std::pow(10, -digits));
  return in_last_place;
}

double largest_side(const Mesh& mesh) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Point3& p : mesh.points) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

/// With one digit, rounded up.
double one_digit(double x) {
  const double unit = std::pow(10.0, std::floor(std::log10(x)));
  return std::ceil(x / unit * (1 - 1e-12)) * unit;
}

/// How many edges of one face are two that would be one if points within the tolerance were.
std::size_t edges_that_close(const Mesh& mesh, double tolerance) {
  std::vector<EdgeId> open;
  std::vector<std::uint32_t> place(mesh.points.size(), 0xffffffffU);  // of a vertex among those of open edges
  IndexedVector<VertexId, Point3> points;
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const Edge& edge = mesh.edges[EdgeId(e)];
    if (!edge.of_face || mesh.triangles_at(EdgeId(e)).size() != 1) continue;
    open.emplace_back(e);
    for (const VertexId v : {edge.a, edge.b}) {
      if (place[v.value] != 0xffffffffU) continue;
      place[v.value] = static_cast<std::uint32_t>(points.size());
      points.push_back(mesh.points[v]);
    }
  }
  if (open.empty()) return 0;
  IndexedVector<VertexId, VertexId> merged = merge_points(points);
  try {
    merge_clusters(points, tolerance, merged);
  } catch (const InputError&) {
    return 0;  // details of the model are as small as the noise would be
  }
  std::vector<std::pair<VertexId, VertexId>> joined;
  for (const EdgeId e : open) {
    const auto end = [&](VertexId v) { return merged[VertexId(place[v.value])]; };
    joined.push_back(std::minmax(end(mesh.edges[e].a), end(mesh.edges[e].b)));
  }
  std::sort(joined.begin(), joined.end());
  std::size_t close = 0;
  for (std::size_t i = 0, j = 0; i < joined.size(); i = j) {
    while (j < joined.size() && joined[j] == joined[i]) ++j;
    if (j - i > 1) close += j - i;
  }
  return close;
}

/// Whether a tolerance is smaller than the details of the model.
bool can_be_merged(const Mesh& mesh, double tolerance) {
  IndexedVector<VertexId, VertexId> merged = mesh.merged;
  try {
    merge_clusters(mesh.points, tolerance, merged);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

struct Flat {
  Point3 at, normal;

  Flat(const Mesh& mesh, TriangleId t) : at(mesh.points[mesh.triangles[t][0]]) {
    const auto& c = mesh.triangles[t];
    normal = unit(cross(unit(minus(mesh.points[c[1]], at)), unit(minus(mesh.points[c[2]], at))));
  }
  /// How far the corners of a triangle are from the plane, at most.
  double farthest(const Mesh& mesh, TriangleId t) const {
    double most = 0;
    for (const VertexId v : mesh.triangles[t]) most = std::max(most, std::fabs(dot(minus(mesh.points[v], at), normal)));
    return most;
  }
};

/// Whether a corner of t is not in the plane of s, exactly.
bool is_off_plane(const Mesh& mesh, TriangleId s, TriangleId t, Predicates& exact) {
  const auto &c = mesh.triangles[s], &d = mesh.triangles[t];
  const Plane plane = Plane::of_face(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]);
  return std::any_of(d.begin(), d.end(), [&](VertexId v) { return exact.side(plane, mesh.points[v]) != Sign::zero; });
}

/// The height of a triangle over its longest side.
double least_height(const Mesh& mesh, TriangleId t) {
  const auto& c = mesh.triangles[t];
  const Point3 u = minus(mesh.points[c[1]], mesh.points[c[0]]), v = minus(mesh.points[c[2]], mesh.points[c[0]]),
               w = minus(v, u);
  const Point3 area = cross(u, v);
  return std::sqrt(dot(area, area) / std::max({dot(u, u), dot(v, v), dot(w, w)}));
}

/// Whether a side of one runs along the other for much more than the tolerance.
bool touch_along_a_line(const Mesh& mesh, TriangleId s, TriangleId t, double tolerance) {
  constexpr double much = 100;
  for (const auto& [flat, other] : {std::pair(s, t), std::pair(t, s)})
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& c = mesh.triangles[other];
      const Point3 &a = mesh.points[c[k]], &b = mesh.points[c[(k + 1) % 3]];
      const auto part = near_contact(mesh, flat, a, b, tolerance);
      const Point3 along = minus(b, a);
      if (part && (part->to - part->from) * std::sqrt(dot(along, along)) > much * tolerance) return true;
    }
  return false;
}

/// Which faces touch another nearly in one plane, and how far off it they are at most. Only such as are much larger than the noise: of
/// a fine mesh neighbours are as near to one plane.
std::size_t faces_in_near_planes(const Mesh& mesh, double tolerance, double& farthest) {
  const std::size_t n = mesh.triangles.size();
  if (n > most_triangles) return 0;
  constexpr double large = 1000;
  std::vector<std::uint8_t> is_large(n);
  const RepeatedTriangles repeated(mesh);
  parallel_for_each(n, [&](std::size_t t) {
    is_large[t] =
        repeated.first(TriangleId(t)) == TriangleId(t) && least_height(mesh, TriangleId(t)) > large * tolerance ? 1 : 0;
  });
  const BitRange bits = bit_range(mesh.points);
  std::vector<std::atomic<std::uint8_t>> is_near(n);
  std::atomic<double> most = 0;
  SpaceTree(mesh, tolerance).visit_pairs([&] {
    return [&, exact = Predicates(bits)](TriangleId s, TriangleId t) mutable {
      if (is_large[s.value] == 0 || is_large[t.value] == 0 || mesh.face_of[s] == mesh.face_of[t]) return;
      const auto& d = mesh.triangles[t];
      if (std::any_of(d.begin(), d.end(), [&](VertexId v) { return mesh.has_corner(s, v); })) return;
      const double off = std::max(Flat(mesh, s).farthest(mesh, t), Flat(mesh, t).farthest(mesh, s));
      if (off > tolerance || !is_off_plane(mesh, std::min(s, t), std::max(s, t), exact) ||
          !touch_along_a_line(mesh, std::min(s, t), std::max(s, t), tolerance))
        return;
      is_near[s.value].store(1, std::memory_order_relaxed);
      is_near[t.value].store(1, std::memory_order_relaxed);
      double seen = most.load(std::memory_order_relaxed);
      while (off > seen && !most.compare_exchange_weak(seen, off, std::memory_order_relaxed)) {
      }
    };
  });
  farthest = most;
  std::size_t faces = 0;
  for (std::size_t i = 0; i < n;) {
    const FaceId f = mesh.face_of[TriangleId(i)];
    bool is_one = false;
    for (; i < n && mesh.face_of[TriangleId(i)] == f; ++i)
      is_one = is_one || is_near[repeated.first(TriangleId(i)).value].load() != 0;
    faces += is_one ? 1U : 0U;
  }
  return faces;
}

}  // namespace

InputNoise noise_of(const Mesh& mesh) {
  const double small = noise_of_coordinates(mesh);
  // Far from the origin the last place may be as large as the model.
  if (!(small > 0) || !(small < 1e-3 * largest_side(mesh))) return {};
  InputNoise noise;
  double farthest = 0;
  noise.open_edges = edges_that_close(mesh, small);
  noise.near_planes = faces_in_near_planes(mesh, small, farthest);
  if (noise.open_edges > 0)
    noise.tolerance = one_digit(small);
  else if (noise.near_planes > 0)
    noise.tolerance = one_digit(std::max(4 * farthest, small));
  if (noise.tolerance > 0 && !can_be_merged(mesh, noise.tolerance)) return {};
  return noise;
}

}  // namespace hsr::internal
