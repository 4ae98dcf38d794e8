#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/number.h"
#include "geometry/point.h"
#include "hsr/io/write/json.h"

namespace hsr::internal {

/// JSON text, appended to a string.
void append_integer(std::string& out, std::uint64_t x);
void append_number(std::string& out, double x, Numbers numbers);
void append_rational(std::string& out, const Rational& x, Numbers numbers);
void append_point(std::string& out, const Point3& p, Numbers numbers);
void append_string(std::string& out, std::string_view text);  ///< quoted and escaped; malformed UTF-8 becomes U+FFFD

}  // namespace hsr::internal
