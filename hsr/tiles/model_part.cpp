#include "hsr/tiles/model_part.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

void sort_unique(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

void copy_names(const Model& from, Model& to) {
  to.name = from.name;
  to.format = from.format;
  to.palette = from.palette;
  to.objects = from.objects;
  to.materials = from.materials;
  to.unit = from.unit;
  to.up_axis = from.up_axis;
}

void copy_labels(const Model& from, std::span<const std::uint32_t> faces, std::span<const std::uint32_t> segments, Model& to) {
  const auto copy = [](const auto& all, std::span<const std::uint32_t> chosen, auto& some) {
    if (!all.empty())
      for (const std::uint32_t i : chosen) some.push_back(all[i]);
  };
  copy(from.face_colour, faces, to.face_colour);
  copy(from.face_object, faces, to.face_object);
  copy(from.face_material, faces, to.face_material);
  copy(from.polygons.is_ghost, faces, to.polygons.is_ghost);
  copy(from.segment_object, segments, to.segment_object);
}

/// The order of all entries by number, and where each number that is new begins.
std::vector<std::array<std::uint32_t, 2>> by_number(const std::vector<ModelPart>& parts,
                                                    std::vector<std::uint32_t> ModelPart::*of) {
  std::vector<std::array<std::uint32_t, 2>> all;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    for (std::uint32_t i = 0; i < (parts[p].*of).size(); ++i) all.push_back({p, i});
  std::stable_sort(all.begin(), all.end(),
                   [&](const auto& x, const auto& y) { return (parts[x[0]].*of)[x[1]] < (parts[y[0]].*of)[y[1]]; });
  return all;
}

}  // namespace

ModelPart part_of(const Model& whole, std::span<const std::uint32_t> stands_for, const PartChoice& choice) {
  const auto point = [&](std::uint32_t p) { return stands_for.empty() ? p : stands_for[p]; };
  ModelPart part;
  copy_names(whole, part.model);
  part.faces.assign(choice.faces.begin(), choice.faces.end());
  part.segments.assign(choice.segments.begin(), choice.segments.end());
  copy_labels(whole, choice.faces, choice.segments, part.model);
  for (const std::uint32_t f : choice.faces)
    for (const std::uint32_t c : whole.polygons[f]) part.points.push_back(point(c));
  for (const std::uint32_t s : choice.segments)
    for (const std::uint32_t c : whole.polygons.segments[s]) part.points.push_back(point(c));
  for (const std::uint32_t p : choice.more_points) part.points.push_back(point(p));
  sort_unique(part.points);
  part.points.shrink_to_fit();
  const auto place = [&](std::uint32_t p) {
    return static_cast<std::uint32_t>(std::lower_bound(part.points.begin(), part.points.end(), point(p)) - part.points.begin());
  };
  for (const std::uint32_t p : part.points) part.model.points.push_back(whole.points[p]);
  Polygons& polygons = part.model.polygons;
  for (const std::uint32_t f : choice.faces) {
    for (const std::uint32_t c : whole.polygons[f]) polygons.corners.push_back(place(c));
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  for (const std::uint32_t s : choice.segments) {
    const auto [a, b] = whole.polygons.segments[s];
    polygons.segments.push_back({place(a), place(b)});
  }
  return part;
}

ModelPart part_of(const ModelPart& part, const PartChoice& choice) {
  ModelPart some = part_of(part.model, {}, choice);
  const auto name = [](std::vector<std::uint32_t>& numbers, const std::vector<std::uint32_t>& of_whole) {
    for (std::uint32_t& n : numbers) n = of_whole[n];
  };
  name(some.points, part.points);
  name(some.faces, part.faces);
  name(some.segments, part.segments);
  return some;
}

ModelPart united(std::vector<ModelPart> parts) {
  ModelPart all;
  if (parts.empty()) return all;
  copy_names(parts.front().model, all.model);
  for (const auto& [p, i] : by_number(parts, &ModelPart::points)) {
    const std::uint32_t number = parts[p].points[i];
    const Point3& at = parts[p].model.points[i];
    if (!all.points.empty() && all.points.back() == number) {
      if (!(all.model.points.back() == at))
        throw InputError("point " + std::to_string(number) + ": found in two places, expected parts of one model");
      continue;
    }
    all.points.push_back(number);
    all.model.points.push_back(at);
  }
  const auto place = [&](const ModelPart& part, std::uint32_t p) {
    return static_cast<std::uint32_t>(std::lower_bound(all.points.begin(), all.points.end(), part.points[p]) -
                                      all.points.begin());
  };
  Polygons& polygons = all.model.polygons;
  std::vector<std::uint32_t> corners;
  for (const auto& [p, i] : by_number(parts, &ModelPart::faces)) {
    const ModelPart& part = parts[p];
    corners.clear();
    for (const std::uint32_t c : part.model.polygons[i]) corners.push_back(place(part, c));
    if (!all.faces.empty() && all.faces.back() == part.faces[i]) {
      if (!std::ranges::equal(polygons[polygons.size() - 1], corners))
        throw InputError("face " + std::to_string(part.faces[i]) + ": found with other corners, expected parts of one model");
      continue;
    }
    all.faces.push_back(part.faces[i]);
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
    const std::uint32_t one[] = {i};
    copy_labels(part.model, one, {}, all.model);
  }
  for (const auto& [p, i] : by_number(parts, &ModelPart::segments)) {
    const ModelPart& part = parts[p];
    if (!all.segments.empty() && all.segments.back() == part.segments[i]) continue;
    all.segments.push_back(part.segments[i]);
    const auto [a, b] = part.model.polygons.segments[i];
    polygons.segments.push_back({place(part, a), place(part, b)});
    const std::uint32_t one[] = {i};
    copy_labels(part.model, {}, one, all.model);
  }
  return all;
}

}  // namespace hsr::internal
