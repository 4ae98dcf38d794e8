#include "hsr/drawing/near_lines.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "geometry/index.h"
#include "geometry/ragged.h"

namespace hsr::internal {

namespace {

__extension__ using Wide = __int128;  // coordinates are below 2^41: products of three differences fit

constexpr std::int64_t slope = 8;  // of two lines that run in roughly one direction, no more than 1 in this
constexpr std::int64_t shortest_run = 100 * least_on_paper;  // left out of a path

struct Vector {
  Wide x, y;
};
Vector operator-(const PaperPoint& a, const PaperPoint& b) { return {a.x - b.x, a.y - b.y}; }
Wide dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
Wide cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Wide magnitude(Wide a) { return a < 0 ? -a : a; }
/// @pre b > 0
template <class T>
T floor_of(T a, T b) {
  return a / b - (a % b < 0 ? 1 : 0);
}
/// The same; nearly all numbers are short, and division by long ones takes many times as long.
Wide floor_of(Wide a, Wide b) {
  const auto short_a = static_cast<std::int64_t>(a), short_b = static_cast<std::int64_t>(b);
  return short_a == a && short_b == b ? Wide{floor_of<std::int64_t>(short_a, short_b)} : floor_of<Wide>(a, b);
}
Wide ceiling_of(Wide a, Wide b) { return -floor_of(-a, b); }

bool is_near(const PaperPoint& p, const PaperPoint& q) { return dot(p - q, p - q) <= least_on_paper * least_on_paper; }

bool is_near(const PaperPoint& p, const PaperLine& line) {
  const Vector s = line.to - line.from, v = p - line.from;
  const Wide along = dot(v, s);
  if (along <= 0) return is_near(p, line.from);
  if (along >= dot(s, s)) return is_near(p, line.to);
  const Wide off = magnitude(cross(s, v));
  if (off > least_on_paper * (magnitude(s.x) + magnitude(s.y))) return false;  // so that the squares fit
  return off * off <= least_on_paper * least_on_paper * dot(s, s);
}

/// A line as a row of points of the paper, one for each step along the coordinate that changes more.
class Steps {
 public:
  explicit Steps(const PaperLine& line) : line_(line), d_(line.to - line.from) {
    count_ = static_cast<std::int64_t>(std::max(magnitude(d_.x), magnitude(d_.y)));
  }
  std::int64_t count() const { return count_; }
  PaperPoint operator[](std::int64_t m) const {
    const auto at = [&](std::int64_t from, Wide d) {
      return from + static_cast<std::int64_t>(floor_of(2 * d * m + count_, 2 * static_cast<Wide>(count_)));
    };
    return {at(line_.from.x, d_.x), at(line_.from.y, d_.y)};
  }
  const Vector& direction() const { return d_; }

 private:
  PaperLine line_;
  Vector d_;
  std::int64_t count_;
};

/// Whether any two steps of a line are near each other, so that no other line runs beside it for long enough to count. Of a drawing that
/// is a dot on paper all lines are such, and each would be compared with each.
bool is_too_short(const PaperLine& line) {
  constexpr std::int64_t most = 6;  // both ways, and one more for the rounding of another line's steps beside it
  static_assert(2 * (most + 1) * (most + 1) <= least_on_paper * least_on_paper);
  return Steps(line).count() <= most;
}

/// Steps of a line, first and last.
struct Range {
  std::int64_t first, last;
};

/// The last of the steps from `inside` to `end` that is near; what is near is in one piece.
std::int64_t last_near(const Steps& steps, const PaperLine& line, std::int64_t inside, std::int64_t end) {
  if (is_near(steps[end], line)) return end;
  while (inside - end > 1 || end - inside > 1) {
    const std::int64_t middle = (inside + end) / 2;
    (is_near(steps[middle], line) ? inside : end) = middle;
  }
  return inside;
}

/// What of a line runs beside another.
struct Beside {
  Range range;
  std::uint32_t line;
};

/// Ascending, with a gap between any two.
std::vector<Range> united(std::vector<Beside> beside) {
  std::sort(beside.begin(), beside.end(), [](const Beside& a, const Beside& b) { return a.range.first < b.range.first; });
  std::vector<Range> result;
  for (const Beside& b : beside)
    if (!result.empty() && b.range.first <= result.back().last + 1)
      result.back().last = std::max(result.back().last, b.range.last);
    else
      result.push_back(b.range);
  return result;
}

/// The line less some of it.
std::vector<PaperLine> rest(const PaperLine& line, const std::vector<Range>& out) {
  std::vector<PaperLine> result;
  if (out.empty()) return {line};
  const Steps steps(line);
  std::int64_t done = 0;
  const auto keep_up_to = [&](std::int64_t end) {
    if (end > done) result.push_back({steps[done], steps[end], line.style, line.object});
  };
  for (const Range& range : out) {
    keep_up_to(range.first);
    done = range.last;
  }
  keep_up_to(steps.count());
  return result;
}

/// A cut breaks a path, and its dashes begin anew: so of a path only longer runs are left out, or all of it.
void put_back_short_runs(const std::vector<PaperLine>& lines, std::span<const std::uint32_t> passes, bool closed,
                         std::vector<std::vector<Range>>& out) {
  struct Run {
    std::int64_t length;
    std::vector<std::array<std::uint32_t, 2>> of;  // line, and which of its ranges
  };
  std::vector<Run> runs;
  bool from_start = false, open = false;  // the first run begins where the path does; the last one may go on
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const std::uint32_t k = passes[i] / 2;
    const bool back = (passes[i] & 1U) != 0;
    const std::int64_t count = Steps(lines[k]).count();
    const auto n = static_cast<std::uint32_t>(out[k].size());
    if (n == 0) open = false;
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t r = back ? n - 1 - j : j;
      const Range& range = out[k][r];
      const bool at_begin = back ? range.last == count : range.first == 0;
      const bool at_end = back ? range.first == 0 : range.last == count;
      if (i == 0 && at_begin) from_start = true;
      if (!(open && at_begin)) runs.push_back({0, {}});
      runs.back().length += range.last - range.first;
      runs.back().of.push_back({k, r});
      open = at_end;
    }
  }
  if (runs.empty() || (runs.size() == 1 && from_start && open && runs[0].of.size() == passes.size())) return;
  if (closed && runs.size() > 1 && from_start && open) {
    runs[0].length += runs.back().length;
    runs.back().length = runs[0].length;
  }
  constexpr Range put_back = {1, 0};
  for (const Run& run : runs)
    if (run.length < shortest_run)
      for (const auto& [k, r] : run.of) out[k][r] = put_back;
  for (const std::uint32_t pass : passes) std::erase_if(out[pass / 2], [](const Range& r) { return r.first > r.last; });
}

/// The part of a line that the other one stands for; first > last: none.
Range part_near(const PaperLine& weak, const PaperLine& strong) {
  const Range none = {1, 0};
  const Steps steps(weak);
  const Vector &d = steps.direction(), s = strong.to - strong.from;
  const Wide along = dot(d, s);
  if (along == 0 || magnitude(cross(d, s)) * slope > magnitude(along)) return none;

  // Beside it: the foot of the perpendicular is on the strong line.
  const PaperPoint& start = along > 0 ? strong.from : strong.to;
  const Wide per_step = magnitude(along), before = dot(start - weak.from, s) * (along > 0 ? 1 : -1);
  const auto first = static_cast<std::int64_t>(std::max<Wide>(0, ceiling_of(before * steps.count(), per_step)));
  const auto last =
      static_cast<std::int64_t>(std::min<Wide>(steps.count(), floor_of((before + dot(s, s)) * steps.count(), per_step)));
  if (first >= last) return none;

  // The nearest step is at an end of that, or where the two cross.
  const Wide off_first = cross(s, steps[first] - strong.from), off_last = cross(s, steps[last] - strong.from);
  std::int64_t inside = magnitude(off_first) <= magnitude(off_last) ? first : last;
  if ((off_first < 0) != (off_last < 0) && off_first != off_last)
    inside =
        first + static_cast<std::int64_t>((last - first) * magnitude(off_first) / (magnitude(off_first) + magnitude(off_last)));
  if (!is_near(steps[inside], strong)) return none;
  Range part = {last_near(steps, strong, inside, first), last_near(steps, strong, inside, last)};
  if (is_near(steps[part.first], steps[part.last])) return none;

  const bool meet = weak.from == strong.from || weak.from == strong.to || weak.to == strong.from || weak.to == strong.to;
  if (meet && (part.first != first || part.last != last)) return none;
  if (part.first == first) part.first = last_near(steps, strong, first, 0);
  if (part.last == last) part.last = last_near(steps, strong, last, steps.count());
  return part;
}

/// A line in doubles, which hold the coordinates and their differences exactly.
struct LineInDoubles {
  double x, y, dx, dy, length;

  explicit LineInDoubles(const PaperLine& line)
      : x(static_cast<double>(line.from.x)),
        y(static_cast<double>(line.from.y)),
        dx(static_cast<double>(line.to.x - line.from.x)),
        dy(static_cast<double>(line.to.y - line.from.y)),
        length(std::hypot(dx, dy)) {}

  /// Whether part_near() certainly finds nothing: most lines that are looked at run in another direction.
  bool is_certainly_apart(const LineInDoubles& other) const {
    const double turn = other.dx * dy - other.dy * dx, along = other.dx * dx + other.dy * dy;
    if (std::fabs(turn) * slope > std::fabs(along) + 1e-12 * length * other.length) return true;
    // Both ends are farther than least_on_paper from the line of the other, on one side of it: then no step is near. Of coordinates
    // below 2^41 the roundings move the line by less than 2^-6, and steps are off theirs by less than 1.
    const double u = x - other.x, v = y - other.y;
    const double from = other.dx * v - other.dy * u, to = from + turn;
    const double most = (least_on_paper + 2) * other.length;
    if ((from > most && to > most) || (from < -most && to < -most)) return true;
    // The feet of the perpendiculars from both ends are beyond one end of the other.
    const double first = other.dx * u + other.dy * v, last = first + along;
    const double error = 1e-12 * other.length * (std::fabs(u) + std::fabs(v) + length + other.length);
    const double end = other.length * other.length + error;
    return (first < -error && last < -error) || (first > end && last > end);
  }
};

/// Which lines come within least_on_paper of each square of the paper, of those that were put there: what is left of the lines so far,
/// and behind it the lines of one block.
class Squares {
 public:
  /// Has room for all lines, but too short ones, and holds none.
  explicit Squares(const std::vector<PaperLine>& lines);

  std::span<const std::uint32_t> squares_of(std::uint32_t line) const { return squares_of_line_[line]; }
  std::span<const std::uint32_t> lines_in(std::uint32_t square) const {
    return {lines_.data() + first_[square], lines_.data() + end_[square]};
  }
  void add(std::uint32_t line) {
    for (const std::uint32_t s : squares_of(line)) lines_[end_[s]++] = line;
  }
  /// Of a block that was added only some lines are left. @param remaining some of the block
  void settle(std::span<const std::uint32_t> block, std::span<const std::uint32_t> remaining) {
    for (const std::uint32_t line : block)
      for (const std::uint32_t s : squares_of(line)) end_[s] = settled_[s];
    for (const std::uint32_t line : remaining) {
      add(line);
      for (const std::uint32_t s : squares_of(line)) settled_[s] = end_[s];
    }
  }

 private:
  struct Entry {
    std::int32_t column, row;
    std::uint32_t line;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  /// A size that suits some lines, with few enough squares each way.
  static std::int64_t size_for(const std::vector<PaperLine>& lines) {
    constexpr std::int64_t most = 1 << 20;
    Wide length = 0;
    std::int64_t farthest = 0;
    for (const PaperLine& line : lines) {
      length += Steps(line).count();
      for (const std::int64_t x : {line.from.x, line.from.y, line.to.x, line.to.y}) farthest = std::max(farthest, std::abs(x));
    }
    return std::max(
        {std::int64_t{100}, farthest / most + 1, static_cast<std::int64_t>(length / std::max<std::size_t>(1, lines.size()))});
  }
  std::int64_t square(std::int64_t x) const { return floor_of(x, size_); }
  template <class F>
  void each(const PaperLine& line, F&& f) const;

  std::int64_t size_;
  Ragged<std::uint32_t> squares_of_line_;
  std::vector<std::uint32_t> lines_;                  // by square, in rows that hold all that may come there
  std::vector<std::uint32_t> first_, settled_, end_;  // by square
};

Squares::Squares(const std::vector<PaperLine>& lines) : size_(size_for(lines)) {
  std::vector<Entry> entries;
  for (std::uint32_t k = 0; k < lines.size(); ++k)
    if (!is_too_short(lines[k]))
      each(lines[k], [&](std::int64_t column, std::int64_t row) {
        entries.push_back({static_cast<std::int32_t>(column), static_cast<std::int32_t>(row), k});
      });
  check_countable(entries.size(), "squares of lines");
  tbb::parallel_sort(entries.begin(), entries.end());
  lines_.resize(entries.size());
  const auto begins_square = [&](std::size_t i) {
    return i == 0 || entries[i].column != entries[i - 1].column || entries[i].row != entries[i - 1].row;
  };
  for (std::uint32_t i = 0; i < entries.size(); ++i)
    if (begins_square(i)) first_.push_back(i);
  settled_ = end_ = first_;
  squares_of_line_.assign(lines.size(), [&](const auto& add) {
    std::uint32_t square = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i > 0 && begins_square(i)) ++square;
      add(entries[i].line, square);
    }
  });
}

/// Calls f(column, row) for the squares that the line comes near.
template <class F>
void Squares::each(const PaperLine& line, F&& f) const {
  PaperPoint a = line.from, b = line.to;
  if (b < a) std::swap(a, b);
  const Vector d = b - a;
  const std::int64_t low = std::min(a.y, b.y), high = std::max(a.y, b.y), reach = least_on_paper + 1;
  for (std::int64_t column = square(a.x - reach); column <= square(b.x + reach); ++column) {
    // The line over the column, and a little more.
    std::int64_t from = low, to = high;
    if (d.x > 0) {
      const auto y_at = [&](std::int64_t x) {
        return a.y + static_cast<std::int64_t>(floor_of((std::clamp(x, a.x, b.x) - a.x) * d.y, d.x));
      };
      const std::int64_t y = y_at(column * size_ - reach), z = y_at((column + 1) * size_ + reach);
      from = std::min(y, z);
      to = std::max(y, z) + 1;
    }
    for (std::int64_t row = square(from - reach); row <= square(to + reach); ++row) f(column, row);
  }
}

/// The lines' numbers, the strongest first.
std::vector<std::uint32_t> by_strength(const std::vector<PaperLine>& lines, const Chains& chains) {
  std::vector<std::int64_t> length(chains.passes.size(), 0);
  std::vector<std::uint32_t> chain_of(lines.size()), order(lines.size());
  for (std::uint32_t c = 0; c < chains.passes.size(); ++c)
    for (const std::uint32_t pass : chains.passes[c]) {
      chain_of[pass / 2] = c;
      length[c] += Steps(lines[pass / 2]).count();
    }
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t k) {
    return std::make_tuple(lines[k].style ^ 16U, -length[chain_of[k]], chain_of[k], k);  // visible: + 16, hence first
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  return order;
}

/// Finds what of each line runs beside stronger ones, the strongest lines first, a block of them at a time. What has been left out
/// wholly is not looked at again: where lines are dense, that is most of them.
class BesideStronger {
 public:
  BesideStronger(const std::vector<PaperLine>& lines, std::vector<std::uint32_t> order)
      : beside(lines.size()),
        out(lines.size()),
        lines_(lines),
        order_(std::move(order)),
        rank_(lines.size()),
        in_doubles_(lines.begin(), lines.end()),
        squares_(lines),
        seen_by_(std::vector<std::uint32_t>(lines.size(), none)),
        left_(lines.size()) {
    for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
    constexpr std::size_t width = 1024;  // enough for many threads, and few pairs of lines that are both left out
    for (std::size_t begin = 0; begin < order_.size(); begin += width)
      take(static_cast<std::uint32_t>(begin), std::span(order_).subspan(begin, std::min(width, order_.size() - begin)));
  }

  // By line.
  std::vector<std::vector<Beside>> beside;
  std::vector<std::vector<Range>> out;

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// @param first the rank of the first of a block
  void take(std::uint32_t first, std::span<const std::uint32_t> block) {
    for (const std::uint32_t k : block) squares_.add(k);
    std::vector<std::vector<std::uint32_t>> stronger(block.size());  // of the same block
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, block.size(), 32), [&](const auto& range) {
      std::vector<std::uint32_t>& seen_by = seen_by_.local();
      for (std::size_t i = range.begin(); i != range.end(); ++i) find_stronger(block[i], first, seen_by, stronger[i]);
    });
    // Only what is left of the stronger ones leaves something out: so of many lines side by side not all vanish.
    std::vector<std::uint32_t> remaining;
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::uint32_t k = block[i];
      for (const std::uint32_t other : stronger[i]) add_beside(k, other);
      out[k] = united(beside[k]);
      left_[k] = rest(lines_[k], out[k]);
      if (!left_[k].empty()) remaining.push_back(k);
    }
    squares_.settle(block, remaining);
  }
  /// Looks at each line near which line k may be once: what stands for it of those of earlier blocks is known.
  void find_stronger(std::uint32_t k, std::uint32_t first, std::vector<std::uint32_t>& seen_by,
                     std::vector<std::uint32_t>& in_block) {
    for (const std::uint32_t square : squares_.squares_of(k))
      for (const std::uint32_t other : squares_.lines_in(square)) {
        if (rank_[other] >= rank_[k] || seen_by[other] == k) continue;
        seen_by[other] = k;
        if (in_doubles_[k].is_certainly_apart(in_doubles_[other])) continue;
        const Range part = part_near(lines_[k], lines_[other]);
        if (part.first > part.last) continue;
        if (rank_[other] < first)
          add_beside(k, other);
        else
          in_block.push_back(other);
      }
  }
  void add_beside(std::uint32_t k, std::uint32_t other) {
    for (const PaperLine& part : left_[other]) {
      const Range range = part_near(lines_[k], part);
      if (range.first <= range.last) beside[k].push_back({range, other});
    }
  }

  const std::vector<PaperLine>& lines_;
  std::vector<std::uint32_t> order_, rank_;
  std::vector<LineInDoubles> in_doubles_;
  Squares squares_;                                                      // of what has something left, and of a block
  tbb::enumerable_thread_specific<std::vector<std::uint32_t>> seen_by_;  // by line: the last one that looked at it
  std::vector<std::vector<PaperLine>> left_;
};

}  // namespace

DistinctLines without_near(const std::vector<PaperLine>& lines, const Chains& chains) {
  BesideStronger found(lines, by_strength(lines, chains));
  const std::vector<std::vector<Beside>>& beside = found.beside;
  std::vector<std::vector<Range>>& out = found.out;

  // To draw more than needed never makes a gap.
  for (std::uint32_t c = 0; c < chains.passes.size(); ++c)
    put_back_short_runs(lines, chains.passes[c], chains.closed[c] != 0, out);

  DistinctLines result;
  std::vector<std::vector<std::uint32_t>> stands_for(lines.size());
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    if (out[k].empty()) continue;
    ++result.near_coincident;
    for (const Beside& b : beside[k])
      if (std::any_of(out[k].begin(), out[k].end(),
                      [&](const Range& r) { return r.first <= b.range.first && b.range.last <= r.last; }))
        stands_for[b.line].push_back(k);
  }
  for (std::uint32_t k = 0; k < lines.size(); ++k)
    for (const PaperLine& part : rest(lines[k], out[k])) {
      for (const std::uint32_t other : stands_for[k])
        result.stands_for.push_back({static_cast<std::uint32_t>(result.lines.size()), other});
      result.lines.push_back(part);
      result.part_of.push_back(k);
    }
  return result;
}

}  // namespace hsr::internal
