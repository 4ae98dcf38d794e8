#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "hsr/scene/half_space.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/triangle_filter.h"
#include "hsr/symbols/cut.h"

namespace hsr::internal {

class ShadowObserver;

/// A place on a line with its approximate parameter, for sorting: the exact order is computed only where the errors overlap.
struct Breakpoint {
  Cut cut;
  double t = 0, error = 0;
  Sign fall = Sign::positive;  ///< positive: the value of the cutting plane decreases from a to b; negative: it increases
};

/// A part of a line that one triangle hides.
struct HiddenInterval {
  Breakpoint from, to;
  FaceId face;
};

/// The shadows that triangles cast on one line at a time: an edge from a to b, or where two faces pierce each other, from the
/// one end a to the other b. One object per thread.
///
/// A point p is in the shadow of a triangle T that is not seen edge-on iff
///   p is strictly beyond the plane of T: facing * T(p) < 0;
///   p is in the closed cone of the eye and T: facing * O(t_i, t_i+1, p) >= 0 for its three sides;
///   if the near plane cuts T, the line of sight meets T beyond the near plane: facing * near_line(p) >= 0.
/// All of these are linear along the line, so the shadow is an interval. A T seen edge-on hides only in its own plane, where it
/// acts by its three sides and its interior (see edge_on).
class TriangleOcclusion {
 public:
  explicit TriangleOcclusion(const ProjectedMesh& projected) : projected_(projected), exact_(projected.predicates()) {}

  /// Turns to another edge. False: it is seen as a point, or nothing of it is beyond the near plane.
  bool start(EdgeId edge);
  /// Turns to a part of an edge.
  bool start(EdgeId edge, const Cut& from, const Cut& to);
  /// Turns to where two facets pierce each other. False: it is seen as a point.
  bool start(const Intersection& meet);
  /// The part of the line within half-spaces; false: a point or nothing. @param along the one on whose border the line runs, or
  /// 3
  bool within(const std::array<HalfSpace, 3>& half_spaces, Breakpoint& from, Breakpoint& to, std::size_t& along);
  /// Appends the shadows of `triangle` on the edge, at most four.
  void cast(TriangleId triangle, std::vector<HiddenInterval>& occlusion) { cast(triangle, {}, occlusion); }
  /// As above, for a triangle whose filter is at hand.
  void cast(const TriangleFilter& face, std::vector<HiddenInterval>& occlusion);

  /// Where the plane of `cut` crosses the line. @pre it separates the ends of the line
  Breakpoint place(const Cut& cut);
  /// The same; nothing where it does not separate the ends of the part that is looked at.
  std::optional<Breakpoint> crossing(const Cut& cut);

  /// Cuts a part of the line down to where the plane of `cut` has this sign, or is zero. False: to a point or nothing.
  bool keep(const Cut& cut, Sign kept, Breakpoint& from, Breakpoint& to);
  /// Turns to a part of the line. @pre start() of the line was true
  void look_at(const Breakpoint& from, const Breakpoint& to) { first_ = from, last_ = to; }

  /// The ends of the part that is looked at: beyond the near plane.
  const Breakpoint& first() const { return first_; }
  const Breakpoint& last() const { return last_; }

  /// Which of two places comes first along the edge: negative, x; zero, they are one place.
  Sign order(const Breakpoint& x, const Breakpoint& y);

  Predicates& exact() { return exact_; }

 private:
  struct Value {
    ErrorBounded x;
    Sign sign;
  };
  /// What a prepared triangle tells of the edge for certain.
  struct Prefilter {
    bool may_miss = true;                            ///< not looked at: whether it misses the edge in the image
    bool is_behind = false;                          ///< the edge is strictly beyond its plane
    const TriangleFilter::Overlap* image = nullptr;  ///< with the edge
  };
  void cast(TriangleId triangle, const Prefilter& prefilter, std::vector<HiddenInterval>& occlusion);
  /// An end of the line: a vertex, or where a plane cuts the line of two others, and then known within an error.
  struct End {
    VertexId vertex;
    BoundedPoint3 at;
    Plane cut;
    Cut cut_name;
  };
  static Value known(const ErrorBounded& x, Sign s);
  Value at(const PlaneFilter& filter, const Plane& plane, const End& end, bool on_plane);
  bool is_edge() const { return a_.vertex.is_valid(); }
  bool is_one(FacetId facet) const { return facet == s_ || facet == t_; }
  bool is_end(VertexId v) const { return v == a_.vertex || v == b_.vertex; }
  bool misses(const std::array<VertexId, 3>& corners);

  void begin() { from_ = first_, to_ = last_; }
  bool clip(const Cut& cut, const Plane& plane, bool a_on, bool b_on, Sign wanted, bool open);
  bool clip(const Cut& cut, const Value& at_a, const Value& at_b, Sign wanted, bool open);
  Breakpoint bound(const Cut& cut, const Value& at_a, const Value& at_b) const;
  void edge_on(TriangleId triangle, std::vector<HiddenInterval>& occlusion);

  const ProjectedMesh& projected_;
  Predicates exact_;
  End a_, b_;
  SegmentFilter image_;  // of the edge, where images are known
  FacetId s_, t_;        // the facets that pierce each other
  Plane s_plane_, t_plane_;
  std::optional<PlaneFilter> edge_sight_;  // of the edge's view plane, once it was asked for
  Breakpoint first_, last_, from_, to_;
};

/// Sorts the shadows along the line that was turned to, and replaces what overlaps or touches by its union.
void unite(TriangleOcclusion& occlusion, std::vector<HiddenInterval>& shadows);
/// The same, told.
void unite(TriangleOcclusion& occlusion, std::vector<HiddenInterval>& shadows, ShadowObserver& observer);

}  // namespace hsr::internal
