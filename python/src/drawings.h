#pragma once

#include <pybind11/pybind11.h>

namespace hsr::python {

namespace py = pybind11;

/// draw(): what `hsr draw` writes, byte by byte.
void add_drawings(py::module_& module);

}  // namespace hsr::python
