#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "hsr/scene/occluders.h"
#include "hsr/scene/occlusion_pyramid.h"
#include "hsr/visibility_map/map_predicates.h"
#include "hsr/visibility_map/triangle_sides.h"

namespace hsr::internal {

/// A part of a line of the map along which the envelope is wanted, and the segment in space whose image it is. Places on it
/// have a parameter t along that segment: t = 0 at a, whose image is `from`, and t = 1 at b, whose image is `to`.
struct MapStretch {
  MapLine line;
  MapPoint from, to;
  BoundedPoint3 a, b;
  VertexId at_a = {}, at_b = {};  ///< the vertices at a and b; not valid where the end is no vertex
  /// The segment is a visible part of an edge, so no face that is wholly nearer can be seen beside it.
  bool is_visible = false;
  TriangleId elsewhere = {};  ///< a face that ends at the line and lies on the other side, so that it need not be looked at
  /// Faces that are likely to be visible beside it. They are looked at first, and whatever is behind them is then skipped.
  std::array<const TriangleFilter*, 2> first = {};

  /// The point in space at the parameter t, which is known within `error`.
  BoundedPoint3 at(double t, double error) const;
};

/// A part of a line of the map, and the triangle that is visible just beside it; not valid if nothing but the paper is.
struct SeenPart {
  MapPoint from, to;  ///< along the line
  TriangleId seen;
  double to_t = 0, to_error = 0;  ///< the parameter of `to` along the MapStretch, and its error bound
};

/// Which triangle is visible just beside a part of a line: the lower envelope of the faces over it. One object per thread.
///
/// "Just beside" settles what coincides in the image: a triangle that ends at the line is there on its own side only; of two
/// that meet in the line the one that is nearer beside it is seen; of two in one plane the one on top (TieRule).
/// Doubles with proven bounds tell most places and depths apart; the symbols decide the others.
/// Exact: yes. Cost: O(k m) for the k triangles that overlap the part and m parts. Source: Hart & Sharir 1986 (envelopes of
/// segments), here of faces over a line.
class LineEnvelope {
 public:
  /// @param pyramid what is known to be hidden, or nullptr
  LineEnvelope(MapPredicates& map, const Occluders& occluders, const OcclusionPyramid* pyramid)
      : map_(map), projected_(map.projected()), occluders_(occluders), pyramid_(pyramid) {}

  /// @param side positive, to the left of the line; the answer holds until the next call
  std::span<const SeenPart> find(const MapStretch& stretch, Sign side);

  /// The envelope on both sides of the line in which two faces meet.
  struct EnvelopePair {
    /// What is visible just to the left, part by part. Where other faces hide both of the two, `seen` is any of those that do.
    std::span<const SeenPart> left;
    /// True: on every part where one of the two faces is visible on the left, the other one is visible on the right, so this
    /// one pass serves both sides. False: each side has to be looked at on its own.
    bool is_for_both = false;
  };
  /// One pass for both sides of the line in which the two faces `stretch.first` meet. Where other faces hide these two, the
  /// same face is visible on both sides, unless another line of the map runs there: so those parts bound no region.
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
    /// Lower bounds of how near `seen` is on this part, once they are known: as boxes measure nearness, and as `nearness` does.
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
  ImageBox query_;                // only triangles that overlap this box can change the answer
  SegmentFilter image_;           // of the stretch
  double least_ = 0;              // a face whose `nearness` stays below this changes nothing
  bool is_meeting_ = false;       // both sides are looked at in one pass
  bool depends_on_side_ = false;  // some answer of this pass holds for the left side only
  Linear own_nearness_;           // of the stretch: ProjectedMesh::nearness
  Sign side_ = Sign::positive;
  std::vector<Part> parts_, next_;
  std::vector<SeenPart> result_;
};

}  // namespace hsr::internal
