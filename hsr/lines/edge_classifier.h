#pragma once

#include <optional>
#include <span>

#include "geometry/predicates.h"
#include "hsr/face_labels.h"
#include "hsr/lines/crease.h"
#include "hsr/lines/half_planes.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/touching_bodies.h"
#include "hsr/scene/edge_mark_table.h"
#include "hsr/scene/projected_mesh.h"
#include "hsr/scene/scene.h"

namespace hsr::internal {

/// The class of a part of an edge. Nothing: it is never drawn, as a diagonal, or an edge within one surface, that is no outline.
struct PartClass {
  std::optional<EdgeClass> seen;
  /// What touches the seen surface there from behind, if that makes an edge: intersection or sharp. It is hidden.
  std::optional<EdgeClass> behind = {};
  /// Whether it would be sharp if it led to something sharp: it is over the second crease and not over the first.
  bool may_go_on = false;
  /// The class where it is hidden, if that is another: without the half-planes in which bodies touch.
  std::optional<EdgeClass> hidden = {};
  /// What is behind where the part is visible, if that is another: nothing is seen inside bodies, so in the half-planes that are the
  /// nearest on their side none touch there.
  std::optional<EdgeClass> behind_seen = {};
  /// Not 0: equally many faces coincide all around, and bodies touch there if the entry of this number of a log, from 1, says so.
  std::uint32_t alike = 0;
  /// Undecided: the class if it is in doubt whether bodies touch there.
  std::optional<EdgeClass> in_doubt = {};

  bool is_undecided() const { return alike != 0; }
  bool depends_on_more() const { return behind || hidden || behind_seen || alike != 0; }

  friend bool operator==(const PartClass&, const PartClass&) = default;
};

/// The same where the edge is a wire, too, if it is one: a wire where faces make it no more than smooth or joint.
PartClass with_wire(const Edge& edge, PartClass found);

/// Finds the classes of edges in a view from the faces there as a set of points: whose edges the faces have there, and how they
/// are cut into faces, means nothing (docs/conventions.md, "Classes of edges").
///
/// Exact: yes, but for the angle. Cost: O(m^2) signs of degree 3 for m faces at the part, nearly always m = 2.
class EdgeClassifier {
 public:
  /// @param labels of the faces of the mesh @param marks of its edges
  EdgeClassifier(const ProjectedMesh& projected, const FaceLabels& labels, const EdgeMarkTable& marks,
                 const LineOptions& options)
      : projected_(projected),
        labels_(labels),
        marks_(marks),
        crease_(options.crease, options.crease_goes_on.value_or(options.crease)) {}

  const ProjectedMesh& projected() const { return projected_; }
  const EdgeMarkTable& marks() const { return marks_; }
  /// The class of an edge, or of the part of it where it has these contacts.
  /// @param log takes what coincides there; nullptr: hidden parts are not wanted
  PartClass operator()(Predicates& exact, EdgeId edge, std::span<const EdgeContact> contacts = {},
                       std::vector<CoincidentFaces>* log = nullptr) const;
  /// The marks of an edge and of those along which it has these contacts.
  void add_marks(HalfPlanes& half_planes, EdgeId edge, std::span<const EdgeContact> contacts) const;
  /// The class of a part along which these half-planes are. @param only_diagonal of a face that is cut into triangles
  PartClass operator()(HalfPlanes& half_planes, bool only_diagonal, std::vector<CoincidentFaces>* log) const;

 private:
  struct Around;
  enum class Contacts : std::uint8_t { count, only_on_top, left_out };
  PartClass class_of(const HalfPlanes& half_planes, bool only_diagonal, Contacts contacts, std::size_t surface = 1) const;
  std::optional<PartClass> at_a_glance(EdgeId id) const;
  std::optional<EdgeClass> more_than_flat(const HalfPlanes& half_planes, const Around& around) const;
  std::optional<EdgeMark> mark_between(std::span<const FaceId> left, std::span<const FaceId> right,
                                       std::span<const MarkOfObject> marks) const;
  std::optional<EdgeMark> mark_of(const HalfPlanes& half_planes, const Around& around) const;
  bool is_inner_edge_on(const HalfPlanes& half_planes) const;
  EdgeClass flat(FaceId left, FaceId right) const;

  const ProjectedMesh& projected_;
  const FaceLabels& labels_;
  const EdgeMarkTable& marks_;
  Crease crease_;
};

}  // namespace hsr::internal
