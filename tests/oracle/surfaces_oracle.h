#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"
#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

/// A place in the image, in coordinates of the oracle's own.
using Place = std::array<Q, 2>;

/// What is visible, by cutting the image into trapezoids in each of which nothing changes, and looking at the middle of each.
///
/// Between two neighbouring events (ends and crossings of all sides and all lines where two planes meet) the image is cut from
/// left to right, between two neighbouring segments from below to above.
class SurfacesOracle {
 public:
  /// @param coplanar which of coincident faces is visible
  SurfacesOracle(const Mesh& mesh, const View& view, Coplanar coplanar = Coplanar::first);

  /// How the fragments differ from the truth: at the middle of a trapezoid, in the area or the number of the fragments of a
  /// facet, or by a ring that is none. Empty: not at all.
  std::vector<std::string> differences(const VisibleFragments& found) const;
  /// Of the visible part of each triangle's facet, in the oracle's image.
  const std::vector<Q>& areas() const { return areas_; }

 private:
  struct Piece {
    FacetId facet;
    std::vector<Place> corners;
    std::array<Q, 3> nearness;  // of u, v and 1
  };
  struct Segment {
    Place from, to;  // from.u < to.u
    Q at(const Q& u) const;
  };
  struct Trapezoid {
    Place middle;
    Q left, right, area;
    Segment below, above;
    FacetId visible;
  };

  Place image(const Vec& p) const;
  Q nearness(const Vec& p) const;
  void add_piece(TriangleId t);
  std::vector<Segment> segments() const;
  void cut_image();
  FacetId visible_at(const Place& p) const;
  std::vector<std::size_t> count_regions() const;
  std::vector<Place> ring(const VisibleFragments& found, FacetId facet, std::uint32_t r) const;

  const Mesh& mesh_;
  const View& view_;
  bool is_last_visible_;  // of coincident faces
  bool parallel_;
  Vec eye_, axis_;
  std::array<Vec, 2> rows_;
  std::vector<Piece> pieces_;
  std::vector<Trapezoid> trapezoids_;
  std::vector<Q> areas_;
};

}  // namespace hsr::oracle
