#pragma once

#include <memory>

#include "hsr/painter/painters_order.h"
#include "python/src/drawn_page.h"

namespace hsr::python {

/// A painter's order, and the scene that it is of.
struct OrderData {
  std::shared_ptr<SceneData> data;
  cli::ChosenView chosen;
  SceneView scene;
  PaintersOrder order;
  bool may_be_wrong = false;  ///< whole faces, sorted by one depth each
};

/// The order painted on a page, and written as the command `hsr order` does. @param named `view` is passed over
std::shared_ptr<DrawnPage> draw_order(const std::shared_ptr<OrderData>& data, const py::dict& named);

}  // namespace hsr::python
