#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "geometry/rational_vector.h"
#include "hsr/io/read/json_depth.h"
#include "hsr/io/read/read.h"
#include "hsr/io/read/source.h"

namespace hsr {

using namespace internal;

namespace {

using Json = nlohmann::json;

class OrderReader {
 public:
  explicit OrderReader(const read::Source& source) : source_(source) {}

  PaintingFile read(const Json& file) const {
    if (!file.is_object()) source_.refuse("", "found no object, expected {\"format\": \"hsr-order/1\", ...}");
    if (!file.contains("format") || file["format"] != "hsr-order/1")
      source_.refuse("format", "found " + shown(file, "format") + ", expected \"hsr-order/1\"");
    PaintingFile out;
    if (file.contains("view")) out.view = view(file["view"]);
    if (file.contains("coplanar")) out.coplanar = coplanar(file["coplanar"]);
    if (!file.contains("pieces") || !file["pieces"].is_array())
      source_.refuse("pieces", "found " + shown(file, "pieces") + ", expected a list");
    for (const Json& piece : file["pieces"]) {
      const std::string where = "piece " + std::to_string(out.far_to_near.size());
      out.far_to_near.push_back(polygon(piece, where));
    }
    return out;
  }

 private:
  static std::string shown(const Json& object, const char* key) {
    return object.contains(key) ? read::printable(object[key].dump(-1, ' ', false, Json::error_handler_t::replace)) : "nothing";
  }
  [[noreturn]] void refuse(const std::string& where, const Json& found, const char* expected) const {
    source_.refuse(where, "found " + read::printable(found.dump(-1, ' ', false, Json::error_handler_t::replace)) +
                              ", expected " + expected);
  }

  /// A view is doubles; an exact file writes them as "p/q".
  double number(const Json& x, const std::string& where) const {
    if (x.is_string()) {
      const Rational exact = coordinate(x, where);
      const double value = exact.to_double();
      if (!std::isfinite(value) || (Rational(value) - exact).sign() != Sign::zero)
        refuse(where, x, "a number that a double holds");
      return value;
    }
    if (!x.is_number()) refuse(where, x, "a number");
    const auto value = x.get<double>();
    if (!std::isfinite(value)) refuse(where, x, "a finite number");
    return value;
  }

  Rational coordinate(const Json& x, const std::string& where) const {
    if (!x.is_string()) return number(x, where);
    const auto& text = x.get_ref<const std::string&>();
    constexpr std::size_t longest = 100'000;
    if (text.size() > longest) refuse(where, x, "at most 100000 characters");
    try {
      return Rational::from_string(text);
    } catch (const std::logic_error&) {
      refuse(where, x, "a number or a string \"p/q\"");
    }
  }

  Point3 point(const Json& object, const char* key) const {
    const std::string where = std::string("view: ") + key;
    if (!object.is_object() || !object.contains(key) || !object[key].is_array() || object[key].size() != 3)
      source_.refuse(where, "found " + (object.is_object() ? shown(object, key) : "nothing") + ", expected [x, y, z]");
    const Json& p = object[key];
    return {number(p[0], where), number(p[1], where), number(p[2], where)};
  }

  View view(const Json& v) const {
    if (!v.is_object() || !v.contains("eye") || !v["eye"].is_array() || v["eye"].size() != 4)
      source_.refuse("view: eye", "found " + (v.is_object() ? shown(v, "eye") : "nothing") + ", expected [x, y, z, w]");
    const Json& e = v["eye"];
    const Point3 eye = {number(e[0], "view: eye"), number(e[1], "view: eye"), number(e[2], "view: eye")};
    const double w = number(e[3], "view: eye");
    if (w != 0 && w != 1) refuse("view: eye", e[3], "w = 0 (a direction) or 1 (an eye)");
    const Point3 target = v.contains("target") ? point(v, "target") : Point3{}, up = point(v, "up");
    View out = w == 0 ? parallel_view(eye, up, target) : perspective_view(eye, target, up);
    if (w == 1) {
      if (!v.contains("near")) source_.refuse("view: near", "found nothing, expected k of the near plane");
      out.near = number(v["near"], "view: near");
      if (!(out.near > 0)) refuse("view: near", v["near"], "a number above 0");
    }
    if (v.contains("section")) out = with_section(out, point(v["section"], "point"), point(v["section"], "normal"));
    if (v.contains("frame")) {
      const Json& f = v["frame"];
      out.frame = {point(f, "origin"), point(f, "right"), point(f, "up")};
      if (!crosses_paper(out)) refuse("view: frame", f, "a plane that the line of sight in its middle crosses");
    }
    return out;
  }

  /// Whether the line of sight through the frame's origin crosses the frame's plane.
  static bool crosses_paper(const View& view) {
    const RationalVector at = rational(view.viewpoint.at), o = rational(view.frame.origin);
    const RationalVector normal = cross(rational(view.frame.right), rational(view.frame.up));
    return dot(normal, view.is_perspective() ? minus(o, at) : at).sign() != Sign::zero;
  }

  Coplanar coplanar(const Json& x) const {
    if (x == "first") return Coplanar::first;
    if (x == "last") return Coplanar::last;
    refuse("coplanar", x, "\"first\" or \"last\"");
  }

  PaintedPolygon polygon(const Json& piece, const std::string& where) const {
    if (!piece.is_object()) refuse(where, piece, "an object with \"points\"");
    PaintedPolygon out;
    if (piece.contains("face") && !piece["face"].is_null()) {
      const Json& f = piece["face"];
      if (!f.is_number_unsigned() || f.get<std::uint64_t>() >= 0xffffffffU) refuse(where + ": face", f, "the number of a face");
      out.face = f.get<std::uint32_t>();
    }
    if (!piece.contains("points") || !piece["points"].is_array())
      source_.refuse(where + ": points", "found " + shown(piece, "points") + ", expected a list of [x, y, z]");
    for (const Json& p : piece["points"]) {
      const std::string at = where + ", point " + std::to_string(out.corners.size());
      if (!p.is_array() || p.size() != 3) refuse(at, p, "[x, y, z]");
      out.corners.push_back({coordinate(p[0], at), coordinate(p[1], at), coordinate(p[2], at)});
    }
    const bool is_wire = piece.contains("wire") && !piece["wire"].is_null();
    if (is_wire && out.face) source_.refuse(where, "found \"wire\" beside \"face\", expected one of them");
    if (is_wire && out.corners.size() != 2)
      source_.refuse(where, "found " + std::to_string(out.corners.size()) + " points, expected the two of a wire");
    if (!is_wire && out.corners.size() < 3)
      source_.refuse(where, "found " + std::to_string(out.corners.size()) + " points, expected 3 or more");
    return out;
  }

  const read::Source& source_;
};

}  // namespace

PaintingFile read_order(const std::string& path) {
  const read::Bytes bytes = read::read_file(path);
  const read::Source source{path, bytes.view()};
  read::check_json_depth(source, bytes.view());
  Json json;
  try {
    json = Json::parse(bytes.view());
  } catch (const Json::parse_error& e) {
    source.refuse("byte " + std::to_string(e.byte), "found no JSON there, expected \"hsr-order/1\"");
  } catch (const Json::exception& e) {
    source.refuse("", std::string("found a number that no double holds, expected finite numbers"));
  }
  return OrderReader(source).read(json);
}

}  // namespace hsr
