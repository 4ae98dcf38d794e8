#pragma once

#include <string>

namespace hsr {

/// What a file of lines can be written as.
enum class Format { svg, png, json };

/// The format that a file name's ending chooses.
/// @throws InputError for another ending; for pdf, eps, dxf and tex it says that they come in a later release
Format format_of(const std::string& path);

}  // namespace hsr
