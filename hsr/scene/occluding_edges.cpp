#include "hsr/scene/occluding_edges.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "geometry/parallel.h"
#include "hsr/scene/line_filter.h"

namespace hsr::internal {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t block = 4096;

template <class T>
void store(T& place, T value) {
  std::atomic_ref<T>(place).store(value, std::memory_order_relaxed);
}

}  // namespace

OccludingEdges::OccludingEdges(const ProjectedMesh& projected, const std::vector<std::uint8_t>& left_out)
    : projected_(projected), left_out_(left_out) {
  choose_counted();
  weigh_edges();
  find_stars();
}

/// Marks the counted triangles, and the vertices around whose image lies exactly one layer of them, as far as triangles alone
/// can tell. A counted triangle lies to the right of its corner of middle height for just one of its turns; where each triangle
/// at a vertex turns certainly as its rounded image does, and no edge at the vertex has a weight, their number is that of the
/// layers around it: moving the images from the rounded to the exact places turns no triangle over.
void OccludingEdges::choose_counted() {
  const Mesh& mesh = projected_.mesh();
  counts_.resize(mesh.triangles.size());
  std::vector<std::uint8_t> to_the_right(mesh.points.size(), 0);  // 2: two or more
  is_plain_.assign(mesh.points.size(), 1);
  tbb::parallel_for(Range(0, mesh.triangles.size(), block), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const TriangleId t(i);
      counts_[t] = projected_.facing(t) != Sign::zero && !near_cuts_face(t) && !is_left_out(t) ? 1 : 0;
      if (counts_[t] == 0) continue;
      std::array<VertexId, 3> c = mesh.triangles[t];
      if (LineFilter(projected_, c[0], c[1]).certain_side(c[2]) == Sign::zero) {
        for (const VertexId v : c) store(is_plain_[v.value], std::uint8_t{0});
        continue;
      }
      if (projected_.facing(t) == Sign::negative) std::swap(c[1], c[2]);
      const auto is_lower = [&](VertexId v, VertexId w) {
        const double y = projected_.image(v).y, z = projected_.image(w).y;
        return y != z ? y < z : v < w;
      };
      for (std::size_t k = 0; k < 3; ++k)
        if (is_lower(c[(k + 1) % 3], c[k]) && is_lower(c[k], c[(k + 2) % 3])) {
          std::atomic_ref<std::uint8_t> count(to_the_right[c[k].value]);
          if (count.fetch_add(1, std::memory_order_relaxed) != 0) count.store(2, std::memory_order_relaxed);
        }
    }
  });
  tbb::parallel_for(Range(0, is_plain_.size(), block), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      if (to_the_right[i] != 1) is_plain_[i] = 0;
  });
}

/// Whether t, seen edge-on, has to be cast because of its side e: see layers.h. @pre no counted triangle is at e
bool OccludingEdges::needs_cast(TriangleId t, EdgeId e, Predicates& exact) const {
  const Mesh& mesh = projected_.mesh();
  const Edge& edge = mesh.edges[e];
  if (LineFilter(projected_, edge.a, edge.b).is_point(exact)) return false;
  // All of these triangles lie in the view plane of the edge; on which side of it, two coordinates tell.
  for (int axis = 0; axis < 3; ++axis) {
    const Plane line = Plane::along_axis(projected_.point(edge.a), projected_.point(edge.b), axis);
    const Sign side = exact.side(line, projected_.point(mesh.apex(t, edge)));
    if (side == Sign::zero) continue;
    const auto all = mesh.triangles_at(e);
    return std::none_of(all.begin(), all.end(), [&](TriangleId other) {
      return projected_.facing(other) == Sign::zero && exact.side(line, projected_.point(mesh.apex(other, edge))) == -side;
    });
  }
  return true;
}

/// The triangles of a planar face are counted or cast together: where two of them meet the mesh has no edge.
bool OccludingEdges::near_cuts_face(TriangleId t) const {
  if (!projected_.has_near()) return false;
  const Mesh& mesh = projected_.mesh();
  const FaceId f = mesh.face_of[t];
  for (std::uint32_t k = mesh.first_triangle[f]; k < mesh.first_triangle[FaceId(f.value + 1U)]; ++k)
    if (projected_.reaches_before_near(TriangleId(k))) return true;
  return false;
}

void OccludingEdges::weigh_edges() {
  const Mesh& mesh = projected_.mesh();
  edges_ = parallel_collect<OccludingEdge>(
      mesh.edges.size(), [&](std::size_t from, std::size_t to, std::vector<OccludingEdge>& part) {
        Predicates exact = projected_.predicates();
        for (std::size_t i = from; i < to; ++i) {
          const EdgeId e(i);
          const Edge& edge = mesh.edges[e];
          std::int32_t weight = 0;
          bool is_counted = false;
          for (const TriangleId t : mesh.triangles_at(e)) {
            if (!counts(t)) continue;
            is_counted = true;
            weight += static_cast<int>(projected_.side_of_edge(t, edge));
          }
          if (weight != 0) part.push_back({e, weight});
          // An edge between no counted triangles, such as a wire, may lie behind those at its ends.
          if (weight == 0 && (is_counted || LineFilter(projected_, edge.a, edge.b).is_point(exact))) continue;
          store(is_plain_[edge.a.value], std::uint8_t{0});
          store(is_plain_[edge.b.value], std::uint8_t{0});
        }
      });
  std::vector<ImageBox> boxes(edges_.size());
  tbb::parallel_for(Range(0, boxes.size(), block), [&](const Range& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Edge& edge = mesh.edges[edges_[i].edge];
      boxes[i] = projected_.box(edge.a, edge.b);
    }
  });
  tree_ = BoxTree(boxes);

  cast_ = parallel_collect<TriangleId>(mesh.edges.size(), [&](std::size_t from, std::size_t to, std::vector<TriangleId>& part) {
    Predicates exact = projected_.predicates();
    for (std::size_t i = from; i < to; ++i) {
      const auto all = mesh.triangles_at(EdgeId(i));
      if (std::any_of(all.begin(), all.end(),
                      [&](TriangleId t) { return counts(t) || (is_left_out(t) && projected_.facing(t) != Sign::zero); }))
        continue;
      for (const TriangleId t : all)
        if (projected_.facing(t) == Sign::zero && !near_cuts_face(t) && !is_left_out(t) && needs_cast(t, EdgeId(i), exact))
          part.push_back(t);
    }
  });
  if (projected_.has_near()) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (near_cuts_face(TriangleId(i)) && !is_left_out(TriangleId(i)) && projected_.reaches_beyond_near(TriangleId(i)))
        cast_.emplace_back(i);
  }
  std::sort(cast_.begin(), cast_.end());
  cast_.erase(std::unique(cast_.begin(), cast_.end()), cast_.end());
  boxes.resize(cast_.size());
  for (std::size_t i = 0; i < cast_.size(); ++i) boxes[i] = projected_.box(cast_[i]);
  cast_tree_ = BoxTree(boxes);
}

void OccludingEdges::find_stars() {
  struct Place {
    VertexId vertex;
    TriangleId triangle;
  };
  const Mesh& mesh = projected_.mesh();
  auto places = parallel_collect<Place>(mesh.triangles.size(), [&](std::size_t from, std::size_t to, std::vector<Place>& part) {
    for (std::size_t i = from; i < to; ++i) {
      if (!counts(TriangleId(i))) continue;
      for (const VertexId v : mesh.triangles[TriangleId(i)])
        if (!is_plain(v)) part.push_back({v, TriangleId(i)});
    }
  });
  stars_.assign(mesh.points.size(), [&](const auto& add) {
    for (const Place& p : places) add(p.vertex.value, p.triangle);
  });
}

}  // namespace hsr::internal
