#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hsr/lines/edge_classifier.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/box_tree.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/projected_mesh.h"

namespace hsr::internal {

class InsideBodies;
class NearParts;
class ViewFrustum;

/// How many edges are handled together: fixed, so that counts are the same for any number of threads.
constexpr std::size_t edges_of_block = 512;

/// An edge, or the part of it that has one class, whose visibility is wanted.
struct RequestedPart {
  EdgeId edge;
  EdgeClass edge_class = EdgeClass::smooth;
  bool is_behind = false;                     ///< what touches the seen surface there from behind
  std::optional<EdgeClass> hidden = {};       ///< the class where it is hidden, if that is another
  std::optional<EdgeClass> behind_seen = {};  ///< of what is behind it where it is visible, if that is more than elsewhere
  Cut from{Cut::Kind::start}, to{Cut::Kind::end};
};

/// The edges of the classes that are wanted, in ascending order, with their classes and boxes. An edge whose class changes
/// along it is listed once for each part, along it, and then once for each part that touches the seen surface from behind.
/// Cost: O(n), parallel.
struct ClassifiedEdges {
  std::vector<EdgeId> edges;
  std::vector<EdgeClass> classes;
  std::vector<ImageBox> boxes;
  /// Whether the class of some, or what is behind them, depends on whether it is hidden there.
  bool has_hidden_classes = false;
  /// Edges of which what is listed depended on more than the faces there, ascending.
  std::vector<EdgeId> in_doubt;
  /// By edge of the list: 1 if it is hidden all along and its image is no point. Empty if this is known of none.
  std::vector<std::uint8_t> hidden;
  DecisionCounts decisions;

  /// @param outside leaves out the edges outside of this frustum, unless it is nullptr
  /// @param occluders all triangles, or nullptr
  /// @param has_contact by edge: whether it may lie in one of these triangles or along its border; empty if none does
  /// @param with_behind whether what touches the seen surface from behind is wanted: it is hidden all along
  /// @param near finds the classes of all edges, within a tolerance; nullptr: they are exact
  /// @param inside tells where bodies touch, if what is behind is wanted
  ClassifiedEdges(const EdgeClassifier& classifier, const LineOptions& options, const ViewFrustum* outside,
                  const Occluders* occluders, const std::vector<std::uint8_t>& has_contact, bool with_behind,
                  const NearParts* near, const InsideBodies* inside);
  /// The given edges from end to end, without finding their classes.
  ClassifiedEdges(const ProjectedMesh& projected, std::vector<EdgeId> ascending);

  /// Appends the edges of ghosts, ascending, each with the class that it has among the ghosts alone. They hide nothing, so they
  /// are tested like any other edge.
  /// @param projected the mesh that they are the ghosts of
  void add_ghosts(const ProjectedMesh& projected, const EdgeClassifier& among_ghosts, const LineOptions& options,
                  const ViewFrustum* outside);
  /// Whether entry i of the list is an edge of a ghost.
  bool is_ghost(std::size_t i) const { return i >= first_ghost_; }

  /// Whether entry i of the list is only a part of its edge.
  bool is_part(std::size_t i) const;
  RequestedPart operator[](std::size_t i) const;

 private:
  struct Part {
    std::size_t index;
    RequestedPart part;
  };
  struct Finder;
  const Part* part(std::size_t i) const;
  void list_parts(const std::vector<RequestedPart>& ascending);
  void find_boxes(const ProjectedMesh& projected);

  std::size_t first_ghost_ = static_cast<std::size_t>(-1);
  std::vector<Part> parts_;  // ascending; entries of the list that are not in it stand for whole edges
};

}  // namespace hsr::internal
