#include "hsr/cli/coincident_note.h"

#include <fmt/core.h>

#include <array>
#include <map>
#include <vector>

namespace hsr::cli {

namespace {

/// A number for each face, the same for those that have colour, material and object in common.
std::vector<std::uint32_t> kinds_of(const Model& model, std::size_t faces) {
  const auto of = [](const std::vector<std::uint32_t>& list, std::size_t f) { return list.empty() ? 0 : list[f]; };
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number;
  std::vector<std::uint32_t> kinds;
  for (std::size_t f = 0; f < faces; ++f)
    kinds.push_back(
        number
            .emplace(std::array{of(model.face_colour, f), of(model.face_material, f), of(model.face_object, f)}, number.size())
            .first->second);
  return kinds;
}

}  // namespace

std::string coincident_note(const SceneView& scene, const Model& model, Coincidence which) {
  const std::size_t n = under_coincident_faces(scene, kinds_of(model, scene.mesh().faces.size()), which).size();
  if (n == 0) return {};
  const bool is_last = scene.options().coplanar == Coplanar::last;
  return fmt::format(
      "{} under faces of another colour, material or object in the same plane: of faces that coincide the {} in the file is on "
      "top, --coplanar {} turns it",
      n == 1 ? "1 face lies" : fmt::format("{} faces lie", n), is_last ? "last" : "first", is_last ? "first" : "last");
}

}  // namespace hsr::cli
