#pragma once

#include <span>
#include <string>

namespace hsr::internal {

/// What a result can be written as; csv: the table of error against run time.
enum class Format { svg, png, json, csv };

/// The format that a file name's ending chooses, one of those expected.
/// @throws InputError for another ending; for pdf, eps, dxf and tex it says that they come in a later release
Format format_of(const std::string& path, std::span<const Format> expected);

/// The format of that name, "svg", one of those expected. @param said what the message begins with
/// @throws InputError as format_of() does
Format format_named(const std::string& name, const std::string& said, std::span<const Format> expected);

}  // namespace hsr::internal
