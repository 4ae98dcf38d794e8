#pragma once

#include <initializer_list>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/drawing/drawing.h"
#include "hsr/lines/visible_lines.h"

namespace hsr {

/// Segments whose visibility a test makes up, in a view from the front: x to the right, z up.
struct HandMadeLines {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<EdgeClass> classes;
  std::vector<bool> hidden;

  /// @return the number of its first point
  std::uint32_t add(const Point3& a, const Point3& b, EdgeClass edge_class = EdgeClass::outline, bool is_hidden = false) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.push_back(a);
    points.push_back(b);
    segments.push_back({first, first + 1});
    classes.push_back(edge_class);
    hidden.push_back(is_hidden);
    return first;
  }

  Mesh mesh() const {
    Polygons polygons;
    polygons.segments = segments;
    return make_mesh(points, polygons);
  }

  /// Each segment visible or hidden from end to end.
  VisibleLines lines(const Mesh& m) const {
    VisibleLines result;
    for (std::uint32_t e = 0; e < m.edges.size(); ++e) {
      std::size_t s = 0;
      const auto is_edge = [&](const std::array<std::uint32_t, 2>& segment) {
        const VertexId a = m.merged[VertexId(segment[0])], b = m.merged[VertexId(segment[1])];
        return std::min(a, b) == m.edges[EdgeId(e)].a && std::max(a, b) == m.edges[EdgeId(e)].b;
      };
      while (!is_edge(segments[s])) ++s;
      Line line;
      line.edge = EdgeId(e);
      line.edge_class = classes[s];
      line.starts_hidden = hidden[s];
      line.first_cut = static_cast<std::uint32_t>(result.cuts.size());
      result.cuts.push_back({Cut::Kind::start, 0, 0, 0});
      result.cuts.push_back({Cut::Kind::end, 0, 0, 0});
      line.end_cut = static_cast<std::uint32_t>(result.cuts.size());
      result.lines.push_back(line);
    }
    return result;
  }

  /// On a page of 100 by 100 mm, 1 unit to the millimetre; the middle of the box around the lines is in the middle of the page.
  Drawing draw(HiddenLines hidden_lines = HiddenLines::dashed, double scale = 1, bool leave_out_near = false) const {
    const Mesh m = mesh();
    DrawingOptions options;
    options.page = parse_page("100x100mm");
    options.scale = scale;
    options.hidden = hidden_lines;
    options.leave_out_near = leave_out_near;
    return hsr::draw(m, named_view("front"), lines(m), options);
  }
};

}  // namespace hsr
