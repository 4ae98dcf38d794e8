// How a BspTree is built: which planes divide, and what becomes of the pieces.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <string>

#include "geometry/cancel.h"
#include "geometry/error.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/bsp/bsp_nodes.h"
#include "hsr/painter/bsp/bsp_observer.h"
#include "hsr/painter/bsp/bsp_parts.h"
#include "hsr/painter/bsp/side_bits.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/half_space.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/visibility_map/convex_ring.h"

namespace hsr::internal {

namespace {

constexpr std::size_t small_node = 24;  // faces: below it the planes of faces divide, above it mostly planes across axes
constexpr std::size_t tested = 48;      // faces of a node that a plane is tried on

View any_view() {
  View view;
  view.viewpoint = {{0, 0, 1}, true};
  return view;
}

/// Little is good: cuts, and parts more on one side than on the other.
std::size_t score(std::size_t behind, std::size_t before, std::size_t both) {
  return 8 * both + (behind > before ? behind - before : before - behind);
}

std::size_t number_of(std::uint64_t bits) { return static_cast<std::size_t>(std::popcount(bits)); }

/// Ascending.
template <class F>
void for_each_bit(std::uint64_t bits, const F& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

class BspBuilder {
 public:
  /// What all builders of one tree share.
  struct Shared {
    const ProjectedMesh& projected;  // of no view in particular: its points and planes
    const std::vector<BspBounds::Side>& sides;
    std::size_t most = 0;
    std::atomic<std::size_t> pieces = 0;
    const SomeFacets* some = nullptr;  // or all
    BspObserver* observer = nullptr;   // or nobody
  };

  BspBuilder(BspNodes& tree, Shared& shared, std::uint64_t seed)
      : tree_(tree),
        mesh_(shared.projected.mesh()),
        shared_(shared),
        projected_(shared.projected),
        parts_(projected_, shared.sides, tree.bounds.acrosses),
        seed_(seed) {}

  /// All facets, their count first.
  void add_facets();
  std::size_t parts() const { return parts_.size(); }
  void build();

 private:
  using Divider = BspParts::Divider;
  /// A node that is still to be divided: it has the parts from `first` to the end of the stack of waiting parts.
  struct Task {
    std::size_t first;
    std::uint32_t parent;
    bool is_before;
    std::uint32_t depth;
  };
  /// A task that another builder will do, with its parts.
  struct Subtree {
    std::vector<std::uint32_t> parts;
    Task task;
  };

  void add_facet(FacetId facet);
  void add_part(FacetId facet, std::span<const VertexId> ring, int axis, const std::vector<std::uint8_t>& original);
  void build_subtrees(const std::vector<Subtree>& subtrees);
  void take_subtree(const BspNodes& part, const Task& task, std::size_t acrosses);
  void take_sample(std::span<const std::uint32_t> parts);
  Divider choose(std::span<const std::uint32_t> parts);
  std::size_t score_across(std::size_t axis, float at) const;
  std::size_t score_face(const Divider& d);
  bool sort_parts(const Divider& d, std::span<const std::uint32_t> parts);
  void divide(const Task& task);
  void divide_small(const Task& task);
  const SideBits<small_node>::Row& small_row(std::size_t place, std::uint64_t parts);
  std::size_t choose_small(std::uint64_t parts);
  std::array<std::uint32_t, 2> split(std::uint32_t part, const Divider& d);
  std::uint32_t add_node(const Cut& plane, const Task& task, std::span<std::uint32_t> inside);
  std::vector<PieceCorner> ring_of(std::uint32_t part) const;
  std::vector<std::uint32_t> parts_in(std::uint64_t places) const;
  std::uint64_t random() {  // splitmix64, Steele, Lea & Flood 2014
    std::uint64_t z = (seed_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// Some parts of a node, and their corners a coordinate at a time: what planes are tried on.
  struct Sample {
    std::array<std::array<float, tested>, 3> low, high;
    std::vector<double> x, y, z, error;
    std::vector<double> side;        // of a plane, by corner: 1, before it; -1, behind; 0, or doubles do not tell
    std::vector<std::uint32_t> end;  // by part
    std::vector<std::uint32_t> parts;
  };

  BspNodes& tree_;
  const Mesh& mesh_;
  Shared& shared_;
  const ProjectedMesh& projected_;
  BspParts parts_;
  std::uint64_t seed_;
  std::vector<Task> tasks_;
  std::vector<std::uint32_t> waiting_;                   // the parts of all tasks
  std::vector<std::uint32_t> behind_, before_, inside_;  // of a plane
  std::vector<std::uint32_t> now_;                       // the parts of a task
  /// The parts of a node below a small one: bit k, that in place k.
  struct SmallNode {
    std::uint64_t parts;
    Task task;
  };
  std::vector<SmallNode> small_open_;
  /// The parts below a small node, and the planes of their facets.
  struct Small {
    std::uint64_t used = 0;                                        // places
    std::array<std::uint32_t, SideBits<small_node>::places> part;  // by place
    std::array<std::uint8_t, SideBits<small_node>::places> plane;  // by place: that of its facet
    std::array<Divider, small_node> dividers;                      // by plane, once it is asked for
    SideBits<small_node> sides;
  };
  Small small_;
  Sample sample_;
};

/// For an observer.
std::vector<PieceCorner> BspBuilder::ring_of(std::uint32_t part) const {
  std::vector<PieceCorner> ring;
  for (const BspParts::Corner& c : parts_.corners(parts_[part])) ring.push_back(tree_.corner(c.bounds));
  return ring;
}

std::vector<std::uint32_t> BspBuilder::parts_in(std::uint64_t places) const {
  std::vector<std::uint32_t> parts;
  for_each_bit(places, [&](std::size_t place) { parts.push_back(small_.part[place]); });
  return parts;
}

/// The sides of a facet as planes parallel to an axis: they do not depend on a view.
void BspBuilder::add_part(FacetId facet, std::span<const VertexId> ring, int axis, const std::vector<std::uint8_t>& original) {
  std::vector<BspBounds::Corner> corners;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const VertexId u = ring[k], v = ring[(k + 1) % ring.size()];
    corners.push_back({u.value, BspBounds::none,
                       tree_.bounds.add({std::min(u, v), std::max(u, v), static_cast<std::uint8_t>(axis), original[k] != 0})});
  }
  const std::uint32_t part = parts_.add(facet, corners);
  parts_.find_box(part);
  if (shared_.observer != nullptr) shared_.observer->added_part(part, facet, ring_of(part));
}

void BspBuilder::add_facet(FacetId facet) {
  const TriangleId end = facet_end(mesh_, facet);
  const int axis = dropped_axis(projected_, first_triangle(facet), parts_.exact());
  std::vector<std::uint8_t> original(3, 1);
  if (triangle_count(mesh_, facet) > 1) {
    if (const std::vector<VertexId> ring = convex_ring(projected_, facet, parts_.exact()); !ring.empty()) {
      original.assign(ring.size(), 1);
      add_part(facet, ring, axis, original);
      return;
    }
  }
  for (TriangleId t = first_triangle(facet); t < end; t = TriangleId(t.value + 1U)) {
    for (std::size_t k = 0; k < 3; ++k) original[k] = goes_around_face(mesh_, facet, 3) || is_edge_of_face(mesh_, t, k) ? 1 : 0;
    add_part(facet, mesh_.triangles[t], axis, original);
  }
}

void BspBuilder::add_facets() {
  if (shared_.some != nullptr) {
    for (const FacetId facet : shared_.some->facets) add_facet(facet);
    return;
  }
  const std::size_t n = mesh_.triangles.size();
  parts_.reserve(n, 3 * n);
  tree_.bounds.sides.reserve(3 * n);
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
    if (is_first(mesh_, TriangleId(i))) add_facet(FacetId(i));
}

void BspBuilder::take_sample(std::span<const std::uint32_t> parts) {
  Sample& s = sample_;
  for (std::vector<double>* v : {&s.x, &s.y, &s.z, &s.error}) v->clear();
  s.end.clear();
  s.parts.clear();
  const std::size_t n = std::min(tested, parts.size());
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t index = parts[k * parts.size() / n];
    const BspParts::Part& part = parts_[index];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      s.low[axis][k] = part.low[axis];
      s.high[axis][k] = part.high[axis];
    }
    for (const BspParts::Corner& corner : parts_.corners(part)) {
      s.x.push_back(corner.at.p.x);
      s.y.push_back(corner.at.p.y);
      s.z.push_back(corner.at.p.z);
      s.error.push_back(corner.at.error);
    }
    s.end.push_back(static_cast<std::uint32_t>(s.x.size()));
    s.parts.push_back(index);
  }
  s.side.resize(s.x.size());
}

/// As large as possible: the plane divides nothing. By floats: no tree is wrong for a wrong guess.
std::size_t BspBuilder::score_across(std::size_t axis, float at) const {
  const std::size_t n = sample_.parts.size();
  const float *const low = sample_.low[axis].data(), *const high = sample_.high[axis].data();
  std::uint32_t only_behind = 0, only_before = 0, inside = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t is_behind = low[k] < at ? 1 : 0, is_before = high[k] > at ? 1 : 0;
    only_behind += is_behind & ~is_before;
    only_before += is_before & ~is_behind;
    inside += 1U & ~(is_behind | is_before);
  }
  const std::size_t both = n - only_behind - only_before - inside, behind = only_behind, before = only_before;
  const bool divides = (behind > 0 && before > 0) || inside > 0;
  if (!divides || behind + both == n || before + both == n) return ~std::size_t{0};
  // Where all others lie on one side, it takes the faces in it out of a large node, and no more.
  if ((behind + both == 0 || before + both == 0) && inside <= 1) return 2 * n;
  return score(behind, before, both);
}

/// By doubles: what is too near to the plane for them counts as in it.
std::size_t BspBuilder::score_face(const Divider& d) {
  Sample& s = sample_;
  const std::size_t corners = s.x.size(), n = s.end.size();
  double* const sides = s.side.data();
  const double* const error = s.error.data();
  const double *const x = s.x.data(), *const y = s.y.data(), *const z = s.z.data();
  const PlaneFilter f = d.filter;
  const double spread = f.spread();
  for (std::size_t i = 0; i < corners; ++i) {
    const ErrorBounded value = f(Point3{x[i], y[i], z[i]});
    const double bound = value.error + spread * error[i];
    sides[i] = (value.value > bound ? 1.0 : 0.0) - (value.value < -bound ? 1.0 : 0.0);
  }
  std::array<std::size_t, 4> count = {0, 0, 0, 0};  // by whether some is behind, and before
  std::uint32_t corner = 0;
  for (std::size_t k = 0; k < n; ++k) {
    double least = 0, most = 0;
    for (; corner < s.end[k]; ++corner) {
      least = std::min(least, sides[corner]);
      most = std::max(most, sides[corner]);
    }
    const bool is_own = d.id == BspBounds::facet(parts_[s.parts[k]].facet);
    ++count[is_own ? 0U : unsigned{least < 0} | unsigned{most > 0} << 1U];
  }
  const auto [inside, behind, before, both] = count;
  const bool divides = (behind > 0 && before > 0) || inside > 0;
  if (!divides || behind + both == n || before + both == n) return 9 * n;
  if ((behind + both == 0 || before + both == 0) && inside <= 1) return 2 * n;
  return score(behind, before, both);
}

/// Of a large node.
BspBuilder::Divider BspBuilder::choose(std::span<const std::uint32_t> parts) {
  take_sample(parts);
  struct Best {
    std::size_t score = ~std::size_t{0};
    VertexId vertex;
    int axis = 0;
  } best;
  // Planes across the axes at quantiles of some vertices.
  constexpr std::size_t vertices = 31;
  std::array<VertexId, vertices> some;
  std::size_t count = 0;
  for (std::size_t k = 0; k < vertices; ++k) {
    const auto corners = parts_.corners(parts_[parts[static_cast<std::size_t>(random() % parts.size())]]);
    const BspBounds::Corner& c = corners[static_cast<std::size_t>(random() % corners.size())].bounds;
    if (c.is_vertex()) some[count++] = VertexId(c.a);
  }
  for (int axis = 0; axis < 3 && count > 0; ++axis) {
    struct Place {
      double at;
      VertexId vertex;
    };
    std::array<Place, vertices> places;
    for (std::size_t k = 0; k < count; ++k) places[k] = {projected_.point(some[k])[axis], some[k]};
    std::sort(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Place& x, const Place& y) { return x.at != y.at ? x.at < y.at : x.vertex < y.vertex; });
    for (const std::size_t tenths : {3U, 4U, 5U, 6U, 7U}) {
      const Place& place = places[count * tenths / 10];
      const std::size_t s = score_across(static_cast<std::size_t>(axis), static_cast<float>(place.at));
      if (s < best.score) best = {s, place.vertex, axis};
    }
  }
  // Planes of some faces.
  Divider face;
  bool is_face = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t part = parts[static_cast<std::size_t>(random() % parts.size())];
    const Divider d = parts_.divider(parts_[part].facet);
    const std::size_t s = score_face(d);
    if (s >= best.score) continue;
    best.score = s;
    face = d;
    is_face = true;
  }
  if (is_face) return face;
  Divider across = parts_.divider(best.vertex, best.axis);
  across.id = BspBounds::across(tree_.bounds.acrosses.size());
  return across;
}

std::array<std::uint32_t, 2> BspBuilder::split(std::uint32_t part, const Divider& d) {
  ++tree_.splits;
  const SomeFacets* const some = shared_.some;
  if (some != nullptr) throw_if_stopped(some->stop);
  if (++shared_.pieces > shared_.most)
    throw InputError((some != nullptr ? some->method : "bsp") +
                     (": this scene takes more than " + std::to_string(shared_.most)) + " pieces, expected fewer" +
                     (some != nullptr ? "" : ": --method depth-sort cuts less"));
  const auto halves = parts_.split(part, d);
  if (shared_.observer != nullptr) shared_.observer->split(part, halves[0], ring_of(halves[0]), halves[1], ring_of(halves[1]));
  return halves;
}

/// False: nothing is divided.
bool BspBuilder::sort_parts(const Divider& d, std::span<const std::uint32_t> parts) {
  behind_.clear();
  before_.clear();
  inside_.clear();
  const auto axis = static_cast<std::size_t>(d.cut.axis);
  const auto at = static_cast<float>(d.at);
  for (const std::uint32_t index : parts) {
    const BspParts::Part& part = parts_[index];
    BspParts::Sides sides;
    // Most boxes tell.
    if (d.is_across() && (part.high[axis] < at || part.low[axis] > at))
      sides = {part.high[axis]<at, part.low[axis]> at};
    else
      sides = parts_.sides(d, part);
    if (sides.behind && sides.before) {
      const auto [behind, before] = split(index, d);
      for (const std::uint32_t half : {behind, before}) parts_.find_box(half);
      behind_.push_back(behind);
      before_.push_back(before);
    } else {
      (sides.behind ? behind_ : sides.before ? before_ : inside_).push_back(index);
    }
  }
  return !inside_.empty() || (!behind_.empty() && !before_.empty());
}

/// A node with the parts that lie in its plane.
std::uint32_t BspBuilder::add_node(const Cut& plane, const Task& task, std::span<std::uint32_t> inside) {
  const auto node = static_cast<std::uint32_t>(tree_.nodes.size());
  const auto first = static_cast<std::uint32_t>(tree_.pieces.size());
  tree_.depth = std::max<std::size_t>(tree_.depth, task.depth);
  if (node > 0) (task.is_before ? tree_.nodes[task.parent].before : tree_.nodes[task.parent].behind) = node;
  if (inside.size() > 1)
    std::stable_sort(inside.begin(), inside.end(),
                     [&](std::uint32_t x, std::uint32_t y) { return parts_[x].facet < parts_[y].facet; });
  for (const std::uint32_t index : inside) {
    const BspParts::Part& part = parts_[index];
    const auto corner = static_cast<std::uint32_t>(tree_.corners.size());
    for (const BspParts::Corner& c : parts_.corners(part)) tree_.corners.push_back(c.bounds);
    tree_.pieces.push_back({part.facet, corner, static_cast<std::uint32_t>(tree_.corners.size())});
  }
  tree_.nodes.push_back({plane, 0, 0, first, static_cast<std::uint32_t>(tree_.pieces.size())});
  if (shared_.observer != nullptr) shared_.observer->added_node(node, task.parent, task.is_before, plane, inside);
  return node;
}

/// The parts of the task are the last that wait.
void BspBuilder::divide(const Task& task) {
  now_.assign(waiting_.begin() + static_cast<std::ptrdiff_t>(task.first), waiting_.end());
  waiting_.resize(task.first);
  if (shared_.observer != nullptr) shared_.observer->opened(now_, task.parent, task.is_before);
  Divider d = choose(now_);
  if (!sort_parts(d, now_)) {
    // Floats were mistaken about a plane across an axis. The plane of a face always has that face in it.
    d = parts_.divider(parts_[now_.front()].facet);
    sort_parts(d, now_);
  }
  if (d.is_across()) tree_.bounds.add_across(d.cut);
  const std::uint32_t node = add_node(d.cut, task, inside_);
  for (const bool is_before : {true, false}) {
    const std::vector<std::uint32_t>& side = is_before ? before_ : behind_;
    if (side.empty()) continue;
    tasks_.push_back({waiting_.size(), node, is_before, task.depth + 1});
    waiting_.insert(waiting_.end(), side.begin(), side.end());
  }
}

/// All that is below a small node. On which side of a face's plane a part lies is asked once, and kept for all nodes below: the
/// best of many planes costs little.
void BspBuilder::divide_small(const Task& task) {
  small_ = {};
  for (std::size_t k = task.first; k < waiting_.size(); ++k) {
    const std::size_t place = k - task.first;
    small_.part[place] = waiting_[k];
    small_.plane[place] = static_cast<std::uint8_t>(place);
    small_.used |= std::uint64_t{1} << place;
  }
  waiting_.resize(task.first);
  small_open_.assign(1, {small_.used, task});
  while (!small_open_.empty()) {
    const SmallNode node = small_open_.back();
    small_open_.pop_back();
    if (shared_.observer != nullptr) shared_.observer->opened(parts_in(node.parts), node.task.parent, node.task.is_before);
    const std::size_t best = choose_small(node.parts);
    // A plane has its own part in it.
    const auto row = number_of(node.parts) == 1 ? SideBits<small_node>::Row() : small_row(best, node.parts);
    std::uint64_t behind = node.parts & row.behind & ~row.before, before = node.parts & row.before & ~row.behind;
    const std::uint64_t both = node.parts & row.behind & row.before, inside = node.parts & ~(row.behind | row.before);
    if (number_of(small_.used) + number_of(both) > SideBits<small_node>::places) {
      // More than there are places for.
      tasks_.push_back({waiting_.size(), node.task.parent, node.task.is_before, node.task.depth});
      for_each_bit(node.parts, [&](std::size_t place) {
        waiting_.push_back(small_.part[place]);
        parts_.find_box(waiting_.back());
      });
      small_.used &= ~node.parts;
      continue;
    }
    for_each_bit(both, [&](std::size_t place) {
      const auto free = static_cast<std::size_t>(std::countr_zero(~small_.used));
      const auto halves = split(small_.part[place], small_.dividers[small_.plane[best]]);
      small_.part[place] = halves[0];
      small_.part[free] = halves[1];
      small_.plane[free] = small_.plane[place];
      small_.sides.cut(place, free);
      small_.used |= std::uint64_t{1} << free;
      behind |= std::uint64_t{1} << place;
      before |= std::uint64_t{1} << free;
    });
    inside_.clear();
    for_each_bit(inside, [&](std::size_t place) { inside_.push_back(small_.part[place]); });
    small_.used &= ~inside;
    const std::uint32_t at = add_node({Cut::Kind::face, 0, parts_[small_.part[best]].facet.value, 0}, node.task, inside_);
    if (before != 0) small_open_.push_back({before, {0, at, true, node.task.depth + 1}});
    if (behind != 0) small_open_.push_back({behind, {0, at, false, node.task.depth + 1}});
  }
}

/// The sides of the plane of the part in a place, for all of `parts`.
const SideBits<small_node>::Row& BspBuilder::small_row(std::size_t place, std::uint64_t parts) {
  const std::size_t plane = small_.plane[place];
  BspParts::Divider& divider = small_.dividers[plane];
  if (divider.id == BspBounds::none) divider = parts_.divider(parts_[small_.part[place]].facet);
  return small_.sides.find(plane, parts, [&](std::size_t k) { return parts_.sides(divider, parts_[small_.part[k]]); });
}

/// The place of a part whose plane divides well; of eight that are tried, and of those that cost nothing, as they have been
/// tried above.
std::size_t BspBuilder::choose_small(std::uint64_t parts) {
  std::size_t least = ~std::size_t{0}, best = static_cast<std::size_t>(std::countr_zero(parts)), tries = 8;
  if (number_of(parts) == 1) return best;
  for (std::uint64_t left = parts; left != 0; left &= left - 1) {
    const auto place = static_cast<std::size_t>(std::countr_zero(left));
    const bool is_known = (parts & ~small_.sides[small_.plane[place]].known) == 0;
    if (!is_known && tries == 0) continue;
    if (!is_known) --tries;
    const SideBits<small_node>::Row& row = small_row(place, parts);
    const std::uint64_t behind = parts & row.behind, before = parts & row.before;
    const std::size_t s = score(number_of(behind & ~before), number_of(before & ~behind), number_of(behind & before));
    if (shared_.observer != nullptr)
      shared_.observer->tried({Cut::Kind::face, 0, parts_[small_.part[place]].facet.value, 0},
                              {number_of(behind), number_of(before), number_of(behind & before), s});
    if (s < least) {
      least = s;
      best = place;
    }
    if ((behind & before) == 0) break;
  }
  return best;
}

/// The top of the tree first, then what is below it in parallel: where it is parted does not depend on the threads.
void BspBuilder::build() {
  constexpr std::size_t least = 16'384, share = 32;
  const std::size_t small = std::max(least, parts_.size() / share);
  std::vector<Subtree> subtrees;
  for (std::uint32_t k = 0; k < parts_.size(); ++k) waiting_.push_back(k);
  if (!waiting_.empty()) tasks_.push_back({0, 0, false, 1});
  const bool is_large = parts_.size() > small;
  while (!tasks_.empty()) {
    const Task task = tasks_.back();
    tasks_.pop_back();
    const std::size_t n = waiting_.size() - task.first;
    if (is_large && n <= small) {
      subtrees.push_back({{waiting_.begin() + static_cast<std::ptrdiff_t>(task.first), waiting_.end()}, task});
      waiting_.resize(task.first);
    } else if (n <= small_node) {
      divide_small(task);
    } else {
      divide(task);
    }
  }
  build_subtrees(subtrees);
  tree_.decisions += parts_.exact().counts();
}

void BspBuilder::build_subtrees(const std::vector<Subtree>& subtrees) {
  std::vector<BspNodes> built(subtrees.size(), BspNodes());
  const std::uint64_t seed = seed_;
  const std::vector<Cut> acrosses = tree_.bounds.acrosses;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, subtrees.size(), 1), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k) {
      built[k].bounds.acrosses = acrosses;
      BspBuilder builder(built[k], shared_, seed + k);
      for (const std::uint32_t part : subtrees[k].parts) builder.parts_.add(parts_, parts_[part]);
      builder.build();
    }
  });
  std::size_t nodes = tree_.nodes.size(), pieces = tree_.pieces.size(), corners = tree_.corners.size();
  for (const BspNodes& part : built) {
    nodes += part.nodes.size();
    pieces += part.pieces.size();
    corners += part.corners.size();
  }
  check_countable(corners, "corners of a BSP");
  tree_.nodes.reserve(nodes);
  tree_.pieces.reserve(pieces);
  tree_.corners.reserve(corners);
  for (std::size_t k = 0; k < subtrees.size(); ++k) {
    take_subtree(built[k], subtrees[k].task, acrosses.size());
    built[k] = BspNodes();
  }
}

/// @param acrosses how many of its planes across an axis are those of the top of the tree
void BspBuilder::take_subtree(const BspNodes& part, const Task& task, std::size_t acrosses) {
  const auto node = static_cast<std::uint32_t>(tree_.nodes.size()), piece = static_cast<std::uint32_t>(tree_.pieces.size()),
             corner = static_cast<std::uint32_t>(tree_.corners.size());
  (task.is_before ? tree_.nodes[task.parent].before : tree_.nodes[task.parent].behind) = node;
  for (BspNodes::Node n : part.nodes) {
    if (n.before != 0) n.before += node;
    if (n.behind != 0) n.behind += node;
    n.first_piece += piece;
    n.end_piece += piece;
    tree_.nodes.push_back(n);
  }
  for (OrderedPiece p : part.pieces) {
    p.first_corner += corner;
    p.end_corner += corner;
    tree_.pieces.push_back(p);
  }
  const auto shift = static_cast<std::uint32_t>(tree_.bounds.acrosses.size() - acrosses);
  const auto shifted = [&](BspBounds::Id id) {
    return id != BspBounds::none && BspBounds::is_across(id) && BspBounds::place(id) >= acrosses ? id + shift : id;
  };
  for (const BspBounds::Corner& c : part.corners)
    tree_.corners.push_back({c.is_vertex() ? c.a : shifted(c.a), shifted(c.b), shifted(c.side)});
  for (std::size_t k = acrosses; k < part.bounds.acrosses.size(); ++k) tree_.bounds.add_across(part.bounds.acrosses[k]);
  tree_.depth = std::max(tree_.depth, part.depth + task.depth - 1);
  tree_.splits += part.splits;
  tree_.decisions += part.decisions;
}

BspNodes build_nodes(const Mesh& mesh, const BspOptions& options, const SomeFacets* some, BspObserver* observer) {
  BspNodes tree;
  tree.mesh = &mesh;
  if (mesh.triangles.empty()) return tree;
  const ProjectedMesh projected(mesh, any_view(), Arithmetic::staged);
  BspBuilder::Shared shared{projected, tree.bounds.sides};
  shared.some = some;
  shared.observer = observer;
  BspBuilder builder(tree, shared, options.seed);
  builder.add_facets();
  shared.pieces = builder.parts() + (some != nullptr ? some->pieces_before : 0);
  shared.most = options.most_pieces > 0 ? options.most_pieces : std::max<std::size_t>(1'000'000, builder.parts() * 64);
  builder.build();
  return tree;
}

}  // namespace hsr::internal
