#pragma once

#include <stdexcept>
#include <string>

namespace hsr {

// What hsr throws. Each public function names what of these it throws; besides, any function that takes memory may throw
// std::bad_alloc, and any that is a defect of hsr's an InvariantError. After an error nothing has changed: results are returned
// or not, and a scene that was asked may be asked again. Nothing is printed, and nothing ends the program.

/// Unreadable or unfit input. The message is one line and names the file, the line or index, what was found and what was
/// expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A call that breaks its `@pre`.
struct PreconditionError : std::logic_error {
  using std::logic_error::logic_error;
};

/// The work was ended because the caller asked for it by a std::stop_token (LineOptions::stop and its like). What a progress
/// function throws arrives as it is.
struct CancelledError : std::runtime_error {
  using std::runtime_error::runtime_error;
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
