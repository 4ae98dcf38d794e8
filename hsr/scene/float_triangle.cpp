#include "hsr/scene/float_triangle.h"

#include <algorithm>
#include <cmath>

namespace hsr::internal {

namespace {

constexpr float v = 0x1p-24F;
// Where no length is above `most`, underflow changes no value by as much as `least`.
constexpr float most = 0x1p20F, least = 0x1p-80F;

/// The middle of an interval and how far its ends are, rounded outward.
struct Middle {
  float at, error;
  Middle(float low, float high) : at(low / 2 + high / 2), error(std::max(high - at, at - low) * (1 + 4 * v)) {}
};

/// As planes see it: the nearness itself, or in perspective its negative reciprocal.
Middle nearness(const ImageBox& box, bool is_perspective) {
  if (!is_perspective) return {box.farthest, box.nearest};
  if (!(box.nearest < 0)) return {-HUGE_VALF, HUGE_VALF};
  return {-1 / box.farthest * (1 - 4 * v), -1 / box.nearest * (1 + 4 * v)};
}

}  // namespace

FloatTriangle::FloatTriangle(const ProjectedMesh& projected, TriangleId t, bool is_single) {
  const auto& c = projected.mesh().triangles[t];
  float error = 0, size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const ImageBox& box = projected.box(c[k]);
    const Middle a(box.low[0], box.high[0]), b(box.low[1], box.high[1]), d = nearness(box, projected.is_perspective());
    x[k] = a.at;
    y[k] = b.at;
    z[k] = d.at;
    error = std::max(std::max(error, a.error), std::max(b.error, d.error));
    vertex[k] = c[k].value;
  }
  for (const auto* at : {&x, &y, &z})
    size += std::max(std::max((*at)[0], (*at)[1]), (*at)[2]) - std::min(std::min((*at)[0], (*at)[1]), (*at)[2]);
  x[3] = error;
  y[3] = size * (1 + 8 * v);
  z[3] = 0;
  vertex[3] = is_single ? single : other;
}

TriangleSeparation::TriangleSeparation(const FloatTriangle& s) : s_(s) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = k == 2 ? 0 : k + 1;
    dx_[k] = s.x[next] - s.x[k];
    dy_[k] = s.y[next] - s.y[k];
  }
  const float turn = dx_[0] * (s.y[2] - s.y[0]) - dy_[0] * (s.x[2] - s.x[0]), size = s.size(), e = s.error();
  // As in has_beyond_side(), of its own corner.
  const float margin = (2 * e * size + size * (2 * e + 8 * v * size) + 16 * e * e) * 1.1F + least;
  if (size < most && e < most) turn_ = turn > margin ? 1 : turn < -margin ? -1 : 0;
}

bool TriangleSeparation::is_apart_from(const FloatTriangle& t) const {
  if (!(s_.size() < most && t.size() < most && s_.error() < most && t.error() < most)) return false;
  if (has_beyond_side(t)) return true;
  const TriangleSeparation other(t);
  return other.has_beyond_side(s_) || has_beside_plane(t) || other.has_beside_plane(s_);
}

/// With e and e' the errors of a coordinate, of these and of the other's, S and S' the sizes: no corner of the other is farther
/// from one of these, as a sum of differences, than S + S' and some errors, since the boxes touch. A side d and the way w to a
/// corner are off by 2 e and e + e' in each entry, so that det(d, w) is by at most S (e + e') + (S + S') 2 e + 8 e (e + e'); the
/// differences, products and the last one round by 4 v |d| |w| together.
bool TriangleSeparation::has_beyond_side(const FloatTriangle& t) const {
  if (turn_ == 0) return false;
  const float e = s_.error(), both = e + t.error(), way = s_.size() + t.size() + 8 * both, size = s_.size();
  const float margin = (size * both + way * (2 * e + 8 * v * size) + 8 * e * both) * 1.1F + least;
  const FourFloats beyond = FourFloats::all(-margin);
  const FourFloats tx = FourFloats::load(t.x.data()), ty = FourFloats::load(t.y.data());
  const FourIndices vertex = FourIndices::load(t.vertex.data());
  std::array<FourFloats, 3> is_common;
  for (std::size_t k = 0; k < 3; ++k) is_common[k] = vertex == FourIndices::all(s_.vertex[k]);
  const bool are_single = s_.is_single() && t.is_single();
  // All sides, without a branch: which of them tells, no processor foresees.
  bool is_beyond = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const FourFloats common = is_common[k] | is_common[k == 2 ? 0 : k + 1];
    const FourFloats det = FourFloats::all(turn_ * dx_[k]) * (ty - FourFloats::all(s_.y[k])) -
                           FourFloats::all(turn_ * dy_[k]) * (tx - FourFloats::all(s_.x[k]));
    const unsigned shared = common.bits() & 7U;
    const bool is_one_corner = (shared & (shared - 1)) == 0;
    is_beyond |= ((((det < beyond) | common).bits() & 7U) == 7) & (is_one_corner | are_single);
  }
  return is_beyond;
}

/// det(u, v, w) of two sides u, v and the way w to a corner: with errors as above at most 2 e 2 (S + 6 e) |w| + 2 e 2 S |w| +
/// 2 S^2 (e + e'), and 6.1 v of terms that add up to S^2 |w| at most.
bool TriangleSeparation::has_beside_plane(const FloatTriangle& t) const {
  const float e = s_.error(), both = e + t.error(), way = s_.size() + t.size() + 8 * both, size = s_.size();
  const float margin = (8 * e * (size + 6 * e) * way + 2 * size * size * both + 8 * v * size * size * way) * 1.1F + least;
  const FourFloats above = FourFloats::all(margin), below = -above;
  const float ux = dx_[0], uy = dy_[0], uz = s_.z[1] - s_.z[0], vx = s_.x[2] - s_.x[0], vy = s_.y[2] - s_.y[0],
              vz = s_.z[2] - s_.z[0];
  const auto all = [](float f) { return FourFloats::all(f); };
  const FourFloats x = FourFloats::load(t.x.data()) - all(s_.x[0]), y = FourFloats::load(t.y.data()) - all(s_.y[0]),
                   z = FourFloats::load(t.z.data()) - all(s_.z[0]);
  const FourFloats value = all(uy * vz - uz * vy) * x + all(uz * vx - ux * vz) * y + all(ux * vy - uy * vx) * z;
  const FourIndices vertex = FourIndices::load(t.vertex.data());
  const FourFloats common = (vertex == FourIndices::all(s_.vertex[0])) | (vertex == FourIndices::all(s_.vertex[1])) |
                            (vertex == FourIndices::all(s_.vertex[2]));
  const unsigned shared = common.bits() & 7U;
  if (shared == 7 || ((shared & (shared - 1)) != 0 && !(s_.is_single() && t.is_single()))) return false;
  return (((value > above) | common).bits() & 7U) == 7 || (((value < below) | common).bits() & 7U) == 7;
}

}  // namespace hsr::internal
