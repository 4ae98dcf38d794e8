#include "hsr/io/write/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "geometry/error.h"

namespace hsr::internal {

int UnfinishedFiles::add(const std::string& path) noexcept {
  if (path.size() >= longest_name) return -1;
  for (int k = 0; k < slots; ++k) {
    int expected = free;
    if (!slots_[k].state.compare_exchange_strong(expected, being_written)) continue;
    std::memcpy(slots_[k].path, path.c_str(), path.size() + 1);
    slots_[k].state = in_use;
    return k;
  }
  return -1;
}

void UnfinishedFiles::forget(int slot) noexcept {
  if (slot >= 0) slots_[slot].state = free;
}

void UnfinishedFiles::remove_all() noexcept {
  for (Slot& slot : slots_)
    if (slot.state == in_use) ::unlink(slot.path);
}

namespace {

std::string without_links(const std::string& path) {
  char resolved[PATH_MAX];
  return ::realpath(path.c_str(), resolved) != nullptr ? resolved : path;
}

}  // namespace

OutputFile::OutputFile(std::string path, UnfinishedFiles* unfinished) : path_(std::move(path)), unfinished_(unfinished) {
  if (path_ == "-") {
    file_ = STDOUT_FILENO;
    return;
  }
  if (path_.empty()) throw InputError("output: found an empty file name");
  struct stat status = {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(errno);
    return;
  }
  if (exists && ::access(path_.c_str(), W_OK) != 0) fail(errno);  // a rename would not ask
  target_ = exists ? without_links(path_) : path_;
  const auto slash = target_.find_last_of('/');
  const std::string directory = slash == std::string::npos ? "" : target_.substr(0, slash + 1);
  for (int attempt = 0;; ++attempt) {
    temporary_ = directory + ".hsr-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part";
    // Registered first: a signal after the file is made must find its name, which no other process uses.
    if (unfinished_ != nullptr) slot_ = unfinished_->add(temporary_);
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ >= 0) break;
    const int error = errno;
    temporary_.clear();
    discard();
    if (error != EEXIST || attempt == 1000) fail(error);
  }
  if (exists) (void)::fchmod(file_, status.st_mode & 07777);
}

OutputFile::~OutputFile() { discard(); }

void OutputFile::write(std::string_view bytes) {
  require(file_ >= 0, "OutputFile: written after commit");
  while (!bytes.empty()) {
    const ssize_t n = ::write(file_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

void OutputFile::sync() {
  if (file_ >= 0 && ::fsync(file_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);  // a pipe has no disk
}

void OutputFile::close() {
  const int file = std::exchange(file_, -1);
  if (file >= 0 && file != STDOUT_FILENO && ::close(file) != 0 && errno != EINTR) fail(errno);
}

void OutputFile::commit() {
  require(file_ >= 0 || !temporary_.empty(), "OutputFile: committed twice");
  close();
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  if (unfinished_ != nullptr) unfinished_->forget(slot_);
  slot_ = -1;
}

void OutputFile::discard() noexcept {
  if (file_ >= 0 && file_ != STDOUT_FILENO) ::close(file_);
  file_ = -1;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
  if (unfinished_ != nullptr) unfinished_->forget(slot_);
  slot_ = -1;
}

void OutputFile::fail(int error) {
  discard();
  throw InputError((path_ == "-" ? "standard output" : path_) +
                   ": cannot be written: " + std::generic_category().message(error));
}

void write_file(const std::string& path, std::string_view bytes, UnfinishedFiles* unfinished) {
  OutputFile file(path, unfinished);
  file.write(bytes);
  file.commit();
}

}  // namespace hsr::internal
