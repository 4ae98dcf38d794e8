#pragma once

#include "hsr/cli/command_line.h"
#include "hsr/io/write/output_file.h"

namespace hsr::cli {

using namespace internal;

/// What a verb was asked to check does not hold; it has said so. Exit status 1.
struct CheckFailed {};

/// Each adds one verb to the command; its callback does the work and may throw InputError.
/// @param unfinished the files that an interrupt must remove
void add_batch(CommandLine& command, UnfinishedFiles& unfinished);
void add_compare(CommandLine& command, UnfinishedFiles& unfinished);
void add_draw(CommandLine& command, UnfinishedFiles& unfinished);
void add_explain(CommandLine& command, UnfinishedFiles& unfinished);
void add_info(CommandLine& command, UnfinishedFiles& unfinished);
void add_join(CommandLine& command, UnfinishedFiles& unfinished);
void add_order(CommandLine& command, UnfinishedFiles& unfinished);
void add_sheet(CommandLine& command, UnfinishedFiles& unfinished);
void add_split(CommandLine& command, UnfinishedFiles& unfinished);
void add_stability(CommandLine& command, UnfinishedFiles& unfinished);
void add_tile(CommandLine& command, UnfinishedFiles& unfinished);
void add_verify(CommandLine& command, UnfinishedFiles& unfinished);

/// Verbs of the build that --help does not name: `manual` prints the manual page, `completion bash` a script for that shell.
void add_manual(CommandLine& command);

}  // namespace hsr::cli
