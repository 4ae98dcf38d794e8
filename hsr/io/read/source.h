#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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

/// A regular file that is read in blocks: for formats that are gone through once, without all of it in memory.
class BlockFile {
 public:
  /// Opens it; nothing where it is not a regular file that can be read.
  static std::optional<BlockFile> open(const std::string& path);
  BlockFile(BlockFile&& other) noexcept : fd_(std::exchange(other.fd_, -1)), size_(other.size_) {}
  BlockFile(const BlockFile&) = delete;
  BlockFile& operator=(const BlockFile&) = delete;
  BlockFile& operator=(BlockFile&&) = delete;
  ~BlockFile();

  std::size_t size() const { return size_; }  ///< as it was opened
  /// Up to `n` bytes from byte `at` on. @returns how many; fewer where the file ends, or cannot be read
  std::size_t read(std::size_t at, char* to, std::size_t n) const;

 private:
  BlockFile(int fd, std::size_t size) : fd_(fd), size_(size) {}
  int fd_;
  std::size_t size_;
};

/// All bytes of a file that another file names; nothing if it is missing, unreadable or not a regular file.
std::optional<Bytes> read_named_file(const std::string& path);

/// What a reader is given.
struct Source {
  std::string path;                 ///< as given: files that this one names are looked for beside it
  std::string_view bytes;           ///< inflated; a NUL follows
  const BlockFile* file = nullptr;  ///< not null: `bytes` are only the first ones of this file

  std::size_t size() const { return file == nullptr ? bytes.size() : file->size(); }

  /// The path of a file that this one names.
  std::string beside(std::string_view named) const;
  /// @throws InputError "PATH: where: what"; an empty `where` is left out
  [[noreturn]] void refuse(const std::string& where, const std::string& what) const;
};

/// `text` on one line: at most `most` characters, unprintable ones as '?'.
std::string printable(std::string_view text, std::size_t most = 40);

/// `text` in double quotes, clipped.
std::string in_quotes(std::string_view text);

}  // namespace hsr::internal::read
