#pragma once

#include <atomic>
#include <string>
#include <string_view>

namespace hsr::internal {

/// Names of files that are not complete yet, for a signal handler that removes them.
///
/// `remove_all` is safe in a signal handler: it neither locks nor allocates. The one who handles signals owns the object; hsr
/// has no global one.
class UnfinishedFiles {
 public:
  static constexpr int slots = 32, longest_name = 4096;

  /// @return the slot; -1 if the name is too long or all slots are taken: then it is not removed by a signal
  int add(const std::string& path) noexcept;
  void forget(int slot) noexcept;
  void remove_all() noexcept;

 private:
  enum State : int { free, being_written, in_use };
  struct Slot {
    std::atomic<int> state = free;
    char path[longest_name] = {};
  };
  Slot slots_[slots];
};

/// An output file that is either complete or absent: written under a temporary name beside it, renamed by `commit`, removed if
/// the object goes without one. A file that was there before stays as it was until then.
///
/// "-" is the standard output; what exists and is no ordinary file (a device, a pipe) is written in place.
/// @throws InputError in one line that names the file and what went wrong
class OutputFile {
 public:
  explicit OutputFile(std::string path, UnfinishedFiles* unfinished = nullptr);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view bytes);
  /// What has been written is on the disk when this returns.
  void sync();
  /// All is written, and nothing but the name is missing: of several files none is in place before all are complete.
  void close();
  void commit();

 private:
  [[noreturn]] void fail(int error);
  void discard() noexcept;

  std::string path_;       // as given
  std::string target_;     // links followed
  std::string temporary_;  // empty: written in place
  int file_ = -1, slot_ = -1;
  UnfinishedFiles* unfinished_;
};

/// All of it or nothing.
void write_file(const std::string& path, std::string_view bytes, UnfinishedFiles* unfinished = nullptr);

}  // namespace hsr::internal
