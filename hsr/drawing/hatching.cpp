#include "hsr/drawing/hatching.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hsr::internal {

namespace {

constexpr double thousandths = 1000;

using Place = std::array<double, 2>;

}  // namespace

double thickness_of(const std::vector<std::vector<PaperPoint>>& rings) {
  double area = 0, length = 0;
  for (const auto& ring : rings)
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const PaperPoint &p = ring[k], &q = ring[(k + 1) % ring.size()];
      const double dx = static_cast<double>(q.x - p.x), dy = static_cast<double>(q.y - p.y);
      area += (static_cast<double>(p.x - ring[0].x) * dy - static_cast<double>(p.y - ring[0].y) * dx) / 2;
      length += std::hypot(dx, dy);
    }
  return length > 0 ? 2 * std::fabs(area) / length / thousandths : 0;
}

Hatch hatch_for(double thickness, double of_object, std::uint32_t style, double pen, double unit) {
  Hatch hatch;
  hatch.degrees = style % 2 == 0 ? 45 : 135;
  hatch.spacing = std::clamp(of_object / unit / 3, 1.0, 4.0) * (style / 2 % 2 == 0 ? 1 : 0.7);
  hatch.phase = style / 4 % 2 == 0 ? 0 : 0.5;
  if (thickness / unit < 0.7) hatch.spacing = pen;
  hatch.spacing *= unit;
  return hatch;
}

/// A sweep over the lines, each of which cuts an even number of sides, since a ring comes back to where it began.
std::vector<std::array<PaperPoint, 2>> hatch_lines(const std::vector<std::vector<PaperPoint>>& rings, const Hatch& hatch) {
  const double turn = hatch.degrees * (std::numbers::pi / 180), c = std::cos(turn), s = std::sin(turn);
  const double spacing = hatch.spacing * thousandths;
  // Along the lines, and across them; y of the paper runs down.
  const auto turned = [&](const PaperPoint& p) -> Place {
    const auto x = static_cast<double>(p.x), y = -static_cast<double>(p.y);
    return {c * x + s * y, c * y - s * x};
  };
  const auto back = [&](double along, double across) -> PaperPoint {
    return {std::llround(c * along - s * across), -std::llround(s * along + c * across)};
  };
  struct Crossing {
    std::int64_t line;
    double along;
  };
  std::vector<Crossing> crossings;
  for (const auto& ring : rings)
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Place p = turned(ring[k]), q = turned(ring[(k + 1) % ring.size()]);
      const auto share = [&](double across) { return across / spacing - hatch.phase; };
      const double low = std::min(p[1], q[1]), high = std::max(p[1], q[1]);
      for (auto line = static_cast<std::int64_t>(std::ceil(share(low))); static_cast<double>(line) < share(high); ++line) {
        const double across = (static_cast<double>(line) + hatch.phase) * spacing;
        crossings.push_back({line, p[0] + (across - p[1]) / (q[1] - p[1]) * (q[0] - p[0])});
      }
    }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.line != b.line ? a.line < b.line : a.along < b.along; });
  std::vector<std::array<PaperPoint, 2>> lines;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const double across = (static_cast<double>(crossings[k].line) + hatch.phase) * spacing;
    const std::array<PaperPoint, 2> line = {back(crossings[k].along, across), back(crossings[k + 1].along, across)};
    if (line[0] != line[1]) lines.push_back(line);
  }
  return lines;
}

}  // namespace hsr::internal
