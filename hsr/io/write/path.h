#pragma once

#include <span>
#include <string>
#include <vector>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// A straight line or an arc on the page.
struct PathPart {
  PaperPoint from, to;
  bool is_arc = false;
  EllipseArc arc = {};  ///< runs from `from` to `to`, to the rounding

  double length() const;  ///< mm
  /// What of it lies between two lengths along it, both within it. Its ends are kept where they are.
  PathPart between(double begin, double end) const;
  Point2 leaving() const;   ///< the direction in which it begins, in thousandths of a millimetre where it is straight
  Point2 arriving() const;  ///< and in which it ends
};

/// Parts end to end: what a polyline with its arcs is to writers.
struct Path {
  std::vector<PathPart> parts;
  bool closed = false;  ///< the last part ends where the first one begins
};

Path path_of(const Drawing& drawing, const Polyline& p);
/// Of straight lines only.
Path path_of(std::span<const PaperPoint> points, bool closed);

/// Parts of an arc that are equally large: at most so many radians each.
std::vector<PathPart> at_most(const PathPart& arc, double radians);

/// A cubic Bezier curve from where the one before ended.
struct Bezier {
  Point2 first, second;  ///< mm
  PaperPoint to;
};
/// An arc as these, within a hundredth of the tolerance that it was fitted with, or 0.0001 mm if that is more.
std::vector<Bezier> beziers(const PathPart& arc, double tolerance);

/// The points of a path, arcs as chords that are within `error` mm of them; of a closed path without the first one again.
std::vector<PaperPoint> flattened(const Path& path, double error);

/// Walks over a path: move(from), line(to) and arc(part). A straight line that closes a path is left out.
template <class Move, class Line, class Arc>
void for_each_part(const Path& path, const Move& move, const Line& line, const Arc& arc) {
  if (path.parts.empty()) return;
  move(path.parts.front().from);
  for (const PathPart& part : path.parts)
    if (part.is_arc)
      arc(part);
    else if (!path.closed || &part != &path.parts.back())
      line(part.to);
}

}  // namespace hsr::internal
