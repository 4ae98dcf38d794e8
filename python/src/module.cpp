#include <pybind11/pybind11.h>

#include "python/src/drawings.h"
#include "python/src/errors.h"
#include "python/src/lines.h"
#include "python/src/orders.h"
#include "python/src/scene_data.h"
#include "python/src/sheets.h"
#include "python/src/surfaces.h"

/// What hsr/__init__.py is made of. Arguments come in one dict by name, spelled and checked there.
PYBIND11_MODULE(_core, module) {
  using namespace hsr::python;
  add_errors(module);
  add_scene(module);
  add_lines(module);
  add_hidden_points(module);
  add_surfaces(module);
  add_orders(module);
  add_drawings(module);
  add_sheets(module);
  module.attr("version") = HSR_VERSION;
}
