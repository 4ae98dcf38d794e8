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
  return such_as(values);
}

Option& Option::such_as(const std::vector<std::string>& values) {
  *offered_ = {values, false};
  return *this;
}

Option& Option::list_of(const std::vector<std::string>& values) {
  *offered_ = {values, true};
  return *this;
}

Option& Option::separated_by(char separator) {
  option_->delimiter(separator);
  return *this;
}

Option Options::declared(CLI::Option* option) { return {option, (*offered_)[option]}; }

template <class Value>
Option Options::add_value(const std::string& names, Value& value, const std::string& type, const std::string& help) {
  CLI::Option* option = verb_->add_option(names, value, help)->group(group_);
  if (!type.empty()) option->type_name(type);
  return declared(option);
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
  return declared(verb_->add_option(name, value, help)->group(group_)->type_name(""));
}

Option Options::add_one_each(const std::string& names, std::vector<std::string>& value, const std::string& type,
                             const std::string& help) {
  return declared(verb_->add_option(names, value, help)->group(group_)->type_name(type)->allow_extra_args(false));
}

void Options::add_flag(const std::string& names, bool& value, const std::string& help) {
  verb_->add_flag(names, value, help)->group(group_);
}

void Options::on_run(std::function<void()> run) { verb_->callback(std::move(run)); }

namespace {

OptionDescription described(const CLI::Option& option, const OfferedByOption& offered) {
  OptionDescription d;
  if (option.get_positional()) {
    d.type = option.get_name(true);
  } else {
    for (const std::string& name : option.get_snames()) d.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) d.names.push_back("--" + name);
    const std::string type = option.get_type_name();  // "STYLE:{none,dashed,solid}" where other values are refused
    if (option.get_type_size_max() > 0) d.type = type.substr(0, type.find(":{"));
    d.refuses_others = type.find(":{") != std::string::npos;
  }
  d.group = option.get_group();
  d.help = option.get_description();
  d.default_value = option.get_default_str();
  if (const auto found = offered.find(&option); found != offered.end()) d.offered = found->second;
  d.is_required = option.get_required();
  d.is_repeated = option.get_expected_max() > 1;
  return d;
}

std::vector<OptionDescription> described_options(const CLI::App& app, const OfferedByOption& offered) {
  std::vector<OptionDescription> all;
  for (const std::string& group : app.get_groups())
    for (const CLI::Option* option :
         app.get_options([&](const CLI::Option* o) { return !group.empty() && o->get_group() == group; }))
      all.push_back(described(*option, offered));
  return all;
}

std::vector<const CLI::App*> shown_verbs(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

}  // namespace

CommandLine::CommandLine(const std::string& name, const std::string& description, const std::string& version,
                         const std::string& footer)
    : app_(std::make_unique<CLI::App>(description, name)), version_(version) {
  app_->require_subcommand(1);
  app_->set_version_flag("--version", version);
  app_->footer(footer);
}

CommandLine::~CommandLine() = default;

Options CommandLine::add_verb(const std::string& name, const std::string& description, const std::string& footer) {
  CLI::App* verb = app_->add_subcommand(name, description);
  verb->footer(footer);
  return {verb, offered_};
}

Options CommandLine::add_hidden_verb(const std::string& name, const std::string& description) {
  return {app_->add_subcommand(name, description)->group(""), offered_};
}

CommandDescription CommandLine::description() const {
  CommandDescription command{
      app_->get_name(), app_->get_description(), version_, app_->get_footer(), described_options(*app_, offered_), {}};
  for (const CLI::App* verb : shown_verbs(*app_))
    command.verbs.push_back(
        {verb->get_name(), verb->get_description(), verb->get_footer(), described_options(*verb, offered_)});
  return command;
}

void CommandLine::run(int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  const bool is_verb = !verb.empty() && verb.front() != '-';
  if (is_verb && app_->get_subcommands([&](const CLI::App* v) { return v->get_name() == verb; }).empty()) {
    const std::vector<const CLI::App*> verbs = shown_verbs(*app_);
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
