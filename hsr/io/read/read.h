#pragma once

#include <string>
#include <string_view>

#include "hsr/model.h"

namespace hsr {

/// The model in a file: OBJ, OFF family, PLY, STL, each also gzipped, glTF and GLB. Decimal numbers are rounded correctly.
///
/// The format is told by the content where the content says it, else by the ending.
/// @throws InputError in one line: the file, the line or index, what was found and what was expected. Nothing is allocated by a
///   count that the file's size has not confirmed.
Model read_model(const std::string& path);

/// The model in the bytes of a file in memory; `name` is used like a path: for its ending, in messages, and to find the files
/// that the model names.
Model read_model(const std::string& name, std::string_view bytes);

}  // namespace hsr
