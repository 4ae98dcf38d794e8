#pragma once

#include <span>
#include <string>

namespace hsr::internal {

/// What a result can be written as; tex: LaTeX with TikZ; csv: the table of error against run time.
enum class Format { svg, pdf, eps, dxf, tex, hpgl, png, json, csv };

const char* name_of(Format format);  ///< "svg"

/// The format that a file name's ending chooses, one of those expected.
/// The ending .plt means hpgl, too.
/// @throws InputError for another ending
Format format_of(const std::string& path, std::span<const Format> expected);

/// The format of that name, "svg", one of those expected. @param said what the message begins with
/// @throws InputError as format_of() does
Format format_named(const std::string& name, const std::string& said, std::span<const Format> expected);

}  // namespace hsr::internal
