#pragma once

#include <optional>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"
#include "hsr/view/view.h"
#include "tests/oracle/visible_lines_oracle.h"

namespace hsr::oracle {

struct ClassVerdict {
  EdgeClass edge_class = EdgeClass::smooth;
  /// The angle is so near to the crease, or a face so thin, that doubles may call the edge sharp, or else what it is flat.
  bool is_near_crease = false;
  EdgeClass flat = EdgeClass::smooth;  ///< what it is else

  friend bool operator==(const ClassVerdict& x, const ClassVerdict& y) { return x.edge_class == y.edge_class; }
};

/// A part of an edge of one class; no verdict: it is not listed (a diagonal that is no outline).
struct ClassPart {
  Interval part;
  std::optional<ClassVerdict> verdict;
  std::optional<ClassVerdict> behind = {};       ///< of what touches the seen surface from behind
  std::optional<ClassVerdict> hidden = {};       ///< of what is hidden of the part, if that is another
  std::optional<ClassVerdict> behind_seen = {};  ///< of what is behind what is visible of the part
};

/// The classes along each edge by the definition, in rationals, from all triangles that contain a part of it, whoever's edge it is.
/// @param beyond by edge the part beyond the near plane; nothing: seen as a point, or not there. Then its own triangles alone count.
std::vector<std::vector<ClassPart>> class_parts(const Mesh& mesh, const View& view, const FaceLabels& labels, Coplanar coplanar,
                                                double crease, const std::vector<std::optional<Interval>>& beyond);

/// Whether the side of triangle t from corner k to the next is a diagonal within a planar face.
bool is_within_face(const Mesh& mesh, TriangleId t, std::size_t k);

}  // namespace hsr::oracle
