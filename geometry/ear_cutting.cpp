#include "geometry/ear_cutting.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <queue>

namespace hsr::internal {

namespace {

using Corner = std::uint32_t;  // a place in the polygon; several may be at one vertex
constexpr std::uint32_t none = 0xffffffffU;

enum class Rule { closed, open };  // the first and the second kind of ear

// The polygon as a doubly linked ring of corners. Whether the lowest corner is an ear is tested when its turn comes; a corner
// that is none waits at the corner that is in its way and goes on from there when that is gone: removals alone never bring a
// new one. What a removal does change, the neighbours and the edges at their vertices, is tested anew.
class EarCutter {
 public:
  EarCutter(const FlatPlane& plane, std::span<const VertexId> polygon);
  EarCutting run();

 private:
  VertexId vertex(Corner c) const { return polygon_[c]; }
  bool is_same_vertex(Corner a, Corner b) const { return polygon_[a] == polygon_[b]; }
  Sign orientation(Corner a, Corner b, Corner c) const { return plane_.orientation(polygon_[a], polygon_[b], polygon_[c]); }
  bool is_spike_at(Corner c) const { return is_spike(point(previous_[c]), point(c), point(next_[c]), plane_.predicates); }
  const Point3& point(Corner c) const { return plane_.points[polygon_[c]]; }

  void enqueue(Corner c);
  void start_anew(Corner c);
  void start_anew_around(Corner c);
  bool blocks(Corner t, Corner ear, Rule rule) const;
  Corner in_the_way(Corner ear, Corner from, Rule rule) const;

  bool cut_closed_ear();
  bool cut_open_ear();
  bool cut_by_force();
  void cut(Corner ear);
  void remove(Corner c);
  void drop_spikes(Corner p);
  void match(std::uint32_t side, std::uint32_t other);

  FlatPlane plane_;
  std::span<const VertexId> polygon_;
  std::vector<double> u_, v_;                           // the two coordinates, for quick boxes
  std::vector<Corner> previous_, next_;                 // links of removed corners keep leading onward
  std::vector<std::uint32_t> side_;                     // the edge to the next corner: none, or 4 triangle + side of a diagonal
  std::vector<char> is_alive_, is_convex_, is_queued_;  // char: vector<bool> is slow
  std::vector<Corner> resume_;                          // where the first rule's test goes on; none: from the start
  std::vector<Corner> blocker_;                         // what was in the way by the second rule
  std::vector<Corner> ascending_;                       // all corners, lowest first
  std::vector<std::uint32_t> rank_;                     // the place of the first corner at the same vertex in ascending_
  struct Wait {
    Corner corner;
    std::uint32_t next;
  };
  std::vector<Wait> waits_;
  std::vector<std::uint32_t> first_wait_;
  std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>> queue_;
  std::size_t first_alive_ = 0;  // nothing before it in ascending_ is alive
  std::size_t size_;
  EarCutting result_;
};

EarCutter::EarCutter(const FlatPlane& plane, std::span<const VertexId> polygon)
    : plane_(plane), polygon_(polygon), size_(polygon.size()) {
  const std::size_t n = polygon.size();
  const int i = plane.axis == 2 ? 0 : plane.axis + 1;
  const int j = plane.axis == 0 ? 2 : plane.axis - 1;
  for (const VertexId v : polygon) {
    u_.push_back(plane.points[v][i]);
    v_.push_back(plane.points[v][j]);
  }
  previous_.resize(n);
  next_.resize(n);
  for (Corner c = 0; c < n; ++c) {
    next_[c] = c + 1 == n ? 0 : c + 1;
    previous_[next_[c]] = c;
  }
  side_.assign(n, none);
  is_alive_.assign(n, 1);
  is_convex_.assign(n, 0);
  is_queued_.assign(n, 0);
  resume_.assign(n, none);
  blocker_.assign(n, none);
  first_wait_.assign(n, none);
  ascending_.resize(n);
  std::iota(ascending_.begin(), ascending_.end(), 0U);
  std::stable_sort(ascending_.begin(), ascending_.end(), [&](Corner a, Corner b) { return polygon[a] < polygon[b]; });
  rank_.resize(n);
  for (std::size_t k = 0; k < n; ++k)
    rank_[ascending_[k]] =
        k > 0 && is_same_vertex(ascending_[k - 1], ascending_[k]) ? rank_[ascending_[k - 1]] : static_cast<std::uint32_t>(k);
  for (Corner c = 0; c < n; ++c) start_anew(c);
}

void EarCutter::enqueue(Corner c) {
  if (is_queued_[c]) return;
  is_queued_[c] = 1;
  queue_.push(static_cast<std::uint64_t>(vertex(c).value) << 32 | c);
}

// The neighbours of c have changed, or the edges at a vertex of its triangle.
void EarCutter::start_anew(Corner c) {
  is_convex_[c] = orientation(previous_[c], c, next_[c]) == Sign::positive;
  resume_[c] = none;
  blocker_[c] = none;
  if (is_convex_[c]) enqueue(c);
}

void EarCutter::start_anew_around(Corner c) {
  start_anew(c);
  const std::uint32_t rank = rank_[c];
  for (std::size_t k = rank; k < ascending_.size() && rank_[ascending_[k]] == rank; ++k) {
    const Corner visit = ascending_[k];
    if (visit == c || !is_alive_[visit]) continue;
    start_anew(previous_[visit]);
    start_anew(visit);
    start_anew(next_[visit]);
  }
}

bool EarCutter::blocks(Corner t, Corner ear, Rule rule) const {
  const Corner a = previous_[ear], b = ear, c = next_[ear];
  if (u_[t] < std::min({u_[a], u_[b], u_[c]}) || u_[t] > std::max({u_[a], u_[b], u_[c]}) ||
      v_[t] < std::min({v_[a], v_[b], v_[c]}) || v_[t] > std::max({v_[a], v_[b], v_[c]}))
    return false;
  const Sign ab = orientation(a, b, t);
  if (ab == Sign::negative) return false;
  const Sign bc = orientation(b, c, t);
  if (bc == Sign::negative) return false;
  const Sign ca = orientation(c, a, t);
  if (ca == Sign::negative) return false;
  if (rule == Rule::closed && !is_same_vertex(t, a) && !is_same_vertex(t, b) && !is_same_vertex(t, c)) return true;
  if (ab == Sign::positive && bc == Sign::positive && ca == Sign::positive) return true;
  for (const Corner z : {previous_[t], next_[t]}) {
    const bool runs_inside = (ab != Sign::zero || orientation(a, b, z) == Sign::positive) &&
                             (bc != Sign::zero || orientation(b, c, z) == Sign::positive) &&
                             (ca != Sign::zero || orientation(c, a, z) == Sign::positive);
    if (runs_inside) return true;
  }
  return false;
}

Corner EarCutter::in_the_way(Corner ear, Corner from, Rule rule) const {
  const Corner end = previous_[ear];
  for (Corner t = from; t != end; t = next_[t])
    if (is_alive_[t] && blocks(t, ear, rule)) return t;
  return none;
}

bool EarCutter::cut_closed_ear() {
  while (!queue_.empty()) {
    const auto c = static_cast<Corner>(queue_.top());
    queue_.pop();
    is_queued_[c] = 0;
    if (!is_alive_[c] || !is_convex_[c]) continue;
    const Corner t = in_the_way(c, resume_[c] == none ? next_[next_[c]] : resume_[c], Rule::closed);
    if (t == none) {
      cut(c);
      return true;
    }
    resume_[c] = t;
    waits_.push_back({c, first_wait_[t]});
    first_wait_[t] = static_cast<std::uint32_t>(waits_.size() - 1);
  }
  return false;
}

bool EarCutter::cut_open_ear() {
  for (std::size_t k = first_alive_; k < ascending_.size(); ++k) {
    const Corner c = ascending_[k];
    if (!is_alive_[c] || !is_convex_[c]) continue;
    if (blocker_[c] != none && is_alive_[blocker_[c]] && blocks(blocker_[c], c, Rule::open)) continue;
    blocker_[c] = in_the_way(c, next_[next_[c]], Rule::open);
    if (blocker_[c] != none) continue;
    cut(c);
    return true;
  }
  return false;
}

bool EarCutter::cut_by_force() {
  result_.only_ears = false;
  for (std::size_t k = first_alive_; k < ascending_.size(); ++k) {
    const Corner c = ascending_[k];
    if (!is_alive_[c] || !is_convex_[c]) continue;
    cut(c);
    return true;
  }
  for (std::size_t k = first_alive_; k < ascending_.size(); ++k) {
    const Corner c = ascending_[k];
    if (!is_alive_[c] || !has_area(point(previous_[c]), point(c), point(next_[c]), plane_.predicates)) continue;
    cut(c);
    return true;
  }
  return false;
}

void EarCutter::cut(Corner ear) {
  const Corner p = previous_[ear], n = next_[ear];
  const auto t = static_cast<std::uint32_t>(result_.triangles.size());
  const unsigned ring_sides = (side_[p] == none ? 1U : 0U) | (side_[ear] == none ? 2U : 0U);
  result_.triangles.push_back({{vertex(p), vertex(ear), vertex(n)}, static_cast<std::uint8_t>(ring_sides)});
  side_[p] = 4 * t + 2;
  remove(ear);
  start_anew_around(p);
  start_anew_around(n);
  drop_spikes(p);
}

void EarCutter::remove(Corner c) {
  const Corner p = previous_[c], n = next_[c];
  next_[p] = n;
  previous_[n] = p;
  is_alive_[c] = 0;
  --size_;
  for (std::uint32_t w = first_wait_[c]; w != none; w = waits_[w].next)
    if (is_alive_[waits_[w].corner] && is_convex_[waits_[w].corner]) enqueue(waits_[w].corner);
  while (first_alive_ < ascending_.size() && !is_alive_[ascending_[first_alive_]]) ++first_alive_;
}

// Two edges run along each other to and fro: a side of a triangle that lies on an edge of the polygon is one.
void EarCutter::match(std::uint32_t side, std::uint32_t other) {
  if (side == none && other != none) std::swap(side, other);
  if (side != none && other == none) result_.triangles[side / 4].ring_sides |= static_cast<std::uint8_t>(1U << (side % 4));
}

// Whatever the new edge from p made turn back on itself.
void EarCutter::drop_spikes(Corner p) {
  while (size_ > 2) {
    Corner spike = none;
    if (is_spike_at(p))
      spike = p;
    else if (is_spike_at(next_[p]))
      spike = next_[p];
    if (spike == none) return;
    const Corner before = previous_[spike], after = next_[spike];
    if (is_same_vertex(before, after)) {
      match(side_[before], side_[spike]);
      side_[before] = side_[after];
      remove(spike);
      remove(after);  // the same vertex as `before`
    } else {
      result_.only_ears = false;
      remove(spike);
    }
    start_anew_around(before);
    start_anew_around(next_[before]);
    p = before;
  }
  if (size_ == 2) {
    match(side_[p], side_[next_[p]]);
    size_ = 0;
  }
}

EarCutting EarCutter::run() {
  while (size_ > 2 && (cut_closed_ear() || cut_open_ear() || cut_by_force())) {
  }
  return std::move(result_);
}

// --- overlap ---

struct Box {
  double left, right, bottom, top;
  std::uint32_t what;
};

// Whether `meets` holds for no two boxes that overlap: sweep from left to right.
template <class Meets>
bool no_two_meet(std::vector<Box> boxes, const Meets& meets) {
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.left < b.left; });
  std::vector<Box> active;
  for (const Box& box : boxes) {
    std::size_t kept = 0;
    for (const Box& other : active) {
      if (other.right < box.left) continue;
      active[kept++] = other;
      if (other.bottom <= box.top && box.bottom <= other.top && meets(box.what, other.what)) return false;
    }
    active.resize(kept);
    active.push_back(box);
  }
  return true;
}

Box box_of(const FlatPlane& plane, std::span<const VertexId> corners, std::uint32_t what) {
  const int i = plane.axis == 2 ? 0 : plane.axis + 1;
  const int j = plane.axis == 0 ? 2 : plane.axis - 1;
  const Point3& first = plane.points[corners[0]];
  Box box{first[i], first[i], first[j], first[j], what};
  for (const VertexId v : corners) {
    const Point3& p = plane.points[v];
    box.left = std::min(box.left, p[i]);
    box.right = std::max(box.right, p[i]);
    box.bottom = std::min(box.bottom, p[j]);
    box.top = std::max(box.top, p[j]);
  }
  return box;
}

// Closed segments; boxes that overlap are given, so collinear ones count as touching.
bool touch(const FlatPlane& plane, const std::array<VertexId, 2>& a, const std::array<VertexId, 2>& b) {
  return plane.orientation(a[0], a[1], b[0]) * plane.orientation(a[0], a[1], b[1]) != Sign::positive &&
         plane.orientation(b[0], b[1], a[0]) * plane.orientation(b[0], b[1], a[1]) != Sign::positive;
}

// Triangles that run counter-clockwise are disjoint inside iff a side of one has the other on its right.
bool overlap(const FlatPlane& plane, const std::array<VertexId, 3>& a, const std::array<VertexId, 3>& b) {
  const auto side_separates = [&](const std::array<VertexId, 3>& of, const std::array<VertexId, 3>& from) {
    for (unsigned k = 0; k < 3; ++k)
      if (std::all_of(from.begin(), from.end(), [&](VertexId v) {
            return v == of[k] || v == of[(k + 1) % 3] || plane.orientation(of[k], of[(k + 1) % 3], v) != Sign::positive;
          }))
        return true;
    return false;
  };
  return !side_separates(a, b) && !side_separates(b, a);
}

}  // namespace

EarCutting cut_ears(const FlatPlane& plane, std::span<const VertexId> polygon) { return EarCutter(plane, polygon).run(); }

bool is_free_of_overlap(const FlatPlane& plane, std::span<const VertexId> polygon, std::span<const FaceTriangle> triangles) {
  // Positive triangles glued side to side along the diagonals, all vertices on the border: a locally injective image of a disc.
  // If the border is a simple closed curve, every point inside has as many preimages as its winding number: one.
  const auto n = static_cast<std::uint32_t>(polygon.size());
  std::vector<Box> boxes;
  const auto edge = [&](std::uint32_t e) { return std::array{polygon[e], polygon[e + 1 == n ? 0 : e + 1]}; };
  for (std::uint32_t e = 0; e < n; ++e) boxes.push_back(box_of(plane, edge(e), e));
  const bool is_simple = no_two_meet(std::move(boxes), [&](std::uint32_t d, std::uint32_t e) {
    if (d > e) std::swap(d, e);
    // Neighbours meet in their corner, and nowhere else: the polygon has no spikes.
    if (e - d == 1 || e - d == n - 1) return false;
    return touch(plane, edge(d), edge(e));
  });
  if (is_simple) return true;
  boxes.clear();
  for (std::uint32_t t = 0; t < triangles.size(); ++t) boxes.push_back(box_of(plane, triangles[t].corners, t));
  return no_two_meet(std::move(boxes), [&](std::uint32_t s, std::uint32_t t) {
    return overlap(plane, triangles[s].corners, triangles[t].corners);
  });
}

}  // namespace hsr::internal
