#include "hsr/io/read/source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "geometry/error.h"

namespace hsr::internal::read {

namespace {

/// A pipe has no size that could be checked, so it ends here.
constexpr std::size_t most_from_pipe = std::size_t{1} << 32;

struct File {
  int fd = -1;
  explicit File(int f) : fd(f) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (fd >= 0) ::close(fd);
  }
};

std::string reason(int code) { return std::generic_category().message(code); }

/// Reads up to `n` bytes. @returns the count, less than n at the end of the file; -1 on an error
ssize_t read_up_to(int fd, char* to, std::size_t n) {
  std::size_t done = 0;
  while (done < n) {
    const ssize_t k = ::read(fd, to + done, std::min<std::size_t>(n - done, std::size_t{1} << 30));
    if (k < 0 && errno == EINTR) continue;
    if (k < 0) return -1;
    if (k == 0) break;
    done += static_cast<std::size_t>(k);
  }
  return static_cast<ssize_t>(done);
}

Bytes read_pipe(int fd, const Source& source) {
  std::string all;
  std::string chunk(std::size_t{1} << 20, '\0');
  for (;;) {
    const ssize_t k = read_up_to(fd, chunk.data(), chunk.size());
    if (k < 0) source.refuse("", "cannot be read: " + reason(errno));
    all.append(chunk, 0, static_cast<std::size_t>(k));
    if (all.size() > most_from_pipe)
      source.refuse("", "found more than 4 GiB in a pipe, expected a file for a model of that size");
    if (static_cast<std::size_t>(k) < chunk.size()) break;
  }
  Bytes bytes = Bytes::of_size(all.size());
  std::memcpy(bytes.data.get(), all.data(), all.size());
  return bytes;
}

/// @returns the errno of what went wrong, or 0
int read_regular(int fd, std::size_t size, Bytes& bytes) {
  bytes = Bytes::of_size(size);
  const ssize_t k = read_up_to(fd, bytes.data.get(), size);
  if (k < 0) return errno;
  bytes.size = static_cast<std::size_t>(k);
  bytes.data[bytes.size] = '\0';
  return 0;
}

}  // namespace

Bytes Bytes::of_size(std::size_t n) {
  Bytes bytes{std::unique_ptr<char[]>(new char[n + 1]), n};
  bytes.data[n] = '\0';
  return bytes;
}

Bytes read_file(const std::string& path) {
  const Source source{path, {}};
  if (path.find('\0') != std::string::npos) source.refuse("", "found a NUL in the path, expected a file");
  const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.fd < 0) source.refuse("", "cannot be opened: " + reason(errno));
  struct stat info {};
  if (::fstat(file.fd, &info) != 0) source.refuse("", "cannot be read: " + reason(errno));
  if (S_ISDIR(info.st_mode)) source.refuse("", "found a directory, expected a model file");
  if (S_ISFIFO(info.st_mode)) return read_pipe(file.fd, source);
  if (!S_ISREG(info.st_mode)) source.refuse("", "found a device or socket, expected a model file");
  Bytes bytes;
  if (const int code = read_regular(file.fd, static_cast<std::size_t>(info.st_size), bytes))
    source.refuse("", "cannot be read: " + reason(code));
  return bytes;
}

std::optional<BlockFile> BlockFile::open(const std::string& path) {
  // A pipe must not be opened to see what it is: whoever writes to it would find it closed again.
  struct stat info {};
  if (path.find('\0') != std::string::npos || ::stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return {};
  BlockFile file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK), 0);  // without blocking: it may be a pipe by now
  if (file.fd_ < 0 || ::fstat(file.fd_, &info) != 0 || !S_ISREG(info.st_mode)) return {};
  file.size_ = static_cast<std::size_t>(info.st_size);
  return file;
}

BlockFile::~BlockFile() {
  if (fd_ >= 0) ::close(fd_);
}

std::size_t BlockFile::read(std::size_t at, char* to, std::size_t n) const {
  std::size_t done = 0;
  while (done < n) {
    const ssize_t k = ::pread(fd_, to + done, n - done, static_cast<off_t>(at + done));
    if (k < 0 && errno == EINTR) continue;
    if (k <= 0) break;
    done += static_cast<std::size_t>(k);
  }
  return done;
}

std::optional<Bytes> read_named_file(const std::string& path) {
  if (path.find('\0') != std::string::npos) return {};
  // Without blocking: a model may name a pipe that nobody writes to.
  const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat info {};
  if (file.fd < 0 || ::fstat(file.fd, &info) != 0 || !S_ISREG(info.st_mode)) return {};
  Bytes bytes;
  if (read_regular(file.fd, static_cast<std::size_t>(info.st_size), bytes) != 0) return {};
  return bytes;
}

std::string Source::beside(std::string_view named) const {
  if (!named.empty() && named.front() == '/') return std::string(named);
  const std::size_t slash = path.rfind('/');
  return (slash == std::string::npos ? std::string() : path.substr(0, slash + 1)) + std::string(named);
}

void Source::refuse(const std::string& where, const std::string& what) const {
  std::string name = path;
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  throw InputError(name + ": " + (where.empty() ? "" : where + ": ") + what);
}

std::string printable(std::string_view text, std::size_t most) {
  std::string out;
  for (const char c : text.substr(0, most)) out += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > most) out += "...";
  return out;
}

std::string in_quotes(std::string_view text) { return '"' + printable(text) + '"'; }

}  // namespace hsr::internal::read
