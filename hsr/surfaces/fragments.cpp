#include <tbb/parallel_for.h>

#include "hsr/surfaces/visible_fragments.h"
#include "hsr/symbols/constructions.h"

namespace hsr {

std::vector<Rational> visible_areas(const Mesh& mesh, const View& view, const VisibleFragments& fragments) {
  std::vector<Rational> areas(fragments.fragments.size());
  const PaperImage image(view);
  tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t k) {
    const Fragment& f = fragments.fragments[k];
    Rational twice;
    for (std::uint32_t ring = f.first_ring; ring < f.end_ring; ++ring) {
      std::vector<std::array<Rational, 2>> at;
      for (const MapCorner& c : fragments.rings[ring]) {
        at.push_back(image(exact_point(mesh, view, f.facet, c.at)));
      }
      for (std::size_t i = 0; i < at.size(); ++i) {
        const auto &p = at[i], &q = at[(i + 1) % at.size()];
        twice = twice + (p[0] * q[1] - p[1] * q[0]);
      }
    }
    areas[k] = twice / Rational(2.0);
  });
  return areas;
}

}  // namespace hsr
