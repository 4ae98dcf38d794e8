#pragma once

#include <cstddef>
#include <vector>

namespace hsr {

/// A value for each sample of a picture: rows from the top, each from the left.
template <class T>
struct Image {
  int width = 0, height = 0;
  std::vector<T> pixels;

  Image() = default;
  Image(int w, int h, const T& value = {})
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}

  T* row(int j) { return pixels.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width); }
  const T* row(int j) const { return pixels.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width); }
  T& at(int i, int j) { return row(j)[i]; }
  const T& at(int i, int j) const { return row(j)[i]; }

  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace hsr
