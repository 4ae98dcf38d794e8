#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "geometry/number.h"
#include "geometry/point.h"

namespace hsr {

/// How numbers are written: the shortest text that reads back as the same double, or exactly as a string "p/q".
enum class Numbers { rounded, exact };

/// JSON text, appended to a string.
void append_integer(std::string& out, std::uint64_t x);
void append_number(std::string& out, double x, Numbers numbers);
void append_rational(std::string& out, const Rational& x, Numbers numbers);
void append_point(std::string& out, const Point3& p, Numbers numbers);
void append_string(std::string& out, std::string_view text);  ///< quoted; control characters, quotes and backslashes escaped

}  // namespace hsr
