#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstring>
#include <memory>
#include <vector>

namespace hsr::python {

namespace py = pybind11;

/// A vector as an array of this shape, which takes its memory over; nothing is copied.
template <class T>
py::array array_of(std::vector<T>&& values, const std::vector<py::ssize_t>& shape) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  T* const data = owned->data();
  const py::capsule owner(owned.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  owned.release();
  return py::array_t<T>(shape, data, owner);
}

/// In one dimension.
template <class T>
py::array array_of(std::vector<T>&& values) {
  const auto n = static_cast<py::ssize_t>(values.size());
  return array_of(std::move(values), {n});
}

inline py::array bool_array(const std::vector<std::uint8_t>& values) {
  py::array_t<bool> array(static_cast<py::ssize_t>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) array.mutable_data()[i] = values[i] != 0;
  return array;
}

}  // namespace hsr::python
