#pragma once

namespace hsr::internal {

/// From here on GMP throws std::bad_alloc where there is no memory for a number, instead of ending the process, as it does by itself. For
/// programs: a library leaves that to its host. Call it before any number is made.
void throw_where_numbers_have_no_memory();

}  // namespace hsr::internal
