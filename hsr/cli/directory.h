#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "hsr/io/write/output_file.h"

namespace hsr::cli {

using namespace internal;

/// A directory of results: made with the first file if it is not there, and not left behind if that cannot be written; files in it
/// are replaced one by one, each complete or as it was.
class OutputDirectory {
 public:
  /// @throws InputError if it is a file
  OutputDirectory(std::string path, UnfinishedFiles& unfinished);

  /// @param name may have directories in it @throws InputError if they cannot be made
  void write(const std::string& name, std::string_view bytes);
  const std::string& path() const { return path_; }
  std::string path(const std::string& name) const;
  /// How many it has written.
  std::size_t files() const { return files_; }

 private:
  std::string path_;
  std::size_t files_ = 0;
  UnfinishedFiles& unfinished_;
};

/// "AMD EPYC, 2 processors, g++ 12.2.0; 2026-11-25"
std::string machine_and_date();

}  // namespace hsr::cli
