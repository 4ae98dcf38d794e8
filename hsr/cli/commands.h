#pragma once

#include <CLI/App.hpp>

#include "hsr/write/output_file.h"

namespace hsr::cli {

/// Each adds one verb to the command; its callback does the work and may throw InputError.
/// @param unfinished the files that an interrupt must remove
void add_draw(CLI::App& app, UnfinishedFiles& unfinished);
void add_info(CLI::App& app, UnfinishedFiles& unfinished);

}  // namespace hsr::cli
