#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bounded_point.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

struct AffineDepth;

/// A sub-interval of an edge that the tiles do not prove hidden. Parameters are linear along the projected edge: 0 at e.a, 1 at
/// e.b. -infinity and +infinity mean "from the vertex e.a" and "to the vertex e.b".
struct UnhiddenInterval {
  double from, to;    ///< everything between `to` and the `from` of the next interval is hidden
  double low, high;   ///< the same interval made a little longer on both sides, but not longer than the edge
  float hidden_from;  ///< whatever has a nearness below this is hidden between `low` and `high`
};

/// A grid of tiles over the image, each with a depth beyond which everything is hidden: a conservative test that drops what is
/// provably hidden, before anything exact is asked.
///
/// A tile is covered by a triangle, or by two that share an edge and lie on opposite sides of it, where it lies certainly
/// within all their other sides. Whatever is farther than the farthest point of those triangles within the tile is then hidden
/// in all of the closed tile. Every bound is rounded toward "not hidden". Where the images are exact (axis-parallel views), so
/// are sides that run along an axis: in an elevation a face that ends exactly where the face in front of it ends is hidden,
/// too.
///
/// Tiles keep a nearness (greater is nearer) that is affine over the image of a plane: in parallel views that of the boxes, in
/// perspective the reciprocal of the depth.
///
///   (1) what `hides` says yes to, and what `unhidden` leaves out, is hidden at every point
///   (2) the same for any number of threads
///
/// Cost: O(n + tiles covered), parallel; a query O(tiles touched), less where all of them hide alike.
/// Source: Greene, Kass & Miller 1993, "Hierarchical z-buffer visibility"; here with bounds instead of samples.
class OcclusionPyramid {
 public:
  /// @param always even if there is little to hide
  OcclusionPyramid(const ProjectedMesh& projected, bool always);

  /// No tile hides anything.
  bool is_empty() const { return levels_.empty(); }

  /// Whether the triangle, or the edge, is certainly hidden.
  bool hides(TriangleId t) const;
  bool hides(const Edge& e) const;
  /// Whether the segment between two points, each known within its error, is certainly hidden.
  bool hides(const BoundedPoint3& a, const BoundedPoint3& b) const;
  /// Finds the parts of an edge that may be visible, ordered from e.a to e.b; all the rest of the edge is hidden. Returns
  /// false, and no parts, if the tiles say nothing about the edge.
  bool unhidden(const Edge& e, std::vector<UnhiddenInterval>& parts) const;
  /// A nearness below which everything is hidden along the image segment from p to q and just beside it; no_occluder if nothing
  /// is known to be hidden there. @param error of each coordinate of p and q
  float hidden_from(const ImagePoint& p, const ImagePoint& q, double error) const;
  /// Marks, by triangle, the faces that are certainly hidden. Whole faces: where the triangles of a planar face meet, the mesh
  /// has no edge.
  void mark_hidden(std::vector<std::uint8_t>& hidden) const;

  /// The finest tiles, to be shown: tile (i, j) reaches in the image from corner + (i column, j row) to a column and a row on.
  struct Grid {
    ImagePoint corner = {};
    double column = 0, row = 0;
    std::int32_t columns = 0, rows = 0;
    std::vector<float> nearness = {};  ///< by rows, as boxes have it: whatever is less near is hidden; no_occluder: nothing is
  };
  Grid grid() const;
  /// A tile that a triangle touches, and whether it hides the triangle there.
  struct TouchedTile {
    std::int32_t column, row;
    bool hides;
  };
  /// A triangle is certainly hidden if all these tiles hide it, and there are any: of one that reaches beyond the grid there are none.
  std::vector<TouchedTile> touched(TriangleId t) const;

 private:
  struct Rectangle {
    std::array<double, 2> low, high;
  };
  /// The tiles along one coordinate: tile i reaches from border(i) to border(i + 1).
  struct Axis {
    double first = 0, width = 1, per_width = 1;
    double slack = 0;  // of a place reckoned in tiles
    std::int32_t tiles = 0;

    double border(std::int32_t i) const { return first + i * width; }
    std::int32_t last_border_up_to(double x) const;  ///< -1: none
    std::int32_t first_border_from(double x) const;  ///< tiles + 1: none
  };
  struct Level {
    std::int32_t columns = 0, rows = 0;
    std::vector<float> nearness;  // affine; whatever is less near than this is hidden; no_occluder: nothing is hidden
    float at(std::int32_t i, std::int32_t j) const {
      return nearness[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
    }
  };
  /// Columns or rows of tiles.
  struct Tiles {
    std::int32_t first, last;
  };
  /// Of the way along a segment, each known within `error`.
  struct Shares {
    double low, high, error;
  };
  class Region;
  class AlongSegment;

  /// Where an image lies on the grid. Columns are counted from the right to the left of the image, so the grid is its mirror
  /// image: what turns counter-clockwise as seen turns clockwise there.
  static ImagePoint on_grid(const ImagePoint& image) { return {-image.x, image.y}; }
  double affine(float nearness) const;
  Rectangle rectangle(std::span<const VertexId> vertices) const;
  Rectangle rectangle(TriangleId t, TriangleId s) const;
  Rectangle grown(Rectangle r, double error) const;
  AffineDepth plane_nearness(TriangleId t, const Rectangle& around) const;
  void choose_grid(bool always);
  template <class F>
  void for_each_cover(std::size_t begin, std::size_t end, const F& visit) const;
  void cover_all();
  void cover_by_triangle(TriangleId t, const Tiles& rows);
  void cover_by_pair(TriangleId t, TriangleId s, const Tiles& rows);
  template <std::size_t n>
  void cover(const Region& region, const Rectangle& around, const Tiles& rows, const std::array<AffineDepth, n>& planes);
  void build_levels();
  bool is_inside(const Rectangle& r, std::array<Tiles, 2>& range) const;
  template <class F>
  bool visit_tiles(TriangleId t, const Rectangle& around, const std::array<Tiles, 2>& range, const AffineDepth& n,
                   const F& visit) const;
  Tiles between(std::size_t axis, double low, double high, const Tiles& within) const;
  bool is_before(const ImagePoint& p, double nearness) const;
  template <class S, class F>
  bool walk_along(std::size_t level, const ImagePoint& p, const ImagePoint& q, double error, const S& start,
                  const F& visit) const;
  bool hides(const ImagePoint& p, float nearness_of_p, const ImagePoint& q, float nearness_of_q, double error) const;
  bool hides(const std::array<Tiles, 2>& range, float nearest) const;
  bool hides(std::size_t level, std::int32_t i, std::int32_t j, const std::array<Tiles, 2>& range, float nearest) const;

  const ProjectedMesh& projected_;
  std::array<Axis, 2> axes_;
  std::vector<Level> levels_;  // finest first
};

}  // namespace hsr::internal
