#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hsr/io/write/output_file.h"

namespace hsr::cli {

using namespace internal;

/// Refuses, before any work, files to write that are the model itself, that are one file, or whose directory is missing.
/// @param outputs empty names are passed over; "-" is the standard output
/// @throws InputError in one line that names the file
void check_outputs(const std::string& model, const std::vector<std::string>& outputs);

/// Several files that appear together: none is put in place before all are written.
class OutputFiles {
 public:
  explicit OutputFiles(UnfinishedFiles& unfinished) : unfinished_(unfinished) {}
  void write(const std::string& path, const std::string& bytes);
  void commit();

 private:
  UnfinishedFiles& unfinished_;
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace hsr::cli
