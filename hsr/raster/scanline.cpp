#include "hsr/raster/scanline.h"

#include <algorithm>
#include <cmath>

#include "geometry/watched.h"
#include "hsr/raster/drawn_triangles.h"
#include "hsr/raster/scanline_observer.h"

namespace hsr::internal {

namespace {

using Corner = Seen<double>;
using Drawn = ScannedTriangle<double>;

/// An entry of the face table: the plane of its depths, nearness + (i - x) right + (j - y) down.
struct Face {
  TriangleId shown;
  double x = 0, y = 0, nearness = 0, right = 0, down = 0;
  int left_end = 0, right_end = 0;  // no sample is outside these columns
  int row_end = 0;                  // one past its last sample of this row
  int inside = 0;                   // the flag: left edges less right edges that the row has passed
  double at(int i, int j) const { return nearness + (j - y) * down + (i - x) * right; }
};

using FaceEdge = ScannedEdge;
using Crossing = ScannedCrossing;

template <class Watch = Unwatched>
class Scanner {
 public:
  Scanner(const SampleGrid& samples, TieRule ties, Watch watch = {})
      : watch_(watch), ties_(ties), width_(samples.width), height_(samples.height) {}

  void add_triangle(TriangleId t, Corner a, Corner b, Corner c) {
    Drawn scanned;
    if (!scanned.set(a, b, c, width_, height_)) return;
    const Corner& from = scanned.corner();
    begin_face({t, from.x, from.y, from.nearness, scanned.step(), scanned.step_down(), scanned.left(), scanned.right(), 0, 0});
    // As ScannedTriangle has them, so that samples on edges are decided alike.
    if (b.y < a.y) std::swap(a, b);
    if (c.y < a.y) std::swap(a, c);
    if (c.y < b.y) std::swap(b, c);
    const bool b_on_right = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    add_edge(a, c, b_on_right);
    add_edge(a, b, !b_on_right);
    add_edge(b, c, !b_on_right);
  }

  /// @param corners of a convex polygon, around it @param plane at column 0 of row 0, and a column and a row on
  void add_polygon(TriangleId t, const std::vector<Corner>& corners, const std::array<double, 3>& plane) {
    double area = 0, low = HUGE_VAL, high = -HUGE_VAL;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner &o = corners[0], &p = corners[k], &q = corners[(k + 1) % corners.size()];
      area += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
    if (!(area != 0) || !std::all_of(corners.begin(), corners.end(), Drawn::is_drawable)) return;
    begin_face(
        {t, 0, 0, plane[0], plane[1], plane[2], Drawn::first_sample(low, width_), Drawn::first_sample(high, width_), 0, 0});
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner &p = corners[k], &q = corners[(k + 1) % corners.size()];
      if (p.y < q.y)
        add_edge(p, q, area < 0);
      else
        add_edge(q, p, area > 0);
    }
  }

  Scanline scanned() && {
    result_.triangles = Image<TriangleId>(width_, height_);
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const FaceEdge& a, const FaceEdge& b) { return a.first_row < b.first_row; });
    if constexpr (Watch::is_watched) watch_.observer->began(edges_);
    std::size_t next = 0;
    for (int j = 0; j < height_; ++j) {
      for (; next < edges_.size() && edges_[next].first_row == j; ++next) active_.push_back(edges_[next]);
      result_.most_active = std::max(result_.most_active, active_.size());
      scan(j);
      std::erase_if(active_, [&](const FaceEdge& e) { return e.end_row == j + 1; });
    }
    result_.bytes = faces_.capacity() * sizeof(Face) + (edges_.capacity() + active_.capacity()) * sizeof(FaceEdge) +
                    crossings_.capacity() * sizeof(Crossing) + (inside_.capacity() + begun_.capacity()) * sizeof(std::uint32_t);
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  void begin_face(const Face& face) {
    faces_.push_back(face);
    if constexpr (Watch::is_watched) watch_.observer->added_face(static_cast<std::uint32_t>(faces_.size() - 1), face.shown);
  }

  void add_edge(const Corner& upper, const Corner& lower, bool is_left) {
    const int first = Drawn::first_sample(upper.y, height_), end = Drawn::first_sample(lower.y, height_);
    if (first >= end) return;
    edges_.push_back({upper.x, upper.y, Drawn::slope(lower.x - upper.x, lower.y - upper.y), first, end,
                      static_cast<std::uint32_t>(faces_.size() - 1), is_left});
  }

  void scan(int j) {
    crossings_.clear();
    for (const FaceEdge& e : active_) {
      Face& face = faces_[e.face];
      const int column =
          std::clamp(Drawn::first_sample(e.x + (j - e.y) * e.columns_a_row, width_), face.left_end, face.right_end);
      crossings_.push_back({column, e.face, e.is_left});
      if (!e.is_left) face.row_end = column;
    }
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) { return a.column < b.column; });
    if constexpr (Watch::is_watched) watch_.observer->row(j, active_, crossings_);
    std::uint32_t shown = none;
    for (std::size_t k = 0; k < crossings_.size();) {
      const int column = crossings_[k].column;
      begun_.clear();
      for (; k < crossings_.size() && crossings_[k].column == column; ++k) pass(crossings_[k]);
      const int end = k < crossings_.size() ? crossings_[k].column : column;
      shown = nearest(shown, column, j);
      if constexpr (Watch::is_watched)
        if (column != end) watch_.observer->shown(j, column, end, shown);
      if (shown == none || column == end) continue;
      ++result_.spans;
      std::fill(result_.triangles.row(j) + column, result_.triangles.row(j) + end, faces_[shown].shown);
    }
  }

  void pass(const Crossing& c) {
    Face& face = faces_[c.face];
    const bool was_inside = face.inside > 0;
    face.inside += c.is_left ? 1 : -1;
    if (face.inside > 0 && !was_inside) {
      inside_.push_back(c.face);
      begun_.push_back(c.face);
    } else if (was_inside && face.inside <= 0) {
      inside_.erase(std::find(inside_.begin(), inside_.end(), c.face));
    }
    if constexpr (Watch::is_watched) watch_.observer->passed(c, inside_);
  }

  /// What to show from a sample on, where `before` was shown up to it.
  std::uint32_t nearest(std::uint32_t before, int i, int j) {
    const bool goes_on = before != none && faces_[before].inside > 0;
    const std::vector<std::uint32_t>& others = goes_on ? begun_ : inside_;
    std::uint32_t best = goes_on ? before : none;
    for (const std::uint32_t f : others) {
      if (faces_[f].inside <= 0) continue;  // it ended where it began
      if (best == none) {
        best = f;
        continue;
      }
      ++result_.depth_comparisons;
      const bool is_the_nearer = is_nearer(faces_[f], faces_[best], i, j);
      if constexpr (Watch::is_watched) tell(f, best, i, j, is_the_nearer);
      if (is_the_nearer) best = f;
    }
    return best;
  }

  /// Faces that do not pierce are in one order all along the part of the row that both have; but they may meet just where it
  /// begins, and there rounding would decide. So they are compared at the end of it where they are farther apart. Equal depths
  /// are decided as those of a sample moved by (e, e^2).
  bool is_nearer(const Face& f, const Face& g, int i, int j) const {
    const int last = std::max(i, std::min(f.row_end, g.row_end) - 1);
    const double at_first = f.at(i, j) - g.at(i, j), at_last = f.at(last, j) - g.at(last, j);
    const double nearer = std::fabs(at_last) > std::fabs(at_first) ? at_last : at_first;
    if (nearer != 0) return nearer > 0;
    if (f.right != g.right) return f.right > g.right;
    if (f.down != g.down) return f.down > g.down;
    return ties_.is_above(f.shown, g.shown);
  }

  void tell(std::uint32_t f, std::uint32_t shown, int i, int j, bool is_the_nearer) const {
    const Face &a = faces_[f], &b = faces_[shown];
    const int last = std::max(i, std::min(a.row_end, b.row_end) - 1);
    watch_.observer->compared({f, shown, i, last, a.at(i, j), b.at(i, j), a.at(last, j), b.at(last, j), is_the_nearer});
  }

  [[no_unique_address]] Watch watch_;
  TieRule ties_;
  int width_, height_;
  std::vector<Face> faces_;
  std::vector<FaceEdge> edges_, active_;
  std::vector<Crossing> crossings_;            // of a row, from the left
  std::vector<std::uint32_t> inside_, begun_;  // faces: all that the row is inside of; those that begin at this column
  Scanline result_;
};

/// The depth of a facet's plane as an affine function of the sample, up to a positive factor that all facets share. In the
/// range of long doubles: lengths of 1e300 have products.
std::array<double, 3> depth_plane(const Mesh& mesh, const View& view, const SampleGrid& samples, FacetId facet) {
  using namespace projection_numbers;
  using Wide = long double;
  const auto wide = [](const Point3& p) { return vector<Wide>(p); };
  const auto& c = mesh.triangles[first_triangle(facet)];
  const Vector<Wide> a = wide(mesh.points[c[0]]);
  const Vector<Wide> normal = cross(minus(wide(mesh.points[c[1]]), a), minus(wide(mesh.points[c[2]]), a));
  const Vector<Wide> origin = wide(samples.origin), right = wide(samples.right), down = wide(samples.down);
  const Vector<Wide> eye = wide(view.viewpoint.at);
  // The sample q sees e + s (q - e) with 1 / s = n.(q - e) / n.(a - e); in a parallel view q + t e, t = n.(a - q) / n.e.
  const Wide of = view.is_perspective() ? dot(normal, minus(a, eye)) : -dot(normal, eye);
  const Wide at_origin = view.is_perspective() ? dot(normal, minus(origin, eye)) : dot(normal, minus(origin, a));
  return {static_cast<double>(at_origin / of), static_cast<double>(dot(normal, right) / of),
          static_cast<double>(dot(normal, down) / of)};
}

}  // namespace

namespace {

template <class Watch>
Scanline scanned(const Mesh& mesh, const View& view, const SampleGrid& samples, Scanner<Watch> scanner) {
  const DrawnTriangles<double> triangles(mesh, view, samples);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    triangles.visit(TriangleId(k),
                    [&](const Corner& a, const Corner& b, const Corner& c) { scanner.add_triangle(TriangleId(k), a, b, c); });
  return std::move(scanner).scanned();
}

}  // namespace

Scanline scanline(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties) {
  return scanned(mesh, view, samples, Scanner<>(samples, ties));
}

Scanline scanline(const Mesh& mesh, const View& view, const SampleGrid& samples, TieRule ties, ScanlineObserver& observer) {
  return scanned(mesh, view, samples, Scanner<Watched<ScanlineObserver>>(samples, ties, {&observer}));
}

Scanline scanline(const Mesh& mesh, const View& view, const SampleGrid& samples, const PaintersOrder& pieces, TieRule ties) {
  Scanner<> scanner(samples, ties);
  const SampleProjection<double> project(view, samples);
  std::vector<Corner> corners;
  for (const OrderedPiece& piece : pieces.pieces) {
    corners.clear();
    for (const PieceCorner& c : pieces.corners_of(piece)) {
      if (c.vertex.is_valid()) {
        corners.push_back(project(mesh.points[c.vertex]));
      } else {
        const std::array<Rational, 3> p = exact_point(mesh, view, piece.facet, c);
        corners.push_back(project(Point3{p[0].to_double(), p[1].to_double(), p[2].to_double()}));
      }
    }
    scanner.add_polygon(first_triangle(piece.facet), corners, depth_plane(mesh, view, samples, piece.facet));
  }
  return std::move(scanner).scanned();
}

}  // namespace hsr::internal
