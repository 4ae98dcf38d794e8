#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "hsr/scene/occluders.h"
#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/visibility_map/map_predicates.h"
#include "hsr/visibility_map/triangle_sides.h"

namespace hsr {

/// A part of a line of the map to look along, and the part of a line in space that is seen as it, along which places are
/// reckoned: from a, where `from` is seen, t = 0, to b, where `to` is, t = 1.
struct MapStretch {
  MapLine line;
  MapPoint from, to;
  BoundedPoint3 a, b;
  VertexId at_a = {}, at_b = {};  ///< the vertices that are a and b, if they are
  /// It is of an edge, and visible: no face that is wholly nearer is beside it.
  bool is_visible = false;
  TriangleId elsewhere = {};  ///< a face that ends at the line, on the side that is not looked at
  /// Faces that are likely to be seen beside it: looked at first, so that what lies behind them need not be.
  std::array<const TriangleFilter*, 2> first = {};

  /// The place at t, in space.
  BoundedPoint3 at(double t, double error) const;
};

/// A part of a line of the map, and the triangle that is seen just beside it; none: nothing is.
struct SeenPart {
  MapPoint from, to;  ///< along the line
  TriangleId seen;
  double to_t = 0, to_error = 0;  ///< where `to` is, as in MapStretch
};

/// Which triangle is seen just beside a part of a line: the lower envelope of the faces over it. One object per thread.
///
/// "Just beside" settles what coincides in the image: a triangle that ends at the line is there on its own side only; of two
/// that meet in the line the one that is nearer beside it is seen; of two in one plane the lower index.
/// Doubles with proven bounds tell most places and depths apart; the symbols decide the others.
/// Exact: yes. Cost: O(k m) for the k triangles that overlap the part and m parts. Source: Hart & Sharir 1986 (envelopes of
/// segments), here of faces over a line.
class LineEnvelope {
 public:
  /// @param tiles none: nothing is known to be hidden
  LineEnvelope(MapPredicates& map, const Occluders& occluders, const OcclusionPyramid* pyramid)
      : map_(map), projected_(map.projected()), occluders_(occluders), pyramid_(pyramid) {}

  /// @param side positive, to the left of the line; the answer holds until the next call
  std::span<const SeenPart> find(const MapStretch& stretch, Sign side);

  /// What the two faces that meet in a line are seen as.
  struct EnvelopePair {
    std::span<const SeenPart> left;  ///< to the left; what hides both is any face before them
    bool is_for_both = false;        ///< where one of the two is seen to the left, the other one is to the right
  };
  /// The same of the line in which the two faces `stretch.first` meet, at once for both sides. Where they are hidden, both
  /// sides are seen the same, but where another line of the map runs.
  EnvelopePair both_sides(const MapStretch& stretch);

 private:
  struct Place {
    MapPoint p;
    double t, error;
  };
  /// A function that is linear along the stretch.
  struct Linear {
    ErrorBounded at_a, at_b;
  };
  struct Part {
    Place from, to;
    TriangleId seen;
    Linear nearness;
    /// At least, so far as they are known: of what is seen here, as boxes and as `nearness` have it.
    float farthest = unknown;
    double least = HUGE_VAL;
  };
  static constexpr float unknown = std::numeric_limits<float>::infinity();

  void start(const MapStretch& stretch, Sign side);
  bool look_at(const TriangleFilter& face);
  void look_around();
  std::span<const SeenPart> result();
  bool meets_here(TriangleId t) const { return t == stretch_->first[0]->triangle || t == stretch_->first[1]->triangle; }
  /// Of two faces that meet: nothing matters any more where others hide them.
  bool is_settled(const Part& part) const { return is_meeting_ && part.seen.is_valid() && !meets_here(part.seen); }
  void insert(const TriangleFilter& face, const Linear& of_t, const TriangleFilter::Overlap& overlap);
  bool clip(const TriangleFilter& face, const TriangleFilter::Overlap& overlap, Place& from, Place& to);
  Linear along_side(const TriangleFilter& face, const TriangleFilter::Overlap& overlap, std::size_t k,
                    const MapHalfPlane& h) const;
  bool clip(const MapHalfPlane& h, const Linear& value, Place& from, Place& to);
  Linear along(const PlaneFilter& filter, bool zero_at_a, bool zero_at_b) const;
  Linear nearness(const TriangleFilter& face) const;
  ErrorBounded at(const Linear& f, const Place& place) const;
  Place crossing(const MapLine& other, const Linear& value) const;
  Sign order(const Place& x, const Place& y);
  bool have_in_common(TriangleId s, TriangleId t, const MapPoint& p) const;
  Sign nearer(TriangleId s, const Linear& of_s, const Part& part, const Place& place);
  Sign nearer_beside(TriangleId s, TriangleId t);
  void add(const Place& from, const Place& to, TriangleId t, const Linear& nearness);
  void bound(Part& part) const;

  MapPredicates& map_;
  const ProjectedMesh& projected_;
  const Occluders& occluders_;
  const OcclusionPyramid* pyramid_;
  const MapStretch* stretch_ = nullptr;
  ImageBox query_;                // of what may change the answer
  SegmentFilter image_;           // of the stretch
  double least_ = 0;              // of `nearness` of what matters: what is less near changes nothing
  bool is_meeting_ = false;       // both sides are looked at
  bool depends_on_side_ = false;  // what was found does
  Linear depth_;                  // of the stretch, as ProjectedMesh has it
  Sign side_ = Sign::positive;
  std::vector<Part> parts_, next_;
  std::vector<SeenPart> result_;
};

}  // namespace hsr
