#include "hsr/io/write/dashes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace hsr::internal {

namespace {

const double corner_cosine = std::cos(35 * 3.14159265358979 / 180);

double distance(const PaperPoint& a, const PaperPoint& b) {  // mm
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)) / 1000;
}

bool is_corner(const PaperPoint& a, const PaperPoint& b, const PaperPoint& c) {
  const double scalar = static_cast<double>(b.x - a.x) * static_cast<double>(c.x - b.x) +
                        static_cast<double>(b.y - a.y) * static_cast<double>(c.y - b.y);
  return scalar < corner_cosine * distance(a, b) * distance(b, c) * 1e6;
}

/// The pen's dashes, and what they come to.
class Pattern {
 public:
  explicit Pattern(const Pen& pen)
      : dashes_(pen.dashes),
        width_(pen.width),
        period_(std::accumulate(dashes_.begin(), dashes_.end(), 0.0)),
        least_(std::min(dashes_[0], dashes_[1])) {}

  /// What has a dash, a gap and a dash as they should be.
  double least_stretch() const { return period_ - dashes_[0] + 2 * least_; }

  /// One period of a stretch, whose last one ends with its first dash; or one dash.
  std::vector<double> along(double length) const {
    const double n = std::max(1.0, std::round((length - dashes_[0]) / period_));
    if (n > 1 || length >= least_stretch()) {
      if (2 * dashes_[0] < period_) return scaled(length / (n * period_ + dashes_[0]));
      return adapted((length - n * (period_ - dashes_[0])) / (n + 1));
    }
    if (length >= 3 * width_) return {length / 3, length / 3};
    return {length};
  }

  /// One period of a closed line without corners; or one dash.
  std::vector<double> around(double length) const {
    const double n = std::max(2.0, std::round(length / period_));
    if (2 * dashes_[0] < period_) return scaled(length / (n * period_));
    const double dash = length / n - (period_ - dashes_[0]);
    if (dash >= least_) return adapted(dash);
    if (length >= 4 * width_) return {length / 4, length / 4};
    return {length};
  }

 private:
  std::vector<double> adapted(double dash) const {
    std::vector<double> period = dashes_;
    period[0] = dash;
    return period;
  }
  std::vector<double> scaled(double factor) const {
    std::vector<double> period = dashes_;
    for (double& x : period) x *= factor;
    return period;
  }

  const std::vector<double>& dashes_;
  double width_, period_, least_;
};

/// The lengths of the stretches of an open line.
std::vector<double> stretches_of(std::span<const PaperPoint> points, double least) {
  std::vector<double> stretches = {0};
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (k > 0 && stretches.back() >= least && is_corner(points[k - 1], points[k], points[k + 1])) stretches.push_back(0);
    stretches.back() += distance(points[k], points[k + 1]);
  }
  if (stretches.size() > 1 && stretches.back() < least) {
    stretches[stretches.size() - 2] += stretches.back();
    stretches.pop_back();
  }
  return stretches;
}

/// The dashes of a stretch after those before it, with which it shares a dash over the corner.
void append_stretch(std::vector<double>& lengths, double length, const std::vector<double>& period) {
  const double whole = std::accumulate(period.begin(), period.end(), 0.0);
  const auto periods = period.size() == 1 ? 0 : std::llround((length - period[0]) / whole);
  if (lengths.empty()) lengths.push_back(0);
  for (long long n = 0; n < periods; ++n) {
    lengths.back() += period[0];
    lengths.insert(lengths.end(), period.begin() + 1, period.end());
    lengths.push_back(0);
  }
  lengths.back() += period[0];
}

/// The first corner of a closed line.
std::optional<std::size_t> first_corner(std::span<const PaperPoint> points) {
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k)
    if (is_corner(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) return k;
  return {};
}

}  // namespace

DashedPath dashed_path(std::span<const PaperPoint> points, bool closed, const Pen& pen) {
  DashedPath path;
  path.points.assign(points.begin(), points.end());
  path.closed = closed;
  const Pattern pattern(pen);
  if (closed) {
    const auto corner = first_corner(points);
    if (corner) std::rotate(path.points.begin(), path.points.begin() + static_cast<std::ptrdiff_t>(*corner), path.points.end());
    path.points.push_back(path.points.front());
    if (!corner) {
      double length = 0;
      for (std::size_t k = 0; k + 1 < path.points.size(); ++k) length += distance(path.points[k], path.points[k + 1]);
      path.lengths = pattern.around(length);
      return path;
    }
  }
  const std::vector<double> stretches = stretches_of(path.points, pattern.least_stretch());
  if (stretches.size() == 1) {
    path.lengths = pattern.along(stretches[0]);
    return path;
  }
  for (const double stretch : stretches) append_stretch(path.lengths, stretch, pattern.along(stretch));
  return path;
}

bool has_corners_only(std::span<const PaperPoint> points, bool closed) {
  const std::size_t n = points.size();
  for (std::size_t k = closed ? 0 : 1; k + (closed ? 0 : 1) < n; ++k)
    if (!is_corner(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) return false;
  return true;
}

std::vector<std::vector<PaperPoint>> dashes_of(const DashedPath& path) {
  constexpr double slack = 1e-6;  // mm: what is left at the end is a sum that was rounded
  std::vector<std::vector<PaperPoint>> dashes;
  bool is_down = true;
  std::size_t at = 0;
  double left = path.lengths[0];  // of the dash or the gap at hand
  if (!path.points.empty()) dashes.push_back({path.points.front()});
  for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
    const PaperPoint &a = path.points[k], &b = path.points[k + 1];
    const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y), length = distance(a, b);
    double done = 0;
    while (length - done > left + slack) {
      done += left;
      const PaperPoint p = {a.x + std::llround(dx * done / length), a.y + std::llround(dy * done / length)};
      if (is_down)
        dashes.back().push_back(p);
      else
        dashes.push_back({p});
      is_down = !is_down;
      at = (at + 1) % path.lengths.size();
      left = path.lengths[at];
    }
    left -= length - done;
    if (is_down) dashes.back().push_back(b);
  }
  // A closed line that begins at a corner has one dash over it.
  if (path.closed && is_down && dashes.size() > 1) {
    dashes.back().insert(dashes.back().end(), dashes.front().begin() + 1, dashes.front().end());
    dashes.erase(dashes.begin());
  }
  return dashes;
}

}  // namespace hsr::internal
