#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
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
  std::uint32_t circle = none;
};

class MarksReader {
 public:
  MarksReader(const read::Source& source, Model& model) : source_(source), model_(model) {}

  void read(const Json& file) {
    if (!file.is_object()) source_.refuse("", "found no object, expected {\"format\": \"hsr-marks/1\", ...}");
    if (!file.contains("format") || file["format"] != "hsr-marks/1")
      source_.refuse("format", "found " + shown(file, "format") + ", expected \"hsr-marks/1\"");
    if (file.contains("surfaces")) read_surfaces(file["surfaces"]);
    if (!file.contains("edges")) return;
    if (!file["edges"].is_array()) refuse("edges", file["edges"], "a list");
    merge_points();
    for (const Json& edge : file["edges"]) read_edge(edge, "edge " + std::to_string(edges_read_++));
    add_marks();
  }

 private:
  static std::string shown(const Json& object, const char* key) {
    return object.contains(key) ? read::printable(object[key].dump(-1, ' ', false, Json::error_handler_t::replace)) : "nothing";
  }
  [[noreturn]] void refuse(const std::string& where, const Json& found, const std::string& expected) const {
    source_.refuse(where, "found " + read::printable(found.dump(-1, ' ', false, Json::error_handler_t::replace)) +
                              ", expected " + expected);
  }

  void read_surfaces(const Json& surfaces) {
    const std::size_t faces = model_.polygons.size();
    if (!surfaces.is_array()) refuse("surfaces", surfaces, "a list");
    if (surfaces.size() != faces)
      source_.refuse("surfaces", "found " + std::to_string(surfaces.size()) + " numbers, expected one for each of the " +
                                     std::to_string(faces) + " faces of the model");
    std::vector<std::uint32_t> of_face;
    for (const Json& x : surfaces) {
      const bool is_number = x.is_number_unsigned() && x.get<std::uint64_t>() < none;
      if (!is_number && !x.is_null())
        refuse("surfaces, face " + std::to_string(of_face.size()), x, "the number of a surface, or null");
      of_face.push_back(is_number ? x.get<std::uint32_t>() : none);
    }
    model_.face_surface = std::move(of_face);
    model_.surfaces.clear();
  }

  /// Points that are equal have one number here, whatever the faces call them.
  void merge_points() {
    std::vector<Point3> merged;
    read::MergedPoints numbers(merged);
    for (const Point3& p : model_.points) merged_.push_back(numbers.index(p));
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
      source_.refuse(where + ": points", "found " + shown(edge, "points") + ", expected the numbers of two points or more");
    SaidOfEdge said{mark_named(edge.contains("mark") ? edge["mark"] : Json(), where), none};
    if (edge.contains("circle")) said.circle = read_circle(edge["circle"], where + ": circle");
    std::uint32_t last = none;
    for (const Json& p : edge["points"]) {
      if (!p.is_number_unsigned() || p.get<std::uint64_t>() >= model_.points.size())
        refuse(where + ": points", p,
               "the number of one of the " + std::to_string(model_.points.size()) + " points of the model");
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
    model_.circles.push_back({centre, {axis.x / length, axis.y / length, axis.z / length}, radius});
    return static_cast<std::uint32_t>(model_.circles.size() - 1);
  }

  /// A mark for each object that has a face along the edge.
  void add_marks() {
    std::map<Ends, std::set<std::uint32_t>> objects;
    for (std::size_t f = 0; f < model_.polygons.size(); ++f) {
      const auto corners = model_.polygons[f];
      const std::uint32_t object = model_.face_object.empty() ? 0 : model_.face_object[f];
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Ends ends = std::minmax(merged_[corners[k]], merged_[corners[(k + 1) % corners.size()]]);
        if (said_.contains(ends)) objects[ends].insert(object);
      }
    }
    std::size_t missing = 0;
    std::map<std::uint32_t, std::uint32_t> first_of;  // a point of each number
    for (std::uint32_t p = 0; p < merged_.size(); ++p) first_of.try_emplace(merged_[p], p);
    for (const auto& [ends, said] : said_) {
      if (!objects.contains(ends)) ++missing;
      for (const std::uint32_t object : objects[ends])
        for (const SaidOfEdge& s : said)
          model_.marks.push_back({{first_of[ends.first], first_of[ends.second]}, s.mark, object, s.circle});
    }
    if (missing > 0)
      model_.notes.push_back(source_.path + ": marks of edges that no face has, passed over: " + std::to_string(missing));
  }

  const read::Source& source_;
  Model& model_;
  std::vector<std::uint32_t> merged_;
  std::map<Ends, std::vector<SaidOfEdge>> said_;
  std::size_t edges_read_ = 0;
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
  MarksReader(source, model).read(json);
}

}  // namespace hsr
