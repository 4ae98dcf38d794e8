#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hsr/cli/command_description.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the name that CLI11 has
class App;
class Option;
}  // namespace CLI

namespace hsr::cli {

/// An option that was declared, to say more of it.
class Option {
 public:
  Option(CLI::Option* option, OfferedValues& offered) : option_(option), offered_(&offered) {}
  Option& required();
  Option& with_default_shown();
  /// Refuses other values.
  Option& one_of(const std::vector<std::string>& values);
  /// Offers these values to complete, and refuses no others.
  Option& such_as(const std::vector<std::string>& values);
  /// The same of a list with commas between.
  Option& list_of(const std::vector<std::string>& values);
  /// One argument may have several values.
  Option& separated_by(char separator);

 private:
  CLI::Option* option_;
  OfferedValues* offered_;
};

using OfferedByOption = std::map<const CLI::Option*, OfferedValues>;

/// The options of a verb. This and CommandLine hide CLI11 from the verbs, since it takes seconds to compile.
class Options {
 public:
  Options(CLI::App* verb, OfferedByOption& offered) : verb_(verb), offered_(&offered) {}

  /// The heading in --help over the options that follow.
  void begin_group(const std::string& name) { group_ = name; }
  /// Options that the help does not show.
  void begin_hidden_group() { group_.clear(); }

  /// Stores what is found in `value`, which must live until the verb has run.
  /// @param names "-o,--output", or "MODEL" for an argument without a name
  /// @param type what stands for the value in --help
  Option add(const std::string& names, std::string& value, const std::string& type, const std::string& help);
  Option add(const std::string& names, std::vector<std::string>& value, const std::string& type, const std::string& help);
  Option add(const std::string& names, int& value, const std::string& type, const std::string& help);
  Option add(const std::string& names, std::optional<int>& value, const std::string& type, const std::string& help);
  Option add(const std::string& names, std::uint64_t& value, const std::string& type, const std::string& help);
  Option add(const std::string& names, double& value, const std::string& type, const std::string& help);
  Option add(const std::string& names, std::optional<double>& value, const std::string& type, const std::string& help);
  /// An argument without a name that may be given several times, anywhere among the options.
  Option add_several(const std::string& name, std::vector<std::string>& value, const std::string& help);
  /// An option that takes one value each time it is given, so that no argument after it is taken for another value.
  Option add_one_each(const std::string& names, std::vector<std::string>& value, const std::string& type,
                      const std::string& help);
  void add_flag(const std::string& names, bool& value, const std::string& help);

  /// What the verb does once all options are known; it may throw InputError.
  void on_run(std::function<void()> run);

 private:
  template <class Value>
  Option add_value(const std::string& names, Value& value, const std::string& type, const std::string& help);
  Option declared(CLI::Option* option);

  CLI::App* verb_;
  OfferedByOption* offered_;
  std::string group_ = "Options";
};

/// The command with its verbs.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& description, const std::string& version, const std::string& footer);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// @param footer what --help of the verb ends with
  Options add_verb(const std::string& name, const std::string& description, const std::string& footer);
  /// A verb that --help does not name, for the build.
  Options add_hidden_verb(const std::string& name, const std::string& description);
  /// What --help says.
  CommandDescription description() const;
  /// Does what the arguments ask for: runs a verb, or prints help or the version.
  /// @throws InputError in one line for arguments that are no use of the command; and what the verb throws
  void run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  std::string version_;
  OfferedByOption offered_;
};

}  // namespace hsr::cli
