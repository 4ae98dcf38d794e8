#include "hsr/io/write/dxf.h"

#include <algorithm>
#include <vector>

#include "hsr/io/write/dxf_entities.h"
#include "hsr/io/write/dxf_tables.h"

namespace hsr::internal {

namespace {

DxfExtent extent_of(const Drawing& drawing, const ModelUnits& units) {
  if (drawing.points.empty()) return {0, 0, 1, 1};
  const auto [left, right] = std::ranges::minmax(drawing.points, {}, &PaperPoint::x);
  const auto [top, bottom] = std::ranges::minmax(drawing.points, {}, &PaperPoint::y);
  return {units(left.x), -units(bottom.y), units(right.x), -units(top.y)};
}

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
  DxfEntities entities(body, drawing, units, model, options.page_scale);
  for (const Layer& layer : layers)
    for (const Polyline& p : layer.polylines) entities.append(p, layer);
  body.add(0, "ENDSEC");
  append_dxf_objects(body);
  body.add(0, "EOF");
  DxfText out(options.version);
  append_dxf_header(out, extent, options, dash_unit, body.next_handle());
  return out.text + body.text;
}

}  // namespace hsr::internal
