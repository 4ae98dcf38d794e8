#include "hsr/io/write/dxf.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

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
}

class EntityWriter {
 public:
  EntityWriter(DxfText& out, const Drawing& drawing, const ModelUnits& units, std::uint64_t owner)
      : out_(out), drawing_(drawing), units_(units), owner_(owner) {}

  void append(const Polyline& p, const std::string& layer) {
    const auto points = drawing_.points_of(p);
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
  /// Dashes run on over the corners.
  static std::int64_t flags(const Polyline& p) { return (p.closed ? 1 : 0) + 128; }

  void append_line(const Polyline& p, std::span<const PaperPoint> points, const std::string& layer) {
    begin("LINE", layer, "AcDbLine");
    add_point(points[0]);
    add_point(points[1], 11);
    append_provenance(out_, drawing_, p);
  }
  void append_light_polyline(const Polyline& p, std::span<const PaperPoint> points, const std::string& layer) {
    begin("LWPOLYLINE", layer, "AcDbPolyline");
    out_.add(90, static_cast<std::int64_t>(points.size()));
    out_.add(70, flags(p));
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
    out_.add(70, flags(p));
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
};

}  // namespace

std::string dxf(const Drawing& drawing, const DxfOptions& options) {
  const std::vector<Layer> layers = layers_of(drawing);
  const ModelUnits units(drawing.scale);
  const DxfExtent extent = extent_of(drawing, units);
  DxfText body(options.version);
  const std::uint64_t model = append_dxf_tables(body, layers, extent);
  body.add(0, "SECTION");
  body.add(2, "ENTITIES");
  EntityWriter writer(body, drawing, units, model);
  for (const Layer& layer : layers)
    for (const Polyline& p : layer.polylines) writer.append(p, dxf_layer_name(layer));
  body.add(0, "ENDSEC");
  append_dxf_objects(body);
  body.add(0, "EOF");
  DxfText out(options.version);
  append_dxf_header(out, extent, options, body.next_handle());
  return out.text + body.text;
}

}  // namespace hsr::internal
