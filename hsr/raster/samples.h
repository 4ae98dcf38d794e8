#pragma once

#include "geometry/bit_range.h"
#include "geometry/mesh.h"
#include "hsr/view/view.h"

namespace hsr {

/// A part of the paper, in units of the view's frame.
struct PaperRectangle {
  double left = 0, right = 0, bottom = 0, top = 0;
};

/// The samples of a picture: the points origin + i right + j down of space, 0 <= i < width, 0 <= j < height, exactly. Row 0 is
/// the top of the picture.
///
/// A sample that lies exactly on an edge (as seen) is decided as if it were moved by (e, e^2) along (right, down), e -> 0: an
/// edge belongs to what is on its right, a horizontal one to what is below it. `at` is exact for 0 <= i <= width and
/// 0 <= j <= height: the row and the column after the last tell how a plane's value changes.
struct SampleGrid {
  Point3 origin, right, down;
  int width = 0, height = 0;

  Point3 at(int i, int j) const {
    return {origin.x + (i * right.x + j * down.x), origin.y + (i * right.y + j * down.y),
            origin.z + (i * right.z + j * down.z)};
  }
  /// Of every sample, and the vectors. @throws PreconditionError if the samples are no doubles
  BitRange bit_range() const;
};

/// The samples of a picture of width x height square pixels, as small as shows all of `part`, which is in its middle; samples
/// are in the middle of their pixels.
///
///   (1) all coordinates are multiples of one power of two, 2^-50 of the largest one or more: each sample is exactly a double
///   (2) no sample is farther than a 16th of a pixel in each coordinate from where the view's frame has it
///   (3) where (1) and (2) would not go together, the pixels are made larger: at least 16 of that power of two, and (2) is lost
///
/// A part of no size gives pixels of size 1.
/// @throws InputError unless width and height are 1 ... 65536 and the samples are finite
SampleGrid sample_grid(const View& view, const PaperRectangle& part, int width, int height);
/// The picture around the middle of the frame.
/// @throws InputError as above
SampleGrid sample_grid(const View& view, const FrameSize& size, int width, int height);

/// The part of the paper that the mesh beyond the near plane covers, rounded. Nothing: a rectangle of no size.
PaperRectangle paper_rectangle(const Mesh& mesh, const View& view);

}  // namespace hsr
