#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hsr/model.h"

namespace hsr::internal::read {

/// Colours that a file gives to its points. A face has the mean of those of its corners, channel by channel, of the numbers as they
/// are stored, rounded once to a byte (halves up).
///
/// Whether the numbers are fractions or bytes is decided for the whole file: they are fractions if none is above 1.
class CornerColours {
 public:
  bool empty() const { return channels_.empty(); }
  /// The colour of a point: red, green and blue, and opacity if `n` is 4. @pre no point of a greater number has one
  void set(std::size_t point, const double* channels, std::size_t n);
  /// Numbers are bytes, whatever they are: an integer format.
  void are_bytes() { largest_ = 255; }

  /// Nothing where a corner has no colour, or there is no corner.
  std::optional<Colour> mean(const std::uint32_t* first, const std::uint32_t* last) const;

 private:
  std::vector<std::array<float, 4>> channels_;  ///< by point; NaN: it has no colour. No opacity: infinite
  double largest_ = 0;
};

}  // namespace hsr::internal::read
