#include "geometry/mesh_edges.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>
#include <utility>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

// What one triangle, or one segment, has to say about an edge, at its lower vertex: the upper vertex, the triangle, the role;
// in that order, so that sorted numbers are edges ascending and triangles ascending at each.
enum class Role : std::uint64_t { ring = 0, diagonal = 1, wire = 2, ghost = 3 };
constexpr std::uint64_t no_triangle = (1ULL << 30) - 1;

constexpr std::uint64_t entry(VertexId upper, std::uint64_t triangle, Role role) {
  return static_cast<std::uint64_t>(upper.value) << 32 | triangle << 2 | static_cast<std::uint64_t>(role);
}
VertexId upper_vertex(std::uint64_t e) { return VertexId(e >> 32); }
TriangleId triangle_of(std::uint64_t e) { return TriangleId(e >> 2 & no_triangle); }
Role role_of(std::uint64_t e) { return static_cast<Role>(e & 3); }
bool is_side(std::uint64_t e) { return role_of(e) == Role::ring || role_of(e) == Role::diagonal; }

using Segments = std::span<const std::array<std::uint32_t, 2>>;

template <class Visit>
void for_each_entry(const Mesh& mesh, const std::vector<std::uint8_t>& ring_sides, Segments segments, Segments edges_of_ghosts,
                    const Visit& visit) {
  const auto add = [&](VertexId a, VertexId b, std::uint64_t triangle, Role role) {
    if (b < a) std::swap(a, b);
    visit(a, entry(b, triangle, role));
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[TriangleId(t)];
    const unsigned ring = ring_sides[t];
    if (ring == 7) {
      add(a, b, t, Role::ring);
      add(b, c, t, Role::ring);
      add(c, a, t, Role::ring);
      continue;
    }
    const bool is_planar = mesh.faces[mesh.face_of[TriangleId(t)]] == FaceUse::planar;
    const auto add_side = [&](unsigned side, VertexId from, VertexId to) {
      if ((ring >> side & 1U) != 0)
        add(from, to, t, Role::ring);
      else if (!is_planar)
        add(from, to, t, Role::diagonal);
    };
    add_side(0, a, b);
    add_side(1, b, c);
    add_side(2, c, a);
  }
  const auto add_all = [&](Segments ends, Role role) {
    for (const auto& [from, to] : ends) {
      const VertexId a = mesh.merged[VertexId(from)], b = mesh.merged[VertexId(to)];
      if (a != b) add(a, b, no_triangle, role);
    }
  };
  add_all(segments, Role::wire);
  add_all(edges_of_ghosts, Role::ghost);
}

void sort_entries(std::uint64_t* first, std::uint64_t* last) {
  if (last - first > 24) {
    std::sort(first, last);
    return;
  }
  for (std::uint64_t* k = first; k != last; ++k) {
    const std::uint64_t e = *k;
    std::uint64_t* hole = k;
    for (; hole != first && hole[-1] > e; --hole) *hole = hole[-1];
    *hole = e;
  }
}

}  // namespace

void connect_edges(Mesh& mesh, const std::vector<std::uint8_t>& ring_sides, Segments segments, Segments edges_of_ghosts) {
  if (mesh.triangles.size() >= no_triangle)
    throw InputError("fewer than 2^30 - 1 triangles expected, found " + std::to_string(mesh.triangles.size()));
  const std::size_t vertices = mesh.points.size();
  // first[v + 1] counts, then is where the next entry of v goes, then the end of v's entries.
  std::vector<std::size_t> first(vertices + 2, 0);
  for_each_entry(mesh, ring_sides, segments, edges_of_ghosts, [&](VertexId a, std::uint64_t) { ++first[a.value + 2U]; });
  for (std::size_t v = 2; v < first.size(); ++v) first[v] += first[v - 1];
  check_countable(first.back(), "sides of triangles and segments");
  std::vector<std::uint64_t> entries(first.back());
  for_each_entry(mesh, ring_sides, segments, edges_of_ghosts,
                 [&](VertexId a, std::uint64_t e) { entries[first[a.value + 1U]++] = e; });

  // Blocks of vertices, each sorted and counted, then written where the counts before it say: the same for any number of
  // threads.
  constexpr std::size_t block = 4096;
  const std::size_t blocks = (vertices + block - 1) / block;
  struct Count {
    std::uint32_t edges = 0, sides = 0;
  };
  std::vector<Count> counts(blocks + 1);
  const auto for_each_block = [&](const auto& visit) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks, 1), [&](const auto& range) {
      for (std::size_t k = range.begin(); k != range.end(); ++k) visit(k, k * block, std::min(vertices, (k + 1) * block));
    });
  };
  for_each_block([&](std::size_t k, std::size_t from, std::size_t to) {
    Count count;
    for (std::size_t v = from; v < to; ++v) {
      std::uint64_t *begin = entries.data() + first[v], *end = entries.data() + first[v + 1];
      sort_entries(begin, end);
      for (const std::uint64_t* e = begin; e != end; ++e) {
        if (e == begin || upper_vertex(*e) != upper_vertex(e[-1])) ++count.edges;
        if (is_side(*e)) ++count.sides;
      }
    }
    counts[k + 1] = count;
  });
  for (std::size_t k = 1; k <= blocks; ++k) {
    counts[k].edges += counts[k - 1].edges;
    counts[k].sides += counts[k - 1].sides;
  }
  mesh.edges.resize(counts[blocks].edges);
  mesh.first_side.resize(counts[blocks].edges + 1U);
  mesh.sides.resize(counts[blocks].sides);
  for_each_block([&](std::size_t k, std::size_t from, std::size_t to) {
    std::uint32_t next_edge = counts[k].edges, next_side = counts[k].sides;
    for (std::size_t v = from; v < to; ++v) {
      for (std::size_t i = first[v]; i < first[v + 1];) {
        Edge edge{VertexId(v), upper_vertex(entries[i])};
        mesh.first_side[EdgeId(next_edge)] = next_side;
        for (; i < first[v + 1] && upper_vertex(entries[i]) == edge.b; ++i) {
          const Role role = role_of(entries[i]);
          edge.of_face |= role == Role::ring;
          edge.diagonal |= role == Role::diagonal;
          edge.wire |= role == Role::wire;
          edge.ghost |= role == Role::ghost;
          if (is_side(entries[i])) mesh.sides[next_side++] = triangle_of(entries[i]);
        }
        mesh.edges[EdgeId(next_edge++)] = edge;
      }
    }
  });
  mesh.first_side[EdgeId(mesh.edges.size())] = counts[blocks].sides;
}

}  // namespace hsr::internal
