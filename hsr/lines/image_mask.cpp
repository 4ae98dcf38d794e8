#include "hsr/lines/image_mask.h"

#include <algorithm>
#include <cmath>

namespace hsr::internal {

ImageMask::ImageMask(std::span<const ImageBox> boxes, std::size_t queries)
    : places_(std::clamp(static_cast<std::int32_t>(4 * std::sqrt(static_cast<double>(queries))), 16, 1024)) {
  ImageBox all = ImageBox::nothing();
  for (const ImageBox& box : boxes) all.add(box);
  for (std::size_t k = 0; k < 2; ++k) {
    const float extent = all.high[k] - all.low[k];
    if (!(extent > 0) || !std::isfinite(extent)) continue;  // then everything shares the first place
    low_[k] = all.low[k];
    scale_[k] = static_cast<float>(places_) / extent;
    if (!std::isfinite(scale_[k])) scale_[k] = 0;
  }
  // How many boxes cover each place, by where they begin and end: a large box costs no more than a small one.
  std::vector<std::int32_t> cover(at(0, places_ + 1), 0);
  marked_.resize(cover.size(), 0);
  for (const ImageBox& box : boxes) {
    const auto r = range(box);
    ++cover[at(r[0], r[2])];
    --cover[at(r[1] + 1, r[2])];
    --cover[at(r[0], r[3] + 1)];
    ++cover[at(r[1] + 1, r[3] + 1)];
  }
  for (std::int32_t j = 0; j < places_; ++j)
    for (std::int32_t i = 0; i < places_; ++i) {
      std::int32_t& here = cover[at(i, j)];
      if (i > 0) here += cover[at(i - 1, j)];
      if (j > 0) here += cover[at(i, j - 1)];
      if (i > 0 && j > 0) here -= cover[at(i - 1, j - 1)];
      marked_[at(i + 1, j + 1)] = marked_[at(i, j + 1)] + marked_[at(i + 1, j)] - marked_[at(i, j)] + (here > 0 ? 1U : 0U);
    }
}

std::array<std::int32_t, 4> ImageMask::range(const ImageBox& box) const {
  const auto place = [&](float x, std::size_t k) {
    const float step = (x - low_[k]) * scale_[k];
    // NaN (an infinite box over an extent of nothing) goes to the first place, where everything is then.
    return !(step > 0) ? 0 : step < static_cast<float>(places_) ? static_cast<std::int32_t>(step) : places_ - 1;
  };
  return {place(box.low[0], 0), place(box.high[0], 0), place(box.low[1], 1), place(box.high[1], 1)};
}

bool ImageMask::touches(const ImageBox& box) const {
  const auto r = range(box);
  return marked_[at(r[1] + 1, r[3] + 1)] - marked_[at(r[0], r[3] + 1)] - marked_[at(r[1] + 1, r[2])] + marked_[at(r[0], r[2])] >
         0;
}

}  // namespace hsr::internal
