#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "hsr/check/sample_checks.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/rasterizer.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/view_parts.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr {

using namespace internal;

namespace {

/// The spans of fragments. One object per block of them.
class FragmentSpans {
 public:
  FragmentSpans(const SampleSigns& signs, const VisibleFragments& all)
      : signs_(signs), all_(all), map_(signs.projected()), rasterizer_(signs) {}

  std::span<const SampleSpan> operator()(const Fragment& fragment) {
    sides_.clear();
    for (std::uint32_t r = fragment.first_ring; r < fragment.end_ring; ++r) {
      const auto ring = all_.rings[r];
      rows_.clear();
      for (const MapCorner& c : ring) rows_.push_back(rows_above(c.at, fragment.facet));
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const auto [first, end] = std::minmax({rows_[k], rows_[(k + 1) % ring.size()]});
        if (first < end) sides_.push_back({map_.plane(ring[k].line), first, end});
      }
    }
    return rasterizer_.spans(sides_);
  }

 private:
  int rows_above(const MapPoint& p, FacetId facet) {
    Predicates& exact = map_.exact();
    if (p.is_vertex) return signs_.rows_above(p.vertex, exact);
    const ViewPlane l = map_.plane(p.l), m = map_.plane(p.m);
    return signs_.rows_above(std::ceil(signs_.row_of(map_.point(p, facet).p).value), [&](int j) {
      return exact.side(signs_.projected().camera(), ViewPlane::of(signs_.row_plane(j)), l, m);
    });
  }

  const SampleSigns& signs_;
  const VisibleFragments& all_;
  MapPredicates map_;
  Rasterizer rasterizer_;
  std::vector<RasterSide> sides_;
  std::vector<int> rows_;
};

}  // namespace

namespace {

/// Whether every corner of a fragment is in front of the eye as the samples are. Nearly always: only where the samples had to
/// be placed far off the view's frame, or right beside the eye, is it not.
bool all_in_front(const SampleSigns& signs, const VisibleFragments& all) {
  const ProjectedMesh& projected = signs.projected();
  if (!projected.is_perspective()) return true;
  const Mesh& mesh = projected.mesh();
  Predicates exact = projected.predicates();
  bool reaches_near = false;
  std::vector<std::uint8_t> is_used(mesh.points.size(), 0);
  for (const Fragment& f : all.fragments)
    for (TriangleId t = first_triangle(f.facet); t < facet_end(mesh, f.facet); t = TriangleId(t.value + 1U)) {
      reaches_near = reaches_near || projected.reaches_before_near(t);
      for (const VertexId v : mesh.triangles[t]) is_used[v.value] = 1;
    }
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0 && projected.beyond_near(VertexId(v)) != Sign::negative && !signs.is_in_front(VertexId(v), exact))
      return false;
  if (!reaches_near) return true;
  // What the near plane cuts off has corners of its own.
  const MapPredicates map(projected);
  const auto is_in_front = [&](const MapPoint& p, FacetId facet) {
    const Sign certain = signs.certain_front(map.point(p, facet));
    if (certain != Sign::zero) return certain == Sign::positive;
    return signs.is_in_front(exact_point(projected.camera(), map.plane(p.l), map.plane(p.m), projected.face_plane(facet)));
  };
  for (const Fragment& f : all.fragments)
    for (std::uint32_t r = f.first_ring; r < f.end_ring; ++r)
      for (const MapCorner& c : all.rings[r])
        if (!c.at.is_vertex && !is_in_front(c.at, f.facet)) return false;
  return true;
}

}  // namespace

Image<TriangleId> paint(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples,
                        std::uint64_t& overlapping) {
  Image<TriangleId> image(samples.width, samples.height);
  overlapping = 0;
  if (fragments.fragments.empty()) return image;
  const ProjectedMesh& projected = scene.parts().with(samples.bit_range()).projected();
  const SampleSigns signs(projected, samples);
  require(all_in_front(signs, fragments), "paint: a part of the model is not in front of the eye as the samples are");
  constexpr std::size_t block = 1024;
  const std::size_t n = fragments.fragments.size();
  struct Part {
    std::vector<SampleSpan> spans;
    std::vector<std::uint32_t> fragment;  // of each span
  };
  std::vector<Part> parts((n + block - 1) / block);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    FragmentSpans spans_of(signs, fragments);
    for (std::size_t k = p * block; k < std::min((p + 1) * block, n); ++k)
      for (const SampleSpan& span : spans_of(fragments.fragments[k])) {
        parts[p].spans.push_back(span);
        parts[p].fragment.push_back(static_cast<std::uint32_t>(k));
      }
  });
  for (const Part& part : parts)
    for (std::size_t s = 0; s < part.spans.size(); ++s) {
      const SampleSpan& span = part.spans[s];
      TriangleId* row = image.row(span.row);
      for (int i = span.begin; i < span.end; ++i) {
        if (row[i].is_valid()) ++overlapping;
        row[i] = first_triangle(fragments.fragments[part.fragment[s]].facet);
      }
    }
  return image;
}

FragmentCheck check_fragments(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples) {
  return check_fragments(scene, fragments, samples, cast(scene, samples).triangles);
}

FragmentCheck check_fragments(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples,
                              const Image<TriangleId>& nearest) {
  const Mesh& mesh = scene.mesh();
  FragmentCheck check;
  const Image<TriangleId> painted = paint(scene, fragments, samples, check.overlapping);
  const auto facet = [&](TriangleId t) { return t.is_valid() ? facet_of(mesh, t) : FacetId(); };
  const auto face = [&](TriangleId t) { return t.is_valid() ? mesh.face_of[t] : FaceId(); };
  for (int j = 0; j < samples.height; ++j)
    for (int i = 0; i < samples.width; ++i) {
      const TriangleId p = painted.at(i, j), c = nearest.at(i, j);
      ++check.samples;
      if (c.is_valid()) ++check.covered;
      if (facet(p) == facet(c)) continue;
      ++check.wrong;
      if (check.first_wrong.size() < 10) check.first_wrong.push_back({i, j, face(p), face(c)});
    }
  return check;
}

}  // namespace hsr
