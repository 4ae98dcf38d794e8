#include "hsr/drawing/short_chains.h"

#include <algorithm>
#include <cmath>

#include "geometry/disjoint_sets.h"

namespace hsr::internal {

std::vector<std::uint8_t> in_short_groups(const std::vector<PaperLine>& lines, const Chains& chains, double least) {
  struct Visit {
    PaperPoint at;
    std::uint32_t chain;
  };
  std::vector<Visit> visits;
  std::vector<double> length(chains.passes.size(), 0);
  for (std::uint32_t c = 0; c < chains.passes.size(); ++c)
    for (const std::uint32_t pass : chains.passes[c]) {
      const PaperLine& line = lines[pass / 2];
      for (const PaperPoint& p : {line.from, line.to}) visits.push_back({p, c});
      length[c] += std::hypot(static_cast<double>(line.to.x - line.from.x), static_cast<double>(line.to.y - line.from.y));
    }
  const auto place = [](const Visit& v) { return std::pair(v.at.x, v.at.y); };
  std::sort(visits.begin(), visits.end(), [&](const Visit& a, const Visit& b) { return place(a) < place(b); });
  DisjointSets groups(chains.passes.size());
  for (std::size_t k = 1; k < visits.size(); ++k)
    if (place(visits[k - 1]) == place(visits[k])) groups.join(visits[k - 1].chain, visits[k].chain);
  std::vector<double> of_group(chains.passes.size(), 0);
  for (std::uint32_t c = 0; c < chains.passes.size(); ++c) of_group[groups.find(c)] += length[c];
  std::vector<std::uint8_t> is_short(chains.passes.size(), 0);
  for (std::uint32_t c = 0; c < chains.passes.size(); ++c) is_short[c] = of_group[groups.find(c)] < least ? 1 : 0;
  return is_short;
}

}  // namespace hsr::internal
