#include "hsr/io/write/write.h"

#include <array>
#include <optional>

#include "hsr/io/write/dxf.h"
#include "hsr/io/write/eps.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/hpgl.h"
#include "hsr/io/write/image_png.h"
#include "hsr/io/write/pdf.h"
#include "hsr/io/write/png.h"
#include "hsr/io/write/svg.h"
#include "hsr/io/write/tikz.h"

namespace hsr {

using namespace internal;

namespace {

SvgOptions captions(const WriteOptions& options) {
  SvgOptions captions;
  captions.title = options.title;
  captions.description = options.description;
  captions.id_prefix = options.id_prefix;
  return captions;
}

std::optional<PixelSize> size(const WriteOptions& options) {
  if (options.width == 0 && options.height == 0) return std::nullopt;
  return parse_size(std::to_string(options.width) + "x" + std::to_string(options.height));
}

}  // namespace

std::string written(const Drawing& drawing, const std::string& format, const WriteOptions& options) {
  constexpr std::array formats = {Format::svg, Format::pdf, Format::eps, Format::dxf, Format::tex, Format::hpgl, Format::png};
  switch (format_named(format, "written", formats)) {
    case Format::pdf:
      return pdf(drawing, options.title);
    case Format::eps:
      return eps(drawing, options.title);
    case Format::dxf:
      return dxf(drawing, {options.is_dxf_2000 ? DxfVersion::r2000 : DxfVersion::r12, options.unit, options.page_scale});
    case Format::tex:
      return tikz(drawing);
    case Format::hpgl:
      return hpgl(drawing);
    case Format::png:
      return png(drawing, size(options));
    default:
      return svg(drawing, captions(options));
  }
}

std::string written(const Image<Colour>& image) { return image_png(image); }

}  // namespace hsr
