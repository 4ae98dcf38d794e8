#include "hsr/drawing/short_dashes.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hsr::internal {

namespace {

constexpr std::uint32_t several = 0xffffffffU;

/// One of the two ends of a short chain.
struct ChainEnd {
  std::uint32_t style;
  PaperPoint at;
  std::uint32_t object, chain;
};

bool is_shorter(const std::vector<PaperLine>& lines, std::span<const std::uint32_t> passes, double limit) {
  double length = 0;
  for (const std::uint32_t pass : passes) {
    const PaperLine& l = lines[pass / 2];
    length += std::hypot(static_cast<double>(l.to.x - l.from.x), static_cast<double>(l.to.y - l.from.y));
    if (length >= limit) return false;
  }
  return true;
}

PaperPoint start_of(const PaperLine& line, std::uint32_t pass) { return pass % 2 != 0 ? line.to : line.from; }

}  // namespace

bool share_short_dashes(std::vector<PaperLine>& lines, const Chains& chains,
                        const std::function<double(std::uint32_t)>& shortest) {
  std::vector<ChainEnd> ends;
  for (std::uint32_t c = 0; c < chains.passes.size(); ++c) {
    const auto passes = chains.passes[c];
    const PaperLine &first = lines[passes.front() / 2], &last = lines[passes.back() / 2];
    if (chains.closed[c] != 0 || first.object == several) continue;
    const double limit = shortest(first.style);
    if (!(limit > 0) || !is_shorter(lines, passes, limit)) continue;
    ends.push_back({first.style, start_of(first, passes.front()), first.object, c});
    ends.push_back({first.style, start_of(last, passes.back() ^ 1U), first.object, c});
  }
  std::sort(ends.begin(), ends.end(), [](const ChainEnd& a, const ChainEnd& b) {
    return std::tie(a.style, a.at, a.object, a.chain) < std::tie(b.style, b.at, b.object, b.chain);
  });
  bool any = false;
  for (std::size_t i = 0, j = 0; i < ends.size(); i = j) {
    while (j < ends.size() && ends[j].style == ends[i].style && ends[j].at == ends[i].at) ++j;
    if (ends[i].object == ends[j - 1].object) continue;
    any = true;
    for (std::size_t k = i; k < j; ++k)
      for (const std::uint32_t pass : chains.passes[ends[k].chain]) lines[pass / 2].object = several;
  }
  return any;
}

}  // namespace hsr::internal
