#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>
#include <stop_token>

namespace hsr::python {

namespace py = pybind11;

/// How the caller looks after work that takes long.
struct Control {
  std::optional<int> threads;  ///< at most so many; nothing: all
  py::object progress;         ///< called with the share done, 0 ... 1, on the thread of the caller; None: nobody asks
};

/// What the work tells, and what it must listen to.
struct Ticket {
  std::function<void(double)> progress;
  std::stop_token stop;

  /// Between two steps. @throws CancelledError if a stop is asked for
  void check() const;
};

/// Does the work on a thread of its own, without the GIL. The caller's thread listens for Ctrl-C meanwhile and calls
/// Control::progress; what a handler of signals or the progress function raises ends the work and is raised.
/// @throws InputError unless the threads are 1 or more; what the work throws
/// The work must not touch Python.
void run(const Control& control, const std::function<void(const Ticket&)>& work);

}  // namespace hsr::python
