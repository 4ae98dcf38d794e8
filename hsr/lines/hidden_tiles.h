#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box_tree.h"
#include "hsr/sight.h"

namespace hsr {

/// A grid of tiles over the image, each with a depth beyond which everything is hidden: a conservative test that drops what is
/// provably hidden, before anything exact is asked.
///
/// A tile is covered by a triangle, or by two that share an edge and lie on opposite sides of it, where it lies certainly
/// within all their other sides. What lies beyond the farthest point of those triangles is then hidden in all of the closed
/// tile. Every bound is rounded toward "not hidden". Where the images are exact (axis-parallel views), so are sides that run
/// along an axis: in an elevation what ends exactly where the face before it ends is hidden, too.
///
///   (1) what `hides` says yes to is hidden at every point
///   (2) the same for any number of threads
///
/// Cost: O(n + tiles covered), parallel; a query O(log tiles) mostly.
/// Source: Greene, Kass & Miller 1993, "Hierarchical z-buffer visibility"; here with bounds instead of samples.
class HiddenTiles {
 public:
  /// @param boxes of the triangles @param always even if there is little to hide
  HiddenTiles(const Sight& sight, std::span<const ImageBox> boxes, bool always);

  /// No tile hides anything.
  bool is_empty() const { return levels_.empty(); }

  /// Whether the convex hull of these vertices is certainly hidden. @pre they lie beyond the near plane
  /// @param nearest not less than the nearness of any of them, as boxes have it
  bool hides(std::span<const VertexId> vertices, float nearest) const;
  /// Marks, by triangle, the faces that are certainly hidden. Whole faces: where the triangles of a planar face meet, the mesh
  /// has no edge.
  void mark_hidden(std::span<const ImageBox> boxes, std::vector<std::uint8_t>& hidden) const;

 private:
  struct Rectangle {
    std::array<double, 2> low, high;
  };
  /// The tiles along one coordinate: tile i reaches from border(i) to border(i + 1).
  struct Axis {
    double first = 0, width = 1;
    std::int32_t tiles = 0;

    double border(std::int32_t i) const { return first + i * width; }
    std::int32_t last_border_up_to(double x) const;  ///< -1: none
    std::int32_t first_border_from(double x) const;  ///< tiles + 1: none
  };
  struct Level {
    std::int32_t columns = 0, rows = 0;
    std::vector<float> nearness;  // what is less near is hidden; -infinity: nothing is
  };
  class Region;

  Rectangle rectangle(std::span<const VertexId> vertices) const;
  void choose_grid(bool always);
  void cover(const Region& region, const Rectangle& around, float nearness);
  void cover_triangles(std::span<const ImageBox> boxes);
  void cover_pair(TriangleId t, TriangleId s, const Edge& edge, std::span<const ImageBox> boxes);
  void cover_pairs(std::span<const ImageBox> boxes);
  void build_levels();
  bool hides(std::size_t level, std::int32_t i, std::int32_t j, const std::array<std::int32_t, 4>& range, float nearest) const;

  const Sight& sight_;
  std::array<Axis, 2> axes_;
  std::vector<Level> levels_;  // finest first
};

}  // namespace hsr
