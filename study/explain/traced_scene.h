#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "hsr/model.h"
#include "hsr/painter/painters_order.h"
#include "hsr/raster/sample_projection.h"
#include "hsr/raster/samples.h"
#include "study/explain/trace.h"

namespace hsr::internal {

/// A scene that is small enough to be followed step by step, and how it is looked at.
struct ExplainedScene {
  Model model;
  Mesh mesh;
  View view;
  std::string title;  ///< "house.obj, view iso"
};

/// @throws InputError for a scene that cannot be followed: more than 200 faces, none, ghosts, a section, or a corner before the near
/// plane
void check_explainable(const ExplainedScene& scene);

/// Where what is told of a scene is in the picture, and what its faces are called.
class ScenePicture {
 public:
  /// @param size samples each way for methods that work at samples; 0: a picture of lines, of no particular samples
  ScenePicture(const ExplainedScene& scene, int size);
  /// Of given samples.
  ScenePicture(const ExplainedScene& scene, const SampleGrid& samples);

  const ExplainedScene& scene() const { return scene_; }
  const SampleGrid& samples() const { return samples_; }
  /// In units of the picture: sample (i, j) is in the middle of cell (i, j).
  TracePlace at(const Point3& p) const;
  TracePlace at(const std::array<Rational, 3>& p) const;
  /// How far away, in units of the model: in a perspective from the eye's plane, else from that of the nearest corner of the scene.
  double depth(const Point3& p) const;
  TraceRing ring(FacetId facet, std::span<const PieceCorner> corners) const;
  /// "A" ... "Z" where there are no more faces than letters, else the number.
  std::string name(std::uint32_t face) const;
  std::uint32_t face_of(FacetId facet) const { return scene_.mesh.face_of[first_triangle(facet)].value; }
  TraceItem item(std::uint32_t face) const { return {name(face), static_cast<int>(face)}; }
  /// The faces, and edges if they are wanted: those of the mesh that are no diagonals, by their numbers.
  TracedScene traced(bool with_edges) const;

 private:
  const ExplainedScene& scene_;
  SampleGrid samples_;
  SampleProjection<double> project_;
  bool has_samples_;
  Point3 away_;  // of length 1
  double nearest_ = 0;
};

}  // namespace hsr::internal
