#pragma once

#include <optional>
#include <string>

#include "hsr/io/write/format.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "hsr/io/write/write.h"

namespace hsr::cli {

/// What a page is written with in that format: the captions, and after them the scale, in the description of an SVG and in the title
/// of other formats.
/// @param scale as scale_in_title() has it @param size PNG; nothing: 150 dots to the inch
WriteOptions page_options(internal::Format format, const internal::SvgOptions& captions, const std::string& scale,
                          const std::optional<internal::PixelSize>& size);

}  // namespace hsr::cli
