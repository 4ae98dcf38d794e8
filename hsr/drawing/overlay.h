#pragma once

#include <cstdint>
#include <vector>

#include "hsr/drawing/image_lines.h"
#include "hsr/drawing/projection.h"

namespace hsr::internal {

/// A place on an edge: a cut of VisibleLines.
struct PlaceOnEdge {
  std::uint32_t line = 0, cut = 0;
};

/// A straight line to draw.
struct Stroke {
  PlaceOnEdge from, to;
  bool hidden = false;
  EdgeClass edge_class = EdgeClass::outline;
  std::uint32_t first_source = 0, end_source = 0;  ///< the lines that are drawn by it
  std::uint32_t object = 0xffffffffU;              ///< of the line on top; SceneObjects::none: of several
};

struct Overlay {
  std::vector<Stroke> strokes;
  std::vector<std::uint32_t> sources;  ///< indices of VisibleLines::lines
  std::uint64_t visible_under_visible = 0, hidden_under_visible = 0, hidden_under_hidden = 0, merged = 0;

  void append(const Overlay& other);
};

/// Lays the parts of the edges on one line of the image over each other: visible over hidden, then class before class, then
/// lower edge before higher. Abutting parts of one style and one object become one stroke.
///
/// @param object_of_line by line; empty: objects are not told apart
/// Exact: yes. Cost: O(k log k) in parts, and for ends in mid-edge that coincide an exact rational position each.
class LineOverlay {
 public:
  LineOverlay(const Projection& projection, const VisibleLines& lines, const std::vector<std::uint32_t>& object_of_line,
              bool with_hidden, Predicates& predicates)
      : projection_(projection),
        lines_(lines),
        object_of_line_(object_of_line),
        with_hidden_(with_hidden),
        predicates_(predicates) {}

  void add_single(std::uint32_t line, Overlay& result) const;
  void add_group(std::span<const std::uint32_t> group, bool steep, Overlay& result);

 private:
  struct Position {
    PlaceOnEdge place;
    Enclosure coordinate;
    VertexId vertex;  // whose image this is, once it is known
    bool vertex_is_known = false;
    std::optional<Rational> exact;
    std::uint32_t rank = 0;
  };
  struct Part {
    std::uint32_t from, to;  // ranks
    std::uint32_t line;
    bool hidden;
    EdgeClass edge_class;
  };

  SupportingLine supporting_line_of(std::uint32_t line) const {
    return hsr::supporting_line_of(projection_.mesh(), lines_, lines_.lines[line]);
  }
  std::uint32_t object_of(std::uint32_t line) const { return object_of_line_.empty() ? 0xffffffffU : object_of_line_[line]; }
  const Cut& cut_of(const PlaceOnEdge& p) const { return lines_.cuts[p.cut]; }
  void collect(std::span<const std::uint32_t> group);
  void rank();
  void lay(Overlay& result);
  int compare(std::uint32_t i, std::uint32_t j);
  VertexId vertex_at(Position& p);
  bool at_one_place(VertexId v, VertexId w);
  const Rational& exact_coordinate(Position& p);

  const Projection& projection_;
  const VisibleLines& lines_;
  const std::vector<std::uint32_t>& object_of_line_;
  bool with_hidden_;
  Predicates& predicates_;

  // Of the group at hand.
  bool steep_ = false;
  VertexId a_, b_;  // two different vertices of its line, if it carries an edge
  int axis_ = -1;   // a coordinate axis out of its view plane
  std::vector<Position> positions_;
  std::vector<Part> parts_;  // with positions instead of ranks until `rank`
  std::vector<PlaceOnEdge> place_of_rank_;
};

}  // namespace hsr::internal
