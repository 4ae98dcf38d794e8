#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hsr/io/write/output_file.h"

namespace hsr::cli {

using namespace internal;

/// What became of one drawing of a batch.
struct BatchRow {
  std::string file, view;
  std::string output;   ///< in the directory of the batch
  int status = 0;       ///< exit status of the command; 128 and more: it was killed by a signal
  double seconds = 0;   ///< by the clock
  std::string request;  ///< hash of what was asked for: the command, its version and options
  std::string input;    ///< hash of the file's bytes; empty: it could not be read
  std::string hash;     ///< of the output's bytes; empty: there is none
  std::string message;  ///< the line that says why there is none
};

/// 32 hexadecimal digits that change if a byte does (XXH3, 128 bits); nothing where the file cannot be read.
std::optional<std::string> hash_of_file(const std::string& path);
std::string hash_of_text(const std::string& text);

/// The rows of a batch, kept in its directory so that one that is killed at any moment loses what it was at and no more: rows go
/// to a journal as they come, and at the end to manifest.csv.
class BatchManifest {
 public:
  /// Reads what earlier batches left. Other batches may be at work in the directory, on other parts.
  /// @param part "3-of-20", or empty: the whole list @throws InputError where a batch of that part is at work there
  BatchManifest(std::string directory, const std::string& part);
  ~BatchManifest();
  BatchManifest(const BatchManifest&) = delete;
  BatchManifest& operator=(const BatchManifest&) = delete;

  /// nullptr: there is none yet.
  const BatchRow* find(const std::string& file, const std::string& view) const;
  /// Any thread.
  void add(const BatchRow& row);
  /// Writes manifest.csv, a row for each of these in turn, and removes the journals.
  /// @throws InputError where another batch is at work on a part
  void finish(const std::vector<std::pair<std::string, std::string>>& files_and_views, UnfinishedFiles& unfinished);

 private:
  using Key = std::pair<std::string, std::string>;
  void read(const std::string& path);
  std::string path(const std::string& name) const { return directory_ + "/" + name; }
  std::vector<std::string> journals() const;

  std::string directory_;
  std::string journal_;  // path
  int file_ = -1;
  std::map<Key, BatchRow> rows_;
  std::mutex mutex_;
};

}  // namespace hsr::cli
