#pragma once

#include <functional>
#include <string>

namespace hsr::internal {

/// Calls a function in which Open CASCADE works on a file. Where entities are missing it may follow a pointer to nothing: such a fault of
/// the processor becomes an InputError, as everything else that is wrong with a file.
///
/// What the function holds at a fault stays as it is, neither freed nor unlocked, so locks are taken outside. Faults of other threads and
/// outside of such calls go where they went before.
/// @throws InputError naming the file, and what the function throws
void survive_faults(const std::string& path, const std::function<void()>& function);

}  // namespace hsr::internal
