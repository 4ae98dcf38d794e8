#pragma once

#include <pybind11/pybind11.h>

namespace hsr::python {

namespace py = pybind11;

/// Painter's orders by depth sort and by a tree, and the verdict on an order by anyone.
void add_orders(py::module_& module);

}  // namespace hsr::python
