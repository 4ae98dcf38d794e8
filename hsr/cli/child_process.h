#pragma once

#include <string>
#include <vector>

namespace hsr::cli {

/// How a program that was run ended.
struct Ended {
  int status = 0;     ///< its exit status; 128 and more: of a signal, as a shell has it
  std::string error;  ///< what it wrote to standard error, the beginning of it
};

/// Runs a program to its end, without standard input and output.
/// @param words its path, then its arguments @throws InputError where it cannot be started
Ended run_program(const std::vector<std::string>& words);

/// The path of this program.
std::string own_path();

}  // namespace hsr::cli
