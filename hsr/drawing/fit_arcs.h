#pragma once

#include <array>
#include <vector>

#include "geometry/ragged.h"
#include "hsr/drawing/drawing.h"
#include "hsr/drawing/marked_circles.h"
#include "hsr/drawing/projection.h"

namespace hsr::internal {

/// The edges of the mesh that each line of a drawing shows, be it the part of one or several in a row. The line from a point to the
/// next of its polyline has the point's number.
struct EdgesOfLines {
  Ragged<std::array<VertexId, 2>> rows;
  std::vector<std::uint32_t> row_of_line;

  /// The line whose edges were added last is complete.
  void end_line() {
    row_of_line.push_back(static_cast<std::uint32_t>(rows.size()));
    rows.end_row();
  }
};

/// Finds arcs: runs of lines of one polyline whose edges follow one another on one circle in space, of any number on a circle that is
/// known, of four lines or more on others.
///
///   (1) each vertex and the middle of each edge of a run are within `tolerance` of the circle, in space, at the scale that the view
///       has there; each edge turns by at most 35 degrees, all the same way; where the circle is not known, a straight line would not be
///       as near
///   (2) no point of the run on paper is farther from the arc than the tolerance, and the arc begins and ends at points of the
///       polyline; a line at its end that shows a part of an edge only stays straight where that is off the circle
///   (3) runs on circles that are known come first, then those whose vertices are within a hundredth of the tolerance of a circle: they
///       are circles by design; each as long as it can be
///   (4) a circle that is seen edge-on, or reaches behind the eye, is left as it is
///
/// A closed polyline in the middle of one of whose arcs it begins is begun elsewhere, unless it keeps its start.
/// What is an arc is a choice of what is drawn, made in doubles. Cost: O(n log n).
/// @param tolerance mm on paper
void fit_arcs(Drawing& drawing, const Projection& projection, const MarkedCircles& known, EdgesOfLines& edges, double tolerance,
              bool keeps_starts);

}  // namespace hsr::internal
