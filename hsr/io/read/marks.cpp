#include "hsr/io/read/marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "geometry/error.h"
#include "hsr/io/read/json_depth.h"
#include "hsr/io/read/merged_points.h"
#include "hsr/io/read/read.h"
#include "hsr/io/read/source.h"

namespace hsr {

using namespace internal;

namespace {

using Json = nlohmann::json;
using Ends = std::pair<std::uint32_t, std::uint32_t>;

constexpr std::uint32_t none = 0xffffffffU;

/// What the file says of one edge.
struct SaidOfEdge {
  EdgeMark mark = EdgeMark::inner;
  std::uint32_t circle = none;  // of those of the file
};

double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// A circle that has been moved; nothing where that makes an ellipse of it. It decides nothing: in doubles, and as near as numbers of
/// matrices in single precision are.
std::optional<KnownCircle> moved(const KnownCircle& circle, const read::Affine& m) {
  if (m == read::identity) return circle;
  constexpr double single = 1e-6;
  const std::array<Point3, 3> axes = {Point3{m[0], m[4], m[8]}, {m[1], m[5], m[9]}, {m[2], m[6], m[10]}};
  const double scale = std::sqrt(dot(axes[0], axes[0]));
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(std::fabs(std::sqrt(dot(axes[k], axes[k])) - scale) <= single * scale)) return {};
    if (!(std::fabs(dot(axes[k], axes[(k + 1) % 3])) <= single * scale * scale)) return {};
  }
  const auto turned = [&](const Point3& p) -> Point3 {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z, m[4] * p.x + m[5] * p.y + m[6] * p.z, m[8] * p.x + m[9] * p.y + m[10] * p.z};
  };
  const Point3 centre = turned(circle.centre), axis = turned(circle.axis);
  const double length = std::hypot(axis.x, axis.y, axis.z), radius = scale * circle.radius;
  const KnownCircle all = {
      {centre.x + m[3], centre.y + m[7], centre.z + m[11]}, {axis.x / length, axis.y / length, axis.z / length}, radius};
  for (const double x : {all.centre.x, all.centre.y, all.centre.z, all.axis.x, all.axis.y, all.axis.z, radius})
    if (!std::isfinite(x)) return {};
  return radius > 0 ? std::optional(all) : std::nullopt;
}

class MarksReader {
 public:
  /// @param part of which the file speaks
  MarksReader(const read::Source& source, const read::MarkedPart& part, Model& model)
      : source_(source), part_(part), model_(model) {}

  void read(const Json& file) {
    if (!file.is_object()) refuse_at("", "found no object, expected {\"format\": \"hsr-marks/1\", ...}");
    if (!file.contains("format") || file["format"] != "hsr-marks/1")
      refuse_at("format", "found " + shown(file, "format") + ", expected \"hsr-marks/1\"");
    if (file.contains("surfaces")) read_surfaces(file["surfaces"]);
    if (!file.contains("edges")) return;
    if (!file["edges"].is_array()) refuse("edges", file["edges"], "a list");
    if (part_.places.empty()) return;
    merge_points();
    for (const Json& edge : file["edges"]) read_edge(edge, "edge " + std::to_string(edges_read_++));
  }

  /// The numbers of surfaces by face of the part; empty: the file has none.
  const std::vector<std::uint32_t>& surfaces() const { return surfaces_; }

  void add_marks() {
    if (said_.empty()) return;
    for (const read::MarkedPart::Place& place : part_.places) add_marks(place);
    if (missing_ > 0)
      model_.notes.push_back(source_.path + (is_part() ? ": " + part_.where : "") +
                             ": marks of edges that no face has, passed over: " + std::to_string(missing_));
  }

 private:
  static std::string shown(const Json& object, const char* key) {
    return object.contains(key) ? read::printable(object[key].dump(-1, ' ', false, Json::error_handler_t::replace)) : "nothing";
  }
  [[noreturn]] void refuse_at(const std::string& where, const std::string& what) const {
    source_.refuse(part_.where + (part_.where.empty() || where.empty() ? "" : ", ") + where, what);
  }
  [[noreturn]] void refuse(const std::string& where, const Json& found, const std::string& expected) const {
    refuse_at(where, "found " + read::printable(found.dump(-1, ' ', false, Json::error_handler_t::replace)) + ", expected " +
                         expected);
  }

  void read_surfaces(const Json& surfaces) {
    const std::size_t faces = part_.faces;
    if (!surfaces.is_array()) refuse("surfaces", surfaces, "a list");
    if (surfaces.size() != faces)
      refuse_at("surfaces", "found " + std::to_string(surfaces.size()) + " numbers, expected one for each of the " +
                                std::to_string(faces) + " faces of the " + thing());
    for (const Json& x : surfaces) {
      const bool is_number = x.is_number_unsigned() && x.get<std::uint64_t>() < none;
      if (!is_number && !x.is_null())
        refuse("surfaces, face " + std::to_string(surfaces_.size()), x, "the number of a surface, or null");
      surfaces_.push_back(is_number ? x.get<std::uint32_t>() : none);
    }
  }

  /// Points that are equal have one number here, whatever the faces call them.
  void merge_points() {
    std::vector<Point3> merged;
    read::MergedPoints numbers(merged);
    for (std::uint32_t p = 0; p < part_.points; ++p)
      merged_.push_back(numbers.index(model_.points[part_.places[0].first_point + p]));
  }

  EdgeMark mark_named(const Json& x, const std::string& where) const {
    static constexpr std::array<std::pair<const char*, EdgeMark>, 4> names = {
        {{"inner", EdgeMark::inner}, {"seam", EdgeMark::inner}, {"smooth", EdgeMark::smooth}, {"sharp", EdgeMark::sharp}}};
    for (const auto& [name, mark] : names)
      if (x == name) return mark;
    refuse(where + ": mark", x, R"("inner", "seam", "smooth" or "sharp")");
  }

  void read_edge(const Json& edge, const std::string& where) {
    if (!edge.is_object()) refuse(where, edge, R"({"points": [i, j, ...], "mark": "smooth"})");
    if (!edge.contains("points") || !edge["points"].is_array() || edge["points"].size() < 2)
      refuse_at(where + ": points", "found " + shown(edge, "points") + ", expected the numbers of two points or more");
    SaidOfEdge said{mark_named(edge.contains("mark") ? edge["mark"] : Json(), where), none};
    if (edge.contains("circle")) said.circle = read_circle(edge["circle"], where + ": circle");
    std::uint32_t last = none;
    for (const Json& p : edge["points"]) {
      if (!p.is_number_unsigned() || p.get<std::uint64_t>() >= part_.points)
        refuse(where + ": points", p, "the number of one of the " + std::to_string(part_.points) + " points of the " + thing());
      const std::uint32_t point = merged_[p.get<std::uint32_t>()];
      if (last != none && last != point) said_[std::minmax(last, point)].push_back(said);
      last = point;
    }
  }

  std::uint32_t read_circle(const Json& circle, const std::string& where) {
    const auto number = [&](const Json& x) {
      if (!x.is_number() || !std::isfinite(x.get<double>())) refuse(where, x, "a finite number");
      return x.get<double>();
    };
    const auto point = [&](const char* key) -> Point3 {
      if (!circle.is_object() || !circle.contains(key) || !circle[key].is_array() || circle[key].size() != 3)
        refuse(where, circle, R"({"centre": [x, y, z], "axis": [x, y, z], "radius": r})");
      return {number(circle[key][0]), number(circle[key][1]), number(circle[key][2])};
    };
    const Point3 centre = point("centre"), axis = point("axis");
    if (!circle.contains("radius")) refuse(where, circle, R"({"centre": [x, y, z], "axis": [x, y, z], "radius": r})");
    const double radius = number(circle["radius"]), length = std::hypot(axis.x, axis.y, axis.z);
    if (!(radius > 0)) refuse(where + ": radius", circle["radius"], "more than 0");
    if (!(length > 0)) refuse(where + ": axis", circle["axis"], "a direction");
    circles_.push_back({centre, {axis.x / length, axis.y / length, axis.z / length}, radius});
    return static_cast<std::uint32_t>(circles_.size() - 1);
  }

  /// The number in model_.circles of each of the file's, at one place.
  std::vector<std::uint32_t> add_circles(const read::Affine& motion) {
    std::vector<std::uint32_t> numbers;
    for (const KnownCircle& circle : circles_) {
      const auto placed = moved(circle, motion);
      numbers.push_back(placed ? static_cast<std::uint32_t>(model_.circles.size()) : none);
      if (placed) model_.circles.push_back(*placed);
    }
    return numbers;
  }

  /// A mark for each object that has a face along the edge.
  void add_marks(const read::MarkedPart::Place& place) {
    const std::vector<std::uint32_t> circles = add_circles(place.motion);
    std::map<Ends, std::set<std::uint32_t>> objects;
    for (std::size_t i = 0; i < part_.numbers.size(); ++i) {
      const std::size_t f = place.first_face + i;
      const auto corners = model_.polygons[f];
      const std::uint32_t object = model_.face_object.empty() ? 0 : model_.face_object[f];
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto merged = [&](std::size_t corner) { return merged_[corners[corner % corners.size()] - place.first_point]; };
        const Ends ends = std::minmax(merged(k), merged(k + 1));
        if (said_.contains(ends)) objects[ends].insert(object);
      }
    }
    missing_ = said_.size() - objects.size();
    std::map<std::uint32_t, std::uint32_t> first_of;  // a point of each number
    for (std::uint32_t p = 0; p < merged_.size(); ++p) first_of.try_emplace(merged_[p], place.first_point + p);
    for (const auto& [ends, of_edge] : objects)
      for (const std::uint32_t object : of_edge)
        for (const SaidOfEdge& s : said_[ends])
          model_.marks.push_back(
              {{first_of[ends.first], first_of[ends.second]}, s.mark, object, s.circle == none ? none : circles[s.circle]});
  }

  bool is_part() const { return !part_.where.empty(); }
  const char* thing() const { return is_part() ? "primitive" : "model"; }

  const read::Source& source_;
  const read::MarkedPart& part_;
  Model& model_;
  std::vector<std::uint32_t> merged_;
  std::vector<std::uint32_t> surfaces_;
  std::map<Ends, std::vector<SaidOfEdge>> said_;
  std::vector<KnownCircle> circles_;
  std::size_t edges_read_ = 0, missing_ = 0;
};

}  // namespace

void read_marks(const std::string& path, Model& model) {
  const read::Bytes bytes = read::read_file(path);
  const read::Source source{path, bytes.view()};
  read::check_json_depth(source, bytes.view());
  Json json;
  try {
    json = Json::parse(bytes.view());
  } catch (const Json::parse_error& e) {
    source.refuse("byte " + std::to_string(e.byte), "found no JSON there, expected \"hsr-marks/1\"");
  } catch (const Json::exception&) {
    source.refuse("", "found a number that no double holds, expected finite numbers");
  }
  read::MarkedPart whole;
  whole.points = static_cast<std::uint32_t>(model.points.size());
  whole.faces = static_cast<std::uint32_t>(model.polygons.size());
  whole.numbers.resize(whole.faces);
  std::iota(whole.numbers.begin(), whole.numbers.end(), 0U);
  whole.places.emplace_back();
  MarksReader reader(source, whole, model);
  reader.read(json);
  if (json.contains("surfaces")) {
    model.face_surface = reader.surfaces();
    model.surfaces.clear();
  }
  if (json.contains("edges")) {
    model.marks.clear();
    model.circles.clear();
  }
  reader.add_marks();
}

void read::add_marks_of_part(const Source& source, const std::string& json, const MarkedPart& part, std::uint32_t& surfaces,
                             Model& model) {
  MarksReader reader(source, part, model);
  reader.read(Json::parse(json));
  reader.add_marks();
  if (reader.surfaces().empty()) return;
  model.face_surface.resize(model.polygons.size(), none);
  for (const MarkedPart::Place& place : part.places) {
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (std::size_t k = 0; k < part.numbers.size(); ++k) {
      const std::uint32_t surface = reader.surfaces()[part.numbers[k]];
      if (surface == none) continue;
      const auto [at, is_new] = numbers.try_emplace(surface, surfaces);
      if (is_new) ++surfaces;
      model.face_surface[place.first_face + k] = at->second;
    }
  }
}

}  // namespace hsr
