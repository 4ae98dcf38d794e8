#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hsr/image.h"

namespace hsr::internal {

/// A list of things for each sample of a picture; all lists in one pool.
template <class T>
class SampleLists {
 public:
  SampleLists(int width, int height) : last_(width, height, nothing) {}

  void add(int i, int j, const T& thing) {
    things_.push_back({thing, last_.at(i, j)});
    last_.at(i, j) = static_cast<std::uint32_t>(things_.size() - 1);
  }
  /// Replaces what `found` has by the things of a sample, the latest first.
  void copy(int i, int j, std::vector<T>& found) const {
    found.clear();
    for (std::uint32_t k = last_.at(i, j); k != nothing; k = things_[k].before) found.push_back(things_[k].thing);
  }
  /// The latest of a sample; null: none.
  T* latest(int i, int j) {
    const std::uint32_t k = last_.at(i, j);
    return k == nothing ? nullptr : &things_[k].thing;
  }

  std::size_t size() const { return things_.size(); }
  std::size_t bytes() const { return things_.capacity() * sizeof(Entry) + last_.pixels.capacity() * sizeof(std::uint32_t); }

 private:
  static constexpr std::uint32_t nothing = 0xffffffffU;
  struct Entry {
    T thing;
    std::uint32_t before;
  };

  Image<std::uint32_t> last_;
  std::vector<Entry> things_;
};

}  // namespace hsr::internal
