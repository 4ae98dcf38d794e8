#include "hsr/cli/outputs.h"

#include <filesystem>

#include "geometry/error.h"

namespace hsr::cli {

using namespace internal;

namespace fs = std::filesystem;

namespace {

/// One name for each file, links followed as far as there is something.
fs::path identity(const std::string& path) {
  if (path == "-") return path;
  std::error_code error;
  // weakly_canonical leaves a name relative of which nothing is there, so that "a.svg" would not be "./a.svg".
  const fs::path absolute = fs::absolute(path, error);
  if (error) return fs::path(path).lexically_normal();
  const fs::path real = fs::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : real;
}

bool is_ordinary(const std::string& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  return !fs::exists(status) || fs::is_regular_file(status);
}

}  // namespace

std::vector<Output> parse_outputs(const std::vector<std::string>& texts, std::span<const Format> expected) {
  std::vector<Output> outputs;
  for (const std::string& text : texts) {
    if (text == "-") throw InputError("-: found no format, expected one in front for the standard output, such as svg:-");
    if (text.ends_with(":-"))
      outputs.push_back({"-", format_named(text.substr(0, text.size() - 2), text, expected)});
    else
      outputs.push_back({text, format_of(text, expected)});
  }
  return outputs;
}

std::vector<std::string> paths_of(const std::vector<Output>& outputs) {
  std::vector<std::string> paths;
  for (const Output& output : outputs) paths.push_back(output.path);
  return paths;
}

void check_outputs(const std::vector<std::string>& models, const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const std::string& path = outputs[i];
    if (path.empty()) continue;
    if (path != "-") {
      const fs::path directory = identity(path).parent_path();
      std::error_code error;
      if (!directory.empty() && !fs::is_directory(directory, error))
        throw InputError(path + ": found no directory " + directory.string() + ", expected one to write into");
      if (!is_ordinary(path)) continue;
    }
    for (const std::string& model : models) {
      std::error_code error;
      if (path == "-" || model == "-") continue;
      if (identity(path) == identity(model) || fs::equivalent(path, model, error))
        throw InputError(path + ": is the model itself; expected another file to write");
    }
    for (std::size_t j = 0; j < i; ++j)
      if (!outputs[j].empty() && identity(outputs[j]) == identity(path))
        throw InputError((path == "-" ? "standard output" : path) +
                         ": found twice among the outputs, expected different files");
  }
}

void OutputFiles::write(const std::string& path, const std::string& bytes) {
  if (path == "-") {
    standard_output_ = bytes;
    return;
  }
  files_.push_back(std::make_unique<OutputFile>(path, &unfinished_));
  files_.back()->write(bytes);
}

void OutputFiles::commit() {
  for (const auto& file : files_) file->close();
  if (standard_output_) write_file("-", *standard_output_);
  for (const auto& file : files_) file->commit();
}

}  // namespace hsr::cli
