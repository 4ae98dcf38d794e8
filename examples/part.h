#pragma once

#include "hsr/model.h"

namespace hsr::examples {

/// A mechanical part: a spur gear of 24 involute teeth on a square flange, with a boss, a keyway, bolt holes and lightening
/// holes. Millimetres, Z up, the axis of the gear is the z axis, about 116 x 116 x 60.
///
///   (1) closed, manifold, oriented outward
///   (2) every polygon is exactly planar: caps have one z, the quads of walls stand upright, those of chamfers are trapezoids
///       cut from circles that are exact multiples of one another
///   (3) coordinates are multiples of 2^-16 mm
///   (4) facets of cylinders and flanks meet at less than 30 degrees, so that only outlines show
Model part();

}  // namespace hsr::examples
