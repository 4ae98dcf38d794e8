// How a BspTree is built: which planes divide, and what becomes of the pieces.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>

#include "geometry/constructed_point.h"
#include "geometry/error.h"
#include "hsr/contacts/half_space.h"
#include "hsr/cut_plane.h"
#include "hsr/facet.h"
#include "hsr/map/convex_ring.h"
#include "hsr/painter/bsp.h"
#include "hsr/sight.h"

namespace hsr {

namespace {

constexpr std::size_t small_node = 24;  // faces: below it the planes of faces divide, above it mostly planes across axes
constexpr std::size_t tested = 48;      // faces of a node that a plane is tried on

View any_view() {
  View view;
  view.viewpoint = {{0, 0, 1}, true};
  return view;
}

/// A corner and about where it is: within `error` in each coordinate, infinite where doubles tell nothing.
struct PlacedCorner {
  PieceCorner corner;
  Point3 p;
  double error = 0;
};

/// A convex part of a facet while the tree is built: corners as the facet runs.
struct Part {
  TriangleId facet;
  std::uint32_t first = 0, end = 0;  // corners
};

enum class Side : std::uint8_t { behind, before, inside, both };

}  // namespace

class BspBuilder {
 public:
  /// What all builders of one tree share.
  struct Shared {
    const Sight& sight;  // of no view in particular: its points and planes
    std::size_t most = 0;
    std::atomic<std::size_t> pieces = 0;
  };

  BspBuilder(BspTree& tree, Shared& shared, std::uint64_t seed)
      : tree_(tree),
        mesh_(shared.sight.mesh()),
        shared_(shared),
        sight_(shared.sight),
        exact_(sight_.predicates()),
        seed_(seed) {}

  /// All facets, their count first.
  void add_facets();
  std::size_t parts() const { return parts_.size(); }
  void build();

 private:
  struct Task {
    std::vector<std::uint32_t> parts;
    std::uint32_t parent;
    bool is_before;
    std::uint32_t depth;
  };
  struct Divider {
    Cut cut;
    Plane plane;
    PlaneFilter filter;
    double at = 0;  // of a cut across an axis: the coordinate
  };

  void build_subtrees(std::vector<Task> tasks);
  void take_parts(const BspBuilder& from, const std::vector<std::uint32_t>& parts);
  void take_subtree(BspTree&& part, const Task& task);
  void add_facet(TriangleId facet);
  void add_part(TriangleId facet, std::span<const VertexId> ring, int axis, const std::vector<std::uint8_t>& original);
  Divider divider(const Cut& cut) const;
  Sign side(const Divider& d, const PlacedCorner& placed, TriangleId facet);
  bool is_side_of(const Cut& cut, const Cut& face) const;
  PlacedCorner placed(const PieceCorner& corner, TriangleId facet) const;
  Side side(const Divider& d, const Part& part);
  void take_sample(const std::vector<std::uint32_t>& parts);
  Divider choose(const std::vector<std::uint32_t>& parts);
  std::size_t score(const Divider& d, bool is_large);
  struct Sorted {
    std::vector<std::uint32_t> behind, before, inside;
  };
  void sort_parts(const Divider& d, const std::vector<std::uint32_t>& parts, Sorted& sorted);
  void divide(const Task& task);
  std::array<std::uint32_t, 2> split(std::uint32_t part, const Divider& d);
  std::uint64_t random() {  // splitmix64, Steele, Lea & Flood 2014
    std::uint64_t z = (seed_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  std::uint32_t any(const std::vector<std::uint32_t>& parts) {
    return parts[static_cast<std::size_t>(random() % parts.size())];
  }

  /// Corners of some parts of a node, a coordinate at a time: what planes are tried on.
  struct Sample {
    std::vector<double> x, y, z, error;
    std::vector<double> side;        // of a plane, by corner: 1, before it; -1, behind; 0, or doubles do not tell
    std::vector<std::uint32_t> end;  // by part
    std::vector<TriangleId> facet;
  };

  BspTree& tree_;
  const Mesh& mesh_;
  Shared& shared_;
  const Sight& sight_;
  Predicates exact_;
  std::uint64_t seed_;
  std::vector<Part> parts_;
  std::vector<PlacedCorner> corners_;
  std::vector<Task> waiting_;
  std::vector<Sign> signs_;
  std::vector<PlacedCorner> crossings_;
  Sample sample_;
  std::vector<VertexId> vertices_;  // that planes across axes are tried at
};

/// The sides of a facet as planes parallel to an axis: they do not depend on a view.
void BspBuilder::add_part(TriangleId facet, std::span<const VertexId> ring, int axis,
                          const std::vector<std::uint8_t>& original) {
  Part part{facet, static_cast<std::uint32_t>(corners_.size()), 0};
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const VertexId u = ring[k], v = ring[(k + 1) % ring.size()];
    PieceCorner c;
    c.vertex = u;
    c.side = {Cut::Kind::line, static_cast<std::uint8_t>(axis), std::min(u, v).value, std::max(u, v).value};
    c.original = original[k] != 0;
    corners_.push_back({c, sight_.point(u), 0});
  }
  check_countable(corners_.size(), "corners of a BSP");
  part.end = static_cast<std::uint32_t>(corners_.size());
  parts_.push_back(part);
}

void BspBuilder::add_facet(TriangleId facet) {
  const TriangleId end = facet_end(mesh_, facet);
  const int axis = dropped_axis(sight_, facet, exact_);
  std::vector<std::uint8_t> original(3, 1);
  if (end.value - facet.value > 1) {
    if (const std::vector<VertexId> ring = convex_ring(sight_, facet, exact_); !ring.empty()) {
      original.assign(ring.size(), 1);
      add_part(facet, ring, axis, original);
      return;
    }
  }
  for (TriangleId t = facet; t < end; t = TriangleId(t.value + 1U)) {
    for (std::size_t k = 0; k < 3; ++k) original[k] = goes_around_face(mesh_, facet, 3) || is_edge_of_face(mesh_, t, k) ? 1 : 0;
    add_part(facet, mesh_.triangles[t], axis, original);
  }
}

void BspBuilder::add_facets() {
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
    if (facet_of(mesh_, TriangleId(i)) == TriangleId(i)) add_facet(TriangleId(i));
}

BspBuilder::Divider BspBuilder::divider(const Cut& cut) const {
  Divider d;
  d.cut = cut;
  d.plane = cut_plane(sight_, cut);
  if (cut.kind == Cut::Kind::across)
    d.at = sight_.point(VertexId(cut.u))[cut.axis];
  else
    d.filter = sight_.filter(d.plane);
  return d;
}

PlacedCorner BspBuilder::placed(const PieceCorner& corner, TriangleId facet) const {
  PlacedCorner out{corner, {}, HUGE_VAL};
  const auto at = near_meet(sight_.face_plane(facet), cut_plane(sight_, corner.a), cut_plane(sight_, corner.b));
  const double error = std::max({at[0].error, at[1].error, at[2].error});
  out.p = {at[0].value, at[1].value, at[2].value};
  // Beyond this a coordinate would break the bound of a filter.
  const double size = std::fabs(out.p.x) + std::fabs(out.p.y) + std::fabs(out.p.z);
  if (exact_.filter_is_proven() && size < 0x1p100 && error < 0x1p100) out.error = std::max(error, 0x1p-1000);
  return out;
}

/// Whether a cut is by an edge of the facet that is also one of the other face: then a corner on it lies in that face's plane.
bool BspBuilder::is_side_of(const Cut& cut, const Cut& face) const {
  if (cut.kind != Cut::Kind::line) return false;
  const auto& c = mesh_.triangles[TriangleId(face.u)];
  const auto has = [&](std::uint32_t v) { return v == c[0].value || v == c[1].value || v == c[2].value; };
  return has(cut.u) && has(cut.v);
}

/// On which side of the plane a corner of a part lies.
Sign BspBuilder::side(const Divider& d, const PlacedCorner& placed, TriangleId facet) {
  const PieceCorner& corner = placed.corner;
  const bool across = d.cut.kind == Cut::Kind::across;
  if (corner.vertex.is_valid()) {
    if (across) return sign_of(placed.p[d.cut.axis] - d.at);
    const auto& c = mesh_.triangles[TriangleId(d.cut.u)];
    if (corner.vertex == c[0] || corner.vertex == c[1] || corner.vertex == c[2]) return Sign::zero;
    const ErrorBounded x = d.filter(placed.p);
    return x.is_certain() ? sign_of(x.value) : exact_.side_beyond_filter(d.plane, placed.p);
  }
  if (corner.a == d.cut || corner.b == d.cut) return Sign::zero;
  if (!across && (is_side_of(corner.a, d.cut) || is_side_of(corner.b, d.cut))) return Sign::zero;
  ErrorBounded x;
  if (across) {
    x = ErrorBounded{placed.p[d.cut.axis], placed.error} - ErrorBounded{d.at, 0};
  } else {
    x = d.filter(placed.p);
    x.error +=
        (std::fabs(d.filter.nx) + std::fabs(d.filter.ny) + std::fabs(d.filter.nz) + 3 * d.filter.slope) * placed.error * 1.01;
  }
  if (x.is_certain()) return sign_of(x.value);
  return exact_.side(d.plane, sight_.face_plane(facet), cut_plane(sight_, corner.a), cut_plane(sight_, corner.b));
}

Side BspBuilder::side(const Divider& d, const Part& part) {
  if (d.cut.kind == Cut::Kind::face && TriangleId(d.cut.u) == part.facet) return Side::inside;
  bool before = false, behind = false;
  for (std::uint32_t k = part.first; k < part.end; ++k) {
    const Sign s = side(d, corners_[k], part.facet);
    before = before || s == Sign::positive;
    behind = behind || s == Sign::negative;
    if (before && behind) return Side::both;
  }
  return before ? Side::before : behind ? Side::behind : Side::inside;
}

void BspBuilder::take_sample(const std::vector<std::uint32_t>& parts) {
  Sample& s = sample_;
  for (std::vector<double>* v : {&s.x, &s.y, &s.z, &s.error}) v->clear();
  s.end.clear();
  s.facet.clear();
  const std::size_t n = std::min(tested, parts.size());
  for (std::size_t k = 0; k < n; ++k) {
    const Part& part = parts_[parts[k * parts.size() / n]];
    for (std::uint32_t c = part.first; c < part.end; ++c) {
      const PlacedCorner& corner = corners_[c];
      s.x.push_back(corner.p.x);
      s.y.push_back(corner.p.y);
      s.z.push_back(corner.p.z);
      s.error.push_back(corner.error);
    }
    s.end.push_back(static_cast<std::uint32_t>(s.x.size()));
    s.facet.push_back(part.facet);
  }
  s.side.resize(s.x.size());
}

/// Little is good: cuts, and parts more on one side than on the other. As large as possible: the plane divides nothing. By
/// doubles: what is too near to the plane for them counts as in it, and no tree is wrong for that.
std::size_t BspBuilder::score(const Divider& d, bool is_large) {
  Sample& s = sample_;
  const std::size_t corners = s.x.size(), n = s.end.size();
  const bool is_face = d.cut.kind == Cut::Kind::face;
  double* const sides = s.side.data();
  const double* const error = s.error.data();
  const auto side = [](double value, double bound) { return (value > bound ? 1.0 : 0.0) - (value < -bound ? 1.0 : 0.0); };
  if (is_face) {
    const PlaneFilter f = d.filter;
    const double spread = (std::fabs(f.nx) + std::fabs(f.ny) + std::fabs(f.nz) + 3 * f.slope) * 1.01;
    const double *const x = s.x.data(), *const y = s.y.data(), *const z = s.z.data();
    for (std::size_t i = 0; i < corners; ++i) {
      const ErrorBounded value = f({x[i], y[i], z[i]});
      sides[i] = side(value.value, value.error + spread * error[i]);
    }
  } else {
    const double* const at = d.cut.axis == 0 ? s.x.data() : d.cut.axis == 1 ? s.y.data() : s.z.data();
    for (std::size_t i = 0; i < corners; ++i) sides[i] = side(at[i] - d.at, error[i]);
  }
  std::array<std::size_t, 4> count = {0, 0, 0, 0};  // by whether some is behind, and before
  std::uint32_t corner = 0;
  for (std::size_t k = 0; k < n; ++k) {
    double least = 0, most = 0;
    for (; corner < s.end[k]; ++corner) {
      least = std::min(least, sides[corner]);
      most = std::max(most, sides[corner]);
    }
    const bool is_own = is_face && TriangleId(d.cut.u) == s.facet[k];
    ++count[is_own ? 0U : unsigned{least < 0} | unsigned{most > 0} << 1U];
  }
  const auto [inside, behind, before, both] = count;
  const bool divides = (behind > 0 && before > 0) || inside > 0;
  if (!divides || behind + both == n || before + both == n) return is_face ? 9 * n : ~std::size_t{0};
  // A face that all others lie on one side of takes itself out of a large node, and no more.
  if (is_large && (behind + both == 0 || before + both == 0) && inside <= 1) return 2 * n;
  return 8 * both + (behind > before ? behind - before : before - behind);
}

BspBuilder::Divider BspBuilder::choose(const std::vector<std::uint32_t>& parts) {
  if (parts.size() == 1) return divider({Cut::Kind::face, 0, parts_[parts.front()].facet.value, 0});
  take_sample(parts);
  const bool is_small = parts.size() <= small_node;
  Divider best;
  std::size_t least = ~std::size_t{0};
  const auto consider = [&](const Cut& cut) {
    const Divider d = divider(cut);
    const std::size_t s = score(d, !is_small);
    if (s >= least) return;
    least = s;
    best = d;
  };
  if (!is_small) {
    // Vertices at quantiles of each coordinate.
    vertices_.clear();
    for (std::size_t k = 0; k < 31; ++k) {
      const Part& part = parts_[any(parts)];
      const VertexId v = corners_[part.first + random() % (part.end - part.first)].corner.vertex;
      if (v.is_valid()) vertices_.push_back(v);
    }
    for (int axis = 0; axis < 3 && !vertices_.empty(); ++axis) {
      std::sort(vertices_.begin(), vertices_.end(), [&](VertexId u, VertexId v) {
        return std::pair(sight_.point(u)[axis], u) < std::pair(sight_.point(v)[axis], v);
      });
      for (const std::size_t tenths : {3U, 4U, 5U, 6U, 7U})
        consider({Cut::Kind::across, static_cast<std::uint8_t>(axis), vertices_[vertices_.size() * tenths / 10].value, 0});
    }
  }
  const std::size_t planes = is_small ? std::min<std::size_t>(8, parts.size()) : 4;
  // In a small node the first plane that cuts nothing is good enough.
  for (std::size_t k = 0; k < planes && !(is_small && least <= parts.size()); ++k) {
    const std::uint32_t part = is_small ? parts[k * parts.size() / planes] : any(parts);
    consider({Cut::Kind::face, 0, parts_[part].facet.value, 0});
  }
  return best;
}

/// The parts behind and before the plane.
std::array<std::uint32_t, 2> BspBuilder::split(std::uint32_t index, const Divider& d) {
  const Part part = parts_[index];
  const std::size_t n = part.end - part.first;
  signs_.clear();
  for (std::uint32_t k = part.first; k < part.end; ++k) signs_.push_back(side(d, corners_[k], part.facet));
  // A convex part has two sides that cross the plane, or fewer; both halves have the corners there.
  crossings_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    const PieceCorner& c = corners_[part.first + k].corner;
    if (signs_[k] * signs_[(k + 1) % n] == Sign::negative)
      crossings_.push_back(placed({{}, c.side, d.cut, c.side, c.original}, part.facet));
  }
  std::array<std::uint32_t, 2> halves;
  for (const Sign wanted : {Sign::negative, Sign::positive}) {
    Part half{part.facet, static_cast<std::uint32_t>(corners_.size()), 0};
    auto crossing = crossings_.begin();
    for (std::size_t k = 0; k < n; ++k) {
      const PlacedCorner corner = corners_[part.first + k];
      const Sign here = signs_[k] * wanted, next = signs_[(k + 1) % n] * wanted;
      const auto along_cut = [&](PlacedCorner c) {  // here the plane takes over
        c.corner.side = d.cut;
        c.corner.original = false;
        return c;
      };
      if (here == Sign::positive) {
        corners_.push_back(corner);
        if (next == Sign::negative) corners_.push_back(along_cut(*crossing++));
      } else if (here == Sign::zero) {
        corners_.push_back(next == Sign::positive ? corner : along_cut(corner));
      } else if (next == Sign::positive) {
        corners_.push_back(*crossing++);
      }
    }
    half.end = static_cast<std::uint32_t>(corners_.size());
    halves[wanted == Sign::positive ? 1 : 0] = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back(half);
  }
  check_countable(corners_.size(), "corners of a BSP");
  ++tree_.splits_;
  if (++shared_.pieces > shared_.most)
    throw InputError("bsp: this scene takes more than " + std::to_string(shared_.most) +
                     " pieces, expected fewer: --method depth-sort cuts less");
  return halves;
}

void BspBuilder::sort_parts(const Divider& d, const std::vector<std::uint32_t>& parts, Sorted& sorted) {
  for (const std::uint32_t part : parts) switch (side(d, parts_[part])) {
      case Side::behind:
        sorted.behind.push_back(part);
        break;
      case Side::before:
        sorted.before.push_back(part);
        break;
      case Side::inside:
        sorted.inside.push_back(part);
        break;
      case Side::both: {
        const auto halves = split(part, d);
        sorted.behind.push_back(halves[0]);
        sorted.before.push_back(halves[1]);
        break;
      }
    }
}

void BspBuilder::divide(const Task& task) {
  Divider d = choose(task.parts);
  Sorted sorted;
  sort_parts(d, task.parts, sorted);
  auto& [behind, before, inside] = sorted;
  if (inside.empty() && (behind.empty() || before.empty())) {
    // Doubles were mistaken about a plane across an axis. The plane of a face always has that face in it.
    sorted = {};
    d = divider({Cut::Kind::face, 0, parts_[task.parts.front()].facet.value, 0});
    sort_parts(d, task.parts, sorted);
  }
  const auto node = static_cast<std::uint32_t>(tree_.nodes_.size());
  tree_.nodes_.push_back({d.cut, 0, 0, static_cast<std::uint32_t>(tree_.pieces_.size()), 0});
  tree_.depth_ = std::max<std::size_t>(tree_.depth_, task.depth);
  if (node > 0) (task.is_before ? tree_.nodes_[task.parent].before : tree_.nodes_[task.parent].behind) = node;
  std::stable_sort(inside.begin(), inside.end(),
                   [&](std::uint32_t x, std::uint32_t y) { return parts_[x].facet < parts_[y].facet; });
  for (const std::uint32_t part : inside) {
    const auto first = static_cast<std::uint32_t>(tree_.corners_.size());
    for (std::uint32_t k = parts_[part].first; k < parts_[part].end; ++k) tree_.corners_.push_back(corners_[k].corner);
    tree_.pieces_.push_back({parts_[part].facet, first, static_cast<std::uint32_t>(tree_.corners_.size())});
  }
  tree_.nodes_[node].end_piece = static_cast<std::uint32_t>(tree_.pieces_.size());
  if (!before.empty()) waiting_.push_back({std::move(before), node, true, task.depth + 1});
  if (!behind.empty()) waiting_.push_back({std::move(behind), node, false, task.depth + 1});
}

/// The top of the tree first, then what is below it in parallel: where it is parted does not depend on the threads.
void BspBuilder::build() {
  constexpr std::size_t least = 16'384, share = 32;
  const std::size_t small = std::max(least, parts_.size() / share);
  std::vector<Task> subtrees;
  Task all{{}, 0, false, 1};
  for (std::uint32_t k = 0; k < parts_.size(); ++k) all.parts.push_back(k);
  if (!all.parts.empty()) waiting_.push_back(std::move(all));
  const bool is_large = parts_.size() > small;
  while (!waiting_.empty()) {
    Task task = std::move(waiting_.back());
    waiting_.pop_back();
    if (is_large && task.parts.size() <= small)
      subtrees.push_back(std::move(task));
    else
      divide(task);
  }
  build_subtrees(std::move(subtrees));
  tree_.decisions_ += exact_.counts();
}

void BspBuilder::take_parts(const BspBuilder& from, const std::vector<std::uint32_t>& parts) {
  for (const std::uint32_t p : parts) {
    const Part& part = from.parts_[p];
    const auto first = static_cast<std::uint32_t>(corners_.size());
    corners_.insert(corners_.end(), from.corners_.begin() + part.first, from.corners_.begin() + part.end);
    parts_.push_back({part.facet, first, static_cast<std::uint32_t>(corners_.size())});
  }
}

void BspBuilder::build_subtrees(std::vector<Task> tasks) {
  std::vector<BspTree> built(tasks.size(), BspTree());
  const std::uint64_t seed = seed_;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tasks.size(), 1), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k) {
      BspBuilder builder(built[k], shared_, seed + k);
      builder.take_parts(*this, tasks[k].parts);
      builder.build();
    }
  });
  for (std::size_t k = 0; k < tasks.size(); ++k) take_subtree(std::move(built[k]), tasks[k]);
}

void BspBuilder::take_subtree(BspTree&& part, const Task& task) {
  const auto node = static_cast<std::uint32_t>(tree_.nodes_.size()), piece = static_cast<std::uint32_t>(tree_.pieces_.size()),
             corner = static_cast<std::uint32_t>(tree_.corners_.size());
  (task.is_before ? tree_.nodes_[task.parent].before : tree_.nodes_[task.parent].behind) = node;
  for (BspTree::Node n : part.nodes_) {
    if (n.before != 0) n.before += node;
    if (n.behind != 0) n.behind += node;
    n.first_piece += piece;
    n.end_piece += piece;
    tree_.nodes_.push_back(n);
  }
  for (OrderedPiece p : part.pieces_) {
    p.first_corner += corner;
    p.end_corner += corner;
    tree_.pieces_.push_back(p);
  }
  tree_.corners_.insert(tree_.corners_.end(), part.corners_.begin(), part.corners_.end());
  check_countable(tree_.corners_.size(), "corners of a BSP");
  tree_.depth_ = std::max(tree_.depth_, part.depth_ + task.depth - 1);
  tree_.splits_ += part.splits_;
  tree_.decisions_ += part.decisions_;
}

BspTree::BspTree(const Mesh& mesh, const BspOptions& options) : mesh_(&mesh) {
  if (mesh.triangles.empty()) return;
  const Sight sight(mesh, any_view(), Arithmetic::staged);
  BspBuilder::Shared shared{sight};
  BspBuilder builder(*this, shared, options.seed);
  builder.add_facets();
  shared.pieces = builder.parts();
  shared.most = options.most_pieces > 0 ? options.most_pieces : std::max<std::size_t>(100'000, builder.parts() * 64);
  builder.build();
  prepare_planes();
}

}  // namespace hsr
