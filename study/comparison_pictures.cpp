#include "study/comparison_pictures.h"

#include <algorithm>

#include "hsr/io/write/image_png.h"

namespace hsr::internal {

Colour mistake_colour(Mistake mistake) {
  switch (mistake) {
    case Mistake::none:
      return {0, 0, 0, 0};
    case Mistake::edge:
      return {30, 100, 255, 255};
    case Mistake::tie:
      return {255, 150, 0, 255};
    case Mistake::order:
      return {225, 0, 30, 255};
  }
  return {};
}

ComparisonImages comparison_images(const Mesh& mesh, const ComparedPicture& picture, const std::vector<Colour>& colours) {
  const int w = picture.shown.width, h = picture.shown.height;
  Image<Colour> shown(w, h), changes(w, h, {0, 0, 0, 0}), mistakes(w, h, {0, 0, 0, 0});
  for (std::size_t k = 0; k < shown.pixels.size(); ++k) {
    const TriangleId t = picture.shown.pixels[k];
    Colour c = t.is_valid() ? colours[mesh.face_of[t].value] : Colour{255, 255, 255, 255};
    c[3] = 255;
    shown.pixels[k] = c;
    if (picture.mistakes.pixels[k] == Mistake::none) continue;
    changes.pixels[k] = c;
    mistakes.pixels[k] = mistake_colour(picture.mistakes.pixels[k]);
  }
  ComparisonImages images{image_png(shown), image_png(changes), image_png(mistakes), {}};
  if (!picture.depth.pixels.empty()) {
    Image<Colour> depth(w, h);
    std::transform(picture.depth.pixels.begin(), picture.depth.pixels.end(), depth.pixels.begin(), [](std::uint8_t d) {
      const auto grey = static_cast<std::uint8_t>(255 - d);
      return Colour{grey, grey, grey, 255};
    });
    images.depth = image_png(depth);
  }
  return images;
}

}  // namespace hsr::internal
