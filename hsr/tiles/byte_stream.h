#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/error.h"
#include "geometry/point.h"
#include "hsr/tiles/ascending_numbers.h"

namespace hsr::internal {

static_assert(std::endian::native == std::endian::little, "files of tiles are little-endian");

/// Appends numbers and lists as bytes.
class ByteWriter {
 public:
  template <class T>
  void add(const T& x) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&x), sizeof x);
  }
  template <class T>
  void add(const std::vector<T>& list) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(static_cast<std::uint64_t>(list.size()));
    bytes_.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
  }
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }
  /// Ascending numbers, as how far each is from the one before: mostly one byte.
  void add_ascending(const std::vector<std::uint32_t>& numbers) {
    add(static_cast<std::uint64_t>(numbers.size()));
    std::uint32_t last = 0;
    for (const std::uint32_t n : numbers) append_gap(bytes_, n - std::exchange(last, n));
  }
  /// In few bytes where it is small.
  void add_small(std::uint32_t number) { append_gap(bytes_, number); }
  /// In floats where these are the same numbers.
  void add(const std::vector<Point3>& points) {
    const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
    const bool are_floats = std::all_of(points.begin(), points.end(),
                                        [&](const Point3& p) { return is_float(p.x) && is_float(p.y) && is_float(p.z); });
    add(static_cast<std::uint64_t>(points.size()));
    add(static_cast<std::uint8_t>(are_floats ? 1 : 0));
    for (const Point3& p : points)
      for (int axis = 0; axis < 3; ++axis) are_floats ? add(static_cast<float>(p[axis])) : add(p[axis]);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what a ByteWriter has written.
/// @throws InputError where the bytes end before, or cannot be such a list
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  T get() {
    T x;
    std::memcpy(&x, taken(sizeof x), sizeof x);
    return x;
  }
  template <class T>
  void get(std::vector<T>& list) {
    const auto count = get<std::uint64_t>();
    if (count > bytes_.size() / sizeof(T)) refuse();
    list.resize(count);
    const char* from = taken(count * sizeof(T));
    if (count > 0) std::memcpy(list.data(), from, count * sizeof(T));
  }
  void get_ascending(std::vector<std::uint32_t>& numbers) {
    const auto count = get<std::uint64_t>();
    if (count > bytes_.size()) refuse();
    numbers.reserve(count);
    std::uint32_t last = 0;
    for (std::uint64_t k = 0; k < count; ++k) numbers.push_back(last += get_small());
  }
  void get(std::vector<Point3>& points) {
    const auto count = get<std::uint64_t>();
    const bool are_floats = get<std::uint8_t>() != 0;
    if (count > bytes_.size() / (are_floats ? 12 : 24)) refuse();
    const auto number = [&] { return are_floats ? static_cast<double>(get<float>()) : get<double>(); };
    points.reserve(count);
    for (std::uint64_t k = 0; k < count; ++k) {
      const double x = number(), y = number();
      points.push_back({x, y, number()});
    }
  }
  std::uint32_t get_small() {
    return gap_of([&] { return get<std::uint8_t>(); }, refuse);
  }
  std::string_view text() {
    const auto size = get<std::uint64_t>();
    if (size > bytes_.size()) refuse();
    return {taken(size), size};
  }
  bool is_at_end() const { return bytes_.empty(); }
  void end() const {
    if (!bytes_.empty()) refuse();
  }
  [[noreturn]] static void refuse() { throw InputError("found bytes of another layout, expected a file that hsr has written"); }

 private:
  const char* taken(std::size_t n) {
    if (n > bytes_.size()) refuse();
    const char* const at = bytes_.data();
    bytes_.remove_prefix(n);
    return at;
  }
  std::string_view bytes_;
};

}  // namespace hsr::internal
