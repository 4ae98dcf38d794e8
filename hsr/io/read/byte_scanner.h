#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "hsr/io/read/source.h"

namespace hsr::internal::read {

enum class ByteOrder { little, big };

/// Goes once through binary data, of a file in blocks; what does not fit is refused with its byte, face or vertex.
class ByteScanner {
 public:
  ByteScanner(const Source& source, std::size_t first_byte, ByteOrder order)
      : source_(source),
        window_(source.bytes),
        at_(first_byte),
        swap_((order == ByteOrder::big) != (std::endian::native == std::endian::big)) {}

  std::size_t offset() const { return at_; }
  std::size_t left() const { return source_.size() - at_; }

  /// @throws InputError unless `n` more bytes are there
  void need(std::size_t n, const std::string& what) const {
    if (left() < n) refuse(at_, "the end of the file", what);
  }
  /// The next number. @pre its bytes are there
  template <class T>
  T get() {
    const T value = peek<T>(next(sizeof(T)));
    at_ += sizeof(T);
    return value;
  }
  /// The next `n` bytes, at most a block, until more are asked for. @pre they are there
  const char* next(std::size_t n) {
    if (at_ - window_at_ > window_.size() || window_.size() - (at_ - window_at_) < n) read_block(n);
    return window_.data() + (at_ - window_at_);
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
  static constexpr std::size_t block = std::size_t{1} << 20;

  /// @throws InputError if the file has become shorter meanwhile
  void read_block(std::size_t n) {
    block_.resize(block);
    const std::size_t count = source_.file == nullptr ? 0 : source_.file->read(at_, block_.data(), block);
    if (count < n)
      refuse(at_ + count, "the end of the file", std::to_string(source_.size()) + " bytes, as many as it had before");
    window_ = std::string_view(block_.data(), count);
    window_at_ = at_;
  }

  const Source& source_;
  std::vector<char> block_;
  std::string_view window_;    // what of the source is in memory,
  std::size_t window_at_ = 0;  // from this byte on
  std::size_t at_;
  bool swap_;
};

}  // namespace hsr::internal::read
