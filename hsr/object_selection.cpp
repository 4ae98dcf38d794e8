#include "hsr/object_selection.h"

#include <algorithm>
#include <filesystem>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

enum class Fate : std::uint8_t { kept, gone, ghost };

/// On one line, whatever is in the name.
std::string in_one_line(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  return name;
}

std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "\"" : ", \"") + in_one_line(name) + "\"";
  return all;
}

/// Which of the names are meant. Objects of one name are meant together.
std::vector<std::uint8_t> meant(const char* option, const std::vector<std::string>& asked,
                                const std::vector<std::string>& names) {
  std::vector<std::uint8_t> is_meant(names.size(), 0);
  for (const std::string& name : asked) {
    bool found = false;
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k] == name) is_meant[k] = found = true;
    if (!found)
      throw InputError(std::string(option) + ": found no object \"" + in_one_line(name) + "\", expected one of " +
                       listed(names));
  }
  return is_meant;
}

std::vector<Fate> fates(const ObjectSelection& s, const std::vector<std::string>& names) {
  const auto only = meant("only", s.only, names), hide = meant("hide", s.hide, names), ghost = meant("ghost", s.ghost, names);
  std::vector<Fate> all(names.size(), Fate::kept);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (hide[k] != 0 && (only[k] != 0 || ghost[k] != 0))
      throw InputError("hide: found \"" + in_one_line(names[k]) +
                       "\", which --only or --ghost asks for; expected one of the two");
    if (ghost[k] != 0)
      all[k] = Fate::ghost;
    else if (hide[k] != 0 || (!s.only.empty() && only[k] == 0))
      all[k] = Fate::gone;
  }
  return all;
}

}  // namespace

void select(Model& model, const ObjectSelection& selection) {
  if (selection.is_empty()) return;
  std::vector<std::string> names = model.objects;
  if (names.empty()) names = {std::filesystem::path(model.name).filename().string()};
  const std::vector<Fate> fate = fates(selection, names);
  const auto fate_of = [&](const std::vector<std::uint32_t>& objects, std::size_t k) {
    const std::size_t of_unnamed = model.objects.empty() ? 0 : fate.size();
    const std::size_t object = objects.empty() ? of_unnamed : objects[k];
    if (object < fate.size()) return fate[object];
    return selection.only.empty() ? Fate::kept : Fate::gone;
  };
  Polygons kept;
  std::vector<std::uint32_t> object_of_kept;
  for (std::size_t k = 0; k < model.polygons.segments.size(); ++k) {
    if (fate_of(model.segment_object, k) == Fate::gone) continue;
    kept.segments.push_back(model.polygons.segments[k]);
    if (!model.segment_object.empty()) object_of_kept.push_back(model.segment_object[k]);
  }
  model.segment_object = std::move(object_of_kept);
  kept.is_ghost.assign(model.polygons.size(), 0);
  for (std::size_t f = 0; f < model.polygons.size(); ++f) {
    const auto corners = model.polygons[f];
    const Fate of_face = fate_of(model.face_object, f);
    if (of_face != Fate::gone) kept.corners.insert(kept.corners.end(), corners.begin(), corners.end());
    kept.first.push_back(static_cast<std::uint32_t>(kept.corners.size()));
    kept.is_ghost[f] = of_face == Fate::ghost ? 1 : 0;
  }
  model.polygons = std::move(kept);
}

}  // namespace hsr::internal
