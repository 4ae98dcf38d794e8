#pragma once

namespace hsr::internal {

/// The largest scale of ISO 5455 up to `most`: ..., 1:10, 1:5, 1:2, 1:1, 2:1, 5:1, ..., each the double that parse_scale() gives it.
/// @pre most > 0
double standard_scale(long double most);

}  // namespace hsr::internal
