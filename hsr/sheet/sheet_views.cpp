#include "hsr/sheet/sheet_views.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Whether one is a positive multiple of the other, exactly enough to choose a view.
bool points_along(const Point3& a, const Point3& b) {
  return dot(a, b) > 0 && dot(a, b) * dot(a, b) >= (1 - 1e-15) * dot(a, a) * dot(b, b);
}

ViewRectangle rectangle_of(const Mesh& mesh, const View& view) {
  ViewRectangle r = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  const Frame& f = view.frame;
  for (const Edge& e : mesh.edges)
    for (const VertexId v : {e.a, e.b}) {
      const Point3& p = mesh.points[v];
      const Point3 d = {p.x - f.origin.x, p.y - f.origin.y, p.z - f.origin.z};
      const double x = dot(d, f.right), y = dot(d, f.up);
      r = {std::min(r.left, x), std::max(r.right, x), std::min(r.bottom, y), std::max(r.top, y)};
    }
  return r;
}

/// A view by the name that the sheet has for it: `side` is from the left in first angle, from the right in third.
View view_named(const std::string& name, const SheetOptions& o, const Point3& target) {
  if (name == "side") return named_view(o.angle == ProjectionAngle::first ? "left" : "right", target, o.y_up);
  if (name != "front" && name != "top" && name != "iso")
    throw InputError("views: found \"" + name + "\", expected some of front, top, side, iso");
  return named_view(name, target, o.y_up);
}

constexpr std::array planes = {"front", "top", "side"};

/// The letters of sections and details, in turn, without I, O, Q and X, which are taken for others.
std::string letter(std::size_t k) {
  constexpr std::string_view letters = "ABCDEFGHJKLMNPRSTUVWYZ";
  if (k >= letters.size())
    throw InputError("section: found more than " + std::to_string(letters.size()) + " sections and details, expected fewer");
  return std::string(1, letters[k]);
}

/// Looked at from the side of the view that looks most along the plane's normal.
SheetView section_view(const SectionPlane& plane, const std::string& letter, const SheetOptions& o, const Point3& target) {
  if (plane.normal == Point3{}) throw InputError("section: found the normal 0,0,0, expected a direction square to the plane");
  SheetView v;
  v.name = v.label = letter + "-" + letter;
  const auto towards = [&](const char* name) { return view_named(name, o, target).viewpoint.at; };
  for (const char* name : planes) {
    const View base = view_named(name, o, target);
    const Point3 &to_eye = base.viewpoint.at, &n = plane.normal, back = {-n.x, -n.y, -n.z};
    if (!points_along(to_eye, n) && !points_along(to_eye, back)) continue;
    v.view = base;
    v.is_in_top_row = name == std::string_view("top");
  }
  if (v.view.up == Point3{}) {
    const Point3 iso = view_named("iso", o, target).viewpoint.at, &n = plane.normal;
    const Point3 to_eye = dot(n, iso) >= 0 ? n : Point3{-n.x, -n.y, -n.z};
    v.view = parallel_view(to_eye, o.y_up ? Point3{0, 1, 0} : Point3{0, 0, 1}, target);
    v.lines_up = false;
  }
  v.view = with_section(v.view, plane.point, plane.normal);
  for (const char* name : planes) {
    if (!v.cut_in.empty() || std::ranges::find(o.views, name) == o.views.end()) continue;
    if (dot(towards(name), plane.normal) == 0) v.cut_in = name;
  }
  return v;
}

void check(const Mesh& mesh, const SheetOptions& o) {
  if (mesh.edges.empty()) throw InputError("the model has no face with an area and no line, expected something to draw");
  for (const SheetDetail& d : o.details) {
    if (!(d.radius > 0) || !std::isfinite(d.radius)) throw InputError("detail: found a radius that is not above 0");
    if (!(d.scale > 0) || !std::isfinite(d.scale)) throw InputError("detail: found a scale that is not above 0");
    if (std::ranges::find(o.views, d.view) == o.views.end())
      throw InputError("detail: found one of the view \"" + d.view +
                       "\", expected one of front, top, side, iso that is on the sheet");
  }
}

}  // namespace

std::vector<SheetView> views_of_sheet(const Scene& scene, const SheetOptions& o) {
  const Mesh& mesh = scene.mesh();
  check(mesh, o);
  const Point3 target = centre(mesh);
  for (const std::string& name : o.views) view_named(name, o, target);
  std::vector<SheetView> views;
  const auto is_asked_for = [&](const char* name) { return std::ranges::find(o.views, name) != o.views.end(); };
  const auto add = [&](SheetView v) {
    if (v.detail == nullptr) v.rectangle = rectangle_of(mesh, v.view);
    views.push_back(std::move(v));
  };
  for (const char* name : planes)
    if (is_asked_for(name)) {
      SheetView v;
      v.name = name;
      v.view = view_named(name, o, target);
      v.is_in_top_row = name == std::string_view("top");
      v.has_hidden_lines = true;
      add(std::move(v));
    }
  std::size_t letters = 0;
  for (const SectionPlane& plane : o.sections) add(section_view(plane, letter(letters++), o, target));
  if (is_asked_for("iso")) {
    SheetView v;
    v.name = "iso";
    v.view = view_named("iso", o, target);
    v.lines_up = false;
    add(std::move(v));
  }
  for (const SheetDetail& d : o.details) {
    SheetView v;
    const std::string name = letter(letters++);
    v.name = "detail " + name;
    v.label = name + " (" + ratio_text(d.scale) + ")";
    v.view = view_named(d.view, o, d.at);
    v.rectangle = {-d.radius, d.radius, -d.radius, d.radius};
    v.lines_up = false;
    v.detail = &d;
    add(std::move(v));
  }
  if (views.empty()) throw InputError("views: found none, expected some of front, top, side, iso");
  return views;
}

std::string ratio_text(double scale) {
  const auto number = [](double x) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, x, std::chars_format::general, 6);
    return std::string(digits, end);
  };
  return scale < 1 ? "1:" + number(1 / scale) : number(scale) + ":1";
}

void append_view(Drawing& sheet, const Drawing& view, const std::string& name) {
  const auto points = static_cast<std::uint32_t>(sheet.points.size()), edges = static_cast<std::uint32_t>(sheet.edges.size()),
             faces = static_cast<std::uint32_t>(sheet.faces.size()), arcs = static_cast<std::uint32_t>(sheet.arcs.size());
  check_countable(sheet.points.size() + view.points.size(), "points of a drawing");
  check_countable(sheet.edges.size() + view.edges.size(), "edges of a drawing");
  check_countable(sheet.faces.size() + view.faces.size(), "faces of a drawing");
  const auto first = static_cast<std::uint32_t>(sheet.polylines.size());
  for (Polyline p : view.polylines) {
    p.first_point += points;
    p.end_point += points;
    p.first_edge += edges;
    p.end_edge += edges;
    p.first_face += faces;
    p.end_face += faces;
    p.first_arc += arcs;
    p.end_arc += arcs;
    sheet.polylines.push_back(p);
  }
  for (DrawnArc arc : view.arcs) {
    arc.first_line += points;
    arc.end_line += points;
    sheet.arcs.push_back(arc);
  }
  sheet.points.insert(sheet.points.end(), view.points.begin(), view.points.end());
  sheet.edges.insert(sheet.edges.end(), view.edges.begin(), view.edges.end());
  sheet.faces.insert(sheet.faces.end(), view.faces.begin(), view.faces.end());
  for (std::uint32_t k = first, end = first; k < sheet.polylines.size(); k = end) {
    const Polyline& p = sheet.polylines[k];
    while (end < sheet.polylines.size() && sheet.polylines[end].hidden == p.hidden &&
           sheet.polylines[end].edge_class == p.edge_class)
      ++end;
    const std::string style = p.hidden ? " hidden " : " visible ";
    sheet.layers.push_back({name + style + edge_class_names[static_cast<std::size_t>(p.edge_class)],
                            view.pens.of(p.hidden, p.edge_class), k, end});
  }
}

}  // namespace hsr::internal
