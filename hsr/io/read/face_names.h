#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace hsr::internal::read {

/// Names that faces bear, such as those of objects, numbered by first use. A name that no face bears leaves no trace.
class FaceNames {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// @param fallback the name of the faces before the first one that is named; empty: they have none
  explicit FaceNames(std::string fallback) : fallback_(std::move(fallback)) {}

  void set_fallback(std::string name) { fallback_ = std::move(name); }

  /// The name of the faces that follow; nothing: the fallback. The same name means the same number.
  void set(std::optional<std::string> name) {
    name_ = std::move(name);
    number_ = none;
    is_new_ = false;
  }
  /// As set, but a new number: the second one of a name is called "name [2]", and so on.
  void start(std::string name) {
    set(std::move(name));
    is_new_ = true;
  }
  /// One more face. @param faces how many there are with it
  void add_face(std::size_t faces) {
    if (name_ || !of_face_.empty()) label(faces);
  }

  bool empty() const { return names_.empty(); }
  /// The names, and for each face the number of its own; takes them out.
  void move_to(std::vector<std::string>& names, std::vector<std::uint32_t>& of_face) {
    names = std::move(names_);
    of_face = std::move(of_face_);
  }

 private:
  void label(std::size_t faces);
  std::uint32_t number_of(const std::string& name);
  std::string unused(const std::string& name);

  std::string fallback_;
  std::vector<std::string> names_;
  std::vector<std::uint32_t> of_face_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::unordered_map<std::string, std::size_t> repeats_;  ///< how often a name was started
  std::optional<std::string> name_;
  std::uint32_t number_ = none;
  bool is_new_ = false;
};

}  // namespace hsr::internal::read
