#include "hsr/io/write/dxf.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "hsr/io/write/dashes.h"
#include "hsr/io/write/dxf_tables.h"

namespace hsr::internal {

namespace {

constexpr std::size_t most_numbers = 1000;  // extended data ends at 16 kB for an entity

/// From thousandths of the drawing to units of the model.
class ModelUnits {
 public:
  explicit ModelUnits(double scale)
      : is_large_(scale >= 1e-3), factor_(is_large_ ? std::round(scale * 1000) : std::round(1e-3 / scale)) {}
  /// Of a power of ten, one rounding: the double nearest to the decimal number.
  double operator()(std::int64_t thousandths) const {
    const auto x = static_cast<double>(thousandths);
    return is_large_ ? x / factor_ : x * factor_;
  }

 private:
  bool is_large_;
  double factor_;
};

DxfExtent extent_of(const Drawing& drawing, const ModelUnits& units) {
  if (drawing.points.empty()) return {0, 0, 1, 1};
  const auto [left, right] = std::ranges::minmax(drawing.points, {}, &PaperPoint::x);
  const auto [top, bottom] = std::ranges::minmax(drawing.points, {}, &PaperPoint::y);
  return {units(left.x), -units(bottom.y), units(right.x), -units(top.y)};
}

void append_numbers(DxfText& out, const char* name, const std::vector<std::uint32_t>& numbers) {
  out.add(1000, name);
  const std::size_t written = std::min(numbers.size(), most_numbers);
  for (std::size_t k = 0; k < written; ++k) out.add(1071, static_cast<std::int64_t>(static_cast<std::int32_t>(numbers[k])));
  if (written < numbers.size()) out.add(1000, "and " + std::to_string(numbers.size() - written) + " more");
}

/// Which edges and faces a line is of.
void append_provenance(DxfText& out, const Drawing& drawing, const Polyline& p) {
  out.add(1001, "HSR");
  std::vector<std::uint32_t> numbers;
  for (const auto& [i, j] : drawing.edges_of(p)) numbers.insert(numbers.end(), {i, j});
  append_numbers(out, "edges", numbers);
  numbers.assign(drawing.faces_of(p).begin(), drawing.faces_of(p).end());
  append_numbers(out, "faces", numbers);
  if (p.object >= drawing.objects.size() || drawing.objects[p.object].empty()) return;
  out.add(1000, "object");
  out.add(1000, dxf_string(drawing.objects[p.object]));
}

class EntityWriter {
 public:
  EntityWriter(DxfText& out, const Drawing& drawing, const ModelUnits& units, std::uint64_t owner, double page_scale)
      : out_(out), drawing_(drawing), units_(units), owner_(owner), page_scale_(page_scale) {}

  void append(const Polyline& p, const Layer& of) {
    const auto points = drawing_.points_of(p);
    const std::string layer = dxf_layer_name(of);
    pen_ = &of.pen;
    if (points.size() == 2 && !p.closed)
      append_line(p, points, layer);
    else if (out_.is_2000())
      append_light_polyline(p, points, layer);
    else
      append_polyline(p, points, layer);
  }

 private:
  void begin(const char* type, const std::string& layer, const char* subclass) {
    out_.begin(type, owner_);
    out_.add_class("AcDbEntity");
    out_.add(8, layer);
    out_.add_class(subclass);
  }
  void add_point(const PaperPoint& p, int code = 10) { out_.add_point(units_(p.x), -units_(p.y), code); }
  /// Dashes run on over the points of a curve, and begin anew at corners; DXF has no line that does both.
  std::int64_t flags(const Polyline& p, std::span<const PaperPoint> points) const {
    const bool begins_anew = pen_->is_dashed() && has_corners_only(points, p.closed);
    return (p.closed ? 1 : 0) + (begins_anew ? 0 : 128);
  }
  /// A line that is too short for two whole dashes and a gap has shorter ones, where the release can say so.
  void add_dash_scale(std::span<const PaperPoint> points) {
    if (!out_.is_2000() || !pen_->is_dashed()) return;
    const double length = std::hypot(units_(points[1].x) - units_(points[0].x), units_(points[1].y) - units_(points[0].y));
    const double wanted = std::accumulate(pen_->dashes.begin(), pen_->dashes.end(), pen_->dashes[0]) / page_scale_;
    if (length > 0 && length < wanted) out_.add_number(48, std::round(length / wanted * 1e4) / 1e4);
  }

  void append_line(const Polyline& p, std::span<const PaperPoint> points, const std::string& layer) {
    out_.begin("LINE", owner_);
    out_.add_class("AcDbEntity");
    out_.add(8, layer);
    add_dash_scale(points);
    out_.add_class("AcDbLine");
    add_point(points[0]);
    add_point(points[1], 11);
    append_provenance(out_, drawing_, p);
  }
  void append_light_polyline(const Polyline& p, std::span<const PaperPoint> points, const std::string& layer) {
    begin("LWPOLYLINE", layer, "AcDbPolyline");
    out_.add(90, static_cast<std::int64_t>(points.size()));
    out_.add(70, flags(p, points));
    for (const PaperPoint& at : points) {
      out_.add_number(10, units_(at.x));
      out_.add_number(20, -units_(at.y));
    }
    append_provenance(out_, drawing_, p);
  }
  void append_polyline(const Polyline& p, std::span<const PaperPoint> points, const std::string& layer) {
    begin("POLYLINE", layer, "");
    out_.add(66, std::int64_t{1});
    out_.add_point(0, 0);
    out_.add(70, flags(p, points));
    append_provenance(out_, drawing_, p);
    for (const PaperPoint& at : points) {
      begin("VERTEX", layer, "");
      add_point(at);
    }
    begin("SEQEND", layer, "");
  }

  DxfText& out_;
  const Drawing& drawing_;
  const ModelUnits& units_;
  std::uint64_t owner_;
  double page_scale_;
  const Pen* pen_ = nullptr;
};

}  // namespace

std::string dxf(const Drawing& drawing, const DxfOptions& options) {
  const std::vector<Layer> layers = layers_of(drawing);
  const ModelUnits units(drawing.scale);
  const DxfExtent extent = extent_of(drawing, units);
  DxfText body(options.version);
  const double dash_unit = drawing.pens.wide() / 2;  // narrow lines' width, so that ISO 128's dashes are 12 long
  const std::uint64_t model = append_dxf_tables(body, layers, dash_unit, extent);
  body.add(0, "SECTION");
  body.add(2, "ENTITIES");
  EntityWriter writer(body, drawing, units, model, options.page_scale);
  for (const Layer& layer : layers)
    for (const Polyline& p : layer.polylines) writer.append(p, layer);
  body.add(0, "ENDSEC");
  append_dxf_objects(body);
  body.add(0, "EOF");
  DxfText out(options.version);
  append_dxf_header(out, extent, options, dash_unit, body.next_handle());
  return out.text + body.text;
}

}  // namespace hsr::internal
