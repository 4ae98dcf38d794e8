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

/// What a DXF is written with besides. @param release r12 or 2000 @param unit millimetres in a unit of the model
/// @param page_scale Drawing::scale of the page
void add_dxf(WriteOptions& options, const std::string& release, double unit, double page_scale);

/// The options for the drawing of a DXF, which is in units of the model: not the page's drawing made larger, each coordinate is
/// rounded once, to what it is in the model. The pens are then those of the page. @param page_scale as above
DrawingOptions in_model_units(DrawingOptions options, double page_scale);

}  // namespace hsr::cli
