#pragma once

#include <pybind11/pybind11.h>

namespace hsr::python {

namespace py = pybind11;

/// What hsr throws, as exceptions of Python with the same line: InputError and PreconditionError are ValueErrors, MemoryLimit is a
/// MemoryError, InvariantError a RuntimeError.
void add_errors(py::module_& module);

}  // namespace hsr::python
