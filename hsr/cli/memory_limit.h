#pragma once

#include <string>

namespace hsr::cli {

/// Makes what does not fit into the memory of this machine, or of its control group, fail in an allocation, so that it can be
/// refused. Otherwise Linux hands out more than there is, and then kills the process without a word.
void limit_memory_to_what_there_is();

/// Makes memory that is freed stay with the process, for the next stage: the system clears every page that it hands out anew.
void keep_freed_memory();

/// For one whose scene did not fit: how much there is, and what would need less.
std::string out_of_memory();

}  // namespace hsr::cli
