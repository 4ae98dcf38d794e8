#pragma once

#include <string>
#include <vector>

#include "hsr/lines/visible_lines.h"
#include "hsr/scene/scene.h"
#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

/// One listed line with its exact parameters: the form in which results are compared and printed.
struct SeenEdge {
  VertexId a, b;
  EdgeClass edge_class = EdgeClass::smooth;
  bool starts_hidden = false;
  std::vector<Q> cuts;  ///< [cuts[k], cuts[k + 1]], hidden and visible in turn; none: nothing is seen
  /// Only by the oracle: so near to the crease that doubles may decide either way.
  bool class_is_uncertain = false, may_be_absent = false;
  EdgeClass other_class = EdgeClass::smooth;
  bool is_behind = false;  ///< what touches the seen surface from behind
  /// Where faces pierce each other, instead of a and b: both facets, and the ends.
  FacetId s = {}, t = {};
  Vec from = {}, to = {};
};

const char* to_text(EdgeClass edge_class);

/// The intervals: "0 visible 1/4 hidden 1"; "nothing" for an edge that is seen as a point or not beyond the near plane.
std::string intervals_text(const SeenEdge& edge);
/// "0-3 outline: 0 visible 1/4 hidden 1"
std::string to_text(const SeenEdge& edge);
std::string to_text(const std::vector<SeenEdge>& edges);  ///< one line each

/// What the oracle says that roberts has to say.
std::vector<SeenEdge> seen_by_oracle(const SceneView& scene, const LineOptions& options);
std::vector<SeenEdge> seen_edges(const Mesh& mesh, const View& view, const VisibleLines& lines);

/// One text for each difference; none: they agree to the last bit.
std::vector<std::string> differences(const std::vector<SeenEdge>& expected, const std::vector<SeenEdge>& found);

/// Whether `lines` is what the oracle finds: the edges listed, their classes, each end of each interval, and where asked for
/// the occluders. One text for each difference.
std::vector<std::string> compare_with_oracle(const SceneView& scene, const VisibleLines& lines,
                                             const LineOptions& options = {});

}  // namespace hsr::oracle
