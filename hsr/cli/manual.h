#pragma once

#include <string>

#include "hsr/cli/command_description.h"

/// What the build makes of the declared options beside --help. Neither has a date in it: the same options give the same bytes.
namespace hsr::cli {

/// The manual page, for the macros `man` of roff.
std::string manual_page(const CommandDescription& command);

/// A script that completes verbs, options, the values that they have, and names of files. It is for bash; zsh reads it, too, after
/// `autoload -U bashcompinit && bashcompinit`.
std::string bash_completion(const CommandDescription& command);

}  // namespace hsr::cli
