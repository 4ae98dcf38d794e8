#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/number.h"
#include "geometry/predicates.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/plan.h"
#include "hsr/view.h"

namespace hsr {

/// The class of an edge in a view (docs/conventions.md, "Classes of edges"). Does not depend on visibility.
enum class EdgeClass : std::uint8_t { outline, sharp, boundary, intersection, wire, smooth };

/// A place on an edge, kept as the symbol of what cuts the edge there: never as a rounded number.
struct Cut {
  enum class Kind : std::uint8_t {
    start,            ///< the first vertex, t = 0
    end,              ///< the second vertex, t = 1
    sight,            ///< the view plane of the vertices u and v
    face,             ///< the plane of triangle u
    near,             ///< the near plane
    near_line,        ///< where triangle u is cut by the near plane, as seen from the eye
    line,             ///< within an edge-on plane: the line of the vertices u and v; drop coordinate `axis`
    sight_of_vertex,  ///< within an edge-on plane: the line of sight of vertex u; drop `axis`
    near_line_end,    ///< within an edge-on plane: where the line of u and v is cut by the near plane; drop `axis`
  };
  Kind kind = Kind::start;
  std::uint8_t axis = 0;
  std::uint32_t u = 0, v = 0;

  friend bool operator==(const Cut&, const Cut&) = default;
};

/// A face whose shadow covers the edge from one cut to another.
struct Occluder {
  FaceId face;
  Cut from, to;
};

/// One edge as seen: the intervals [cuts[k], cuts[k + 1]] tile the edge beyond the near plane, hidden and visible in turn.
struct LineOfEdge {
  EdgeId edge;
  EdgeClass edge_class = EdgeClass::smooth;
  bool starts_hidden = false;
  std::uint32_t first_cut = 0, end_cut = 0;            ///< none: seen as a point, or nothing of it is beyond the near plane
  std::uint32_t first_occluder = 0, end_occluder = 0;  ///< only with LineOptions::why

  bool hidden(std::uint32_t k) const { return ((k & 1U) != 0) != starts_hidden; }
  std::uint32_t intervals() const { return end_cut > first_cut ? end_cut - first_cut - 1 : 0; }
};

struct VisibleLines {
  std::vector<LineOfEdge> lines;  ///< ascending by edge, hence by (a, b)
  std::vector<Cut> cuts;
  std::vector<Occluder> occluders;
  std::uint64_t pairs = 0;  ///< edge-triangle pairs that were tested
  DecisionCounts decisions;
  LinePlan plan;

  std::span<const Cut> cuts_of(const LineOfEdge& line) const {
    return {cuts.data() + line.first_cut, cuts.data() + line.end_cut};
  }
  std::span<const Occluder> occluders_of(const LineOfEdge& line) const {
    return {occluders.data() + line.first_occluder, occluders.data() + line.end_occluder};
  }
};

/// The visible and the hidden parts of each edge of the classes asked for, by the method that the scene calls for.
///
///   (1) the intervals of one edge tile it beyond the near plane, and none is empty
///   (2) removing a face never removes a visible point
///   (3) the result does not depend on the order of the faces, on the number of threads, nor on the method or the stages
///
/// Exact: yes. Degenerate: docs/conventions.md. Cost: see roberts.h and appel.h.
VisibleLines visible_lines(const Mesh& mesh, const View& view, const LineOptions& options = {});

/// The plane that makes a cut. @pre neither start nor end
Plane plane_of(const Mesh& mesh, const View& view, const Cut& cut);

/// The parameter t of a cut, exactly: 0 at edge.a, 1 at edge.b.
Rational parameter(const Mesh& mesh, const View& view, const Edge& edge, const Cut& cut);

}  // namespace hsr
