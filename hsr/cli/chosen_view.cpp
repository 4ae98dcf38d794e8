#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "geometry/error.h"
#include "hsr/cli/model_defaults.h"
#include "hsr/cli/stored_camera.h"
#include "hsr/cli/view_options.h"
#include "hsr/view/view.h"

namespace hsr::cli {

namespace {

[[noreturn]] void refuse_point(const std::string& option, const std::string& text) {
  throw InputError(option + ": found \"" + text + "\", expected three finite numbers X,Y,Z");
}

/// The finite number that the text is; nothing where it is none.
std::optional<double> parse_number(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  const std::string digits = !text.empty() && text.front() == '+' ? text.substr(1) : text;
  double x = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(x)) return {};
  return x + 0.0;
}

/// "45,0.5": the base view seen obliquely.
View parse_oblique(const std::string& text, const View& base) {
  const std::size_t comma = text.find(',');
  const auto degrees = parse_number(text.substr(0, comma));
  const auto ratio = comma == std::string::npos ? std::nullopt : parse_number(text.substr(comma + 1));
  if (!degrees || !ratio)
    throw InputError("--oblique: found \"" + text + "\", expected an angle and a ratio DEG,RATIO, such as 45,0.5");
  return oblique_view(base, *degrees, *ratio);
}

bool is_inside_box(const Mesh& mesh, const Point3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    bool below = false, above = false;
    for (const Edge& e : mesh.edges) {
      for (const VertexId v : {e.a, e.b}) {
        below = below || mesh.points[v][axis] <= p[axis];
        above = above || mesh.points[v][axis] >= p[axis];
      }
    }
    if (!below || !above) return false;
  }
  return true;
}

bool are_parallel(const Point3& a, const Point3& b) {
  const auto minor = [](double p, double q, double r, double s) {
    return Rational(p) * Rational(s) == Rational(q) * Rational(r);
  };
  return minor(a.x, a.y, b.x, b.y) && minor(a.y, a.z, b.y, b.z) && minor(a.x, a.z, b.x, b.z);
}

/// The up that the named views have, and their second one where the line of sight runs along it.
Point3 default_up(bool y_up, const Point3& projected) {
  const Point3 up = y_up ? Point3{0, 1, 0} : Point3{0, 0, 1};
  const Point3 other = y_up ? Point3{0, 0, -1} : Point3{0, 1, 0};
  return are_parallel(up, projected) ? other : up;
}

}  // namespace

Point3 parse_point(const std::string& option, const std::string& text) {
  std::array<std::string, 3> parts;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(',', begin) : text.size();
    if (end == std::string::npos) refuse_point(option, text);
    parts[k] = text.substr(begin, end - begin);
    begin = end + 1;
  }
  const auto x = parse_number(parts[0]), y = parse_number(parts[1]), z = parse_number(parts[2]);
  if (!x || !y || !z) refuse_point(option, text);
  return {*x, *y, *z};
}

SectionPlane parse_plane(const std::string& text) {
  const auto refuse = [&] {
    throw InputError("--section: found \"" + text +
                     "\", expected a plane such as x=12.5, or its normal and a point NX,NY,NZ@X,Y,Z");
  };
  const std::size_t at = text.find('@');
  if (at != std::string::npos)
    return {parse_point("--section", text.substr(at + 1)), parse_point("--section", text.substr(0, at))};
  if (text.size() < 3 || text[1] != '=' || std::string_view("xyz").find(text[0]) == std::string_view::npos) refuse();
  const auto where = parse_number(text.substr(2));
  if (!where) refuse();
  const auto along = [&](double length) {
    return Point3{text[0] == 'x' ? length : 0, text[0] == 'y' ? length : 0, text[0] == 'z' ? length : 0};
  };
  return {along(*where), along(1)};
}

namespace {

/// "x=..12.5" or "x=12.5..", what is left, beside what parse_plane() takes.
SectionPlane parse_section(const std::string& text, const View& view) {
  const auto refuse = [&](const std::string& expected) { throw InputError("--section: found \"" + text + "\", " + expected); };
  const bool is_upper_end = text.size() > 4 && text.compare(2, 2, "..") == 0;
  const bool is_lower_end = !is_upper_end && text.size() > 4 && text.compare(text.size() - 2, 2, "..") == 0;
  const std::string number =
      is_upper_end ? text.substr(4) : text.substr(std::min<std::size_t>(2, text.size()), text.size() - (is_lower_end ? 4 : 2));
  const bool is_axis = text.find('@') == std::string::npos;
  if (is_axis && text.size() > 2 && !parse_number(number))
    refuse("expected a plane such as x=12.5, or its normal and a point NX,NY,NZ@X,Y,Z");
  SectionPlane plane = parse_plane(is_axis && (is_upper_end || is_lower_end) ? text.substr(0, 2) + number : text);
  if (!is_axis) {
    if (plane.normal == Point3{}) refuse("expected a normal that is not 0,0,0");
    return plane;
  }
  if (is_upper_end) plane.normal = {-plane.normal.x + 0.0, -plane.normal.y + 0.0, -plane.normal.z + 0.0};
  const Sign side = viewer_side(view, plane);
  const std::string axis = text.substr(0, 2);
  if (side == Sign::zero && !is_upper_end && !is_lower_end)
    refuse("which is seen edge-on, expected the side that is left, too: " + axis + ".." + number + " or " + axis + number +
           "..");
  if (side == Sign::positive && (is_upper_end || is_lower_end))
    refuse("of which the viewer is on the side that is to be left, expected " + axis + number);
  return plane;
}

View cut_view(const ViewOptions& o, View view) {
  std::vector<SectionPlane> planes;
  for (const std::string& text : o.sections) planes.push_back(parse_section(text, view));
  if (!planes.empty()) view = with_sections(view, planes);
  if (o.depth && planes.empty()) throw InputError("--depth: found no --section, expected one from which to measure");
  return o.depth ? with_depth(view, *o.depth) : view;
}

/// But for the section.
ChosenView choose_uncut_view(const ViewOptions& o, const Mesh& mesh, const Model& model) {
  if (static_cast<int>(!o.name.empty()) + static_cast<int>(!o.eye.empty()) + static_cast<int>(!o.direction.empty()) > 1)
    throw InputError("view: found more than one of --view, --eye and --direction, expected one");
  if (o.eye.empty() && !names_camera(o.name) && (o.near || o.field_of_view))
    throw InputError("view: found --near or --fov without --eye, expected them in perspective only: add --eye X,Y,Z");
  if (o.field_of_view && !(*o.field_of_view > 0 && *o.field_of_view < 180))
    throw InputError(fmt::format("--fov: found {}, expected degrees, more than 0 and less than 180", *o.field_of_view));
  if (o.near && !(*o.near > 0)) throw InputError(fmt::format("--near: found {}, expected a distance above 0", *o.near));
  if (!o.oblique.empty() && (!o.eye.empty() || names_camera(o.name)))
    throw InputError("view: found --oblique with --eye or a camera, expected it with --direction or another --view");
  if (names_camera(o.name)) return view_through_camera(o, mesh, model);
  const bool y_up = up_axis_of(o.up_axis, model) == 'y';
  const Point3 target = o.target.empty() ? centre(mesh) : parse_point("--target", o.target);
  ChosenView chosen;
  if (o.up_axis.empty() && (o.up.empty() || (o.eye.empty() && o.direction.empty()))) chosen.up_axis_note = up_axis_note(model);
  if (!o.eye.empty()) {
    const Point3 eye = parse_point("--eye", o.eye);
    if (eye == target) throw InputError("--eye: found the point looked at itself, expected another: add --target X,Y,Z");
    const Point3 projected = {eye.x / 2 - target.x / 2, eye.y / 2 - target.y / 2, eye.z / 2 - target.z / 2};
    chosen.view = perspective_view(eye, target, o.up.empty() ? default_up(y_up, projected) : parse_point("--up", o.up), o.near);
    chosen.title = "eye " + o.eye;
    chosen.field_of_view = o.field_of_view;
    if (!o.field_of_view && is_inside_box(mesh, eye)) {
      chosen.field_of_view = 90;
      chosen.note = "the eye is inside the model's bounding box: framing 90 degrees (--fov DEG for another angle)";
    }
  } else if (!o.direction.empty()) {
    const Point3 direction = parse_point("--direction", o.direction);
    chosen.view = parallel_view(direction, o.up.empty() ? default_up(y_up, direction) : parse_point("--up", o.up), target);
    chosen.title = "direction " + o.direction;
  } else {
    chosen.title = !o.name.empty() ? o.name : o.oblique.empty() ? "iso" : "front";
    chosen.view = named_view(chosen.title, target, y_up);
    if (!o.up.empty()) chosen.view = parallel_view(chosen.view.viewpoint.at, parse_point("--up", o.up), target);
  }
  if (!o.oblique.empty()) {
    chosen.view = parse_oblique(o.oblique, chosen.view);
    chosen.title += ", oblique " + o.oblique;
  }
  return chosen;
}

}  // namespace

ChosenView choose_view(const ViewOptions& o, const Mesh& mesh, const Model& model) {
  ChosenView chosen = choose_uncut_view(o, mesh, model);
  chosen.view = cut_view(o, chosen.view);
  for (const std::string& section : o.sections) chosen.title += ", section " + section;
  if (o.depth) chosen.title += fmt::format(", depth {}", *o.depth);
  return chosen;
}

JsonValue json_of(const View& view) {
  const auto list = [](const Point3& p) { return JsonValue::array({p.x, p.y, p.z}); };
  JsonValue eye = list(view.viewpoint.at);
  eye.push_back(view.viewpoint.w());
  JsonValue json = {
      {"eye", std::move(eye)},
      {"target", list(view.target)},
      {"up", list(view.up)},
      {"frame", {{"origin", list(view.frame.origin)}, {"right", list(view.frame.right)}, {"up", list(view.frame.up)}}},
      {"near", view.is_perspective() ? JsonValue(view.near) : JsonValue()}};
  const auto plane_json = [&](const SectionPlane& plane) {
    return JsonValue{{"point", list(plane.point)}, {"normal", list(plane.normal)}};
  };
  if (view.section) json.set("section", plane_json(*view.section));
  if (!view.planes.empty()) {
    JsonValue planes = JsonValue::array({});
    for (const SectionPlane& plane : view.planes) planes.push_back(plane_json(plane));
    json.set("sections", std::move(planes));
  }
  if (view.far) json.set("far", plane_json(*view.far));
  return json;
}

}  // namespace hsr::cli
