#pragma once

#include <pybind11/pybind11.h>

namespace hsr::python {

namespace py = pybind11;

/// visible_fragments() with its arrays, and checks of it against the nearest face at samples.
void add_surfaces(py::module_& module);

}  // namespace hsr::python
