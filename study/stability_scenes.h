#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/raster/samples.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// Where the nearest face and the next are closest, as nearnesses (Seen::nearness, hsr/raster/sample_projection.h).
struct ClosestDepths {
  double nearest = 0, farthest = 0;  ///< between these lie the two over the whole picture
  double difference = 0;
};

/// A scene of a family, at one value of its knob, with an answer that is known from how it was made.
struct StiffScene {
  std::vector<Point3> points;
  Polygons polygons;
  View view;
  SampleGrid grid;
  /// The face seen at sample (i, j), not valid: none; nothing: the construction does not tell. May be empty: it tells nowhere.
  std::function<std::optional<FaceId>(int i, int j)> known;
  std::optional<ClosestDepths> closest;  ///< where a prediction for depth buffers makes sense
  /// So many faces at the end are outside the picture, or hidden: they hold the depth range of the buffers. What is farthest in
  /// it may be rounded to the depth of the background by 8 bits, and then is not drawn at all.
  std::size_t only_for_range = 0;
};

/// Scenes with one knob.
struct StabilityFamily {
  const char *name, *title, *knob;
  const char *scene_text, *known_text;          ///< what one sees; where the known answer comes from
  std::vector<double> (*values)(bool quick);    ///< from what is easy to what is hard, all above 0
  StiffScene (*scene)(double value, int size);  ///< @param size samples each way
  Point3 sketch_from = {2, -5, 3};              ///< a parallel view for a sketch: toward the viewer
  double sketch_value = 1;                      ///< of the knob
};

/// gap       two parallel faces around depth 0, seen aslant: 1 ... 5e-324
/// ulp       two at height 1.5, seen from above: down to one unit in the last place
/// distance  two walls at distance 128 of a perspective that has faces at 1/8 and at 8192
/// slope     two faces that cross at a slope of 1 ... 5e-324
/// ratio     two walls a 64th of their distance apart, 1 ... 1e300 times as far as the near plane
/// large, small   three faces in a cycle and two that pierce each other, all times 2^k
/// offset    the same, moved away from the origin by up to 1e300
/// sliver    a strip that is up to 2^53 times as long as wide, along a diagonal of samples
/// grazing   a floor seen at an angle of 1 ... 5e-324, before a wall
/// layers    n steps of a stair between two depths
/// cycle     n slats in a ring, each over the next
/// soup      n triangles with integer corners in [-2, 2]^3: everything coincides
std::span<const StabilityFamily> stability_families();

}  // namespace hsr::internal
