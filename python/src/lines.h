#pragma once

#include <pybind11/pybind11.h>

namespace hsr::python {

namespace py = pybind11;

/// visible_lines() with its arrays, and questions to it.
void add_lines(py::module_& module);

/// hidden_points().
void add_hidden_points(py::module_& module);

}  // namespace hsr::python
