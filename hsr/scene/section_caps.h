#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/error_bounded.h"
#include "geometry/ragged.h"
#include "geometry/rational_vector.h"
#include "hsr/face_labels.h"
#include "hsr/scene/box_tree.h"
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
/// Exact: yes. Cost: O(n) for the faces, O(m log m) for m that are cut; whether a place is in a cap, by a ray, that of the sides of the few
/// outlines around it, or of the sides that the ray meets.
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
  /// Sides that bound nothing, as their outlines do not close.
  const std::vector<CapSide>& open_sides() const { return open_sides_; }
  /// How many connected outlines of the cut do not close.
  std::size_t open_outlines() const { return open_outlines_; }

  /// The point of a corner in space.
  const RationalVector& point(std::uint32_t corner) const { return points_[corner]; }
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

  /// What is to the left and to the right of the middle of a side that no other touches there; nothing where doubles do not tell.
  struct Hands {
    std::vector<std::uint32_t> left, right;
  };
  std::optional<Hands> certain_hands(std::uint32_t side) const;

  /// Calls visit(side) for every side that may touch the box of these places.
  template <class Visit>
  void visit_sides(const Place& a, const Place& b, const Visit& visit) const {
    tree_.visit_boxes<BoxTree::Depth::any>(box_of(a, b), [&](std::uint32_t side, std::uint32_t /*at*/) {
      visit(side);
      return true;
    });
  }

 private:
  struct Counter;
  void find_sides(const ProjectedMesh& projected, const FaceLabels& labels);
  void cancel_opposite();
  void leave_out_open();
  void place_corners();
  void make_tree();
  static ImageBox box_of(const Place& a, const Place& b);
  static ImageBox ray_from(const Place& at);
  std::optional<int> certain_crossing(const CapSide& side, const Place& at) const;
  /// Calls visit(side) for every side that a ray from the place along u may meet, until it returns false.
  template <class Visit>
  void visit_ray(const Place& at, const Visit& visit) const {
    const ImageBox ray = ray_from(at);
    std::array<std::uint32_t, most_outlines> outlines;
    const auto found = outlines_around(at, outlines);
    if (!found) {
      tree_.visit_boxes<BoxTree::Depth::any>(ray, [&](std::uint32_t side, std::uint32_t /*at*/) { return visit(side); });
      return;
    }
    for (std::size_t i = 0; i < *found; ++i)
      for (const std::uint32_t side : outlines_[outlines[i]])
        if (reaches(boxes_[side], ray) && !visit(side)) return;
  }
  /// A closed outline winds only around places in its own box: those that are around a place. Nothing: they, or their sides, are many.
  std::optional<std::size_t> outlines_around(const Place& at, std::span<std::uint32_t> outlines) const;
  static bool reaches(const ImageBox& side, const ImageBox& ray) {
    return side.high[0] >= ray.low[0] && side.low[1] <= ray.high[1] && side.high[1] >= ray.low[1];
  }
  static constexpr std::size_t most_outlines = 16, most_sides = 256;

  const Mesh& mesh_;
  const View& view_;
  Plane plane_;
  int dropped_;  // the axis that the coordinates do without
  std::vector<CapCorner> corners_;
  std::vector<CapSide> sides_, open_sides_;
  std::vector<RationalVector> points_;  // by corner
  std::vector<ExactPlace> exact_places_;
  std::vector<Place> places_;
  std::size_t open_outlines_ = 0;
  BoxTree tree_;                    // of the sides, by u and v
  std::vector<ImageBox> boxes_;     // of the sides
  Ragged<std::uint32_t> outlines_;  // connected sides of one object
  BoxTree outline_tree_;
};

}  // namespace hsr::internal
