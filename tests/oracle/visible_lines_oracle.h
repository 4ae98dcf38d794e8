#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/view/view.h"
#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

/// A closed interval of an edge's parameter, from < to.
struct Interval {
  Q from, to;
  friend bool operator==(const Interval& a, const Interval& b) { return a.from == b.from && a.to == b.to; }
};

/// The union of closed intervals, ascending; those that only touch become one.
std::vector<Interval> united(std::vector<Interval> intervals);

/// What one triangle hides of an edge.
struct Shadow {
  TriangleId triangle;
  Interval interval;
};

/// One edge, straight from the definition of "hidden".
struct EdgeVisibility {
  bool is_seen = false;                   ///< false: seen as a point, or no more than a point of it is beyond the near plane
  Interval beyond;                        ///< the part beyond the near plane
  std::vector<Interval> hidden, visible;  ///< maximal, of positive length, ascending; together they tile `beyond`
  std::vector<Shadow> shadows;            ///< maximal for each triangle, triangles ascending
};

/// Which parts of an edge are visible: the dumbest correct way, in rationals.
///
/// Collects every parameter of the edge at which a triangle could begin or cease to hide it, and asks between each two
/// neighbours, at the midpoint, what the definition asks: does the open segment to the eye (the open half-line toward the
/// viewer) meet the closed triangle, as far as it is beyond the near plane? Shares nothing with geometry/ but the Mesh.
class VisibleLinesOracle {
 public:
  VisibleLinesOracle(const Mesh& mesh, const View& view);

  EdgeVisibility visibility(EdgeId edge) const;
  EdgeVisibility visibility(const Vec& a, const Vec& b) const;  ///< of a segment

  /// Whether the triangle hides the point `p`, which is beyond the near plane or in it.
  bool hides(TriangleId triangle, const Vec& p) const;

 private:
  struct Triangle {
    std::array<Vec, 3> corners;
    Vec normal;
    std::array<Vec, 3> inward;        // in the triangle's plane, from side i (corners i, i + 1) to the inside
    std::vector<Vec> corners_beyond;  // the corners of the part beyond the near plane
    struct SightPlane {
      Vec point, normal;
    };
    std::vector<SightPlane> outline;  // the planes of the viewpoint and each side, of the triangle and of that part
    bool edge_on = false;
  };

  Q depth(const Vec& p) const;  // 0 in the near plane, positive beyond
  Vec to_eye(const Vec& p) const;
  Triangle triangle_of(const std::array<VertexId, 3>& vertices) const;
  std::vector<Q> candidates(const Triangle& triangle, const Vec& a, const Vec& b) const;
  bool hides(const Triangle& triangle, const Vec& p) const;

  const Mesh& mesh_;
  bool parallel_;
  Vec eye_;        // the eye, or the direction toward the viewer
  Vec axis_;       // target - eye
  Q eye_to_near_;  // by how much the depth is less at the eye than in the near plane; by how much it falls along a direction
  bool cuts_;      // there is a near plane, or a section in its place
  Vec section_at_, section_normal_;
  bool is_section_;
  std::vector<Triangle> triangles_;
};

}  // namespace hsr::oracle
