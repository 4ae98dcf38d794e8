#pragma once

#include <span>
#include <string>

#include "hsr/io/write/path.h"

namespace hsr::internal {

/// Lines in the operators of PDF, as painted_paths.h has them: the pen that they are drawn with, and one of them. Dashes are lines of
/// their own: no limit of a reader to the number of their lengths holds.
void append_pen(std::string& out, const Pen& pen);
void append_path(std::string& out, std::span<const PaperPoint> points);  ///< moves to the first, and leads to the others
void append_path(std::string& out, const Path& path, double tolerance);  ///< likewise, arcs as curves; see beziers()
void append_line(std::string& out, const Drawing& drawing, const Polyline& line, const Pen& pen);

}  // namespace hsr::internal
