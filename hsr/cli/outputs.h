#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hsr/io/write/format.h"
#include "hsr/io/write/output_file.h"

namespace hsr::cli {

using namespace internal;

/// A file to write, and what as.
struct Output {
  std::string path;  ///< "-": the standard output
  Format format;
};

/// "part.svg", whose ending chooses the format, or "svg:-", which writes that format to the standard output.
/// @throws InputError where it is neither, or none of the formats that are expected
std::vector<Output> parse_outputs(const std::vector<std::string>& texts, std::span<const Format> expected);
std::vector<std::string> paths_of(const std::vector<Output>& outputs);

/// Refuses, before any work, files to write that are a model itself, that are one file, or whose directory is missing.
/// @param models "-" is the standard input
/// @param outputs empty names are passed over; "-" is the standard output
/// @throws InputError in one line that names the file
void check_outputs(const std::vector<std::string>& models, const std::vector<std::string>& outputs);

/// Several files that appear together: none is put in place before all are written, what goes to the standard output too.
class OutputFiles {
 public:
  explicit OutputFiles(UnfinishedFiles& unfinished) : unfinished_(unfinished) {}
  void write(const std::string& path, const std::string& bytes);
  void commit();

 private:
  UnfinishedFiles& unfinished_;
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::optional<std::string> standard_output_;  // written once all files are
};

}  // namespace hsr::cli
