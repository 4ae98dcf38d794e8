#pragma once

#include "hsr/raster/caster.h"

namespace hsr::internal {

/// A triangle that a ray meets, compared with the nearest so far.
struct CastComparison {
  int column = 0, row = 0;
  TriangleId triangle, nearest;   ///< not valid: nothing was met before
  double nearness = 0, held = 0;  ///< in doubles, of both; larger is nearer
  double error = 0;               ///< the two are surely nearer or farther where they differ by more than this
  bool is_exact = false;          ///< doubles did not tell: it was decided exactly
  bool is_nearest = false;        ///< the triangle is the nearest from now on
};

/// Is told what the caster does, in the order in which it does it. Rays go together in packets, as many as a side is wide.
class CastObserver {
 public:
  CastObserver() = default;
  CastObserver(const CastObserver&) = delete;
  CastObserver& operator=(const CastObserver&) = delete;
  virtual ~CastObserver() = default;

  /// The rays of columns left ... right - 1 and rows top ... bottom - 1.
  virtual void packet(int left, int top, int right, int bottom) = 0;
  /// The box of a triangle meets that of the rays, and reaches nearer than the farthest of what all of them have met.
  virtual void tried(TriangleId t) = 0;
  /// Doubles tell that no ray of the packet is on the inner side of one of its sides: 0 ... 2, from that corner to the next; 3: of
  /// the near plane.
  virtual void apart(TriangleId t, int side) = 0;
  /// A ray meets the triangle.
  virtual void compared(const CastComparison& comparison) = 0;
  /// All that was tried of it is done.
  virtual void tried_all_rays(TriangleId t) = 0;
};

/// How many triangles are in the tree of boxes.
struct WatchedCast {
  CastImage image;
  std::size_t boxes = 0;
};

/// cast(), watched, packet by packet in one thread: it gives the same. @param width of packets: 1, 4 or 16; unwatched they are of 16
/// @pre the scene has no sections
WatchedCast cast(const SceneView& scene, const SampleGrid& samples, int width, CastObserver& observer);

}  // namespace hsr::internal
