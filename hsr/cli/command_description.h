#pragma once

#include <string>
#include <vector>

/// What --help says of the command, as data: the manual page and the completion of shells are made of it.
namespace hsr::cli {

/// Values that a shell can complete.
struct OfferedValues {
  std::vector<std::string> values;
  bool is_list = false;  ///< several of them, with commas between
};

struct OptionDescription {
  std::vector<std::string> names;  ///< "-o", "--output"; none: an argument without a name
  std::string type;                ///< what stands for the value, "FILE"; empty: it takes none
  std::string group;               ///< the heading that it stands under
  std::string help;
  std::string default_value;  ///< where --help shows it
  OfferedValues offered;
  bool refuses_others = false;  ///< than the offered values
  bool is_required = false;
  bool is_repeated = false;  ///< may be given several times
};

struct VerbDescription {
  std::string name, description;
  std::string footer;  ///< "Examples:", a line for each of them, an empty line, and what else there is to say
  std::vector<OptionDescription> options;  ///< in the order of --help; those of a group follow each other
};

struct CommandDescription {
  std::string name, description, version, footer;
  std::vector<OptionDescription> options;  ///< those without a verb
  std::vector<VerbDescription> verbs;
};

}  // namespace hsr::cli
