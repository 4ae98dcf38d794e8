#include "hsr/check/fragment_check.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "hsr/facet.h"
#include "hsr/image/caster.h"
#include "hsr/image/rasterizer.h"
#include "hsr/sight.h"
#include "hsr/surfaces/map_sight.h"

namespace hsr {

namespace {

/// The spans of fragments. One object per block of them.
class FragmentSpans {
 public:
  FragmentSpans(const SampleSigns& signs, const VisibleFragments& all)
      : signs_(signs), all_(all), map_(signs.sight()), rasterizer_(signs) {}

  std::span<const SampleSpan> operator()(const Fragment& fragment) {
    sides_.clear();
    for (std::uint32_t r = fragment.first_ring; r < fragment.end_ring; ++r) {
      const auto ring = all_.ring(r);
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
  int rows_above(const MapPoint& p, TriangleId facet) {
    Predicates& exact = map_.exact();
    if (p.is_vertex) return signs_.rows_above(p.vertex, exact);
    const ViewPlane l = map_.plane(p.l), m = map_.plane(p.m);
    return signs_.rows_above(std::ceil(signs_.row_of(map_.point(p, facet).p)), [&](int j) {
      return exact.side(signs_.sight().camera(), ViewPlane::of(signs_.row_plane(j)), l, m);
    });
  }

  const SampleSigns& signs_;
  const VisibleFragments& all_;
  MapSight map_;
  Rasterizer rasterizer_;
  std::vector<RasterSide> sides_;
  std::vector<int> rows_;
};

}  // namespace

Image<TriangleId> paint(const Mesh& mesh, const View& view, const VisibleFragments& fragments, const SampleGrid& samples,
                        std::uint64_t& overlapping) {
  Image<TriangleId> image(samples.width, samples.height);
  overlapping = 0;
  if (fragments.fragments.empty()) return image;
  const Sight sight(mesh, view, Arithmetic::staged, samples.certificate());
  const SampleSigns signs(sight, samples);
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
        row[i] = fragments.fragments[part.fragment[s]].facet;
      }
    }
  return image;
}

FragmentCheck check_fragments(const Mesh& mesh, const View& view, const VisibleFragments& fragments,
                              const SampleGrid& samples) {
  FragmentCheck check;
  const Image<TriangleId> painted = paint(mesh, view, fragments, samples, check.overlapping);
  const CastImage seen = cast(mesh, view, samples);
  const auto facet = [&](TriangleId t) { return t.is_valid() ? facet_of(mesh, t) : t; };
  const auto face = [&](TriangleId t) { return t.is_valid() ? mesh.face_of[t] : FaceId(); };
  for (int j = 0; j < samples.height; ++j)
    for (int i = 0; i < samples.width; ++i) {
      const TriangleId p = painted.at(i, j), c = facet(seen.triangles.at(i, j));
      ++check.samples;
      if (c.is_valid()) ++check.covered;
      if (p == c) continue;
      ++check.wrong;
      if (check.first_wrong.size() < 10) check.first_wrong.push_back({i, j, face(p), face(c)});
    }
  return check;
}

}  // namespace hsr
