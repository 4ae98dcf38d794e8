#include <fmt/format.h>

#include <string>

#include "hsr/cli/manual.h"

namespace hsr::cli {

namespace {

bool is_file(const OptionDescription& option) {
  return option.type == "FILE" || (option.names.empty() && option.type.find("MODEL") != std::string::npos);
}

/// What completes the value of an option, as a command of the shell.
std::string action(const OptionDescription& option) {
  const std::string values = fmt::format("{}", fmt::join(option.offered.values, " "));
  if (!values.empty()) return fmt::format("{} '{}'", option.offered.is_list ? "_hsr_list" : "_hsr_words", values);
  return is_file(option) ? "_hsr_paths -f" : option.type == "DIR" ? "_hsr_paths -d" : ":";
}

std::string all_names(const std::vector<OptionDescription>& options) {
  std::string text;
  for (const OptionDescription& option : options)
    for (const std::string& name : option.names) text += (text.empty() ? "" : " ") + name;
  return text;
}

/// The function of one verb: the value of the option before it, or else the name of an option or an argument without one.
std::string verb_function(const VerbDescription& verb) {
  std::string text = fmt::format("_hsr_{}() {{\n  case $before in\n", verb.name), argument = ":";
  for (const OptionDescription& option : verb.options) {
    if (option.names.empty()) argument = action(option);
    if (option.names.empty() || option.type.empty()) continue;
    text += fmt::format("    {}) {} ;;\n", fmt::join(option.names, " | "), action(option));
  }
  return text + fmt::format("    *) if [[ $cur == -* ]]; then _hsr_words '{}'; else {}; fi ;;\n  esac\n}}\n\n",
                            all_names(verb.options), argument);
}

const char* const beginning = R"(# Completion of hsr for bash, printed by 'hsr completion bash'.
# zsh reads it after: autoload -U bashcompinit && bashcompinit

_hsr_words() {
  COMPREPLY=($(compgen -W "$1" -- "$cur"))
}

# The last of several words with commas between.
_hsr_list() {
  local head=
  [[ $cur == *,* ]] && head=${cur%,*},
  COMPREPLY=($(compgen -P "$head" -W "$1" -- "${cur##*,}"))
}

_hsr_paths() {
  local IFS=$'\n'
  COMPREPLY=($(compgen "$1" -- "$cur"))
  compopt -o filenames 2>/dev/null || true
}

)";

/// Where bash has parted `--hidden=dashed` in three, the option is two words before.
const char* const end = R"(_hsr() {
  local cur=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  if [[ $cur == = ]]; then
    cur=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  if ((COMP_CWORD == 1)); then
    _hsr_words '%WORDS%'
    return
  fi
  case ${COMP_WORDS[1]} in
    %VERBS%) "_hsr_${COMP_WORDS[1]}" ;;
  esac
}

complete -F _hsr hsr
)";

}  // namespace

std::string bash_completion(const CommandDescription& command) {
  std::string text = beginning, words, verbs;
  for (const VerbDescription& verb : command.verbs) {
    text += verb_function(verb);
    words += verb.name + " ";
    verbs += (verbs.empty() ? "" : " | ") + verb.name;
  }
  text += end;
  const auto put = [&](const std::string& mark, const std::string& what) { text.replace(text.find(mark), mark.size(), what); };
  put("%WORDS%", words + all_names(command.options));
  put("%VERBS%", verbs);
  return text;
}

}  // namespace hsr::cli
