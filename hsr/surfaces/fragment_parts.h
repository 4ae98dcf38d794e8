#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "hsr/lines/line_progress.h"
#include "hsr/scene/facet.h"
#include "hsr/surfaces/rings.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/visibility_map/map_predicates.h"

namespace hsr::internal {

/// Appends the sides of a fragment, ring by ring.
inline void append_sides(const VisibleFragments& all, const Fragment& fragment, std::vector<MapSide>& sides) {
  for (std::uint32_t r = fragment.first_ring; r < fragment.end_ring; ++r) {
    const auto ring = all.rings[r];
    for (std::size_t k = 0; k < ring.size(); ++k)
      sides.push_back({ring[k].line, ring[k].reversed, ring[k].at, ring[(k + 1) % ring.size()].at});
  }
}

/// The fragments of neighbouring facets, as they come.
struct FragmentParts {
  VisibleFragments found;

  /// One of some that are linked.
  void add(const VisibleFragments& all, const Fragment& fragment) {
    const auto first = static_cast<std::uint32_t>(found.rings.size());
    for (std::uint32_t r = fragment.first_ring; r < fragment.end_ring; ++r) found.rings.push_row(all.rings[r]);
    found.fragments.push_back({fragment.facet, first, static_cast<std::uint32_t>(found.rings.size())});
  }
  void add(FacetId facet, const Rings& rings) {
    const auto base_ring = static_cast<std::uint32_t>(found.rings.size());
    found.rings.append(rings.rings);
    for (std::size_t k = 0; k + 1 < rings.first_ring.size(); ++k)
      found.fragments.push_back({facet, base_ring + rings.first_ring[k], base_ring + rings.first_ring[k + 1]});
  }
};

/// Calls find(worker, facet, parts) for each facet, in blocks in parallel, each with a worker of its own, and joins what they
/// find in the order of the facets.
template <class Make, class Find>
VisibleFragments fragments_in_blocks(const Mesh& mesh, const FragmentOptions& options, const Make& make, const Find& find) {
  constexpr std::size_t block = 256;
  const std::size_t n = mesh.triangles.size();
  std::vector<FragmentParts> parts((n + block - 1) / block);
  LineProgress progress(options.progress, options.stop, n);
  using Range = tbb::blocked_range<std::size_t>;
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      auto worker = make();
      const std::size_t begin = part * block, end = std::min(begin + block, n);
      for (std::size_t t = begin; t < end; ++t)
        if (is_first(mesh, TriangleId(t))) find(worker, FacetId(t), parts[part]);
      parts[part].found.decisions = worker.map().exact().counts();
      progress.advance(end - begin);
    }
  });
  VisibleFragments all;
  for (const FragmentParts& part : parts) {
    const VisibleFragments& found = part.found;
    const auto ring = static_cast<std::uint32_t>(all.rings.size());
    for (const Fragment& f : found.fragments) all.fragments.push_back({f.facet, ring + f.first_ring, ring + f.end_ring});
    all.rings.append(found.rings);
    all.decisions += found.decisions;
  }
  check_countable(all.rings.values().size(), "corners of fragments");
  return all;
}

}  // namespace hsr::internal
