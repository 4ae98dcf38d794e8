#include "hsr/drawing/pen_tour.h"

#include <algorithm>
#include <cmath>

#include "hsr/drawing/end_tree.h"

namespace hsr::internal {

namespace {

using Place = std::int64_t;  // in the tour; -1: where the pen is before

constexpr double least_gain = 0.5;  // micrometres: what is less comes from rounding
constexpr std::size_t neighbours = 8;
constexpr int most_passes = 30;
constexpr Place longest_segment = 3;

double distance(const PaperPoint& a, const PaperPoint& b) {
  return std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
}

class TourShortener {
 public:
  TourShortener(const std::vector<PenStroke>& strokes, PenTour& tour, const PaperPoint& start)
      : strokes_(strokes),
        tour_(tour),
        start_(start),
        size_(static_cast<Place>(tour.size())),
        longest_(std::max<Place>(1000, 25'000'000 / std::max<Place>(1, size_))),
        place_of_(tour.size()),
        rests_(tour.size(), 0) {
    for (Place p = 0; p < size_; ++p) place_of_[stroke_at(p)] = p;
    find_neighbours();
  }

  void run() {
    for (int pass = 0; pass < most_passes; ++pass) {
      bool improved = false;
      for (std::uint32_t stroke = 0; stroke < tour_.size(); ++stroke) {
        if (rests_[stroke] != 0) continue;
        bool moved = false;
        for (int moves = 0; moves < 10 && improve(stroke); ++moves) moved = true;
        if (!moved) rests_[stroke] = 1;
        improved = improved || moved;
      }
      if (!improved) return;
    }
  }

 private:
  std::uint32_t stroke_at(Place p) const { return tour_[static_cast<std::size_t>(p)] / 2; }
  std::uint32_t reversed_at(Place p) const { return tour_[static_cast<std::size_t>(p)] & 1U; }
  /// Ends are numbered 2 stroke + 0 or 1.
  std::uint32_t in(Place p) const { return tour_[static_cast<std::size_t>(p)]; }
  std::uint32_t out(Place p) const { return tour_[static_cast<std::size_t>(p)] ^ 1U; }
  const PaperPoint& at(std::uint32_t end) const { return strokes_[end / 2].ends[end & 1U]; }
  const PaperPoint& out_at(Place p) const { return p < 0 ? start_ : at(out(p)); }
  /// From the end of one place to the beginning of another; nothing where the tour is at its end.
  double way(Place p, Place q) const { return q >= size_ ? 0 : distance(out_at(p), at(in(q))); }
  double way(const PaperPoint& from, Place q) const { return q >= size_ ? 0 : distance(from, at(in(q))); }

  void find_neighbours() {
    std::vector<PaperPoint> ends;
    for (const PenStroke& s : strokes_) ends.insert(ends.end(), {s.ends[0], s.ends[1]});
    const EndTree tree(ends);
    near_.resize(ends.size());
    for (std::uint32_t e = 0; e < ends.size(); ++e)
      near_[e] = tree.nearest(ends[e], neighbours, [&](std::uint32_t other) { return other / 2 == e / 2; });
  }

  void wake(Place p) {
    if (p >= 0 && p < size_) rests_[stroke_at(p)] = 0;
  }

  /// Turns the run from p to q around.
  void reverse(Place p, Place q) {
    for (const Place k : {p - 1, p, q, q + 1}) wake(k);
    std::reverse(tour_.begin() + p, tour_.begin() + q + 1);
    for (Place k = p; k <= q; ++k) {
      tour_[static_cast<std::size_t>(k)] ^= 1U;
      place_of_[stroke_at(k)] = k;
    }
    for (const Place k : {p - 1, p, q, q + 1}) wake(k);
  }

  /// 2-opt: the run from p to q is turned around, if that helps.
  bool try_reversal(Place p, Place q) {
    if (p > q || q - p >= longest_) return false;
    const double before = way(p - 1, p) + way(q, q + 1);
    const double after = distance(out_at(p - 1), at(out(q))) + way(at(in(p)), q + 1);
    if (before - after < least_gain) return false;
    reverse(p, q);
    return true;
  }

  /// Or-opt: the run from p to q moves to between r and r + 1, the other way round or not, if that helps.
  bool try_move(Place p, Place q, Place r, bool turned) {
    if (r >= p - 1 && r <= q) return false;
    if (std::max(q, r) - std::min(p, r) >= longest_) return false;
    const double before = way(p - 1, p) + way(q, q + 1) + way(r, r + 1);
    const std::uint32_t first = turned ? out(q) : in(p), last = turned ? in(p) : out(q);
    const double after = way(p - 1, q + 1) + distance(out_at(r), at(first)) + way(at(last), r + 1);
    if (before - after < least_gain) return false;
    for (const Place k : {p - 1, q + 1, r, r + 1}) wake(k);
    // The run and what it is moved over change places: both are turned around, and then all of it.
    const Place n = q - p + 1;
    if (r > q) {
      if (!turned) reverse(p, q);
      reverse(q + 1, r);
      reverse(p, r);
      for (const Place k : {p - 1, p, r - n, r - n + 1, r, r + 1}) wake(k);
    } else {
      if (!turned) reverse(p, q);
      reverse(r + 1, p - 1);
      reverse(r + 1, q);
      for (const Place k : {r, r + 1, r + n, r + n + 1, q, q + 1}) wake(k);
    }
    return true;
  }

  /// Brings the end of `stroke` to one that is nearer than the one that it is beside, in one of the ways.
  bool improve(std::uint32_t stroke) {
    for (const std::uint32_t side : {0U, 1U}) {
      const std::uint32_t end = 2 * stroke + side;
      const Place p = place_of_[stroke];
      const bool leaves = out(p) == end;
      const double beside = leaves ? way(p, p + 1) : way(p - 1, p);
      for (const std::uint32_t other : near_[end]) {
        const Place q = place_of_[other / 2];
        const bool other_leaves = out(q) == other;
        const bool is_nearer = distance(at(end), at(other)) < beside;
        if (!is_nearer && !(leaves && p + 1 == size_)) break;
        if (leaves && other_leaves && try_reversal(std::min(p, q) + 1, std::max(p, q))) return true;
        if (!leaves && !other_leaves && try_reversal(std::min(p, q), std::max(p, q) - 1)) return true;
        for (Place n = 0; n < longest_segment; ++n) {
          // The segment that begins or ends with this end.
          const Place first = leaves ? p - n : p, last = leaves ? p : p + n;
          if (first < 0 || last >= size_ || (q >= first && q <= last)) break;
          if (try_move(first, last, other_leaves ? q : q - 1, leaves == other_leaves)) return true;
        }
      }
    }
    return false;
  }

  const std::vector<PenStroke>& strokes_;
  PenTour& tour_;
  PaperPoint start_;
  Place size_, longest_;
  std::vector<Place> place_of_;  // by stroke
  std::vector<char> rests_;      // by stroke: nothing has changed beside it since nothing helped
  std::vector<std::vector<std::uint32_t>> near_;
};

}  // namespace

double pen_up(const std::vector<PenStroke>& strokes, const PenTour& tour, const PaperPoint& start) {
  double length = 0;
  PaperPoint pen = start;
  for (const std::uint32_t pass : tour) {
    const PenStroke& s = strokes[pass / 2];
    length += distance(pen, s.ends[pass & 1U]);
    pen = s.ends[(pass & 1U) ^ 1U];
  }
  return length;
}

void shorten(const std::vector<PenStroke>& strokes, PenTour& tour, const PaperPoint& start) {
  TourShortener(strokes, tour, start).run();
}

}  // namespace hsr::internal
