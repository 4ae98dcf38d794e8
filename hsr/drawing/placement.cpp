#include "hsr/drawing/placement.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/error.h"
#include "hsr/drawing/standard_scale.h"

namespace hsr {

using namespace internal;

namespace {

using Wide = Enclosure::Wide;

constexpr double widest_drawing = 1e9;  // mm
constexpr int kept_bits = 20;  // of the scale and, beside the size, of the centre: so that no last bit shows in a picture

/// A number of few bits: mantissa 2^exponent, for what may lie beyond the doubles.
Rational round_down(Wide x) {
  if (!(x > 0) || !std::isfinite(x)) return 0.0;
  int exponent = 0;
  const Wide mantissa = std::frexp(x, &exponent);
  return Rational(static_cast<double>(std::floor(std::ldexp(mantissa, kept_bits)))) * power_of_two(exponent - kept_bits);
}

/// The nearest multiple of a small part of `size`.
Rational round_centre(Wide x, Wide size) {
  if (!(size > 0)) size = std::fabs(x);
  if (!(size > 0)) return 0.0;
  int exponent = 0;
  std::frexp(size, &exponent);
  const Wide multiple = std::round(std::ldexp(x, kept_bits - exponent));
  int e = 0;
  const double mantissa = static_cast<double>(std::frexp(multiple, &e));
  return Rational(mantissa) * power_of_two(e + exponent - kept_bits);
}

struct Box {
  Wide low[2] = {HUGE_VALL, HUGE_VALL}, high[2] = {-HUGE_VALL, -HUGE_VALL};
  bool is_empty() const { return low[0] > high[0]; }
  Wide size(int k) const { return is_empty() ? 0 : high[k] - low[k]; }
  Wide centre(int k) const { return is_empty() ? 0 : low[k] / 2 + high[k] / 2; }
  void add(const Box& box) {
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], box.low[k]);
      high[k] = std::max(high[k], box.high[k]);
    }
  }
  void add(int k, Wide x) {
    low[k] = std::min(low[k], x);
    high[k] = std::max(high[k], x);
  }
};

Wide wide(const Rational& x) { return enclose(x).middle; }

/// Whether the error is far below the place to which the box is rounded. Where planes meet at an angle of some ulps it is not.
bool is_known(const Enclosure (&p)[2]) {
  const Wide most = std::max(std::fabs(p[0].middle), std::fabs(p[1].middle));
  return p[0].is_finite() && p[1].is_finite() && p[0].error <= most * 0x1p-48 && p[1].error <= most * 0x1p-48;
}

/// Tells which lines lie certainly within a box, without enclosures: most of them do once it has grown.
class InnerLines {
 public:
  explicit InnerLines(const Projection& projection)
      : projection_(projection), rows_(projection.rounded_rows()), is_parallel_(projection.view().viewpoint.is_direction) {}

  /// Whether the box holds all of a line, certainly.
  bool holds(const Box& box, const Line& line) const {
    if (line.is_intersection()) return false;
    const Edge& edge = projection_.mesh().edges[line.edge];
    return is_within(box, edge.a) && is_within(box, edge.b);
  }

 private:
  /// Doubles are off by less than 32 u of the sum of the terms' sizes: each row and each difference by u, each term by five more
  /// roundings. By far less than 2^-30 of it, and so is the middle of an enclosure that add_line() takes.
  bool is_within(const Box& box, VertexId v) const {
    const Point3 &p = projection_.mesh().points[v], &o = projection_.anchor();
    const std::array<double, 4> d = {p.x - o.x, p.y - o.y, p.z - o.z, 1};
    const auto row = [&](std::size_t i) {
      double x = 0, size = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        x += rows_[i][k] * d[k];
        size += std::fabs(rows_[i][k] * d[k]);
      }
      return std::pair(x, size * 0x1p-30 + 0x1p-1000);
    };
    double w = 1;
    if (!is_parallel_) {
      const auto [x, off] = row(2);
      if (!(x > 1024 * off)) return false;
      w = x;
    }
    const std::array<std::pair<double, double>, 2> xy = {row(0), row(1)};
    const double most = std::max(std::fabs(xy[0].first), std::fabs(xy[1].first)), off = std::max(xy[0].second, xy[1].second);
    // In perspective w is off by its part, too.
    const double by = is_parallel_ ? off : (off + 0x1p-10 * most) / w * 1.01;
    for (std::size_t k = 0; k < 2; ++k) {
      const double at = xy[k].first / w;
      if (!(at - by > static_cast<double>(box.low[k]) && at + by < static_cast<double>(box.high[k]))) return false;
    }
    return true;
  }

  const Projection& projection_;
  std::array<std::array<double, 4>, 3> rows_;
  bool is_parallel_;
};

void add_line(Box& box, const Projection& projection, const VisibleLines& lines, const Line& line) {
  const SupportingLine support = supporting_line_of(projection.mesh(), lines, line);
  for (const std::uint32_t cut : {line.first_cut, line.end_cut - 1}) {
    const HomogeneousPoint h = projection.at(support, lines.cuts[cut]);
    const Enclosure p[2] = {h.x / h.w, h.y / h.w};
    if (is_known(p)) {
      for (int k = 0; k < 2; ++k) box.add(k, p[k].middle);
    } else {
      const auto exact = projection.exact(support, lines.cuts[cut]);
      for (std::size_t k = 0; k < 2; ++k) box.add(static_cast<int>(k), wide(exact[k]));
    }
  }
}

/// The box of the images of the ends of all lines, in units of the frame.
Box box_of(const Projection& projection, const VisibleLines& lines, std::span<const std::uint32_t> drawn) {
  const InnerLines inner(projection);
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, drawn.size(), 1024), Box{},
      [&](const auto& range, Box box) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          if (const Line& line = lines.lines[drawn[i]]; !inner.holds(box, line)) add_line(box, projection, lines, line);
        return box;
      },
      [](Box a, const Box& b) {
        a.add(b);
        return a;
      });
}

/// The caps of a section may reach beyond all lines, where only smooth edges are cut.
void add_caps(Box& box, const Projection& projection, const Section& section) {
  for (const std::array<Rational, 3>& p : section.rings.values()) {
    const auto at = projection.exact(p);
    for (std::size_t k = 0; k < 2; ++k) box.add(static_cast<int>(k), wide(at[k]));
  }
}

/// The box by 45 bits: points whose images coincide in an extreme are enclosed a last place apart, and which of them are drawn must not
/// decide where the centre is rounded to.
Box rounded(Box box) {
  if (box.is_empty()) return box;
  Wide most = 0;
  for (int k = 0; k < 2; ++k) most = std::max({most, box.size(k), std::fabs(box.low[k]), std::fabs(box.high[k])});
  if (!(most > 0) || !std::isfinite(most)) return box;
  constexpr int bits = 45;
  int exponent = 0;
  std::frexp(most * (1 + std::ldexp(Wide{1}, -bits)), &exponent);
  const auto nearest = [&](Wide x) { return std::ldexp(std::round(std::ldexp(x, bits - exponent)), exponent - bits); };
  for (int k = 0; k < 2; ++k) {
    box.low[k] = nearest(box.low[k]);
    box.high[k] = nearest(box.high[k]);
  }
  return box;
}

/// Of the lines, the first that has an end of its edge, and so a point in front of the eye.
std::optional<std::uint32_t> anchor_line(const VisibleLines& lines, std::span<const std::uint32_t> drawn) {
  for (const std::uint32_t i : drawn) {
    const Line& line = lines.lines[i];
    if (line.is_intersection()) continue;
    if (lines.cuts[line.first_cut].kind == Cut::Kind::start || lines.cuts[line.end_cut - 1].kind == Cut::Kind::end) return i;
  }
  return {};
}

/// A point in front of the eye.
Point3 anchor_of(const Mesh& mesh, const View& view, const VisibleLines& lines, std::span<const std::uint32_t> drawn) {
  const auto i = anchor_line(lines, drawn);
  if (!i) return view.frame.origin;
  const Edge& edge = mesh.edges[lines.lines[*i].edge];
  return mesh.points[lines.cuts[lines.lines[*i].first_cut].kind == Cut::Kind::start ? edge.a : edge.b];
}

/// The same of a drawing without hidden lines: the first vertex that is seen. Which hidden edges are listed, too, is told by whole bodies,
/// and the centre is rounded from here.
Point3 visible_anchor_of(const Mesh& mesh, const View& view, const VisibleLines& lines, std::span<const std::uint32_t> drawn) {
  for (const std::uint32_t i : drawn) {
    const Line& line = lines.lines[i];
    if (line.is_intersection()) continue;
    const Edge& edge = mesh.edges[line.edge];
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (line.hidden(k)) continue;
      if (lines.cuts[line.first_cut + k].kind == Cut::Kind::start) return mesh.points[edge.a];
      if (lines.cuts[line.first_cut + k + 1].kind == Cut::Kind::end) return mesh.points[edge.b];
    }
  }
  return view.frame.origin;
}

/// Half the angle's tangent times the distance of the frame.
Wide half_of_frame(const View& view, double degrees) {
  if (!(degrees > 0) || !(degrees < 180))
    throw InputError("fov: found " + std::to_string(degrees) + " degrees, expected an angle between 0 and 180");
  const Point3 &o = view.frame.origin, &e = view.viewpoint.at;
  const Wide distance = std::hypot(static_cast<Wide>(o.x) - e.x, static_cast<Wide>(o.y) - e.y, static_cast<Wide>(o.z) - e.z);
  return distance * std::tan(static_cast<Wide>(degrees) * (std::numbers::pi_v<Wide> / 360));
}

/// Half the picture, in units of the frame; it has the proportions of the drawing area, its shorter side the field of view.
struct HalfPicture {
  Wide width, height;
};

HalfPicture half_picture(const View& view, const Page& page, double degrees) {
  const Wide half = half_of_frame(view, degrees);
  const Wide area_width = page.width - 2 * page.margin, area_height = page.height - 2 * page.margin;
  const Wide shorter = std::min(area_width, area_height);
  return {half * (area_width / shorter), half * (area_height / shorter)};
}

/// The page, turned as the picture wants it.
Page framed_page(Page page) {
  if (page.fits || (page.turns && page.height > page.width)) std::swap(page.width, page.height);
  return page;
}

void check_margin(const Page& page) {
  if (!(page.width > 2 * page.margin) || !(page.height > 2 * page.margin) || !(page.margin >= 0))
    throw InputError("margin: found " + std::to_string(page.margin) + " mm, expected 0 or more, and less than half the page");
}

/// The lesser of the two ratios of area to size; where there is no size, 1.
Wide fitting(Wide width, Wide height, Wide area_width, Wide area_height) {
  const Wide x = width > 0 ? area_width / width : HUGE_VALL, y = height > 0 ? area_height / height : HUGE_VALL;
  const Wide scale = std::min(x, y);
  return std::isfinite(scale) ? scale : 1;
}

/// 10^k that makes the larger side 1000 or more, and less than 10 000; 1 where there is no side.
Rational decimal_scale(Wide size) {
  Rational scale = 1.0;
  if (!(size > 0) || !std::isfinite(size)) return scale;
  const Rational ten = 10.0;
  for (; size < 1000; size *= 10) scale = scale * ten;
  for (; size >= 10000; size /= 10) scale = scale / ten;
  return scale;
}

/// The frame's origin at (0, 0), no page around it.
Placement in_frame_units(Placement result, const View& view, Wide width, Wide height, bool framed) {
  const Rational scale = decimal_scale(std::max(width, height));
  result.scale = static_cast<double>(wide(scale));
  result.width = std::max(1.0, static_cast<double>(width * wide(scale)));
  result.height = std::max(1.0, static_cast<double>(height * wide(scale)));
  result.projection.place(result.projection.relative(view.frame.origin), scale, 0, 0);
  if (framed) result.frame = PaperFrame{-result.width / 2, -result.height / 2, result.width / 2, result.height / 2};
  return result;
}

/// The frame's origin where it is asked for.
Placement at_origin(Placement result, const View& view, const DrawingOptions& options) {
  const Rational scale = Rational(options.scale.value_or(1)) * Rational(options.unit);
  result.scale = static_cast<double>(wide(scale));
  result.width = options.page.width;
  result.height = options.page.height;
  result.projection.place(result.projection.relative(view.frame.origin), scale, options.origin_at->x, options.origin_at->y);
  return result;
}

}  // namespace

std::optional<FrameSize> frame_size(const View& view, const DrawingOptions& options) {
  if (!options.field_of_view || !view.is_perspective()) return {};
  check_margin(options.page);
  const HalfPicture half = half_picture(view, framed_page(options.page), *options.field_of_view);
  return FrameSize{static_cast<double>(half.width), static_cast<double>(half.height)};
}

std::vector<std::uint32_t> internal::bounding_lines(const Mesh& mesh, const View& view, const VisibleLines& lines,
                                                    std::span<const std::uint32_t> drawn) {
  const Projection projection(mesh, view, anchor_of(mesh, view, lines, drawn));
  Box all;
  std::array<std::optional<std::uint32_t>, 5> farthest;
  farthest[4] = anchor_line(lines, drawn);
  const InnerLines inner(projection);
  for (const std::uint32_t i : drawn) {
    if (inner.holds(all, lines.lines[i])) continue;
    Box one;
    add_line(one, projection, lines, lines.lines[i]);
    for (int k = 0; k < 2; ++k) {
      const std::size_t at = 2 * static_cast<std::size_t>(k);
      if (one.low[k] < all.low[k]) farthest[at] = i;
      if (one.high[k] > all.high[k]) farthest[at + 1] = i;
    }
    all.add(one);
  }
  std::vector<std::uint32_t> found;
  for (const auto& i : farthest)
    if (i) found.push_back(*i);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Placement internal::placement(const Mesh& mesh, const View& view, const VisibleLines& lines,
                              std::span<const std::uint32_t> drawn, const DrawingOptions& options) {
  const Point3 anchor =
      options.hidden == HiddenLines::none ? visible_anchor_of(mesh, view, lines, drawn) : anchor_of(mesh, view, lines, drawn);
  Placement result{Projection(mesh, view, anchor), 0, 0, 1, true, {}};
  const bool framed = options.field_of_view && view.is_perspective();
  Page page = options.page;
  check_margin(page);

  Wide width = 0, height = 0;
  std::array<Rational, 2> centre;
  if (framed) {
    page = framed_page(page);
    const HalfPicture half = half_picture(view, page, *options.field_of_view);
    width = 2 * half.width;
    height = 2 * half.height;
    centre = result.projection.relative(view.frame.origin);
  } else {
    Box all = box_of(result.projection, lines, drawn);
    if (options.section != nullptr) add_caps(all, result.projection, *options.section);
    const Box box = rounded(all);
    width = box.size(0);
    height = box.size(1);
    for (int k = 0; k < 2; ++k) centre[static_cast<std::size_t>(k)] = round_centre(box.centre(k), std::max(width, height));
    // A square stays upright, whatever the last place of its sides says.
    const bool is_wide = width - height > 1e-9L * std::max(width, height);
    if ((page.turns || page.fits) && is_wide != (page.width > page.height)) std::swap(page.width, page.height);
  }

  if (options.origin_at) return at_origin(std::move(result), view, options);
  if (options.in_frame_units) return in_frame_units(std::move(result), view, width, height, framed);

  const Wide area_width = page.width - 2 * page.margin, area_height = page.height - 2 * page.margin;
  const auto chosen = options.scale ? options.scale
                      : options.standard_scale
                          ? std::optional(standard_scale(fitting(width, height, area_width, area_height) / options.unit))
                          : std::nullopt;
  const Rational scale =
      chosen ? Rational(*chosen) * Rational(options.unit) : round_down(fitting(width, height, area_width, area_height));
  const Wide drawn_width = width * wide(scale), drawn_height = height * wide(scale);
  if (!(drawn_width <= widest_drawing) || !(drawn_height <= widest_drawing))
    throw InputError("scale: the drawing would be more than 1e9 mm wide; expected a smaller scale, or fit");
  if (page.fits) {
    // Whole thousandths of a millimetre, and never without an extent.
    const auto side = [&](Wide x) { return std::max(1.0, static_cast<double>(std::ceil(x * 1000)) / 1000 + 2 * page.margin); };
    page.width = side(drawn_width);
    page.height = side(drawn_height);
  }
  // What was fitted fits; the rounded centre may be off by a millionth.
  result.fits = !options.scale || page.fits || (drawn_width <= page.width && drawn_height <= page.height);
  result.width = page.width;
  result.height = page.height;
  result.scale = static_cast<double>(wide(scale));
  const double x = page.width / 2, y = page.height / 2;
  result.projection.place(centre, scale, x, y);
  if (framed) {
    const auto half_width = static_cast<double>(drawn_width / 2), half_height = static_cast<double>(drawn_height / 2);
    result.frame = PaperFrame{x - half_width, y - half_height, x + half_width, y + half_height};
  }
  return result;
}

}  // namespace hsr
