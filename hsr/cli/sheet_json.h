#pragma once

#include "hsr/cli/json_value.h"
#include "hsr/sheet/sheet.h"

namespace hsr::cli {

/// Where everything on a sheet is, for programs that add to it: the views with their frames, origins and scales, dimensions, the frame and
/// the title block; mm of the page, y down.
JsonValue json_of(const Sheet& sheet, const SheetOptions& options);

/// A file of the fields of the title block, {"title": "Bracket", "owner": ...}, put into `fields`.
/// @param name of the file, for errors @throws InputError for what is no object of texts, or has a field that is unknown
void read_title_block(const std::string& contents, const std::string& name, TitleBlock& fields);

/// One field, "title=Bracket". @throws InputError
void set_title_field(const std::string& text, TitleBlock& fields);

}  // namespace hsr::cli
