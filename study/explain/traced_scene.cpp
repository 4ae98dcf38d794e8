#include "study/explain/traced_scene.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

constexpr std::size_t most_faces = 200;

/// Told apart on light and on dark paper; black or white letters on each have a contrast of 4.5 and more.
constexpr std::array<Colour, 10> colours = {{{86, 140, 214, 255},
                                             {224, 133, 74, 255},
                                             {92, 176, 120, 255},
                                             {196, 110, 190, 255},
                                             {214, 180, 70, 255},
                                             {84, 178, 186, 255},
                                             {222, 110, 118, 255},
                                             {150, 140, 220, 255},
                                             {158, 172, 84, 255},
                                             {176, 146, 120, 255}}};

/// As large as the scene asks for, with a margin around it.
SampleGrid grid_of(const ExplainedScene& scene, int size) {
  PaperRectangle part = paper_rectangle(scene.mesh, scene.view);
  const double width = part.right - part.left, height = part.top - part.bottom;
  const double margin = std::max(width, height) * (size > 0 ? 0.02 : 0.06);
  part = {part.left - margin, part.right + margin, part.bottom - margin, part.top + margin};
  if (size > 0) return sample_grid(scene.view, part, size, size);
  constexpr int wide = 160;
  const double ratio = (height + 2 * margin) / std::max(width + 2 * margin, 1e-300);
  return sample_grid(scene.view, part, wide, static_cast<int>(std::clamp(wide * ratio, 70.0, 200.0)));
}

}  // namespace

void check_explainable(const ExplainedScene& scene) {
  const std::size_t faces = scene.mesh.faces.size();
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throw InputError("explain: found " + found + ", expected " + expected);
  };
  if (faces > most_faces)
    refuse(std::to_string(faces) + " faces",
           "at most " + std::to_string(most_faces) + ": the steps of more cannot be followed one by one");
  if (scene.mesh.triangles.empty()) refuse("no face with an area", "a scene with faces");
  if (scene.view.has_section() || scene.view.has_cells()) refuse("a section", "a view without one");
  if (!scene.view.is_perspective()) return;
  for (const auto& corners : scene.mesh.triangles)
    for (const VertexId v : corners)
      if (is_before_near(scene.view, scene.mesh.points[v]))
        refuse("a corner before the near plane", "all of the scene in front of the eye: --eye farther away");
}

ScenePicture::ScenePicture(const ExplainedScene& scene, int size) : ScenePicture(scene, grid_of(scene, size)) {
  has_samples_ = size > 0;
}

ScenePicture::ScenePicture(const ExplainedScene& scene, const SampleGrid& samples)
    : scene_(scene), samples_(samples), project_(scene.view, samples_), has_samples_(true) {
  const Point3 &e = scene.view.viewpoint.at, &t = scene.view.target;
  away_ = scene.view.is_perspective() ? Point3{t.x - e.x, t.y - e.y, t.z - e.z} : Point3{-e.x, -e.y, -e.z};
  const double length = std::hypot(away_.x, away_.y, away_.z);
  away_ = {away_.x / length, away_.y / length, away_.z / length};
  if (scene.view.is_perspective()) {
    nearest_ = e.x * away_.x + e.y * away_.y + e.z * away_.z;
    return;
  }
  nearest_ = HUGE_VAL;
  for (const auto& corners : scene.mesh.triangles)
    for (const VertexId v : corners) {
      const Point3& p = scene.mesh.points[v];
      nearest_ = std::min(nearest_, p.x * away_.x + p.y * away_.y + p.z * away_.z);
    }
}

double ScenePicture::depth(const Point3& p) const { return p.x * away_.x + p.y * away_.y + p.z * away_.z - nearest_; }

TracePlace ScenePicture::at(const Point3& p) const {
  const Seen<double> seen = project_(p);
  return {seen.x + 0.5, seen.y + 0.5};
}

TracePlace ScenePicture::at(const std::array<Rational, 3>& p) const {
  return at(Point3{p[0].to_double(), p[1].to_double(), p[2].to_double()});
}

TraceRing ScenePicture::ring(FacetId facet, std::span<const PieceCorner> corners) const {
  TraceRing ring;
  for (const PieceCorner& c : corners) ring.push_back(at(exact_point(scene_.mesh, scene_.view, facet, c)));
  return ring;
}

std::string ScenePicture::name(std::uint32_t face) const {
  if (scene_.mesh.faces.size() > 26) return std::to_string(face);
  return {static_cast<char>('A' + face)};
}

TracedScene ScenePicture::traced(bool with_edges) const {
  TracedScene traced{static_cast<double>(samples_.width), static_cast<double>(samples_.height), has_samples_, {}, {}};
  const Model& model = scene_.model;
  for (std::uint32_t f = 0; f < scene_.mesh.faces.size(); ++f) {
    TracedFace face{name(f), colours[f % colours.size()], {}};
    if (!model.face_colour.empty() && model.face_colour[f] != 0xffffffffU) face.colour = model.palette[model.face_colour[f]];
    if (scene_.mesh.faces[FaceId(f)] != FaceUse::no_area) {
      TraceRing ring;
      for (const std::uint32_t v : model.polygons[f]) ring.push_back(at(model.points[v]));
      face.rings.push_back(std::move(ring));
    }
    traced.faces.push_back(std::move(face));
  }
  if (!with_edges) return traced;
  for (const Edge& e : scene_.mesh.edges)
    traced.edges.push_back({at(scene_.mesh.points[e.a]), at(scene_.mesh.points[e.b]),
                            std::to_string(e.a.value) + "–" + std::to_string(e.b.value)});
  return traced;
}

}  // namespace hsr::internal
