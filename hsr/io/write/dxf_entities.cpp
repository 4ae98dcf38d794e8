#include "hsr/io/write/dxf_entities.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "hsr/io/write/dashes.h"

namespace hsr::internal {

namespace {

constexpr std::size_t most_numbers = 1000;  // extended data ends at 16 kB for an entity
constexpr double pi = std::numbers::pi;

void append_numbers(DxfText& out, const char* name, const std::vector<std::uint32_t>& numbers) {
  out.add(1000, name);
  const std::size_t written = std::min(numbers.size(), most_numbers);
  for (std::size_t k = 0; k < written; ++k) out.add(1071, static_cast<std::int64_t>(static_cast<std::int32_t>(numbers[k])));
  if (written < numbers.size()) out.add(1000, "and " + std::to_string(numbers.size() - written) + " more");
}

/// Where an arc begins and ends, counter-clockwise with y up: from 0 on to below 2 pi, and from there to at most 2 pi more.
std::pair<double, double> turned_up(const EllipseArc& arc) {
  double begin = -std::max(arc.from, arc.to);
  begin -= 2 * pi * std::floor(begin / (2 * pi));
  return {begin, begin + std::fabs(arc.sweep())};
}

double in_degrees(double radians) {
  const double degrees = std::round(radians * 180 / pi * 1e9) / 1e9;
  return degrees >= 360 ? degrees - 360 : degrees;
}

}  // namespace

ModelUnits::ModelUnits(double scale) : is_large_(scale >= 1e-3), factor_(is_large_ ? scale * 1000 : 1e-3 / scale) {
  const double whole = std::round(factor_);
  if (std::fabs(factor_ - whole) <= 1e-9 * whole) factor_ = whole;
}

double ModelUnits::of_millimetres(double mm) const { return (*this)(std::llround(mm * 1000)); }

void DxfEntities::append(const Polyline& p, const Layer& of) {
  polyline_ = &p;
  pen_ = &of.pen;
  layer_ = dxf_layer_name(of);
  append_path(path_of(drawing_, p));
}

void DxfEntities::append_path(const Path& path) {
  const auto is_ellipse = [](const PathPart& part) { return part.is_arc && !part.arc.is_circle(); };
  if (std::ranges::none_of(path.parts, is_ellipse)) return append_run(path.parts, path.closed);
  if (!out_.is_2000()) {
    Path straight;
    straight.closed = path.closed;
    for (const PathPart& part : path.parts) {
      if (!is_ellipse(part)) {
        straight.parts.push_back(part);
        continue;
      }
      const Path chords = path_of(flattened({{part}, false}, drawing_.arc_tolerance / 10), false);
      straight.parts.insert(straight.parts.end(), chords.parts.begin(), chords.parts.end());
    }
    return append_run(straight.parts, straight.closed);
  }
  for (std::size_t first = 0, end = 0; first < path.parts.size(); first = end) {
    while (end < path.parts.size() && !is_ellipse(path.parts[end])) ++end;
    if (end > first) append_run(std::span(path.parts).subspan(first, end - first), false);
    if (end < path.parts.size()) append_ellipse(path.parts[end++].arc);
  }
}

/// Straight lines and arcs of circles.
void DxfEntities::append_run(std::span<const PathPart> parts, bool closed) {
  if (parts.size() == 1) {
    if (parts[0].is_arc) return append_arc(parts[0].arc);
    if (!closed) return append_line(parts[0].from, parts[0].to);
  }
  std::vector<Corner> corners;
  for (const PathPart& part : parts) {
    if (!part.is_arc) {
      corners.push_back({part.from});
      continue;
    }
    // The bulge of more than a half circle hangs on a short chord.
    for (const PathPart& half : at_most(part, pi)) corners.push_back({half.from, std::tan(-half.arc.sweep() / 4)});
  }
  if (!closed) corners.push_back({parts.back().to});
  append_polyline(corners, closed);
}

void DxfEntities::begin(const char* type, const char* subclass) {
  out_.begin(type, owner_);
  out_.add_class("AcDbEntity");
  out_.add(8, layer_);
  out_.add_class(subclass);
}

/// Dashes run on over the points of a curve, and begin anew at corners; DXF has no line that does both.
std::int64_t DxfEntities::flags(std::span<const Corner> corners, bool closed) const {
  std::vector<PaperPoint> points;
  for (const Corner& c : corners) points.push_back(c.at);
  const bool begins_anew = pen_->is_dashed() && std::ranges::all_of(corners, [](const Corner& c) { return c.bulge == 0; }) &&
                           has_corners_only(points, closed);
  return (closed ? 1 : 0) + (begins_anew ? 0 : 128);
}

/// A line that is too short for two whole dashes and a gap has shorter ones, where the release can say so.
void DxfEntities::add_dash_scale(const PaperPoint& from, const PaperPoint& to) {
  if (!out_.is_2000() || !pen_->is_dashed()) return;
  const double length = std::hypot(units_(to.x) - units_(from.x), units_(to.y) - units_(from.y));
  const double wanted = std::accumulate(pen_->dashes.begin(), pen_->dashes.end(), pen_->dashes[0]) / page_scale_;
  if (length > 0 && length < wanted) out_.add_number(48, std::round(length / wanted * 1e4) / 1e4);
}

void DxfEntities::append_line(const PaperPoint& from, const PaperPoint& to) {
  out_.begin("LINE", owner_);
  out_.add_class("AcDbEntity");
  out_.add(8, layer_);
  add_dash_scale(from, to);
  out_.add_class("AcDbLine");
  add_point(from);
  add_point(to, 11);
  append_provenance();
}

void DxfEntities::append_polyline(std::span<const Corner> corners, bool closed) {
  const auto add_bulge = [&](const Corner& c) {
    if (c.bulge != 0) out_.add_number(42, std::round(c.bulge * 1e12) / 1e12);
  };
  if (out_.is_2000()) {
    begin("LWPOLYLINE", "AcDbPolyline");
    out_.add(90, static_cast<std::int64_t>(corners.size()));
    out_.add(70, flags(corners, closed));
    for (const Corner& c : corners) {
      out_.add_number(10, units_(c.at.x));
      out_.add_number(20, -units_(c.at.y));
      add_bulge(c);
    }
    append_provenance();
    return;
  }
  begin("POLYLINE", "");
  out_.add(66, std::int64_t{1});
  out_.add_point(0, 0);
  out_.add(70, flags(corners, closed));
  append_provenance();
  for (const Corner& c : corners) {
    begin("VERTEX", "");
    add_point(c.at);
    add_bulge(c);
  }
  begin("SEQEND", "");
}

void DxfEntities::append_arc(const EllipseArc& arc) {
  begin(arc.is_whole() ? "CIRCLE" : "ARC", "AcDbCircle");
  out_.add_point(units_.of_millimetres(arc.centre.x), -units_.of_millimetres(arc.centre.y));
  out_.add_number(40, units_.of_millimetres(arc.long_radius()));
  if (!arc.is_whole()) {
    const auto [from, to] = turned_up(arc);
    out_.add_class("AcDbArc");
    out_.add_number(50, in_degrees(from));
    out_.add_number(51, in_degrees(to));
  }
  append_provenance();
}

void DxfEntities::append_ellipse(const EllipseArc& arc) {
  begin("ELLIPSE", "AcDbEllipse");
  out_.add_point(units_.of_millimetres(arc.centre.x), -units_.of_millimetres(arc.centre.y));
  out_.add_point(units_.of_millimetres(arc.long_axis.x), -units_.of_millimetres(arc.long_axis.y), 11);
  out_.add_number(210, 0);
  out_.add_number(220, 0);
  out_.add_number(230, 1);
  out_.add_number(40, std::round(arc.short_radius() / arc.long_radius() * 1e12) / 1e12);
  const auto [from, to] = arc.is_whole() ? std::pair(0.0, 2 * pi) : turned_up(arc);
  out_.add_number(41, from);
  out_.add_number(42, to);
  append_provenance();
}

/// Which edges and faces a line is of.
void DxfEntities::append_provenance() {
  const Polyline& p = *polyline_;
  out_.add(1001, "HSR");
  std::vector<std::uint32_t> numbers;
  for (const auto& [i, j] : drawing_.edges_of(p)) numbers.insert(numbers.end(), {i, j});
  append_numbers(out_, "edges", numbers);
  numbers.assign(drawing_.faces_of(p).begin(), drawing_.faces_of(p).end());
  append_numbers(out_, "faces", numbers);
  if (p.object >= drawing_.objects.size() || drawing_.objects[p.object].empty()) return;
  out_.add(1000, "object");
  out_.add(1000, dxf_string(drawing_.objects[p.object]));
}

}  // namespace hsr::internal
