#pragma once

#include "hsr/model.h"

namespace hsr::internal {

/// Whether a model looks as if it stood on its side when z is taken for up: whether y seems to be up in it.
///
/// A *foot* is what a model has flat at an end of an axis: the area of the faces of which all corners are there, by the area of the
/// side of the bounding box. y seems to be up if
///
///   (1) the foot at the least y is half of that side or more,
///   (2) the one at the greatest y is less than an eighth of it, so that the two ends are unlike, as floor and roof are, and
///   (3) the feet at both ends of z differ by less than a sixteenth of their side: front and back are alike.
///
/// A guess: it proposes, and decides nothing. What has no foot (terrain, figures, most scans) is not judged.
/// Cost: O(n).
bool seems_y_up(const Model& model);

}  // namespace hsr::internal
