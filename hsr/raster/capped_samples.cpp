#include "hsr/raster/capped_samples.h"

#include <optional>

#include "geometry/parallel.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

Image<std::uint8_t> capped_samples(const SceneView& scene, const SampleGrid& samples) {
  const SectionCaps* const caps = scene.parts().caps();
  if (caps == nullptr) return {};
  const auto exact = [&](int i, int j) { return caps->seen_at(rational(samples.at(i, j))); };
  const auto difference = [](const SectionCaps::ExactPlace& a, const SectionCaps::ExactPlace& b) {
    return SectionCaps::ExactPlace{a[0] - b[0], a[1] - b[1]};
  };
  Image<std::uint8_t> image(samples.width, samples.height, 0);
  parallel_for_each(static_cast<std::size_t>(samples.height), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < samples.width; ++i) {
      const Point3 p = samples.at(i, j);
      const auto known = caps->covers(caps->seen_at({{{p.x, 0}, {p.y, 0}, {p.z, 0}}}));
      if (known) {
        image.at(i, j) = *known ? 1 : 0;
        continue;
      }
      const SectionCaps::ExactPlace at = exact(i, j);
      std::optional<std::uint32_t> least;
      const auto objects = caps->objects_beside(at, difference(exact(i + 1, j), at), least, difference(exact(i, j + 1), at));
      image.at(i, j) = objects.empty() ? 0 : 1;
    }
  });
  return image;
}

}  // namespace hsr::internal
