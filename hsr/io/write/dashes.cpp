#include "hsr/io/write/dashes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace hsr::internal {

namespace {

const double corner_cosine = std::cos(35 * 3.14159265358979 / 180);

double length_of(const Point2& v) { return std::hypot(v.x, v.y) / 1000; }  // mm

/// Where one direction turns into another.
bool is_corner(const Point2& u, const Point2& v) {
  return u.x * v.x + u.y * v.y < corner_cosine * length_of(u) * length_of(v) * 1e6;
}
bool is_corner(const PathPart& before, const PathPart& after) { return is_corner(before.arriving(), after.leaving()); }

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
std::vector<double> stretches_of(std::span<const PathPart> parts, double least) {
  std::vector<double> stretches = {0};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k > 0 && stretches.back() >= least && is_corner(parts[k - 1], parts[k])) stretches.push_back(0);
    stretches.back() += parts[k].length();
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

/// The part at whose beginning the first corner of a closed line is.
std::optional<std::size_t> first_corner(std::span<const PathPart> parts) {
  const std::size_t n = parts.size();
  for (std::size_t k = 0; k < n; ++k)
    if (is_corner(parts[(k + n - 1) % n], parts[k])) return k;
  return {};
}

}  // namespace

DashedPath dashed_path(Path path, const Pen& pen) {
  DashedPath dashed;
  std::vector<PathPart>& parts = path.parts;
  const Pattern pattern(pen);
  if (path.closed) {
    const auto corner = first_corner(parts);
    if (corner) std::rotate(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(*corner), parts.end());
    if (!corner) {
      double length = 0;
      for (const PathPart& part : parts) length += part.length();
      dashed.lengths = pattern.around(length);
    }
  }
  if (dashed.lengths.empty()) {
    const std::vector<double> stretches = stretches_of(parts, pattern.least_stretch());
    if (stretches.size() == 1)
      dashed.lengths = pattern.along(stretches[0]);
    else
      for (const double stretch : stretches) append_stretch(dashed.lengths, stretch, pattern.along(stretch));
  }
  dashed.path = std::move(path);
  return dashed;
}

bool has_corners_only(std::span<const PaperPoint> points, bool closed) {
  const std::size_t n = points.size();
  const auto direction = [&](std::size_t from, std::size_t to) {
    const PaperPoint &a = points[from % n], &b = points[to % n];
    return Point2{static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)};
  };
  for (std::size_t k = closed ? 0 : 1; k + (closed ? 0 : 1) < n; ++k)
    if (!is_corner(direction(k + n - 1, k), direction(k, k + 1))) return false;
  return true;
}

std::vector<Path> dashes_of(const DashedPath& dashed) {
  constexpr double slack = 1e-6;  // mm: what is left at the end is a sum that was rounded
  std::vector<Path> dashes(1);
  bool is_down = true;
  std::size_t at = 0;
  double left = dashed.lengths[0];  // of the dash or the gap at hand
  for (const PathPart& part : dashed.path.parts) {
    const double length = part.length();
    double done = 0;
    while (length - done > left + slack) {
      const double until = done + left;
      if (is_down)
        dashes.back().parts.push_back(part.between(done, until));
      else
        dashes.emplace_back();
      done = until;
      is_down = !is_down;
      at = (at + 1) % dashed.lengths.size();
      left = dashed.lengths[at];
    }
    left -= length - done;
    if (is_down) dashes.back().parts.push_back(part.between(done, length));
  }
  // A closed line that begins at a corner has one dash over it.
  if (dashed.path.closed && is_down && dashes.size() > 1) {
    const std::vector<PathPart>& first = dashes.front().parts;
    dashes.back().parts.insert(dashes.back().parts.end(), first.begin(), first.end());
    dashes.erase(dashes.begin());
  }
  return dashes;
}

}  // namespace hsr::internal
