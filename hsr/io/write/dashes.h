#pragma once

#include <span>
#include <vector>

#include "hsr/drawing/pens.h"
#include "hsr/io/write/path.h"

namespace hsr::internal {

/// A path with the lengths of its dashes and gaps along it.
///
/// Between its ends and corners, where it turns by more than 35 degrees, a line has stretches; each begins and ends with a dash (ISO
/// 128), so that a corner has dashes on both sides. With the pen's dash d, gap g, and period p = d + g a stretch of length l has
///
///   (1) n gaps as they are, n the nearest to (l - d) / p and at least 1, and n + 1 dashes that fill the rest alike (ISO 128-21);
///       where dashes are less than half of the pattern, all of it stretches alike
///   (2) if its dashes were shorter than the gap (than d, if that is less): a dash, a gap and a dash of a third each
///   (3) if these were shorter than the line is wide: one dash
///
/// A stretch that has less than (2) asks for is not told apart from the one that follows. A closed line without corners has a whole
/// number of periods, at least two.
struct DashedPath {
  Path path;  ///< as given, but closed ones with corners begin at one
  /// mm, dash and gap in turn, from the first point on. An even number: again and again; an odd one: as long as the line.
  std::vector<double> lengths;
};

/// @param pen dashed
DashedPath dashed_path(Path path, const Pen& pen);

/// Whether each point between two others is a corner, as above.
bool has_corners_only(std::span<const PaperPoint> points, bool closed);

/// Each dash as a path, for formats that have no dashes of their own.
std::vector<Path> dashes_of(const DashedPath& dashed);

}  // namespace hsr::internal
