#pragma once

#include <CLI/App.hpp>

#include "hsr/io/write/output_file.h"

namespace hsr::cli {

/// What a verb was asked to check does not hold; it has said so. Exit status 1.
struct CheckFailed {};

/// Each adds one verb to the command; its callback does the work and may throw InputError.
/// @param unfinished the files that an interrupt must remove
void add_compare(CLI::App& app, UnfinishedFiles& unfinished);
void add_draw(CLI::App& app, UnfinishedFiles& unfinished);
void add_info(CLI::App& app, UnfinishedFiles& unfinished);
void add_order(CLI::App& app, UnfinishedFiles& unfinished);
void add_stability(CLI::App& app, UnfinishedFiles& unfinished);
void add_verify(CLI::App& app, UnfinishedFiles& unfinished);

}  // namespace hsr::cli
