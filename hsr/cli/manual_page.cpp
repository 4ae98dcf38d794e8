#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>

#include "hsr/cli/manual.h"

namespace hsr::cli {

namespace {

/// As the text of a line of roff: every sign stands for itself, and lines may break after the commas of a list.
std::string roff(std::string_view text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) switch (text[k]) {
      case '\\':
        out += "\\e";
        break;
      case '-':
        out += "\\-";
        break;
      case '\'':
        out += "\\(aq";
        break;
      case '`':
        out += "\\(ga";
        break;
      case '^':
        out += "\\(ha";
        break;
      case '~':
        out += "\\(ti";
        break;
      case '.':
        out += k == 0 ? "\\&." : ".";
        break;
      case ',':
        out += k + 1 < text.size() && text[k + 1] != ' ' ? ",\\:" : ",";
        break;
      default:
        out += text[k];
    }
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string sentence(const std::string& text) { return text.empty() || text.back() == '.' ? text : text + "."; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// "-o, --output FILE", or what stands for an argument without a name.
std::string heading(const OptionDescription& option) {
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ", ") + bold(name);
  if (!option.type.empty()) text += (text.empty() ? "" : " ") + italic(option.type);
  return text + (option.is_repeated && option.names.empty() ? " ..." : "");
}

/// What --help has beside the help of an option: that it is required, the values that it takes, the default.
std::string entry(const OptionDescription& option) {
  std::string text = ".TP\n" + heading(option) + "\n" + roff(sentence(option.help));
  if (option.is_required) text += " Required.";
  if (option.refuses_others) {
    text += " Values:";
    for (const std::string& value : option.offered.values)
      text += " " + bold(value) + (value == option.offered.values.back() ? "." : ",");
  }
  if (!option.default_value.empty()) text += " Default: " + bold(option.default_value) + ".";
  return text + "\n";
}

using Group = std::vector<OptionDescription>;

std::vector<Group> groups_of(const VerbDescription& verb) {
  std::vector<Group> groups;
  for (const OptionDescription& option : verb.options) {
    if (groups.empty() || groups.back().front().group != option.group) groups.emplace_back();
    groups.back().push_back(option);
  }
  return groups;
}

std::string entries(const Group& group) {
  std::string text;
  for (const OptionDescription& option : group) text += entry(option);
  return text;
}

/// The verb whose section has the same group already; empty: there is none.
std::string earlier_verb_with(const std::string& entries_of_group, const VerbDescription& verb,
                              const std::vector<VerbDescription>& verbs) {
  for (const VerbDescription& earlier : verbs) {
    if (earlier.name == verb.name) break;
    for (const Group& group : groups_of(earlier))
      if (entries(group) == entries_of_group) return earlier.name;
  }
  return "";
}

/// A group that an earlier verb has, too, is not told again: only the names of its options.
std::string group_section(const Group& group, const VerbDescription& verb, const CommandDescription& command) {
  const std::string told = entries(group), earlier = earlier_verb_with(told, verb, command.verbs);
  const std::string head = ".SS " + roff(group.front().group) + "\n";
  if (earlier.empty() || group.size() == 1) return head + told;
  std::string names;
  for (const OptionDescription& option : group) names += (names.empty() ? "" : ", ") + heading(option);
  return head + names + ":\nas for " + bold(command.name + " " + earlier) + ".\n";
}

std::string usage(const CommandDescription& command, const VerbDescription& verb) {
  std::string text = bold(command.name + " " + verb.name) + " [" + italic("OPTIONS") + "]", arguments;
  for (const OptionDescription& option : verb.options) {
    if (option.names.empty()) arguments += " " + italic(option.type) + (option.is_repeated ? " ..." : "");
    if (!option.names.empty() && option.is_required) text += " " + bold(option.names.front()) + " " + italic(option.type);
  }
  return text + arguments + "\n";
}

/// The lines under "Examples:", each an indented command and, after two blanks, what it does.
std::string examples(const std::string& footer) {
  std::string text;
  for (const std::string& line : lines_of(footer)) {
    if (line.rfind("  ", 0) != 0) continue;
    const std::string example = line.substr(2);
    const std::size_t gap = example.find("  ");
    const std::size_t words = gap == std::string::npos ? gap : example.find_first_not_of(' ', gap);
    text += ".TP\n" + bold(example.substr(0, gap)) + "\n";
    text += words == std::string::npos ? "\\&\n" : roff(example.substr(words)) + "\n";
  }
  return text;
}

/// The rest of a footer.
std::string remarks(const std::string& footer) {
  std::string text;
  for (const std::string& line : lines_of(footer))
    if (!line.empty() && line.rfind("  ", 0) != 0 && line != "Examples:") text += roff(line) + "\n";
  return text;
}

std::string beginning(const CommandDescription& command) {
  std::string description = command.description;  // "hsr: what is visible, exactly. ..."
  if (description.rfind(command.name + ": ", 0) == 0) description.erase(0, command.name.size() + 2);
  if (!description.empty() && description.back() == '.') description.pop_back();
  std::string text = fmt::format(".\\\" Printed by '{0} manual', of what '{0} --help' says.\n", command.name);
  text += fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n.nh\n.ad l\n", upper(command.name), roff(command.version));
  text += ".SH NAME\n" + roff(command.name) + " \\- " + roff(description) + "\n.SH SYNOPSIS\n";
  for (const VerbDescription& verb : command.verbs)
    text += (&verb == &command.verbs.front() ? "" : ".br\n") + usage(command, verb);
  for (const OptionDescription& option : command.options) text += ".br\n" + bold(command.name) + " " + heading(option) + "\n";
  return text;
}

}  // namespace

std::string manual_page(const CommandDescription& command) {
  std::string text = beginning(command);
  text +=
      ".SH DESCRIPTION\nEvery decision about what hides what is exact for the numbers that the models have, however they lie.\n"
      "A verb says what is done; each has a section below.\n";
  for (const VerbDescription& verb : command.verbs)
    text += ".TP\n" + bold(verb.name) + "\n" + roff(sentence(verb.description)) + "\n";
  text += ".SH OPTIONS\nWithout a verb:\n" + entries(command.options);
  for (const VerbDescription& verb : command.verbs) {
    text += ".SH " + roff(upper(command.name + " " + verb.name)) + "\n" + roff(sentence(verb.description)) + "\n.PP\n" +
            usage(command, verb) + ".PP\n" + remarks(verb.footer);
    for (const Group& group : groups_of(verb)) text += group_section(group, verb, command);
  }
  text += ".SH EXAMPLES\n";
  for (const VerbDescription& verb : command.verbs) text += ".SS " + roff(verb.name) + "\n" + examples(verb.footer);
  const std::string status = "Exit status: ", footer = command.footer.substr(0, command.footer.find('\n'));
  text += ".SH EXIT STATUS\n" + roff(footer.rfind(status, 0) == 0 ? footer.substr(status.size()) : footer) + "\n";
  text += ".SH SEE ALSO\nconventions.md, installed in share/doc/" + roff(command.name) +
          ": what the results mean, rule by rule.\n.br\n" + bold("inkscape") + "(1), " + bold("rsvg-convert") + "(1)\n";
  return text;
}

}  // namespace hsr::cli
