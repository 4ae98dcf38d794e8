#include "hsr/cli/directory.h"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "geometry/error.h"

namespace hsr::cli {

using namespace internal;

namespace fs = std::filesystem;

namespace {

/// Makes a directory, and those above it. @return those that were not there, the innermost first
std::vector<fs::path> make(const fs::path& path) {
  std::error_code error;
  std::vector<fs::path> made;
  for (fs::path p = path; !p.empty() && !fs::exists(p, error); p = p.parent_path()) made.push_back(p);
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path))
    throw InputError(path.string() + ": cannot be made a directory" + (error ? " (" + error.message() + ")" : "") +
                     ", expected one that is there or can be made");
  return made;
}

}  // namespace

OutputDirectory::OutputDirectory(std::string path, UnfinishedFiles& unfinished)
    : path_(std::move(path)), unfinished_(unfinished) {
  std::error_code error;
  if (fs::exists(path_, error) && !fs::is_directory(path_, error))
    throw InputError(path_ + ": found a file, expected a directory, or a name for a new one");
}

void OutputDirectory::write(const std::string& name, std::string_view bytes) {
  const fs::path file = fs::path(path_) / name;
  const std::vector<fs::path> made = make(file.parent_path());
  try {
    write_file(file.string(), bytes, &unfinished_);
  } catch (...) {
    std::error_code error;
    for (const fs::path& directory : made) fs::remove(directory, error);
    throw;
  }
  ++files_;
}

std::string OutputDirectory::path(const std::string& name) const { return (fs::path(path_) / name).string(); }

std::string machine_and_date() {
  std::string processor = "unknown processor", line;
  std::ifstream file("/proc/cpuinfo");
  while (std::getline(file, line))
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos) {
      processor = line.substr(line.find(": ") + 2);
      break;
    }
  char date[16] = {};
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof date, "%Y-%m-%d", std::localtime(&now));
  return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors, compiler " + __VERSION__ +
         "; " + date;
}

}  // namespace hsr::cli
