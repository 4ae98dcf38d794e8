#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/simd.h"
#include "hsr/painter/sort/face_pieces.h"

namespace hsr::internal {

/// A triangle in the image in floats, its corners counter-clockwise, so that O is positive within. The last place is the third corner again: four
/// make a vector. Not a number: no triangle, or its image is not known.
struct alignas(64) ImageTriangle {
  std::array<float, 4> x, y;
  std::array<std::uint32_t, 4> vertex;
  float size = 0;                   // the width and the height of its box, or more
  float farthest = 0, nearest = 0;  // its nearness lies between, as that of ImageBox
};

/// The images of the pieces that are triangles, moved and multiplied so that all fit into a square from -1 to 1.
struct ImageTriangles {
  std::vector<ImageTriangle> triangles;  // by piece; none: images are not known
  float error = 0;                       // of each coordinate
};

/// Cost: O(n), parallel.
ImageTriangles image_triangles(const ProjectedMesh& projected, const FacePieces& pieces);

/// Whether some side of one triangle has all of the inside of another on its outer side, so that they do not overlap.
enum class Separation : std::uint8_t { yes, no, open };

/// A corner of a triangle in all four places.
struct ImageCorner {
  ImageCorner() = default;
  ImageCorner(const ImageTriangle& t, std::size_t k)
      : x(FourFloats::all(t.x[k])), y(FourFloats::all(t.y[k])), vertex(FourIndices::all(t.vertex[k])) {}

  FourFloats x, y;
  FourIndices vertex;
};

/// The share of R in the bound of ImageSides, for images that are known within `error`.
inline float share_of_reach(float error, float reach) { return 2.2F * error * reach + 9.1F * error * error + 0x1p-100F; }

/// The sides of a triangle, prepared for the corners of many others: place k is the line from corner k to the next.
///
/// f(p) = dx p_y - dy p_x + c is the sign of O. With E the error of a coordinate, u = 2^-24, D = |dx| + |dy| as computed and R
/// at least |r|_1, where r = p - a for the start a of the side: dx and dy are off by 2 E and one rounding, r by 2 E, so
/// dx r_y - dy r_x over the rounded numbers is off by at most 2 E (D + R) (1 + u) + 8 E^2 + 2.1 u D, as no coordinate exceeds
/// 1.01. c rounds three times, f four times more, all terms at most 1.01 D or in the end 2.02 D: 6.1 u D. Lost products: less
/// than 2^-147. So |f - exact| <= 2.1 E (D + R) + 8.1 E^2 + 8.3 u D + 2^-147; the bound is computed with constants a little
/// larger, which pays for its own roundings.
struct ImageSides {
  ImageSides() = default;
  ImageSides(const ImageTriangle& t, float error) {
    const FourFloats x = FourFloats::load(t.x.data()), y = FourFloats::load(t.y.data());
    from = FourIndices::load(t.vertex.data());
    to = from.turned();
    dx = x.turned() - x;
    dy = y.turned() - y;
    c = dy * x - dx * y;
    bound = (dx.magnitude() + dy.magnitude()) * FourFloats::all(2.2F * error + 8.6F * 0x1p-24F);
  }

  /// f of each side.
  FourFloats value(const ImageCorner& p) const { return dx * p.y - dy * p.x + c; }

  FourFloats dx, dy, c;
  FourFloats bound;  // without the share of R
  FourIndices from, to;
};

/// Whether a side of a separates the images of a and of b, of which corner(k) is a corner; open: floats leave one side open.
/// Corners at the ends of a side are on it. @param rest the share of R in the bound. Without branches: which side decides is
/// not to be foreseen.
template <class Corner>
Separation separation(const ImageSides& a, const Corner& corner, float rest) {
  constexpr unsigned sides = 7;
  const FourFloats bound = a.bound + FourFloats::all(rest);
  FourFloats before = FourFloats::zero(), behind = a.from == a.from;  // of a side: certainly one corner; certainly all
  for (std::size_t k = 0; k < 3; ++k) {
    const ImageCorner p = corner(k);
    const FourFloats f = a.value(p), on = (a.from == p.vertex) | (a.to == p.vertex);
    before = before | (f > bound).without(on);
    behind = behind & ((FourFloats::zero() - bound > f) | on);
  }
  if ((behind.bits() & sides) != 0) return Separation::yes;
  return (before.bits() & sides) == sides ? Separation::no : Separation::open;
}

/// A triangle prepared to be compared with many others.
class PreparedTriangle {
 public:
  PreparedTriangle() = default;
  PreparedTriangle(const ImageTriangle& t, float error)
      : sides_(t, error),
        corners_{ImageCorner(t, 0), ImageCorner(t, 1), ImageCorner(t, 2)},
        x_(t.x[0]),
        y_(t.y[0]),
        size_(t.size),
        error_(error) {}

  /// By the sides of this one, and by those of the other.
  struct Both {
    Separation own = Separation::open, other = Separation::open;
  };
  Both separation_from(const ImageTriangle& t) const {
    const float reach = std::fabs(t.x[0] - x_) + std::fabs(t.y[0] - y_) + size_ + t.size;
    const float rest = share_of_reach(error_, reach);
    Both found;
    found.own = separation(
        sides_, [&](std::size_t k) { return ImageCorner(t, k); }, rest);
    if (found.own != Separation::yes)
      found.other = separation(
          ImageSides(t, error_), [&](std::size_t k) { return corners_[k]; }, rest);
    return found;
  }

 private:
  ImageSides sides_;
  std::array<ImageCorner, 3> corners_;
  float x_ = 0, y_ = 0, size_ = 0, error_ = 0;
};

}  // namespace hsr::internal
