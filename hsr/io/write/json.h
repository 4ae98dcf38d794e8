#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "hsr/face_labels.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/surfaces/section.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr {

/// How numbers are written as JSON: the shortest text that reads back as the same double, or exactly as a string "p/q".
enum class Numbers { rounded, exact };

/// As JSON and the command name it: "outline".
const char* name_of(EdgeClass edge_class);

struct JsonOptions {
  Numbers numbers = Numbers::rounded;
  const VisibleFragments* fragments = nullptr;  ///< written beside the lines
  bool why = false;                             ///< with "by", the faces that hide: only if the lines have their occluders
  /// Names of objects at the top, and at each line and fragment that is of one of them its number among these; nullptr, or fewer
  /// than two: none of this is written.
  const SceneObjects* objects = nullptr;
  const Section* section = nullptr;  ///< the caps are written beside the lines
  /// What points and faces are called, where the mesh is of a part of a model; empty: as they are numbered.
  std::span<const std::uint32_t> point_numbers = {}, face_numbers = {};
};

/// Visible lines as JSON, "hsr-lines/1" (docs/conventions.md, "JSON").
///
///   (1) one object for each line, in the order of `lines`
///   (2) t is the correctly rounded double of the exact parameter, or with Numbers::exact the parameter itself, "p/q"
///   (3) the ends of the intervals in space and in the view's frame, y up, correctly rounded, or with Numbers::exact as they are
///   (4) the same text for any number of threads
///
/// @throws PreconditionError if the origin of the view's frame is not in front of the eye
std::string lines_json(const Mesh& mesh, const View& view, const VisibleLines& lines, const JsonOptions& options = {});

/// The view as it stands in every JSON file.
std::string view_json(const View& view, Numbers numbers = Numbers::rounded);

/// A painting order as JSON, "hsr-order/1" (docs/conventions.md, "JSON"). A coordinate that is no double is written "p/q" with
/// either kind of numbers, so that the order survives the file; Numbers::exact writes all of them so.
/// @param coplanar which of coincident faces the order paints last; the file says so unless it is the first
/// @param section its caps, which lie on all pieces, are written beside them; null: none are
std::string order_json(const Mesh& mesh, const View& view, const PaintersOrder& order, Numbers numbers = Numbers::rounded,
                       Coplanar coplanar = Coplanar::first, const Section* section = nullptr);

}  // namespace hsr
