#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace hsr::internal::read {

/// Names that faces and wires bear, such as those of objects, numbered by first use. A name that none bears leaves no trace.
class FaceNames {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// @param fallback the name of the faces and wires before the first one that is named; empty: they have none
  explicit FaceNames(std::string fallback) : fallback_(std::move(fallback)) {}

  void set_fallback(std::string name) { fallback_ = std::move(name); }

  /// The name of the faces and wires that follow; nothing: the fallback. The same name means the same number.
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
  void add_face() { add_to(of_face_); }
  void add_wire() { add_to(of_wire_); }

  bool empty() const { return names_.empty(); }
  /// The names, and for each face and each wire the number of its own; takes them out.
  void move_to(std::vector<std::string>& names, std::vector<std::uint32_t>& of_face, std::vector<std::uint32_t>& of_wire) {
    names = std::move(names_);
    of_face = std::move(of_face_.numbers);
    of_wire = std::move(of_wire_.numbers);
  }

 private:
  /// Of the faces, or of the wires.
  struct Labels {
    std::size_t before_first_name = 0;
    std::vector<std::uint32_t> numbers;
  };

  void add_to(Labels& labels) {
    if (name_ || is_used_)
      label(labels);
    else
      ++labels.before_first_name;
  }
  void label(Labels& labels);
  std::uint32_t number_of(const std::string& name);
  std::string unused(const std::string& name);

  std::string fallback_;
  std::vector<std::string> names_;
  Labels of_face_, of_wire_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::unordered_map<std::string, std::size_t> repeats_;  ///< how often a name was started
  std::optional<std::string> name_;
  std::uint32_t number_ = none;
  bool is_new_ = false;
  bool is_used_ = false;  ///< a face or a wire was named
};

}  // namespace hsr::internal::read
