#pragma once

#include <span>
#include <string>
#include <vector>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// What a drawing has in one style: its lines of one visibility and one class, or a layer that it names.
struct Layer {
  bool hidden = false;
  EdgeClass edge_class = EdgeClass::outline;
  Pen pen = {};
  std::span<const Polyline> polylines = {};
  std::string given_name = {};  ///< by the drawing; empty: after visibility and class

  /// "visible outline", with another character between the words where a format wants one.
  std::string name(char between = ' ') const;
};

/// The layers that occur, in the order in which they are drawn: hidden ones first, then by class. Every writer walks over these
/// and decides nothing itself; fills lie under all of them.
std::vector<Layer> layers_of(const Drawing& drawing);

/// The see-through fills of one layer and one opacity from this one on: they are painted opaque as one sheet, and then the sheet is
/// laid over what is there, so that no seam shows between them. Otherwise just this one.
inline std::span<const Fill> sheet_at(const Fills& fills, std::size_t first) {
  const Fill& f = fills.fills[first];
  std::size_t end = first + 1;
  while (f.opacity < 1 && end < fills.fills.size() && fills.fills[end].layer == f.layer &&
         fills.fills[end].opacity == f.opacity)
    ++end;
  return std::span(fills.fills).subspan(first, end - first);
}

/// Walks over fills and the lines between them as they are painted: fill(fill, opacity) and line(line). A sheet of several fills is
/// told by begin_sheet(fills) and end_sheet() around them, and they are opaque.
template <class BeginSheet, class OnFill, class EndSheet, class OnLine>
void for_each_painted(const Fills& fills, const BeginSheet& begin_sheet, const OnFill& on_fill, const EndSheet& end_sheet,
                      const OnLine& on_line) {
  auto line = fills.lines.begin();
  for (; line != fills.lines.end() && line->fills_before == 0; ++line) on_line(*line);
  for (std::size_t i = 0; i < fills.fills.size();) {
    const std::span<const Fill> sheet = sheet_at(fills, i);
    if (sheet.size() == 1) {
      on_fill(sheet[0], sheet[0].opacity);
    } else {
      begin_sheet(sheet);
      for (const Fill& fill : sheet) on_fill(fill, 1.0);
      end_sheet();
    }
    i += sheet.size();
    for (; line != fills.lines.end() && line->fills_before <= i; ++line) on_line(*line);
  }
}

/// Comments that name the objects of a layer's lines, for formats that have no groups: "% object: gear" before those of one, and
/// "% of several objects" before those that are of none alone.
class ObjectComments {
 public:
  explicit ObjectComments(const std::vector<std::string>& names) : names_(names) {}
  void append(std::string& out, std::uint32_t object);

 private:
  const std::vector<std::string>& names_;
  std::uint32_t object_ = SceneObjects::none;
};

}  // namespace hsr::internal
