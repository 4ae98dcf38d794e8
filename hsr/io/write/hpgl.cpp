#include "hsr/io/write/hpgl.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "hsr/io/write/dashes.h"
#include "hsr/io/write/layers.h"

namespace hsr::internal {

namespace {

constexpr double plotter_unit = 0.025;  // mm

void append_stroke(std::string& out, std::span<const PaperPoint> points, double height) {
  // 25 thousandths of a millimetre to a plotter unit.
  const auto append_point = [&](const PaperPoint& p) {
    out += std::to_string(std::llround(static_cast<double>(p.x) / 25)) + ',' +
           std::to_string(std::llround((height * 1000 - static_cast<double>(p.y)) / 25));
  };
  out += "PU";
  append_point(points.front());
  const char* separator = ";PD";
  for (const PaperPoint& p : points.subspan(1)) {
    out += separator;
    separator = ",";
    append_point(p);
  }
  out += ";\n";
}

}  // namespace

std::string hpgl(const Drawing& drawing) {
  std::string out = "IN;\n";
  std::map<std::pair<double, Colour>, int> pens;  // of named layers: those of a sheet are many more than a plotter has pens
  int last = 0;
  for (const Layer& layer : layers_of(drawing)) {
    int pen = last + 1;
    if (!layer.given_name.empty()) pen = pens.try_emplace({layer.pen.width, layer.pen.colour}, pen).first->second;
    last = std::max(last, pen);
    out += "SP" + std::to_string(pen) + ";\n";
    for (const Polyline& p : layer.polylines) {
      const Path path = path_of(drawing, p);
      if (layer.pen.is_dashed()) {
        for (const Path& dash : dashes_of(dashed_path(path, layer.pen)))
          append_stroke(out, flattened(dash, plotter_unit / 2), drawing.height);
        continue;
      }
      std::vector<PaperPoint> points = flattened(path, plotter_unit / 2);
      if (p.closed) points.push_back(points.front());
      append_stroke(out, points, drawing.height);
    }
  }
  return out + "PU;SP0;\n";
}

}  // namespace hsr::internal
