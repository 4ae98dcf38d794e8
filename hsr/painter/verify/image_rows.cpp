#include "hsr/painter/verify/image_rows.h"

namespace hsr::internal {

ImageRows::ImageRows(const View& view) : parallel(!view.is_perspective()), eye(rational(view.viewpoint.at)) {
  away = parallel ? minus(RationalVector{}, eye) : minus(rational(view.target), eye);
  for (std::size_t k = 0; k < 3; ++k) {
    RationalVector unit;
    unit[k] = 1.0;
    const RationalVector c = cross(away, unit);
    if (dot(c, c).sign() == Sign::zero) continue;
    across = {c, cross(c, away)};
    break;
  }
}

ImagePlace ImageRows::place(const RationalVector& p) const {
  const RationalVector d = from_eye(p);
  const Rational w = parallel ? Rational(1.0) : dot(d, away);
  return {dot(d, across[0]) / w, dot(d, across[1]) / w};
}

RationalVector ImageRows::point(const RationalVector& normal, const RationalVector& on, const ImagePlace& at) const {
  const Rational s = at[0] / dot(across[0], across[0]), t = at[1] / dot(across[1], across[1]);
  RationalVector p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = s * across[0][k] + t * across[1][k];
  if (parallel) {
    const Rational u = dot(normal, minus(on, p)) / dot(normal, away);
    for (std::size_t k = 0; k < 3; ++k) p[k] = p[k] + u * away[k];
    return p;
  }
  const Rational w = Rational(1.0) / dot(away, away);
  for (std::size_t k = 0; k < 3; ++k) p[k] = p[k] + w * away[k];  // the ray
  const Rational u = dot(normal, minus(on, eye)) / dot(normal, p);
  for (std::size_t k = 0; k < 3; ++k) p[k] = eye[k] + u * p[k];
  return p;
}

}  // namespace hsr::internal
