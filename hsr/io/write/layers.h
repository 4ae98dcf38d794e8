#pragma once

#include <span>
#include <string>
#include <vector>

#include "hsr/drawing/drawing.h"

namespace hsr::internal {

/// What a drawing has in one style: its lines of one visibility and one class.
struct Layer {
  bool hidden = false;
  EdgeClass edge_class = EdgeClass::outline;
  Pen pen = {};
  std::span<const Polyline> polylines = {};

  /// "visible outline", with another character between the words where a format wants one.
  std::string name(char between = ' ') const;
};

/// The layers that occur, in the order in which they are drawn: hidden ones first, then by class. Every writer walks over these
/// and decides nothing itself; fills lie under all of them.
std::vector<Layer> layers_of(const Drawing& drawing);

/// Comments that name the objects of a layer's lines, for formats that have no groups: "% object: gear" before those of one, and
/// "% of several objects" before those that are of none alone.
class ObjectComments {
 public:
  explicit ObjectComments(const std::vector<std::string>& names) : names_(names) {}
  void append(std::string& out, std::uint32_t object);

 private:
  const std::vector<std::string>& names_;
  std::uint32_t object_ = FaceObjects::none;
};

}  // namespace hsr::internal
