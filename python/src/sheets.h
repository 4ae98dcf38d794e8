#pragma once

#include <pybind11/pybind11.h>

namespace hsr::python {

namespace py = pybind11;

/// sheet(): what `hsr sheet` writes, byte by byte.
void add_sheets(py::module_& module);

}  // namespace hsr::python
