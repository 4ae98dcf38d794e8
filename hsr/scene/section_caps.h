#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/error_bounded.h"
#include "geometry/ragged.h"
#include "geometry/rational_vector.h"
#include "hsr/face_labels.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

/// Where an edge of a triangle meets the section plane: between the vertices a < b, or in the vertex a = b.
struct CapCorner {
  VertexId a, b;
  friend auto operator<=>(const CapCorner&, const CapCorner&) = default;
};

/// A straight piece of the border of a cap: where a triangle meets the section plane, the cap on its left as the viewer sees it.
struct CapSide {
  std::uint32_t from, to;  ///< of the corners
  TriangleId triangle;
  std::uint32_t object;
  bool counts_once = false;  ///< of an outline without one direction: each side is a change between inside and outside
};

/// The caps of a section: the parts of its plane that are inside closed bodies, as if the plane were moved towards the viewer by less
/// than anything, so that what lies in it stays.
///
/// A cap is nearest of all that is left: a point is hidden by one iff its line of sight goes through it, border included. Inside and
/// outside are told object by object, by the winding number of the outlines of the cut (not zero: inside) or, of those that have no
/// direction, by how many are crossed. Sides that belong to no closed outline bound nothing and are left out.
///
/// Places are kept in coordinates (u, v) of the plane, in which hardly ever two ends have one v, and are exact.
/// Exact: yes. Cost: O(n) for the faces, O(m log m) for m that are cut.
class SectionCaps {
 public:
  /// @pre the view has a section; mesh and view outlive this
  SectionCaps(const ProjectedMesh& projected, const View& view, const FaceLabels& labels);

  /// A place in the plane, u and v; in doubles with a bound, or exactly.
  using Place = std::array<ErrorBounded, 2>;
  using ExactPlace = std::array<Rational, 2>;

  const View& view() const { return view_; }
  const std::vector<CapCorner>& corners() const { return corners_; }
  const std::vector<CapSide>& sides() const { return sides_; }
  /// Whether u, v turn the other way round than the viewer sees them.
  bool is_mirrored() const { return plane_.normal[dropped_] > 0; }
  /// How many connected outlines of the cut do not close.
  std::size_t open_outlines() const { return open_outlines_; }

  /// The point of a corner in space.
  RationalVector point(std::uint32_t corner) const;
  const ExactPlace& exact_place(std::uint32_t corner) const { return exact_places_[corner]; }
  const Place& place(std::uint32_t corner) const { return places_[corner]; }

  /// Where the line of sight of a point meets the plane. @pre the point is not before the plane
  Place seen_at(const std::array<ErrorBounded, 3>& p) const;
  ExactPlace seen_at(const RationalVector& p) const;

  /// Whether the place is in a cap or on its border; nothing where doubles do not tell.
  std::optional<bool> covers(const Place& at) const;
  bool covers(const ExactPlace& at) const;
  /// The objects in whose caps the place is when it is moved by less than anything along `toward`, ascending.
  /// @param least_side becomes the lowest side that the place is on, if any
  /// @param then where it then still is on a side it is moved along this, by less than that
  std::vector<std::uint32_t> objects_beside(const ExactPlace& at, const ExactPlace& toward,
                                            std::optional<std::uint32_t>& least_side, const ExactPlace& then = {}) const;

  /// Calls visit(side) for every side that may touch the box of these places, some twice.
  template <class Visit>
  void visit_sides(const Place& a, const Place& b, const Visit& visit) const {
    if (sides_.empty()) return;
    const auto low = [](const ErrorBounded& x, const ErrorBounded& y) {
      return std::min(x.value - x.error, y.value - y.error);
    };
    const auto high = [](const ErrorBounded& x, const ErrorBounded& y) {
      return std::max(x.value + x.error, y.value + y.error);
    };
    const double left = low(a[0], b[0]), right = high(a[0], b[0]), bottom = low(a[1], b[1]), top = high(a[1], b[1]);
    if (!(left <= right_ && right >= left_ && bottom <= top_ && top >= bottom_)) {
      if (left <= right && bottom <= top) return;  // else doubles do not tell
    }
    for (std::size_t s = slab_of(bottom); s <= slab_of(top); ++s)
      for (const std::uint32_t k : slabs_[s]) {
        const Place &from = places_[sides_[k].from], &to = places_[sides_[k].to];
        if (low(from[0], to[0]) > right || high(from[0], to[0]) < left || low(from[1], to[1]) > top ||
            high(from[1], to[1]) < bottom)
          continue;
        visit(k);
      }
  }

 private:
  struct Counter;
  void find_sides(const ProjectedMesh& projected, const FaceLabels& labels);
  void cancel_opposite();
  void leave_out_open();
  void place_corners();
  void fill_slabs();
  std::size_t slab_of(double v) const;

  const Mesh& mesh_;
  const View& view_;
  Plane plane_;
  int dropped_;  // the axis that the coordinates do without
  std::vector<CapCorner> corners_;
  std::vector<CapSide> sides_;
  std::vector<ExactPlace> exact_places_;  // by corner
  std::vector<Place> places_;
  std::size_t open_outlines_ = 0;
  // Sides by horizontal slabs of the plane.
  double left_ = 0, right_ = 0, bottom_ = 0, top_ = 0, slabs_per_unit_ = 0, margin_ = 0;
  std::size_t slab_count_ = 1;
  Ragged<std::uint32_t> slabs_;
};

}  // namespace hsr::internal
