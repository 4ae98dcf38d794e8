#pragma once

#include <fmt/core.h>

#include <cstdio>
#include <string>
#include <utility>

namespace hsr::cli {

/// Writes a message to standard error. A message that cannot be written is no reason to die: it is lost. (fmt::print throws.)
template <class... Arguments>
void tell(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...);
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
}

/// Sees to it that no file that is opened later becomes standard input, output or error, where the caller closed one of them.
/// The closed ones are filled so that using them still fails. Call it before anything is opened.
void reserve_standard_streams();

}  // namespace hsr::cli
