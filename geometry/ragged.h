#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace hsr {

/// Rows of different lengths, one after the other in one array.
template <class T, class Size = std::uint32_t>
class Ragged {
 public:
  std::size_t size() const { return first_.size() - 1; }  ///< rows
  std::span<const T> operator[](std::size_t row) const {
    return {values_.data() + first_[row], values_.data() + first_[row + 1]};
  }
  std::span<T> operator[](std::size_t row) { return {values_.data() + first_[row], values_.data() + first_[row + 1]}; }
  /// Of all rows, one after the other.
  const std::vector<T>& values() const { return values_; }
  /// Where the first value of a row is among those of all rows; of row size(): how many there are.
  Size begin(std::size_t row) const { return first_[row]; }
  std::size_t bytes() const { return first_.capacity() * sizeof(Size) + values_.capacity() * sizeof(T); }

  /// Adds to the last row, which is no row before it ends.
  void push_back(const T& value) { values_.push_back(value); }
  void end_row() { first_.push_back(static_cast<Size>(values_.size())); }
  template <class Values>
  void push_row(const Values& row) {
    values_.insert(values_.end(), std::begin(row), std::end(row));
    end_row();
  }
  /// All rows of another, after those that are there.
  void append(const Ragged& more) {
    const auto before = static_cast<Size>(values_.size());
    values_.insert(values_.end(), more.values_.begin(), more.values_.end());
    for (std::size_t row = 0; row < more.size(); ++row) first_.push_back(before + more.first_[row + 1]);
  }
  void reserve(std::size_t rows, std::size_t values = 0) {
    first_.reserve(rows + 1);
    values_.reserve(values);
  }
  /// Leaves no row, and keeps the memory.
  void clear() {
    first_.assign(1, 0);
    values_.clear();
  }

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

}  // namespace hsr
