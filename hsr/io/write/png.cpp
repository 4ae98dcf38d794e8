#include "hsr/io/write/png.h"

#include <cairo.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

#include "geometry/error.h"
#include "hsr/io/write/dashes.h"
#include "hsr/io/write/layers.h"

namespace hsr::internal {

namespace {

struct Destroy {
  void operator()(cairo_t* c) const { cairo_destroy(c); }
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};

void expect_success(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw InputError(std::string("png: ") + cairo_status_to_string(status));
}

cairo_status_t append(void* out, const unsigned char* bytes, unsigned int n) {
  try {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(bytes), n);
  } catch (...) {
    return CAIRO_STATUS_NO_MEMORY;
  }
  return CAIRO_STATUS_SUCCESS;
}

constexpr int widest = 32767;  // cairo's limit
constexpr double widest_default = 16384;
constexpr double dots_per_mm = 150 / 25.4;

PixelSize default_size(const Drawing& drawing) {
  const double scale = std::min(dots_per_mm, widest_default / std::max(drawing.width, drawing.height));
  const auto pixels = [&](double mm) { return std::max(1, static_cast<int>(std::lround(mm * scale))); };
  return {pixels(drawing.width), pixels(drawing.height)};
}

void add_ring(cairo_t* c, std::span<const PaperPoint> ring) {
  cairo_new_sub_path(c);  // closing a path leaves its first point as the current one, from which a line would begin
  for (const PaperPoint& p : ring) cairo_line_to(c, static_cast<double>(p.x) / 1000, static_cast<double>(p.y) / 1000);
  cairo_close_path(c);
}

void draw_line(cairo_t* c, std::span<const PaperPoint> points, bool closed) {
  for (const PaperPoint& p : points) cairo_line_to(c, static_cast<double>(p.x) / 1000, static_cast<double>(p.y) / 1000);
  if (closed) cairo_close_path(c);
  cairo_stroke(c);
}

void paint_fills(cairo_t* c, const Fills& fills, const Pens& pens) {
  cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
  double opacity_of_sheet = 1;
  for_each_painted(
      fills,
      [&](std::span<const Fill> sheet) {
        opacity_of_sheet = sheet[0].opacity;
        cairo_push_group(c);
      },
      [&](const Fill& fill, double opacity) {
        cairo_set_source_rgba(c, fill.colour[0] / 255.0, fill.colour[1] / 255.0, fill.colour[2] / 255.0, opacity);
        for (std::uint32_t r = fill.first_ring; r < fill.end_ring; ++r) add_ring(c, fills.rings[r]);
        cairo_fill(c);
      },
      [&] {
        cairo_pop_group_to_source(c);
        cairo_paint_with_alpha(c, opacity_of_sheet);
      },
      [&](const FillLine& line) {
        const Pen& pen = pens.of(false, line.edge_class);
        cairo_set_source_rgb(c, pen.colour[0] / 255.0, pen.colour[1] / 255.0, pen.colour[2] / 255.0);
        cairo_set_line_width(c, pen.width);
        draw_line(c, fills.points_of(line), line.closed);
      });
}

void add_path(cairo_t* c, const Path& path, double tolerance) {
  const auto line = [&](const PaperPoint& p) {
    cairo_line_to(c, static_cast<double>(p.x) / 1000, static_cast<double>(p.y) / 1000);
  };
  cairo_new_sub_path(c);
  for_each_part(path, line, line, [&](const PathPart& arc) {
    for (const Bezier& curve : beziers(arc, tolerance))
      cairo_curve_to(c, curve.first.x, curve.first.y, curve.second.x, curve.second.y, static_cast<double>(curve.to.x) / 1000,
                     static_cast<double>(curve.to.y) / 1000);
  });
  if (path.closed) cairo_close_path(c);
}

void draw_layer(cairo_t* c, const Drawing& drawing, const Layer& layer) {
  const Pen& pen = layer.pen;
  cairo_set_source_rgb(c, pen.colour[0] / 255.0, pen.colour[1] / 255.0, pen.colour[2] / 255.0);
  cairo_set_line_width(c, pen.width);
  cairo_set_line_cap(c, pen.is_dashed() ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
  for (const Polyline& p : layer.polylines) {
    const Path path = path_of(drawing, p);
    if (pen.is_dashed())
      for (const Path& dash : dashes_of(dashed_path(path, pen))) add_path(c, dash, drawing.arc_tolerance);
    else
      add_path(c, path, drawing.arc_tolerance);
    cairo_stroke(c);
  }
}

}  // namespace

PixelSize parse_size(const std::string& text) {
  PixelSize size;
  const char *begin = text.data(), *end = begin + text.size();
  const auto [x, first] = std::from_chars(begin, end, size.width);
  if (first == std::errc{} && x != end && *x == 'x') {
    const auto [rest, second] = std::from_chars(x + 1, end, size.height);
    if (second == std::errc{} && rest == end && size.width > 0 && size.height > 0 && size.width <= widest &&
        size.height <= widest)
      return size;
  }
  throw InputError("size: found \"" + text + "\", expected pixels like 1600x1200, at most 32767 either way");
}

std::string png(const Drawing& drawing, std::optional<PixelSize> size) {
  const PixelSize pixels = size ? *size : default_size(drawing);
  const std::unique_ptr<cairo_surface_t, Destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height));
  expect_success(cairo_surface_status(surface.get()));
  const std::unique_ptr<cairo_t, Destroy> c(cairo_create(surface.get()));
  cairo_set_source_rgb(c.get(), 1, 1, 1);
  cairo_paint(c.get());
  cairo_set_source_rgb(c.get(), 0, 0, 0);
  const double scale = std::min(pixels.width / drawing.width, pixels.height / drawing.height);
  cairo_translate(c.get(), (pixels.width - scale * drawing.width) / 2, (pixels.height - scale * drawing.height) / 2);
  cairo_scale(c.get(), scale, scale);
  cairo_set_line_join(c.get(), CAIRO_LINE_JOIN_ROUND);
  paint_fills(c.get(), drawing.fills, drawing.pens);
  cairo_set_source_rgb(c.get(), 0, 0, 0);
  for (const Layer& layer : layers_of(drawing)) draw_layer(c.get(), drawing, layer);
  expect_success(cairo_status(c.get()));
  std::string out;
  expect_success(cairo_surface_write_to_png_stream(surface.get(), append, &out));
  return out;
}

}  // namespace hsr::internal
