#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>

#include "hsr/io/read/corner_colours.h"
#include "hsr/io/read/face_names.h"
#include "hsr/io/read/source.h"
#include "hsr/model.h"

namespace hsr::internal::read {

/// Puts a Model together, face by face. Colours, objects and materials that nothing uses leave no trace.
///
/// Faces and wires before the first name of an object are of the object "default" (unless it is called otherwise), faces before the first
/// material of none. A face without a colour of its own has the mean colour of its corners.
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

  /// So many faces and corners follow. @pre the size of the file has confirmed it
  void reserve_faces(std::uint64_t faces, std::uint64_t corners) {
    model_.polygons.first.reserve(model_.polygons.first.size() + faces);
    model_.polygons.corners.reserve(model_.polygons.corners.size() + corners);
  }
  void add_corner(std::uint32_t i) { model_.polygons.corners.push_back(i); }
  std::size_t corners_of_open_face() const { return model_.polygons.corners.size() - model_.polygons.first.back(); }
  std::uint32_t open_corner(std::size_t k) const { return model_.polygons.corners[model_.polygons.first.back() + k]; }
  /// Ends the face of the corners added since the last one.
  void end_face() {
    if (model_.polygons.corners.size() > most) too_many("corners");
    model_.polygons.first.push_back(static_cast<std::uint32_t>(model_.polygons.corners.size()));
    if (colour_ || !model_.face_colour.empty()) note_colour();
    objects_.add_face();
    groups_.add_face();
    materials_.add_face();
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    add_corner(a);
    add_corner(b);
    add_corner(c);
    end_face();
  }
  void add_segment(std::uint32_t a, std::uint32_t b) {
    model_.polygons.segments.push_back({a, b});
    objects_.add_wire();
    groups_.add_wire();
  }
  std::size_t faces() const { return model_.polygons.size(); }
  std::size_t segments() const { return model_.polygons.segments.size(); }

  /// The colour of the faces that follow.
  void set_colour(std::optional<Colour> colour) {
    if (colour == colour_) return;
    colour_ = colour;
    colour_index_ = none;
  }
  /// The object of the faces and wires that follow; the same name means the same object.
  void set_object(std::string name) { objects_.set(std::move(name)); }
  /// As set_object, but a new object: if there is one of that name already, "name [2]" and so on.
  void start_object(std::string name) { objects_.start(std::move(name)); }
  /// What the object of faces and wires before the first name is called.
  void call_first_object(std::string name) { objects_.set_fallback(std::move(name)); }
  /// The group of the faces and wires that follow. Groups are the objects of a file that names no object.
  void set_group(std::string name) { groups_.set(std::move(name)); }
  /// The material of the faces that follow; nothing: none.
  void set_material(std::optional<std::string> name) { materials_.set(std::move(name)); }

  /// Colours of points, for faces that have none of their own.
  CornerColours& corner_colours() { return corner_colours_; }

  void set_units(char up_axis, double millimetres) {
    model_.up_axis = up_axis;
    model_.unit = millimetres;
  }
  /// A camera; the second one of a name is "name [2]".
  void add_camera(StoredCamera camera);

  void note(std::string text) { model_.notes.push_back(std::move(text)); }

  /// @param may_be_empty nothing to draw is no mistake
  /// @throws InputError if nothing could be drawn, or there is too much of it
  Model finish(bool may_be_empty = false);
  /// @throws InputError
  [[noreturn]] void too_many(const char* what) const;

 private:
  void note_colour();
  std::uint32_t colour_number(const Colour& colour);
  void colour_by_corners();

  const Source& source_;
  Model model_;
  std::unordered_map<std::uint32_t, std::uint32_t> palette_;  // by the bytes of a colour
  std::optional<Colour> colour_;
  std::uint32_t colour_index_ = none;
  CornerColours corner_colours_;
  FaceNames objects_{"default"}, groups_{"default"}, materials_{""};
};

}  // namespace hsr::internal::read
