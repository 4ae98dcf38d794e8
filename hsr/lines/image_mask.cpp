#include "hsr/lines/image_mask.h"

#include <algorithm>
#include <cmath>

namespace hsr {

ImageMask::ImageMask(std::span<const ImageBox> boxes) : marks_(static_cast<std::size_t>(places) * places, 0) {
  ImageBox all = ImageBox::nothing();
  for (const ImageBox& box : boxes) all.add(box);
  for (std::size_t k = 0; k < 2; ++k) {
    const float extent = all.high[k] - all.low[k];
    if (!(extent > 0) || !std::isfinite(extent)) continue;  // then everything shares the first place
    low_[k] = all.low[k];
    scale_[k] = static_cast<float>(places) / extent;
    if (!std::isfinite(scale_[k])) scale_[k] = 0;
  }
  for (const ImageBox& box : boxes) {
    const auto r = range(box);
    for (std::int32_t j = r[2]; j <= r[3]; ++j)
      std::fill_n(marks_.begin() + static_cast<std::ptrdiff_t>(j) * places + r[0], r[1] - r[0] + 1, std::uint8_t{1});
  }
}

std::array<std::int32_t, 4> ImageMask::range(const ImageBox& box) const {
  const auto place = [&](float x, std::size_t k) {
    const float at = (x - low_[k]) * scale_[k];
    // NaN (an infinite box over an extent of nothing) goes to the first place, where everything is then.
    return !(at > 0) ? 0 : at < static_cast<float>(places) ? static_cast<std::int32_t>(at) : places - 1;
  };
  return {place(box.low[0], 0), place(box.high[0], 0), place(box.low[1], 1), place(box.high[1], 1)};
}

bool ImageMask::touches(const ImageBox& box) const {
  const auto r = range(box);
  for (std::int32_t j = r[2]; j <= r[3]; ++j) {
    const auto row = marks_.begin() + static_cast<std::ptrdiff_t>(j) * places;
    if (std::find(row + r[0], row + r[1] + 1, std::uint8_t{1}) != row + r[1] + 1) return true;
  }
  return false;
}

}  // namespace hsr
