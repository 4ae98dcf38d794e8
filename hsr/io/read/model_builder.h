#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "hsr/io/read/source.h"
#include "hsr/model.h"

namespace hsr::internal::read {

/// Puts a Model together, face by face. Colours and objects that no face uses leave no trace.
class ModelBuilder {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  static constexpr std::size_t most = 0xfffffffeU;  ///< points, faces, corners and segments are counted in 32 bits

  ModelBuilder(const Source& source, std::string format) : source_(source) {
    model_.name = source.path;
    model_.format = std::move(format);
  }

  std::vector<Point3>& points() { return model_.points; }
  const std::vector<Point3>& points() const { return model_.points; }
  void add_point(double x, double y, double z) { model_.points.push_back({x, y, z}); }

  void add_corner(std::uint32_t i) { model_.polygons.corners.push_back(i); }
  std::size_t corners_of_open_face() const { return model_.polygons.corners.size() - model_.polygons.first.back(); }
  std::uint32_t open_corner(std::size_t k) const { return model_.polygons.corners[model_.polygons.first.back() + k]; }
  /// Ends the face of the corners added since the last one.
  void end_face() {
    if (model_.polygons.corners.size() > most) too_many("corners");
    model_.polygons.first.push_back(static_cast<std::uint32_t>(model_.polygons.corners.size()));
    if (colour_ || !model_.face_colour.empty()) note_colour();
    if (!object_name_.empty() || !model_.face_object.empty()) note_object();
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    add_corner(a);
    add_corner(b);
    add_corner(c);
    end_face();
  }
  void add_segment(std::uint32_t a, std::uint32_t b) { model_.polygons.segments.push_back({a, b}); }
  std::size_t faces() const { return model_.polygons.size(); }
  std::size_t segments() const { return model_.polygons.segments.size(); }

  /// The colour of the faces that follow.
  void set_colour(std::optional<Colour> colour) {
    if (colour == colour_) return;
    colour_ = colour;
    colour_index_ = none;
  }
  /// The object of the faces that follow; the same name means the same object.
  void set_object(std::string name) {
    object_name_ = std::move(name);
    object_ = none;
  }
  /// As set_object, but a new object even if there is one of that name.
  void start_object(std::string name) {
    object_names_.clear();
    set_object(std::move(name));
  }

  void note(std::string text) { model_.notes.push_back(std::move(text)); }

  /// @throws InputError if nothing could be drawn, or there is too much of it
  Model finish();
  /// @throws InputError
  [[noreturn]] void too_many(const char* what) const;

 private:
  void note_colour();
  void note_object();

  const Source& source_;
  Model model_;
  std::map<Colour, std::uint32_t> palette_;
  std::optional<Colour> colour_;
  std::uint32_t colour_index_ = none;
  std::unordered_map<std::string, std::uint32_t> object_names_;
  std::string object_name_;
  std::uint32_t object_ = none;
};

}  // namespace hsr::internal::read
