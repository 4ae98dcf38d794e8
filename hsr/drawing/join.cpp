#include "hsr/drawing/join.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hsr::internal {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

// End 2 k is the start of line k, end 2 k + 1 its other end.
struct End {
  PaperPoint at;
  std::uint32_t style, object, end;
};

struct Direction {
  double x, y;
};

Direction leaving(const PaperLine& line, std::uint32_t end) {
  const PaperPoint &p = (end & 1U) == 0 ? line.from : line.to, &q = (end & 1U) == 0 ? line.to : line.from;
  const auto x = static_cast<double>(q.x - p.x), y = static_cast<double>(q.y - p.y), length = std::hypot(x, y);
  return {x / length, y / length};
}

constexpr std::size_t crowd = 32;  // beyond this many ends at a point not all pairs are weighed

void link_crossing(const std::vector<PaperLine>& lines, const End* ends, std::size_t n, std::vector<std::uint32_t>& partner) {
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < n; ++i) directions.push_back(leaving(lines[ends[i].end / 2], ends[i].end));
  if (n > crowd) {
    std::vector<std::size_t> around(n);
    for (std::size_t i = 0; i < n; ++i) around[i] = i;
    std::sort(around.begin(), around.end(), [&](std::size_t i, std::size_t j) {
      return std::make_pair(std::atan2(directions[i].y, directions[i].x), i) <
             std::make_pair(std::atan2(directions[j].y, directions[j].x), j);
    });
    for (std::size_t i = 0; i < n / 2; ++i) {
      const std::uint32_t p = ends[around[i]].end, q = ends[around[i + n / 2]].end;
      partner[p] = q;
      partner[q] = p;
    }
    return;
  }
  struct Pair {
    double cosine;  // -1: straight on
    std::size_t i, j;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      pairs.push_back({directions[i].x * directions[j].x + directions[i].y * directions[j].y, i, j});
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& a, const Pair& b) { return std::tie(a.cosine, a.i, a.j) < std::tie(b.cosine, b.i, b.j); });
  for (const Pair& pair : pairs) {
    const std::uint32_t p = ends[pair.i].end, q = ends[pair.j].end;
    if (partner[p] != none || partner[q] != none) continue;
    partner[p] = q;
    partner[q] = p;
  }
}

}  // namespace

Chains join(const std::vector<PaperLine>& lines) {
  std::vector<End> ends;
  ends.reserve(2 * lines.size());
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    ends.push_back({lines[k].from, lines[k].style, lines[k].object, 2 * k});
    ends.push_back({lines[k].to, lines[k].style, lines[k].object, 2 * k + 1});
  }
  tbb::parallel_sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return std::tie(a.style, a.object, a.at, a.end) < std::tie(b.style, b.object, b.at, b.end);
  });
  std::vector<std::uint32_t> partner(ends.size(), none);
  for (std::size_t i = 0, j = 0; i < ends.size(); i = j) {
    while (j < ends.size() && ends[j].style == ends[i].style && ends[j].object == ends[i].object && ends[j].at == ends[i].at)
      ++j;
    if (j - i == 2) {
      partner[ends[i].end] = ends[i + 1].end;
      partner[ends[i + 1].end] = ends[i].end;
    } else if (j - i > 2) {
      link_crossing(lines, &ends[i], j - i, partner);
    }
  }

  Chains chains;
  chains.passes.reserve(0, lines.size());
  std::vector<bool> used(lines.size(), false);
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    if (used[k]) continue;
    // Back from the start of line k to where the chain begins, or around to k again.
    std::uint32_t begin = 2 * k;
    while (partner[begin] != none && (partner[begin] ^ 1U) != 2 * k) begin = partner[begin] ^ 1U;
    const bool closed = partner[begin] != none;
    if (closed) begin = 2 * k;
    for (std::uint32_t end = begin; end != none && !used[end / 2]; end = partner[end ^ 1U]) {
      used[end / 2] = true;
      chains.passes.push_back(end);
    }
    chains.closed.push_back(closed ? 1 : 0);
    chains.passes.end_row();
  }
  return chains;
}

}  // namespace hsr::internal
