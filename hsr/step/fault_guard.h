#pragma once

#include <functional>

namespace hsr::internal {

/// Calls a function in which Open CASCADE works. Where entities are missing it may follow a pointer to nothing: such a fault of the
/// processor becomes a Standard_Failure, which it catches itself where it can do without the entity, and else comes out of here.
///
/// What the function holds at a fault stays as it is, neither freed nor unlocked, so locks are taken outside. Faults of other threads and
/// outside of such calls go where they went before.
/// @throws what the function throws, and Standard_Failure
void survive_faults(const std::function<void()>& function);

}  // namespace hsr::internal
