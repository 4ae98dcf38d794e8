#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "geometry/error.h"
#include "hsr/cli/batch_manifest.h"
#include "hsr/cli/child_process.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/messages.h"
#include "hsr/cli/output_summary.h"
#include "hsr/cli/progress.h"

namespace hsr::cli {

using namespace internal;

namespace fs = std::filesystem;

namespace {

struct BatchArguments {
  std::string list, directory, views, format = "svg", part;
  std::vector<std::string> options;  ///< of hsr draw
  std::optional<int> jobs;           ///< nothing: as many as there are processors
  bool as_sheets = false, quiet = false;
};

const char* const examples = R"(Examples:
  hsr batch list.txt -o drawings                               front, top, right and iso of each model, as SVG
  find parts -name '*.stl' | hsr batch - -o drawings --views iso --format pdf -- --hidden dashed --scale standard
  hsr batch list.txt -o drawings --sheet --format pdf          a drawing sheet of each
  parallel hsr batch list.txt -o drawings --part {}/20 ::: $(seq 20); hsr batch list.txt -o drawings   on many machines

LIST has a model to a line; empty lines and lines that begin with # say nothing. What follows -- are options of hsr draw (of hsr sheet,
with --sheet). DIR gets a drawing for each model and view, in folders as the models have them, and manifest.csv: file, view, output, exit
status, seconds, hashes, and the line that says why there is no drawing. A model that cannot be drawn stops nothing. Run again, it does only
what is missing, or whose model or options have changed; interrupted or killed, it loses the drawings that it was at.
Exit status 1: some model could not be drawn.)";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

constexpr const char* default_views = "front,top,right,iso";

/// Each once, in the order in which they come.
std::vector<std::string> distinct(const std::vector<std::string>& all) {
  std::vector<std::string> once;
  for (const std::string& text : all)
    if (std::ranges::find(once, text) == once.end()) once.push_back(text);
  return once;
}

/// The models of a list, each once. Lines may end in a zero, as find -print0 ends them.
std::vector<std::string> models_of(const std::string& list) {
  std::ifstream file;
  if (list != "-") {
    file.open(list);
    if (!file || fs::is_directory(list)) throw InputError(list + ": cannot be read, expected a file with a model to a line");
  }
  std::istream& lines = list == "-" ? std::cin : file;
  std::vector<std::string> models;
  std::set<std::string> known;
  const std::string text(std::istreambuf_iterator<char>(lines), {});
  for (std::string line : split(text, text.find('\0') == std::string::npos ? '\n' : '\0')) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    if (known.insert(fs::path(line).lexically_normal().string()).second) models.push_back(line);
  }
  if (models.empty()) throw InputError(list + ": found no model, expected one to a line");
  return models;
}

/// Where the drawing of a model goes, in the directory of the batch: parts/bolt.stl -> parts/bolt.stl.front.svg
std::string output_of(const std::string& model, const std::string& view, const std::string& format) {
  fs::path folder;
  for (const fs::path& step : fs::path(model).lexically_normal().relative_path())
    folder /= step == ".." ? fs::path("up") : step;
  return folder.string() + "." + view + "." + format;
}

/// "3/20": the third of twenty. @return what its journal is called
std::string parse_part(const std::string& text, std::size_t& number, std::size_t& of) {
  const auto parts = split(text, '/');
  const auto read = [](const std::string& digits, std::size_t& n) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    return error == std::errc{} && end == digits.data() + digits.size();
  };
  if (parts.size() != 2 || !read(parts[0], number) || !read(parts[1], of) || number < 1 || number > of)
    throw InputError("--part: found \"" + text + "\", expected a part such as 3/20");
  return parts[0] + "-of-" + parts[1];
}

class Batch {
 public:
  Batch(const BatchArguments& a, UnfinishedFiles& unfinished) : a_(a), unfinished_(unfinished), progress_(a.quiet) {
    check_options();
    views_ = a.as_sheets ? std::vector<std::string>{"sheet"} : distinct(split(a.views.empty() ? default_views : a.views, ','));
    for (const std::string& view : views_)
      if (view.empty()) throw InputError("--views: found \"" + a.views + "\", expected views with commas between");
    std::string part;
    if (!a.part.empty()) part = parse_part(a.part, part_, parts_);
    models_ = models_of(a.list);
    check_outputs_differ();
    std::string words = std::string("hsr ") + HSR_VERSION + (a.as_sheets ? " sheet" : " draw");
    for (const std::string& option : a.options) words += '\0' + option;
    request_ = hash_of_text(words + '\0' + a.format);
    manifest_.emplace(a.directory, part);
  }

  void run() {
    for (std::size_t m = part_ - 1; m < models_.size(); m += parts_)
      for (const std::string& view : views_) tasks_.push_back({models_[m], view});
    progress_.stage("drawing");
    std::vector<std::thread> workers;
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t jobs = std::min(a_.jobs ? static_cast<std::size_t>(*a_.jobs) : processors, tasks_.size());
    for (std::size_t k = 0; k < jobs; ++k) workers.emplace_back([this] { work(); });
    for (std::thread& worker : workers) worker.join();
    if (failure_) std::rethrow_exception(failure_);
    finish();
  }

 private:
  using Task = std::pair<std::string, std::string>;  // model and view

  void check_options() const {
    if (a_.as_sheets && !a_.views.empty())
      throw InputError("--views: found with --sheet, expected -- --views LIST, an option of hsr sheet");
    if (a_.jobs && *a_.jobs < 1) throw InputError(fmt::format("--jobs: found {}, expected 1 or more", *a_.jobs));
    for (const std::string& option : a_.options) {
      const std::string name = option.substr(0, option.find('='));
      const bool is_of_batch = name == "-o" || name == "--output" || name == "--report" || name == "-h" || name == "--help" ||
                               (name == "--view" && !a_.as_sheets) || (option.size() > 2 && option.starts_with("-o"));
      if (is_of_batch)
        throw InputError(
            fmt::format("{}: found after --, expected options of the drawing itself: files and views are the batch's", name));
    }
  }

  /// Two models whose names come to one must not overwrite each other's drawing.
  void check_outputs_differ() const {
    std::map<std::string, std::string> model_of;
    for (const std::string& model : models_) {
      const auto [found, is_new] = model_of.try_emplace(output_of(model, "", ""), model);
      if (!is_new)
        throw InputError(
            fmt::format("{}: found {} and {}, whose drawings would be one file, expected one of them, or other names", a_.list,
                        found->second, model));
    }
  }

  void work() {
    try {
      for (std::size_t k = next_++; k < tasks_.size() && !stops_; k = next_++) {
        do_task(tasks_[k]);
        progress_.show(static_cast<double>(++finished_) / static_cast<double>(tasks_.size()));
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      stops_ = true;
    }
  }

  void do_task(const Task& task) {
    BatchRow row{task.first, task.second, output_of(task.first, task.second, a_.format), 0, 0, request_, {}, {}, {}};
    const std::string path = a_.directory + "/" + row.output;
    row.input = hash_of_file(row.file).value_or("");
    std::error_code error;
    if (row.input.empty() && fs::exists(row.file, error) && !fs::is_directory(row.file, error)) {
      row.status = 2;
      row.message = row.file + ": cannot be read, expected a file";
      add(row);
      return;
    }
    if (is_up_to_date(row, path)) return;
    fs::create_directories(fs::path(path).parent_path(), error);
    const std::string model = row.file[0] == '-' ? "./" + row.file : row.file;  // no option
    std::vector<std::string> words = {own_, a_.as_sheets ? "sheet" : "draw", model, "-o", path, "-q"};
    if (!a_.as_sheets) words.insert(words.end(), {"--view", row.view});
    if (std::ranges::none_of(a_.options, [](const std::string& o) { return o.starts_with("--threads"); }))
      words.insert(words.end(), {"--threads", "1"});
    words.insert(words.end(), a_.options.begin(), a_.options.end());
    const auto start = std::chrono::steady_clock::now();
    const Ended ended = run_program(words);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.status = ended.status;
    if (row.status == 0) row.hash = hash_of_file(path).value_or("");
    if (row.status == 0 && row.hash.empty())
      throw InputError(path + ": was not written, expected options with which hsr draws");
    if (row.status == 0) ++made_;
    if (row.status != 0) {
      row.message = message_of(ended);
      // What is wrong with the options is so for every model.
      if (row.status == 2 && (row.message.starts_with("--") || row.message.find("(see 'hsr") != std::string::npos))
        throw InputError(row.message);
      if (fs::is_regular_file(path, error)) fs::remove(path, error);  // of a model that was right before
    }
    add(row);
  }

  /// Whether it was done before, of the same model with the same options, and what was drawn is still there.
  bool is_up_to_date(const BatchRow& row, const std::string& path) {
    const BatchRow* before = nullptr;
    {
      const std::lock_guard lock(mutex_);
      before = manifest_->find(row.file, row.view);
    }
    if (before == nullptr || before->request != row.request || before->input != row.input || before->output != row.output)
      return false;
    // A model that is wrong stays wrong; where the disk was full or memory was short it is tried again.
    if (before->status != 0) return before->status == 2 && !row.input.empty() && before->message.starts_with(row.file + ": ");
    const bool is_there = hash_of_file(path).value_or("") == before->hash;
    if (is_there) ++kept_;
    return is_there;
  }

  void add(const BatchRow& row) {
    const std::lock_guard lock(mutex_);
    manifest_->add(row);
  }

  static std::string message_of(const Ended& ended) {
    std::string line = ended.error.substr(0, ended.error.find('\n'));
    if (line.starts_with("hsr: ")) line = line.substr(5);
    return line.empty() ? fmt::format("ended with status {}", ended.status) : line;
  }

  void finish() {
    std::size_t failed = 0;
    for (const auto& [file, view] : tasks_)
      if (const BatchRow* row = manifest_->find(file, view); row != nullptr && row->status != 0) ++failed;
    if (a_.part.empty()) manifest_->finish(tasks_, unfinished_);
    progress_.clear();
    if (!a_.quiet) {
      const std::string where = a_.part.empty() ? a_.directory + "/manifest.csv" : a_.directory + ", part " + a_.part;
      tell("hsr: {}: {}: {} made now, {} as they were, {} failed\n", where, counted(tasks_.size(), "drawing"), made_.load(),
           kept_.load(), failed);
    }
    if (failed > 0) throw CheckFailed();
  }

  const BatchArguments& a_;
  UnfinishedFiles& unfinished_;
  ProgressLine progress_;
  std::string own_ = own_path();
  std::vector<std::string> models_, views_;
  std::size_t part_ = 1, parts_ = 1;
  std::string request_;
  std::optional<BatchManifest> manifest_;
  std::vector<Task> tasks_;
  std::atomic<std::size_t> next_ = 0, finished_ = 0, made_ = 0, kept_ = 0;
  std::atomic<bool> stops_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

void add_batch(CommandLine& command, UnfinishedFiles& unfinished) {
  auto a = std::make_shared<BatchArguments>();
  Options options =
      command.add_verb("batch", "Draw many models, in many views, and say in a manifest what became of each", examples);
  options.add("LIST", a->list, "LIST", "A file with a model to a line; - for the standard input").required();
  options.add("-o,--output", a->directory, "DIR", "The directory of the drawings, made if it is not there").required();
  options.add("--views", a->views, "LIST", "Views as hsr draw has them, with commas between [front,top,right,iso]");
  options.add("--format", a->format, "FORMAT", "What the drawings end in")
      .with_default_shown()
      .one_of({"svg", "pdf", "eps", "dxf", "tex", "hpgl", "png", "json"});
  options.add_flag("--sheet", a->as_sheets, "A drawing sheet of each model instead of views, by hsr sheet");
  options.add("--jobs", a->jobs, "N", "So many drawings at once [as many as processors]");
  options.add("--part", a->part, "K/N",
              "Only the models K, K + N, K + 2 N, ... of the list, as one of N that may run anywhere at once; without it, "
              "at the end, manifest.csv has all");
  options.add_flag("-q,--quiet", a->quiet, "Say nothing but what is wrong");
  options.add_several("OPTION", a->options, "After --: options of hsr draw, or of hsr sheet");
  options.on_run([a, &unfinished] { Batch(*a, unfinished).run(); });
}

}  // namespace hsr::cli
