#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace hsr::internal::read {

/// Bytes on the heap, with one NUL behind them, so that a scanner may always look at the next one.
struct Bytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  static Bytes of_size(std::size_t n);
  std::string_view view() const { return {data.get(), size}; }
};

/// All bytes of a regular file or a pipe. The file is read, not mapped: a mapped file that shrinks meanwhile kills the process.
/// @throws InputError in one line that begins with the path
Bytes read_file(const std::string& path);

/// All bytes of a file that another file names; nothing if it is missing, unreadable or not a regular file.
std::optional<Bytes> read_named_file(const std::string& path);

/// What a reader is given.
struct Source {
  std::string path;        ///< as given: files that this one names are looked for beside it
  std::string_view bytes;  ///< inflated; a NUL follows

  /// The path of a file that this one names.
  std::string beside(std::string_view file) const;
  /// @throws InputError "PATH: where: what"; an empty `where` is left out
  [[noreturn]] void refuse(const std::string& where, const std::string& what) const;
};

/// `text` on one line: at most `most` characters, unprintable ones as '?'.
std::string printable(std::string_view text, std::size_t most = 40);

/// `text` in double quotes, clipped.
std::string in_quotes(std::string_view text);

}  // namespace hsr::internal::read
