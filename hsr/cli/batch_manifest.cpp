#include "hsr/cli/batch_manifest.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "geometry/error.h"

namespace hsr::cli {

namespace fs = std::filesystem;

namespace {

const char* const header = "file,view,output,status,seconds,request,input,hash,message";
constexpr std::size_t columns = 9;

std::string digits_of(const XXH128_hash_t& hash) { return fmt::format("{:016x}{:016x}", hash.high64, hash.low64); }

/// A field of CSV, quoted where it has to be (RFC 4180); line ends become blanks, so that a row is a line.
std::string field(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string text_of(const BatchRow& r) {
  return fmt::format("{},{},{},{},{:.3f},{},{},{},{}\n", field(r.file), field(r.view), field(r.output), r.status, r.seconds,
                     r.request, r.input, r.hash, field(r.message));
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"')
      fields.back() += line[i++];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      fields.emplace_back();
    else
      fields.back() += line[i];
  }
  if (quoted) fields.clear();
  return fields;
}

/// Nothing: the line is no row, as the last one of a batch that was killed may not be.
std::optional<BatchRow> row_of(const std::string& line) {
  const std::vector<std::string> f = fields_of(line);
  if (f.size() != columns) return {};
  BatchRow row{f[0], f[1], f[2], 0, 0, f[5], f[6], f[7], f[8]};
  const auto read = [](const std::string& text, auto& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
  };
  if (!read(f[3], row.status) || !read(f[4], row.seconds)) return {};
  return row;
}

/// Takes a file for itself. @returns its descriptor; -1: another process has it
int locked(const std::string& path) {
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw InputError(path + ": cannot be written: " + std::strerror(errno));
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  close(file);
  return -1;
}

[[noreturn]] void refuse_second(const std::string& journal) {
  throw InputError(journal + ": found another hsr batch at work on it, expected to wait until that is done");
}

}  // namespace

std::optional<std::string> hash_of_file(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};  // a pipe would be waited for
  std::ifstream file(path, std::ios::binary);
  if (!file) return {};
  XXH3_state_t state;
  XXH3_128bits_reset(&state);
  std::vector<char> buffer(1 << 16);
  while (file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    XXH3_128bits_update(&state, buffer.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) return {};
  return digits_of(XXH3_128bits_digest(&state));
}

std::string hash_of_text(const std::string& text) { return digits_of(XXH3_128bits(text.data(), text.size())); }

BatchManifest::BatchManifest(std::string directory, const std::string& part) : directory_(std::move(directory)) {
  std::error_code error;
  fs::create_directories(directory_, error);
  if (!fs::is_directory(directory_))
    throw InputError(directory_ + ": cannot be made a directory, expected one that is there or can be made");
  read(path("manifest.csv"));
  for (const std::string& journal : journals()) read(journal);
  journal_ = path(part.empty() ? "journal.csv" : "journal-" + part + ".csv");
  file_ = locked(journal_);
  if (file_ < 0) refuse_second(journal_);
  // One that was killed may have left half a row.
  [[maybe_unused]] const auto written = ::write(file_, "\n", 1);
}

BatchManifest::~BatchManifest() {
  if (file_ >= 0) close(file_);
}

std::vector<std::string> BatchManifest::journals() const {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(directory_)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("journal") && name.ends_with(".csv")) all.push_back(entry.path().string());
  }
  std::ranges::sort(all);
  return all;
}

void BatchManifest::read(const std::string& path) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    if (auto row = row_of(line); row && line != header) rows_[{row->file, row->view}] = std::move(*row);
}

const BatchRow* BatchManifest::find(const std::string& file, const std::string& view) const {
  const auto found = rows_.find({file, view});
  return found == rows_.end() ? nullptr : &found->second;
}

void BatchManifest::add(const BatchRow& row) {
  const std::string text = text_of(row);
  const std::lock_guard lock(mutex_);
  rows_[{row.file, row.view}] = row;
  // One write: a row is there or not, whatever kills the program.
  if (::write(file_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw InputError(journal_ + ": cannot be written: " + std::strerror(errno));
}

void BatchManifest::finish(const std::vector<std::pair<std::string, std::string>>& files_and_views,
                           UnfinishedFiles& unfinished) {
  std::vector<int> others;
  std::vector<std::string> done;
  for (const std::string& journal : journals()) {
    if (journal == journal_) continue;
    const int other = locked(journal);
    if (other < 0) refuse_second(journal);
    others.push_back(other);
    done.push_back(journal);
    read(journal);
  }
  std::string text = std::string(header) + '\n';
  for (const Key& key : files_and_views)
    if (const BatchRow* row = find(key.first, key.second)) text += text_of(*row);
  write_file(path("manifest.csv"), text, &unfinished);
  std::error_code error;
  for (const std::string& journal : done) fs::remove(journal, error);
  for (const int other : others) close(other);
  fs::remove(journal_, error);
}

}  // namespace hsr::cli
