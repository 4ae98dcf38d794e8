#include "hsr/cli/page_writing.h"

namespace hsr::cli {

using namespace internal;

WriteOptions page_options(Format format, const SvgOptions& captions, const std::string& scale,
                          const std::optional<PixelSize>& size) {
  WriteOptions options;
  options.title = format == Format::svg ? captions.title : captions.title + scale;
  options.description = captions.description + scale;
  options.id_prefix = captions.id_prefix;
  if (size) {
    options.width = size->width;
    options.height = size->height;
  }
  return options;
}

void add_dxf(WriteOptions& options, const std::string& release, double unit, double page_scale) {
  options.is_dxf_2000 = release == "2000";
  options.unit = unit;
  options.page_scale = page_scale;
}

DrawingOptions in_model_units(DrawingOptions options, double page_scale) {
  options.in_frame_units = true;
  options.min_length /= page_scale;
  options.fit_arcs /= page_scale;
  options.hatch_scale = page_scale;
  return options;
}

}  // namespace hsr::cli
