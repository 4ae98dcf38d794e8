#include "hsr/raster/capped_samples.h"

#include <optional>

#include "geometry/parallel.h"
#include "hsr/raster/cell_samples.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

namespace {

Image<std::uint8_t> capped_in_cells(const SceneView& scene, const SampleGrid& samples) {
  const Image<std::uint8_t> cell_of = cell_samples(scene, samples);
  Image<std::uint8_t> image(samples.width, samples.height, 0);
  const auto& cells = scene.parts().cells();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Image<std::uint8_t> one = capped_samples(cells[k].scene, samples);
    for (std::size_t p = 0; p < one.pixels.size(); ++p)
      if (cell_of.pixels[p] == k) image.pixels[p] = one.pixels[p];
  }
  return image;
}

}  // namespace

Image<std::uint8_t> capped_samples(const SceneView& scene, const SampleGrid& samples) {
  if (scene.view().has_cells()) return capped_in_cells(scene, samples);
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
