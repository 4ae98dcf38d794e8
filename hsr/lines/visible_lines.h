#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/predicates.h"
#include "hsr/face_labels.h"
#include "hsr/lines/line_options.h"
#include "hsr/symbols/cut.h"
#include "hsr/view/view.h"

namespace hsr {

/// A face whose shadow covers the edge from one cut to another.
struct Occluder {
  FaceId face;
  Cut from, to;
};

/// An edge, or the part of one that has one class, or the segment where two faces pierce each other. The intervals
/// [cuts[k], cuts[k + 1]] tile it beyond the near plane and are hidden and visible in turn.
struct Line {
  EdgeId edge;                     ///< not valid: an intersection
  std::uint32_t intersection = 0;  ///< which one, where there is no edge
  EdgeClass edge_class = EdgeClass::smooth;
  /// The part stands a second time, for what touches the seen surface there from behind: hidden all along.
  bool is_behind = false;
  bool starts_hidden = false;
  bool is_ghost = false;                     ///< of a face that hides nothing; the edge may be one of other faces, too
  std::uint32_t first_cut = 0, end_cut = 0;  ///< none: seen as a point, or nothing of it is beyond the near plane
  std::uint32_t first_occluder = 0, end_occluder = 0;  ///< only with LineOptions::why

  bool is_intersection() const { return !edge.is_valid(); }
  bool hidden(std::uint32_t k) const { return ((k & 1U) != 0) != starts_hidden; }
  std::uint32_t intervals() const { return end_cut > first_cut ? end_cut - first_cut - 1 : 0; }
};

struct VisibleLines {
  /// Ascending by edge, hence by (a, b), and along it; then those of ghosts, by edge; then the intersections.
  std::vector<Line> lines;
  std::vector<Intersection> intersections;  ///< ascending by (s, t)
  std::vector<Cut> cuts;
  std::vector<Occluder> occluders;
  std::uint64_t pairs = 0;  ///< edge-triangle pairs that were tested
  DecisionCounts decisions;
  LinePlan plan;

  std::span<const Cut> cuts_of(const Line& line) const { return {cuts.data() + line.first_cut, cuts.data() + line.end_cut}; }
  std::span<const Occluder> occluders_of(const Line& line) const {
    return {occluders.data() + line.first_occluder, occluders.data() + line.end_occluder};
  }
};

/// The visible and the hidden parts of each edge of the classes asked for, and of each line where two faces pierce each other,
/// by the method that the scene calls for.
///
///   (1) the intervals of one edge tile it beyond the near plane, and none is empty; where an edge lies in other faces its
///       class may change along it, and each part of one class is a line
///   (2) removing a face never removes a visible point
///   (3) the result does not depend on the order of the faces, on the number of threads, nor on the method or the stages
///
/// @throws PreconditionError if appel is asked for with `options.why`, CancelledError if asked to stop by `options.stop`, InputError
/// beyond 2^32 - 1 interval ends, or with `options.why` in a view with a section
/// Exact: yes. Degenerate: docs/conventions.md. Cost: O(n log n + k log k) for k pairs that overlap in the image, parallel: of an
/// edge and a face (Roberts 1963), or, where it pays, of an edge and an occluding edge (Appel 1967).
VisibleLines visible_lines(const SceneView& scene, const LineOptions& options = {});
/// Of a scene that nothing else looks at.
inline VisibleLines visible_lines(const Mesh& mesh, const View& view, const LineOptions& options = {}) {
  return visible_lines(SceneView(mesh, view), options);
}

/// Those of the lines that are of one of these classes, by EdgeClass, and no diagonals that only LineOptions::diagonals brought.
/// Of a scene with surfaces or marks these tell no smooth edges from those within one surface, and with shapes no intersections from
/// those within one shape: there only without these classes.
VisibleLines lines_of_classes(const Mesh& mesh, const VisibleLines& lines, const EdgeClasses& classes);

/// The faces at a line, ascending, each once: those of its edge, or of an intersection those that meet. Of an edge that faces and
/// ghosts have, the one line has the faces, the other the ghosts.
std::vector<FaceId> faces_at(const Mesh& mesh, const VisibleLines& lines, const Line& line);

/// The object that a line is of: a wire's own, and else the one that all faces at the line are of; none: they are of several. A wire
/// that runs along an edge of faces is a wire only where they make nothing more of it.
/// @param faces faces_at() the line
std::uint32_t object_of(const SceneObjects& objects, const Line& line, std::span<const FaceId> faces);

/// What a line runs along: from the vertex a to b, or, where they are not valid, along an intersection.
struct SupportingLine {
  VertexId a, b;
  Intersection meet;

  bool is_edge() const { return a.is_valid(); }
};
SupportingLine supporting_line_of(const Mesh& mesh, const VisibleLines& lines, const Line& line);

/// The parameter t of a cut, exactly: 0 at the first end of the carrier, 1 at the second.
/// @throws PreconditionError if what cuts is parallel to the carrier
Rational exact_parameter(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut);

/// The planes of the two faces of an intersection. @pre the carrier is one
std::array<Plane, 2> planes_of(const Mesh& mesh, const View& view, const SupportingLine& support);

/// The point of a cut, exactly.
/// @throws PreconditionError as exact_parameter() does
std::array<Rational, 3> exact_point(const Mesh& mesh, const View& view, const SupportingLine& support, const Cut& cut);
/// Of the cut number k of a line of the scene: interval k runs from here to the cut k + 1.
/// @throws PreconditionError if the line has no such cut
std::array<Rational, 3> exact_point(const SceneView& scene, const VisibleLines& lines, const Line& line, std::uint32_t k);

}  // namespace hsr
