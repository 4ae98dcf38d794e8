#include "hsr/drawing/image_lines.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "geometry/disjoint_sets.h"
#include "geometry/rational_vector.h"

namespace hsr::internal {

namespace {

// A line of the image is x = m y + c where it is steep, y = m x + c where it is not, |m| <= 1.
struct Candidate {
  std::uint64_t cell = 0;      // of m, and which of the two forms
  std::uint32_t position = 0;  // of the edge in `drawn`
  double low = 0, high = 0;    // bounds of c
};

struct Equation {
  bool steep = false, shallow = false;  // both where it is not known which: then the line is nearly at 45 degrees
  std::int64_t m_low[2] = {}, m_high[2] = {};
  double c_low[2] = {}, c_high[2] = {};
};

constexpr double cells = 0x1p30;    // of m for every unit of slope
constexpr double widest = 0x1p-20;  // mm of uncertainty of c that is left to enclosures

std::int64_t cell_of(long double m) { return static_cast<std::int64_t>(std::floor(m * static_cast<long double>(cells))); }

double below(long double x) { return std::nextafter(static_cast<double>(x), -HUGE_VAL); }
double above(long double x) { return std::nextafter(static_cast<double>(x), HUGE_VAL); }

/// The coefficients of the line through two image points: l[0] x + l[1] y + l[2] = 0.
template <class N, class P>
std::array<N, 3> line_through(const P& a, const P& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Fills in one form. @return false if the enclosures are too wide to be of use
bool fill(Equation& e, bool steep, const std::array<Enclosure, 3>& l) {
  const Enclosure m = steep ? -l[1] / l[0] : -l[0] / l[1], c = -l[2] / (steep ? l[0] : l[1]);
  if (!(std::fabs(m.middle) < 2) || !(m.error < 0.5L / static_cast<long double>(cells)) || !(c.error < widest)) return false;
  e.m_low[steep] = cell_of(m.low());
  e.m_high[steep] = cell_of(m.high());
  e.c_low[steep] = below(c.low());
  e.c_high[steep] = above(c.high());
  return true;
}

bool enclosed_equation(Equation& e, const HomogeneousPoint& a, const HomogeneousPoint& b) {
  using Triple = std::array<Enclosure, 3>;
  const auto l = line_through<Enclosure>(Triple{a.x, a.y, a.w}, Triple{b.x, b.y, b.w});
  const auto absolute = [](const Enclosure& x) { return x.middle < 0 ? -x : x; };
  const Enclosure x = absolute(l[0]), y = absolute(l[1]);
  e.steep = !certainly_less(x, y);
  e.shallow = !certainly_less(y, x);
  return (!e.steep || fill(e, true, l)) && (!e.shallow || fill(e, false, l));
}

/// The equation of a line in its one form, so that equal ones are one line.
struct ExactEquation {
  bool steep;
  Rational m, c;

  friend bool operator==(const ExactEquation& e, const ExactEquation& f) {
    return e.steep == f.steep && e.m == f.m && e.c == f.c;
  }
};

ExactEquation exact_equation(const std::array<std::array<Rational, 3>, 2>& ends) {
  const auto l = line_through<Rational>(ends[0], ends[1]);
  const auto absolute = [](const Rational& x) { return x.sign() == Sign::negative ? -x : x; };
  const bool steep = absolute(l[0]) >= absolute(l[1]);
  const Rational& divisor = steep ? l[0] : l[1];
  return {steep, -(steep ? l[1] : l[0]) / divisor, -l[2] / divisor};
}

void set(Equation& e, const ExactEquation& exact) {
  e.steep = exact.steep;
  e.shallow = !e.steep;
  const double m = exact.m.to_double(), c = exact.c.to_double();
  e.m_low[e.steep] = cell_of(below(m));
  e.m_high[e.steep] = cell_of(above(m));
  e.c_low[e.steep] = below(c);
  e.c_high[e.steep] = above(c);
}

bool on_one_image_line(const Mesh& mesh, const View& view, const Edge& e, const Edge& f, Predicates& predicates) {
  const Plane plane = Plane::of_sight(view.viewpoint, mesh.points[e.a], mesh.points[e.b]);
  const auto contains = [&](VertexId v) {
    return v == e.a || v == e.b || predicates.side(plane, mesh.points[v]) == Sign::zero;
  };
  return contains(f.a) && contains(f.b);
}

}  // namespace

ImageLines image_lines(const Projection& projection, const EndImages& at, const VisibleLines& lines,
                       std::span<const std::uint32_t> drawn, Predicates& predicates) {
  const Mesh& mesh = projection.mesh();
  const auto line_at = [&](std::uint32_t position) -> const Line& { return lines.lines[drawn[position]]; };
  const auto exact_ends = [&](std::uint32_t position) {
    const SupportingLine c = supporting_line_of(mesh, lines, line_at(position));
    if (c.is_edge()) return std::array{projection.exact(c.a), projection.exact(c.b)};
    const auto end = [&](const Cut& cut) {
      const auto p = projection.exact(c, cut);
      return std::array<Rational, 3>{p[0], p[1], 1.0};
    };
    return std::array{end(c.meet.from), end(c.meet.to)};
  };
  std::unordered_map<std::uint32_t, ExactEquation> exact;  // by position, of those that were asked for
  const auto exact_of = [&](std::uint32_t position) -> const ExactEquation& {
    const auto known = exact.find(position);
    return known != exact.end() ? known->second : exact.emplace(position, exact_equation(exact_ends(position))).first->second;
  };
  const auto on_one_line = [&](std::uint32_t i, std::uint32_t k) {
    const Line &x = line_at(i), &y = line_at(k);
    if (!x.is_intersection() && !y.is_intersection())
      return on_one_image_line(mesh, projection.view(), mesh.edges[x.edge], mesh.edges[y.edge], predicates);
    return exact_of(i) == exact_of(k);
  };
  std::vector<Equation> equations(drawn.size());
  tbb::parallel_for(
      tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(drawn.size()), 256), [&](const auto& range) {
        for (std::uint32_t i = range.begin(); i != range.end(); ++i) {
          const SupportingLine c = supporting_line_of(mesh, lines, line_at(i));
          if (c.is_edge() ? enclosed_equation(equations[i], at[c.a], at[c.b])
                          : enclosed_equation(equations[i], projection.at(c, c.meet.from), projection.at(c, c.meet.to)))
            continue;
          equations[i] = {};
          set(equations[i], exact_equation(exact_ends(i)));
        }
      });

  // Each edge stands in every cell that its slope may lie in (one, seldom two): edges on one line share a cell.
  std::vector<Candidate> candidates;
  candidates.reserve(drawn.size() + drawn.size() / 8);
  for (std::uint32_t i = 0; i < drawn.size(); ++i) {
    const Equation& e = equations[i];
    for (int steep = 0; steep < 2; ++steep) {
      if (!(steep != 0 ? e.steep : e.shallow)) continue;
      for (std::int64_t cell = e.m_low[steep]; cell <= e.m_high[steep]; ++cell)
        candidates.push_back(
            {static_cast<std::uint64_t>(cell + (std::int64_t{1} << 40)) * 2 + static_cast<std::uint64_t>(steep), i,
             e.c_low[steep], e.c_high[steep]});
    }
  }
  tbb::parallel_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cell, a.low, a.position) < std::tie(b.cell, b.low, b.position);
  });

  // Along ascending c, the lines seen so far whose c may still be met again.
  DisjointSets partition(drawn.size());
  std::vector<Candidate> open;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const Candidate& c = candidates[k];
    if (k > 0 && candidates[k - 1].cell != c.cell) open.clear();
    std::erase_if(open, [&](const Candidate& o) { return o.high < c.low; });
    bool found = false;
    for (const Candidate& o : open) {
      found = partition.find(o.position) == partition.find(c.position) || on_one_line(o.position, c.position);
      if (!found) continue;
      partition.join(o.position, c.position);
      break;
    }
    if (!found) open.push_back(c);
  }

  ImageLines result;
  const std::size_t n = drawn.size();
  std::vector<std::uint32_t> group(n);
  std::uint32_t groups = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t least = partition.find(i);  // it comes first
    group[i] = least == i ? groups++ : group[least];
  }
  Ragged<std::uint32_t> positions;
  positions.assign(groups, [&](const auto& add) {
    for (std::uint32_t i = 0; i < n; ++i) add(group[i], i);
  });
  result.members.assign(groups, [&](const auto& add) {
    for (std::uint32_t i = 0; i < n; ++i) add(group[i], drawn[i]);
  });
  for (const std::uint32_t i : positions.values()) result.steep.push_back(equations[i].steep ? 1 : 0);
  return result;
}

}  // namespace hsr::internal
