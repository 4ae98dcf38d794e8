#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hsr::internal {

/// Rows of different lengths, one after the other in one array.
template <class T, class Size = std::uint32_t>
class Ragged {
 public:
  std::size_t size() const { return first_.size() - 1; }  ///< rows
  std::span<const T> operator[](std::size_t row) const {
    return {values_.data() + first_[row], values_.data() + first_[row + 1]};
  }
  std::span<T> operator[](std::size_t row) { return {values_.data() + first_[row], values_.data() + first_[row + 1]}; }
  /// Of all rows.
  const std::vector<T>& values() const { return values_; }
  std::size_t bytes() const { return first_.capacity() * sizeof(Size) + values_.capacity() * sizeof(T); }

  /// Adds to the last row, which is no row before it ends.
  void push_back(const T& value) { values_.push_back(value); }
  void end_row() { first_.push_back(static_cast<Size>(values_.size())); }
  void reserve(std::size_t rows) { first_.reserve(rows + 1); }

  /// A counting sort: those of a row stay in order. @param for_each calls its argument with (row, value) for each value, and does
  /// so twice. Memory that is there is used again.
  template <class F>
  void assign(std::size_t rows, const F& for_each) {
    // first_[row + 1] counts the row before, then is where the next value of its row goes, then where the row ends.
    first_.assign(rows + 2, 0);
    for_each([&](std::size_t row, const T&) { ++first_[row + 2]; });
    for (std::size_t k = 2; k < first_.size(); ++k) first_[k] += first_[k - 1];
    values_.resize(first_.back());
    for_each([&](std::size_t row, const T& value) { values_[first_[row + 1]++] = value; });
    first_.pop_back();
  }

 private:
  std::vector<Size> first_ = {0};  // of each row; and where the last one ends
  std::vector<T> values_;
};

}  // namespace hsr::internal
