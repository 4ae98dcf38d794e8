#pragma once

#include <stdexcept>
#include <string>

namespace hsr {

/// Unreadable or unfit input. The message is one line and names the file, the line or index, what was found and what was
/// expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A call that breaks its `@pre`.
struct PreconditionError : std::logic_error {
  using std::logic_error::logic_error;
};

/// A broken invariant of hsr itself: a defect, please report it.
struct InvariantError : std::logic_error {
  using std::logic_error::logic_error;
};

/// @throws PreconditionError with `message` unless `holds`
inline void require(bool holds, const char* message) {
  if (!holds) throw PreconditionError(message);
}

}  // namespace hsr
