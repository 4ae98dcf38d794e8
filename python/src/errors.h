#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace hsr::python {

namespace py = pybind11;

/// Options of the command are arguments here: "--min-length: found ..." is "min_length: found ...".
std::string without_dashes(const std::string& message);

/// What hsr throws, as exceptions of Python with the same line: InputError and PreconditionError are ValueErrors, MemoryLimit is a
/// MemoryError, InvariantError a RuntimeError.
void add_errors(py::module_& module);

}  // namespace hsr::python
