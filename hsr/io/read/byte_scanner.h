#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

enum class ByteOrder { little, big };

/// Goes once through binary data; what does not fit is refused with its byte, face or vertex.
class ByteScanner {
 public:
  ByteScanner(const Source& source, std::size_t first_byte, ByteOrder order)
      : source_(source), at_(first_byte), swap_((order == ByteOrder::big) != (std::endian::native == std::endian::big)) {}

  std::size_t offset() const { return at_; }
  std::size_t left() const { return source_.bytes.size() - at_; }

  /// @throws InputError unless `n` more bytes are there
  void need(std::size_t n, const std::string& what) const {
    if (left() < n) refuse(at_, "the end of the file", what);
  }
  /// The next number. @pre its bytes are there
  template <class T>
  T get() {
    const T value = peek<T>(source_.bytes.data() + at_);
    at_ += sizeof(T);
    return value;
  }
  /// The number at `p`, in the order of this scanner.
  template <class T>
  T peek(const char* p) const {
    char raw[sizeof(T)];
    std::memcpy(raw, p, sizeof(T));
    if (swap_)
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    return std::bit_cast<T>(raw);
  }
  const char* position() const { return source_.bytes.data() + at_; }
  void skip(std::size_t n) { at_ += n; }

  [[noreturn]] void refuse(std::size_t byte, const std::string& found, const std::string& expected) const {
    source_.refuse("byte " + std::to_string(byte), "found " + found + ", expected " + expected);
  }
  [[noreturn]] void refuse_vertex(std::uint64_t vertex, double found) const {
    source_.refuse("vertex " + std::to_string(vertex),
                   std::string("found ") + (std::isnan(found) ? "NaN" : "infinity") + ", expected a finite coordinate");
  }
  [[noreturn]] void refuse_index(std::uint64_t face, std::int64_t found, std::uint64_t vertices) const {
    source_.refuse("face " + std::to_string(face),
                   "found index " + std::to_string(found) + ", expected " +
                       (vertices == 0 ? "a vertex before the first face" : "0 to " + std::to_string(vertices - 1)));
  }

 private:
  const Source& source_;
  std::size_t at_;
  bool swap_;
};

}  // namespace hsr::internal::read
