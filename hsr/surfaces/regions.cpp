#include "hsr/surfaces/regions.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"
#include "hsr/surfaces/fragment_parts.h"
#include "hsr/surfaces/rings.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr {

using namespace internal;

namespace {

/// For each fragment the group that it is united with: a facet, or the number of its colour.
std::vector<std::uint32_t> groups_of(MapPredicates& map, const VisibleFragments& fragments, const std::vector<Colour>& colours,
                                     Merge merge) {
  const Mesh& mesh = map.mesh();
  std::vector<std::uint32_t> group;
  if (merge == Merge::colour) {
    std::map<Colour, std::uint32_t> number;
    for (const Fragment& f : fragments.fragments)
      group.push_back(number.emplace(colours[mesh.face_of[first_triangle(f.facet)].value], number.size()).first->second);
    return group;
  }
  // Any two facets in one plane whose boxes touch: they need not share an edge of the mesh.
  std::vector<FacetId> facets;
  std::vector<ImageBox> boxes;
  for (const Fragment& f : fragments.fragments) {
    if (!facets.empty() && facets.back() == f.facet) continue;
    facets.push_back(f.facet);
    boxes.push_back(ImageBox::nothing());
    for (TriangleId t = first_triangle(f.facet); t < facet_end(mesh, f.facet); t = TriangleId(t.value + 1U))
      boxes.back().add(map.projected().box(t));
  }
  DisjointSets same(mesh.triangles.size());
  const BoxTree tree(boxes);
  BoxTree::PairSearch search;
  const auto colour_of = [&](FacetId facet) { return colours[mesh.face_of[first_triangle(facet)].value]; };
  for (std::uint32_t leaf = 0; leaf < tree.leaf_count(); ++leaf)
    tree.visit_pairs(leaf, search, [&](std::uint32_t i, std::uint32_t k) {
      const FacetId s = facets[i], t = facets[k];
      if (colour_of(s) == colour_of(t) && same.find(s.value) != same.find(t.value) && map.coplanar(s, t))
        same.join(s.value, t.value);
    });
  for (const Fragment& f : fragments.fragments) group.push_back(same.find(f.facet.value));
  return group;
}

/// Of each region that fragments make together, the faces that they belong to.
std::vector<std::vector<std::uint32_t>> faces_of_regions(const Mesh& mesh, const VisibleFragments& fragments,
                                                         std::span<const std::uint32_t> group, const Rings& rings) {
  std::map<std::uint32_t, std::size_t> region_of;  // its owner
  for (std::size_t r = 0; r < rings.owner_of_region.size(); ++r) region_of[rings.owner_of_region[r]] = r;
  std::vector<std::vector<std::uint32_t>> faces(rings.owner_of_region.size());
  for (std::size_t k = 0; k < group.size(); ++k)
    faces[region_of.at(rings.region_owner[k])].push_back(
        mesh.face_of[first_triangle(fragments.fragments[group[k]].facet)].value);
  for (std::vector<std::uint32_t>& of : faces) {
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
  }
  return faces;
}

/// In the order of the first fragment of each: which facets were looked at together, as their boxes touch, makes no difference.
/// @param first_fragment by region
Regions in_order(Regions all, const std::vector<std::uint32_t>& first_fragment) {
  std::vector<std::uint32_t> order(all.regions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return first_fragment[i] < first_fragment[j]; });
  Regions sorted;
  for (const std::uint32_t k : order) {
    Region& region = sorted.regions.emplace_back(std::move(all.regions[k]));
    const std::uint32_t begin = region.first_ring, end = region.end_ring;
    region.first_ring = static_cast<std::uint32_t>(sorted.rings.size());
    for (std::uint32_t r = begin; r < end; ++r) sorted.rings.push_row(all.rings[r]);
    region.end_ring = static_cast<std::uint32_t>(sorted.rings.size());
  }
  return sorted;
}

}  // namespace

Regions regions_of(const SceneView& scene, const VisibleFragments& fragments, const std::vector<Colour>& colours, Merge merge) {
  const Mesh& mesh = scene.mesh();
  Regions out;
  if (fragments.fragments.empty()) return out;
  const auto colour_of = [&](const Fragment& f) { return colours[mesh.face_of[first_triangle(f.facet)].value]; };
  if (merge == Merge::none) {
    out.rings = fragments.rings;
    for (const Fragment& f : fragments.fragments)
      out.regions.push_back({colour_of(f), f.facet, {mesh.face_of[first_triangle(f.facet)].value}, f.first_ring, f.end_ring});
    return out;
  }
  MapPredicates map(scene.parts().projected());
  const std::vector<std::uint32_t> group = groups_of(map, fragments, colours, merge);
  std::vector<std::uint32_t> order(group.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return group[i] < group[j]; });
  std::vector<std::uint32_t> first_fragment;  // by region
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    std::vector<MapSide> sides;
    std::vector<std::uint32_t> owners;
    for (; end < order.size() && group[order[end]] == group[order[i]]; ++end) {
      append_sides(fragments, fragments.fragments[order[end]], sides);
      owners.resize(sides.size(), static_cast<std::uint32_t>(end - i));
    }
    const Rings rings = link_rings(map, sides, owners);
    const auto base = static_cast<std::uint32_t>(out.rings.size());
    out.rings.append(rings.rings);
    std::vector<std::vector<std::uint32_t>> faces =
        faces_of_regions(mesh, fragments, std::span(order).subspan(i, end - i), rings);
    for (std::size_t k = 0; k < faces.size(); ++k) {
      first_fragment.push_back(order[i + rings.owner_of_region[k]]);
      const Fragment& first = fragments.fragments[first_fragment.back()];
      out.regions.push_back(
          {colour_of(first), first.facet, std::move(faces[k]), base + rings.first_ring[k], base + rings.first_ring[k + 1]});
    }
  }
  return merge == Merge::coplanar ? in_order(std::move(out), first_fragment) : out;
}

}  // namespace hsr
