#include "hsr/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "geometry/error.h"

namespace hsr::cli {

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::with_default_shown() {
  option_->capture_default_str();
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& values) {
  option_->check(CLI::IsMember(values));
  return *this;
}

Option& Option::separated_by(char separator) {
  option_->delimiter(separator);
  return *this;
}

template <class Value>
Option Options::add_value(const std::string& names, Value& value, const std::string& type, const std::string& help) {
  CLI::Option* option = verb_->add_option(names, value, help)->group(group_);
  if (!type.empty()) option->type_name(type);
  return Option(option);
}

Option Options::add(const std::string& names, std::string& value, const std::string& type, const std::string& help) {
  return add_value(names, value, type, help);
}
Option Options::add(const std::string& names, std::vector<std::string>& value, const std::string& type,
                    const std::string& help) {
  return add_value(names, value, type, help);
}
Option Options::add(const std::string& names, int& value, const std::string& type, const std::string& help) {
  return add_value(names, value, type, help);
}
Option Options::add(const std::string& names, std::optional<int>& value, const std::string& type, const std::string& help) {
  return add_value(names, value, type, help);
}
Option Options::add(const std::string& names, std::uint64_t& value, const std::string& type, const std::string& help) {
  return add_value(names, value, type, help);
}
Option Options::add(const std::string& names, double& value, const std::string& type, const std::string& help) {
  return add_value(names, value, type, help);
}
Option Options::add(const std::string& names, std::optional<double>& value, const std::string& type, const std::string& help) {
  return add_value(names, value, type, help);
}

Option Options::add_several(const std::string& name, std::vector<std::string>& value, const std::string& help) {
  return Option(verb_->add_option(name, value, help)->group(group_)->type_name(""));
}

Option Options::add_one_each(const std::string& names, std::vector<std::string>& value, const std::string& type,
                             const std::string& help) {
  return Option(verb_->add_option(names, value, help)->group(group_)->type_name(type)->allow_extra_args(false));
}

void Options::add_flag(const std::string& names, bool& value, const std::string& help) {
  verb_->add_flag(names, value, help)->group(group_);
}

void Options::on_run(std::function<void()> run) { verb_->callback(std::move(run)); }

CommandLine::CommandLine(const std::string& name, const std::string& description, const std::string& version,
                         const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->require_subcommand(1);
  app_->set_version_flag("--version", version);
  app_->footer(footer);
}

CommandLine::~CommandLine() = default;

Options CommandLine::add_verb(const std::string& name, const std::string& description, const std::string& footer) {
  CLI::App* verb = app_->add_subcommand(name, description);
  verb->footer(footer);
  return Options(verb);
}

void CommandLine::run(int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  const bool is_verb = !verb.empty() && verb.front() != '-';
  const auto verbs = app_->get_subcommands([](const CLI::App*) { return true; });
  if (is_verb && std::none_of(verbs.begin(), verbs.end(), [&](const CLI::App* v) { return v->get_name() == verb; })) {
    std::string names;
    for (std::size_t k = 0; k < verbs.size(); ++k)
      names += (k == 0 ? "" : k + 1 < verbs.size() ? ", " : " or ") + verbs[k]->get_name();
    throw InputError(verb + ": no such verb, expected " + names + " ('" + app_->get_name() + " --help' lists them)");
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    app_->exit(help_or_version);
  } catch (const CLI::ParseError& e) {
    throw InputError(std::string(e.what()) + " (see '" + app_->get_name() + " " + (is_verb ? verb + " " : "") + "--help')");
  }
}

}  // namespace hsr::cli
