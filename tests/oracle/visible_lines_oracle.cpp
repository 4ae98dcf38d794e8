#include "tests/oracle/visible_lines_oracle.h"

#include <algorithm>
#include <optional>

namespace hsr::oracle {

namespace {

// Where a function that is linear along the edge, f at its start and g at its end, is zero.
void add_root(const Q& f, const Q& g, std::vector<Q>& roots) {
  if (f != g) roots.emplace_back(f / (f - g));
}

std::vector<Interval> rest_of(const Interval& whole, const std::vector<Interval>& parts) {
  std::vector<Interval> out;
  Q from = whole.from;
  for (const Interval& part : parts) {
    if (from < part.from) out.push_back({from, part.from});
    from = part.to;
  }
  if (from < whole.to) out.push_back({from, whole.to});
  return out;
}

}  // namespace

std::vector<Interval> united(std::vector<Interval> in) {
  std::sort(in.begin(), in.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  std::vector<Interval> out;
  for (Interval& i : in) {
    if (!out.empty() && i.from <= out.back().to) {
      if (out.back().to < i.to) out.back().to = i.to;
    } else {
      out.push_back(std::move(i));
    }
  }
  return out;
}

VisibleLinesOracle::VisibleLinesOracle(const Mesh& mesh, const View& view)
    : mesh_(mesh),
      parallel_(view.viewpoint.is_direction),
      eye_(view.viewpoint.at),
      cuts_(!parallel_ || view.section),
      is_section_(view.section.has_value()) {
  if (is_section_) {
    section_at_ = Vec(view.section->point);
    section_normal_ = Vec(view.section->normal);
    eye_to_near_ = parallel_ ? Q(-dot(section_normal_, eye_)) : Q(-dot(section_normal_, eye_ - section_at_));
  } else if (!parallel_) {
    axis_ = Vec(view.target) - eye_;
    eye_to_near_ = Q(view.near) * dot(axis_, axis_);
  }
  triangles_.reserve(mesh.triangles.size());
  for (const auto& vertices : mesh.triangles) triangles_.push_back(triangle_of(vertices));
}

Q VisibleLinesOracle::depth(const Vec& p) const {
  if (is_section_) return dot(p - section_at_, section_normal_);
  if (parallel_) return 1;
  return dot(p - eye_, axis_) - eye_to_near_;
}

Vec VisibleLinesOracle::to_eye(const Vec& p) const { return parallel_ ? eye_ : eye_ - p; }

VisibleLinesOracle::Triangle VisibleLinesOracle::triangle_of(const std::array<VertexId, 3>& vertices) const {
  Triangle t;
  for (std::size_t i = 0; i < 3; ++i) t.corners[i] = Vec(mesh_.points[vertices[i]]);
  t.normal = cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
  t.edge_on = sgn(dot(t.normal, to_eye(t.corners[0]))) == 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec &a = t.corners[i], &b = t.corners[(i + 1) % 3];
    t.inward[i] = cross(t.normal, b - a);
    const Q da = depth(a), db = depth(b);
    if (sgn(da) >= 0) t.corners_beyond.push_back(a);
    if (sgn(da) * sgn(db) < 0) t.corners_beyond.push_back(a + Q(da / (da - db)) * (b - a));
  }
  const auto add_sides_of = [&](const auto& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec &a = corners[i], &b = corners[(i + 1) % corners.size()];
      t.outline.push_back({a, parallel_ ? cross(b - a, eye_) : cross(a - eye_, b - eye_)});
    }
  };
  // The whole triangle's sides too: where only a side or a corner touches the near plane they bound what is left of it.
  add_sides_of(t.corners);
  if (cuts_) add_sides_of(t.corners_beyond);
  return t;
}

bool VisibleLinesOracle::hides(TriangleId triangle, const Vec& p) const { return hides(triangles_[triangle.value], p); }

// The points p + s d, 0 < s (and s <= reach, where the segment leaves the near plane toward the eye), against the triangle.
bool VisibleLinesOracle::hides(const Triangle& t, const Vec& p) const {
  const Vec d = to_eye(p);
  std::optional<Q> reach;
  if (cuts_) {
    const Q here = depth(p);
    reach = parallel_ ? Q(here / eye_to_near_) : Q(here / (here + eye_to_near_));
  }
  const Q rise = dot(t.normal, d);
  const Q height = dot(t.normal, t.corners[0] - p);
  if (sgn(rise) != 0) {
    const Q s = height / rise;
    if (sgn(s) <= 0 || (reach && s > *reach)) return false;
    const Vec q = p + s * d;
    for (std::size_t i = 0; i < 3; ++i)
      if (sgn(dot(t.inward[i], q - t.corners[i])) < 0) return false;
    return true;
  }
  if (sgn(height) != 0) return false;
  // The line of sight runs in the triangle's plane: which of its points are inside all three sides?
  std::optional<Q> low, high;
  for (std::size_t i = 0; i < 3; ++i) {
    const Q inside = dot(t.inward[i], p - t.corners[i]);
    const Q slope = dot(t.inward[i], d);
    if (sgn(slope) == 0) {
      if (sgn(inside) < 0) return false;
      continue;
    }
    const Q s = -inside / slope;
    if (sgn(slope) > 0 && (!low || s > *low)) low = s;
    if (sgn(slope) < 0 && (!high || s < *high)) high = s;
  }
  // A line in the triangle's plane that is outside of no side enters and leaves: both ends are known.
  if (*low > *high || sgn(*high) <= 0) return false;
  return !reach || (sgn(*reach) > 0 && *low <= *reach);
}

// Between two neighbouring candidates the triangle hides all of the edge ab or nothing. Too many do no harm.
std::vector<Q> VisibleLinesOracle::candidates(const Triangle& t, const Vec& a, const Vec& b) const {
  std::vector<Q> roots;
  const Q fa = dot(t.normal, a - t.corners[0]), fb = dot(t.normal, b - t.corners[0]);
  add_root(fa, fb, roots);
  for (const auto& plane : t.outline) add_root(dot(plane.normal, a - plane.point), dot(plane.normal, b - plane.point), roots);
  if (t.edge_on && sgn(fa) == 0 && sgn(fb) == 0) {
    // All within one plane: the lines of the sides, and the lines of sight of the corners.
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec &u = t.corners[i], &v = t.corners[(i + 1) % 3];
      const Vec at_a = cross(v - u, a - u), at_b = cross(v - u, b - u);
      for (int axis = 0; axis < 3; ++axis) add_root(at_a[axis], at_b[axis], roots);
    }
    for (const Vec& corner : t.corners_beyond) {
      const Vec at_a = cross(corner - a, to_eye(corner)), at_b = cross(corner - b, to_eye(corner));
      for (int axis = 0; axis < 3; ++axis) add_root(at_a[axis], at_b[axis], roots);
    }
  }
  return roots;
}

EdgeVisibility VisibleLinesOracle::visibility(EdgeId edge) const {
  return visibility(Vec(mesh_.points[mesh_.edges[edge].a]), Vec(mesh_.points[mesh_.edges[edge].b]));
}

EdgeVisibility VisibleLinesOracle::visibility(const Vec& a, const Vec& b) const {
  EdgeVisibility out;
  if (is_zero(cross(b - a, to_eye(a)))) return out;  // seen as a point

  out.beyond = {0, 1};
  const Q da = depth(a), db = depth(b);
  if (sgn(da) <= 0 && sgn(db) <= 0 && (sgn(da) < 0 || sgn(db) < 0)) return out;
  if (sgn(da) < 0) out.beyond.from = da / (da - db);
  if (sgn(db) < 0) out.beyond.to = da / (da - db);
  out.is_seen = true;

  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    std::vector<Q> cuts = candidates(triangles_[i], a, b);
    std::erase_if(cuts, [&](const Q& t) { return t <= out.beyond.from || t >= out.beyond.to; });
    cuts.push_back(out.beyond.from);
    cuts.push_back(out.beyond.to);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    std::vector<Interval> parts;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const Q middle = (cuts[k] + cuts[k + 1]) / 2;
      if (hides(triangles_[i], a + middle * (b - a))) parts.push_back({cuts[k], cuts[k + 1]});
    }
    for (Interval& shadow : united(std::move(parts))) out.shadows.push_back({TriangleId(i), std::move(shadow)});
  }
  std::vector<Interval> all;
  for (const Shadow& shadow : out.shadows) all.push_back(shadow.interval);
  out.hidden = united(std::move(all));
  out.visible = rest_of(out.beyond, out.hidden);
  return out;
}

}  // namespace hsr::oracle
