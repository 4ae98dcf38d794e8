#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace hsr::internal {

/// Appends how far a number is from the one before, seven bits to a byte, the low ones first.
inline void append_gap(std::string& bytes, std::uint32_t gap) {
  for (; gap >= 128; gap >>= 7U) bytes += static_cast<char>(gap | 128U);
  bytes += static_cast<char>(gap);
}

/// What append_gap() has appended. @param next_byte gives the bytes one by one @throws what `refuse` throws, if there are too many
template <class NextByte, class Refuse>
std::uint32_t gap_of(const NextByte& next_byte, const Refuse& refuse) {
  std::uint32_t gap = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = next_byte();
    if (shift > 28) refuse();
    gap |= (byte & 127U) << shift;
    if (byte < 128) return gap;
  }
}

/// Ascending numbers that are held until all are there, mostly in one byte each.
class AscendingNumbers {
 public:
  /// @pre number >= those added before
  void add(std::uint32_t number) {
    append_gap(bytes_, number - std::exchange(last_, number));
    ++count_;
  }
  std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(count_);
    const char* at = bytes_.data();
    std::uint32_t last = 0;
    for (std::size_t k = 0; k < count_; ++k)
      numbers.push_back(last += gap_of([&] { return static_cast<std::uint8_t>(*at++); }, [] {}));
    return numbers;
  }

 private:
  std::string bytes_;
  std::uint32_t last_ = 0;
  std::size_t count_ = 0;
};

}  // namespace hsr::internal
