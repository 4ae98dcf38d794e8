#pragma once

namespace hsr::internal::read {

/// What scan_decimal met.
enum class Decimal {
  number,     ///< a finite number
  malformed,  ///< no decimal number begins here
  too_large,  ///< it rounds to an infinity
};

/// The decimal number that begins at `p`, rounded correctly (nearest, ties to even, subnormals included), and where it ends.
///
/// One leading '+' or '-', digits with at most one point, an exponent if one follows. No hexadecimal, no "inf", no "nan".
/// Exact: the result is the double nearest to the decimal for any number of digits; what underflows is 0 with its sign.
struct ScannedDecimal {
  double value = 0;
  const char* end = nullptr;
  Decimal status = Decimal::malformed;
};
ScannedDecimal scan_decimal(const char* p, const char* end);

}  // namespace hsr::internal::read
