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

}  // namespace hsr::cli
