#include "hsr/cli/split_model.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/bit_range.h"
#include "geometry/merge_points.h"
#include "geometry/vector3.h"

namespace hsr::cli {

namespace {

/// The points of the model that reach farthest along each axis: least and greatest.
class Extremes {
 public:
  explicit Extremes(const std::vector<Point3>& points) : points_(points) {}
  void add(std::uint32_t v) {
    for (int axis = 0; axis < 3; ++axis) {
      std::uint32_t &low = at_[2 * static_cast<std::size_t>(axis)], &high = at_[2 * static_cast<std::size_t>(axis) + 1];
      if (low == none || points_[v][axis] < points_[low][axis]) low = v;
      if (high == none || points_[v][axis] > points_[high][axis]) high = v;
    }
  }
  std::vector<Point3> found() const {
    std::vector<Point3> all;
    for (const std::uint32_t v : at_)
      if (v != none) all.push_back(points_[v]);
    return all;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  const std::vector<Point3>& points_;
  std::array<std::uint32_t, 6> at_ = {none, none, none, none, none, none};
};

/// Whether doubles tell that a triangle has an area: far beyond what is rounded.
bool has_certain_area(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 p = minus(b, a), q = minus(c, a), n = cross(p, q);
  const double size = std::max({norm_max(a), norm_max(b), norm_max(c)});
  return norm_max(n) > 0x1p-40 * size * size && std::isfinite(norm_max(n)) && size > 0x1p-400;
}

/// Those of some faces that a mesh has: not those without an area.
void add_edges_of(const Model& model, const std::vector<std::uint32_t>& faces, Extremes& extremes) {
  std::vector<Point3> points;
  std::vector<std::uint32_t> number;
  Polygons polygons;
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t c : model.polygons[f]) {
      polygons.corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(model.points[c]);
      number.push_back(c);
    }
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  const Mesh mesh = make_mesh(std::move(points), polygons);
  for (const Edge& e : mesh.edges) {
    extremes.add(number[e.a.value]);
    extremes.add(number[e.b.value]);
  }
}

constexpr std::size_t block = 65536;

}  // namespace

void name_merged_points(Model& model) {
  for (Point3& p : model.points) p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
  IndexedVector<VertexId, Point3> points;
  static_cast<std::vector<Point3>&>(points).swap(model.points);
  const auto merged = merge_points(points);
  static_cast<std::vector<Point3>&>(points).swap(model.points);
  for (std::uint32_t& c : model.polygons.corners) c = merged[VertexId(c)].value;
  for (auto& wire : model.polygons.segments)
    for (std::uint32_t& end : wire) end = merged[VertexId(end)].value;
}

Mesh bounding_mesh(const Model& model) {
  Extremes extremes(model.points);
  std::vector<std::uint32_t> unsure;
  const Polygons& polygons = model.polygons;
  for (std::uint32_t f = 0; f < polygons.size(); ++f) {
    const auto c = polygons[f];
    if (c.size() == 3 && has_certain_area(model.points[c[0]], model.points[c[1]], model.points[c[2]]))
      for (const std::uint32_t v : c) extremes.add(v);
    else if (!c.empty())
      unsure.push_back(f);
    if (unsure.size() == block || (f + 1 == polygons.size() && !unsure.empty())) {
      add_edges_of(model, unsure, extremes);
      unsure.clear();
    }
  }
  for (const auto& [a, b] : polygons.segments)
    if (!(model.points[a] == model.points[b])) {
      extremes.add(a);
      extremes.add(b);
    }
  std::vector<Point3> points = extremes.found();
  Polygons wires;
  for (std::uint32_t k = 0; k + 1 < points.size(); ++k) wires.segments.push_back({k, k + 1});
  return make_mesh(std::move(points), wires);
}

ImageTiles tiles_of(const Model& model, const View& view, std::uint32_t count) {
  constexpr std::size_t most = 500000;
  const std::size_t faces = model.polygons.size(), step = faces / most + 1;
  std::vector<Point2> places;
  for (std::size_t f = 0; f < faces; f += step) {
    const auto corners = model.polygons[f];
    if (corners.empty()) continue;
    Point3 middle;
    for (const std::uint32_t c : corners) middle = sum(middle, 1.0 / static_cast<double>(corners.size()), model.points[c]);
    places.push_back(place_in_frame(view, middle));
  }
  for (const auto& [a, b] : model.polygons.segments) places.push_back(place_in_frame(view, model.points[a]));
  return balanced_tiles(view, std::move(places), count);
}

TileContents contents_of_tiles(const Model& model, const View& view, const ImageTiles& tiles) {
  struct Found {
    std::uint32_t tile, face;
  };
  const BitRange bits = bit_range(model.points);
  TileContents all;
  all.faces.resize(tiles.count());
  all.segments.resize(tiles.count());
  const std::size_t faces = model.polygons.size();
  constexpr std::size_t blocks_at_once = 64;
  std::vector<std::vector<Found>> found(blocks_at_once);
  for (std::size_t first = 0; first < faces; first += blocks_at_once * block) {
    tbb::parallel_for(std::size_t{0}, blocks_at_once, [&](std::size_t b) {
      found[b].clear();
      TileFinder finder(tiles, view, bits);
      std::vector<Point3> corners;
      std::vector<std::uint32_t> of_face;
      for (std::size_t f = first + b * block; f < std::min(faces, first + (b + 1) * block); ++f) {
        corners.clear();
        for (const std::uint32_t c : model.polygons[f]) corners.push_back(model.points[c]);
        if (corners.empty()) continue;
        of_face.clear();
        finder.find(corners, of_face);
        for (const std::uint32_t t : of_face) found[b].push_back({t, static_cast<std::uint32_t>(f)});
      }
    });
    for (const auto& some : found)
      for (const Found& f : some) all.faces[f.tile].add(f.face);
  }
  TileFinder finder(tiles, view, bits);
  std::vector<std::uint32_t> of_segment;
  for (std::uint32_t s = 0; s < model.polygons.segments.size(); ++s) {
    const auto [a, b] = model.polygons.segments[s];
    of_segment.clear();
    finder.find(std::array{model.points[a], model.points[b]}, of_segment);
    for (const std::uint32_t t : of_segment) all.segments[t].add(s);
  }
  return all;
}

}  // namespace hsr::cli
