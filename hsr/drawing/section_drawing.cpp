#include "hsr/drawing/section_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "geometry/error.h"
#include "geometry/vector3.h"
#include "hsr/drawing/hatching.h"
#include "hsr/drawing/join.h"
#include "hsr/drawing/paper_rings.h"

namespace hsr::internal {

namespace {

using Wide = Enclosure::Wide;

/// From the plane of the section to the page.
class SectionPlacer {
 public:
  SectionPlacer(const Placement& placement, const Section& section) : placement_(placement), section_(section) {}

  PaperPoint operator()(const std::array<Rational, 3>& p) const { return placement_.projection.rounded(p); }

  std::vector<std::vector<PaperPoint>> rings_of(const SectionCap& cap) const {
    std::vector<std::vector<PaperPoint>> rings;
    for (std::uint32_t r = cap.first_ring; r < cap.end_ring; ++r) {
      std::vector<PaperPoint> ring;
      for (const auto& p : section_.rings[r]) ring.push_back((*this)(p));
      if (placement_.frame) ring = in_frame(ring);
      drop_repeated(ring);
      if (!ring.empty()) rings.push_back(std::move(ring));
    }
    return rings;
  }

  /// The part in the frame: Liang and Barsky's.
  std::optional<std::array<PaperPoint, 2>> in_frame(const PaperPoint& from, const PaperPoint& to) const {
    if (!placement_.frame) return std::array{from, to};
    const PaperFrame& f = *placement_.frame;
    const std::array<double, 4> at_from = inside(f, from), at_to = inside(f, to);
    double low = 0, high = 1;
    for (std::size_t k = 0; k < 4; ++k) {
      if (at_from[k] < 0 && at_to[k] < 0) return std::nullopt;
      if (at_from[k] < 0) low = std::max(low, at_from[k] / (at_from[k] - at_to[k]));
      if (at_to[k] < 0) high = std::min(high, at_from[k] / (at_from[k] - at_to[k]));
    }
    if (!(low < high)) return std::nullopt;
    const auto at = [&](double t) -> PaperPoint {
      if (t == 0) return from;
      if (t == 1) return to;
      return {from.x + std::llround(t * static_cast<double>(to.x - from.x)),
              from.y + std::llround(t * static_cast<double>(to.y - from.y))};
    };
    return std::array{at(low), at(high)};
  }

 private:
  static std::array<double, 4> inside(const PaperFrame& f, const PaperPoint& p) {
    const double x = static_cast<double>(p.x) / 1000, y = static_cast<double>(p.y) / 1000;
    return {x - f.left, f.right - x, y - f.top, f.bottom - y};
  }
  std::vector<PaperPoint> in_frame(const std::vector<PaperPoint>& ring) const {
    std::vector<std::array<Wide, 2>> wide;
    wide.reserve(ring.size());
    for (const PaperPoint& p : ring) wide.push_back({static_cast<Wide>(p.x) / 1000, static_cast<Wide>(p.y) / 1000});
    return clipped(std::move(wide), *placement_.frame);
  }

  const Placement& placement_;
  const Section& section_;
};

/// Twice the area over the length around, in space.
double thickness_of(const Section& section, const SectionCap& cap) {
  Point3 area = {};
  double length = 0;
  for (std::uint32_t r = cap.first_ring; r < cap.end_ring; ++r) {
    std::vector<Point3> ring;
    for (const auto& p : section.rings[r]) ring.push_back({p[0].to_double(), p[1].to_double(), p[2].to_double()});
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point3 p = minus(ring[k], ring[0]), along = minus(ring[(k + 1) % ring.size()], ring[k]);
      const Point3 twice = cross(p, along);
      area = {area.x + twice.x, area.y + twice.y, area.z + twice.z};
      length += std::sqrt(dot(along, along));
    }
  }
  return length > 0 ? std::sqrt(dot(area, area)) / length : 0;
}

std::uint32_t object_of(const DrawingOptions& options, FaceId face) {
  return options.objects == nullptr ? SceneObjects::none : options.objects->object_of(std::array{face});
}

/// Lines of one class that are joined end to end.
void add_polylines(Drawing& drawing, const std::vector<PaperLine>& lines) {
  const Chains chains = join(lines);
  std::vector<std::uint32_t> order(chains.passes.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto first_of = [&](std::uint32_t chain) -> const PaperLine& { return lines[chains.passes[chain].front() / 2]; };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(first_of(a).style, first_of(a).object) < std::pair(first_of(b).style, first_of(b).object);
  });
  for (const std::uint32_t chain : order) {
    Polyline p;
    p.edge_class = static_cast<EdgeClass>(first_of(chain).style);
    p.object = first_of(chain).object;
    p.closed = chains.closed[chain] != 0;
    p.first_point = static_cast<std::uint32_t>(drawing.points.size());
    const auto passes = chains.passes[chain];
    for (const std::uint32_t pass : passes) drawing.points.push_back(pass % 2 != 0 ? lines[pass / 2].to : lines[pass / 2].from);
    if (!p.closed)
      drawing.points.push_back(passes.back() % 2 != 0 ? lines[passes.back() / 2].from : lines[passes.back() / 2].to);
    p.end_point = static_cast<std::uint32_t>(drawing.points.size());
    p.first_edge = p.end_edge = static_cast<std::uint32_t>(drawing.edges.size());
    p.first_face = p.end_face = static_cast<std::uint32_t>(drawing.faces.size());
    check_countable(drawing.points.size(), "points of a drawing");
    drawing.polylines.push_back(p);
  }
}

/// The thickness of the thickest cap of each object, on paper.
std::map<std::uint32_t, double> thickest(const Section& section, const std::vector<double>& of_cap) {
  std::map<std::uint32_t, double> of_object;
  for (std::size_t k = 0; k < of_cap.size(); ++k) {
    double& most = of_object[section.caps[k].object];
    most = std::max(most, of_cap[k]);
  }
  return of_object;
}

}  // namespace

ObjectHatching hatching_of(const std::vector<const Section*>& sections) {
  constexpr std::uint32_t styles = 8;
  ObjectHatching hatching;
  std::map<std::uint32_t, std::set<std::uint32_t>> touching;
  for (const Section* const section : sections) {
    for (const SectionLine& line : section->lines) {
      const auto [a, b] = line.objects;
      if (a == SectionLine::none || b == SectionLine::none || a == b) continue;
      touching[std::max(a, b)].insert(std::min(a, b));
    }
    for (const SectionCap& cap : section->caps) {
      double& most = hatching.thickness[cap.object];
      most = std::max(most, thickness_of(*section, cap));
    }
  }
  for (const auto& [object, thickness] : hatching.thickness) {
    std::set<std::uint32_t> taken;
    for (const std::uint32_t other : touching[object])
      if (const auto at = hatching.style.find(other); at != hatching.style.end()) taken.insert(at->second);
    std::uint32_t style = object % styles;
    for (std::uint32_t k = 0; k < styles && taken.contains(style); ++k) style = (style + 1) % styles;
    hatching.style[object] = style;
  }
  return hatching;
}

void add_section_lines(Drawing& drawing, const Placement& placement, const DrawingOptions& options) {
  if (options.section == nullptr) return;
  const Section& section = *options.section;
  const SectionPlacer placed(placement, section);
  std::vector<PaperLine> lines;
  const auto wants = [&](EdgeClass c) { return options.section_classes[static_cast<std::size_t>(c)]; };
  const auto add = [&](const PaperPoint& from, const PaperPoint& to, EdgeClass c, std::uint32_t object) {
    const auto seen = placed.in_frame(from, to);
    if (seen && (*seen)[0] != (*seen)[1]) lines.push_back({(*seen)[0], (*seen)[1], static_cast<std::uint32_t>(c), object});
  };
  for (const SectionLine& line : section.lines)
    if (wants(line.edge_class)) add(placed(line.ends[0]), placed(line.ends[1]), line.edge_class, object_of(options, line.face));
  if (wants(EdgeClass::hatching)) {
    const ObjectHatching own = options.hatching == nullptr ? hatching_of({&section}) : ObjectHatching();
    const ObjectHatching& hatching = options.hatching == nullptr ? own : *options.hatching;
    const double pen = drawing.pens.of(false, EdgeClass::hatching).width;
    // Paper and page differ where the drawing is in units of the frame.
    const double unit = options.in_frame_units ? drawing.scale / options.hatch_scale : 1;
    std::vector<std::vector<std::vector<PaperPoint>>> rings;
    std::vector<double> thickness;
    for (const SectionCap& cap : section.caps) thickness.push_back(thickness_of(rings.emplace_back(placed.rings_of(cap))));
    const std::map<std::uint32_t, double> of_object = thickest(section, thickness);
    for (std::size_t k = 0; k < section.caps.size(); ++k) {
      const std::uint32_t object = section.caps[k].object;
      const double most = options.hatching == nullptr ? of_object.at(object) : hatching.thickness.at(object) * drawing.scale;
      const Hatch hatch = hatch_for(thickness[k], most, hatching.style.at(object), pen, unit);
      for (const auto& [from, to] : hatch_lines(rings[k], hatch))
        add(from, to, EdgeClass::hatching, object_of(options, section.caps[k].face));
    }
  }
  add_polylines(drawing, lines);
}

void add_section_fills(Fills& fills, const Placement& placement, const DrawingOptions& options) {
  if (options.section == nullptr) return;
  const SectionPlacer placed(placement, *options.section);
  const std::uint32_t layer = fills.fills.empty() ? 0 : fills.fills.back().layer + 1;
  for (std::size_t k = 0; k < options.section->caps.size(); ++k) {
    const SectionCap& cap = options.section->caps[k];
    Fill fill;
    fill.colour = k < options.cap_colours.size() ? options.cap_colours[k] : Colour{255, 255, 255, 255};
    fill.first_ring = static_cast<std::uint32_t>(fills.rings.size());
    for (const auto& ring : placed.rings_of(cap)) fills.rings.push_row(ring);
    fill.end_ring = static_cast<std::uint32_t>(fills.rings.size());
    fill.first_face = static_cast<std::uint32_t>(fills.faces.size());
    fill.end_face = fill.first_face + 1;
    fill.object = object_of(options, cap.face);
    fill.layer = layer;
    if (fill.end_ring == fill.first_ring) continue;
    fills.faces.push_back(cap.face.value);
    fills.fills.push_back(fill);
  }
}

}  // namespace hsr::internal
