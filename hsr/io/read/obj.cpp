#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hsr/io/read/formats.h"
#include "hsr/io/read/material_library.h"
#include "hsr/io/read/model_builder.h"
#include "hsr/io/read/text_scanner.h"

namespace hsr::internal::read {

namespace {

constexpr const char* coordinate = "a coordinate";
constexpr const char* vertex_index = "the index of a vertex";

/// Statements that say nothing about shape or colour.
constexpr std::array<std::string_view, 24> silent = {
    "vt", "vn",     "vp",    "s",     "mg",   "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "maplib",
    "p",  "usemap", "ctech", "stech", "bmat", "step",  "parm",     "trim",     "hole", "scrv",       "sp",        "end"};
/// Free-form curves and surfaces, which need what `silent` has of them too.
constexpr std::array<std::string_view, 9> free_form = {"curv", "curv2", "surf", "cstype", "deg", "con", "bzp", "bsp", "cdc"};

template <std::size_t n>
bool is_one_of(std::string_view word, const std::array<std::string_view, n>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class ObjReader {
 public:
  explicit ObjReader(const Source& source)
      : source_(source), text_(source, {.comment = '#', .continuation = true}), model_(source, "OBJ") {}

  Model read() {
    for (; text_.skip_lines(); text_.next_line()) {
      const char* const p = text_.position();
      if (*p == 'v' && text_.is_delimiter(p + 1)) {
        text_.move_to(p + 1);
        read_vertex();
      } else if (*p == 'f' && text_.is_delimiter(p + 1)) {
        text_.move_to(p + 1);
        read_face();
      } else {
        read_other(text_.word(), p);
      }
    }
    check_forward_references();
    if (weights_ != 0)
      model_.note(std::to_string(weights_) + " vertices with a weight other than 1: the weights are passed over");
    if (!free_form_.empty()) model_.note("curves and surfaces (" + free_form_ + ") are passed over");
    if (textured_) model_.note("textures (map_Kd) are passed over: faces have the colour of their material");
    if (!unknown_.empty()) model_.note("statements that OBJ does not have are passed over, the first: " + unknown_);
    return model_.finish();
  }

 private:
  void read_vertex() {
    const double x = text_.number(coordinate);
    const double y = text_.number(coordinate);
    const double z = text_.number(coordinate);
    model_.add_point(x, y, z);
    if (text_.at_line_end()) return;
    // A fourth number is the weight, unless more follow: three, or four with an opacity, are a colour.
    std::array<double, 4> more = {text_.number("a weight, a colour or the end of the line")};
    if (text_.at_line_end()) {
      if (more[0] != 1) ++weights_;
      return;
    }
    std::size_t n = 1;
    for (; n < more.size(); ++n) {
      const std::optional<double> next = text_.number_if_any();
      if (!next) break;
      more[n] = *next;
    }
    if (n >= 3) model_.corner_colours().set(model_.points().size() - 1, more.data(), 3);
  }

  /// The vertex at the scanner; passes over /vt/vn.
  std::uint32_t read_index() {
    const char* const start = text_.position();
    const std::int64_t i = text_.integer_prefix();
    const char* p = text_.position();
    if (*p == '/')
      while (*p == '/' || *p == '-' || *p == '+' || (*p >= '0' && *p <= '9')) ++p;
    if (text_.position() == start || !text_.is_delimiter(p)) text_.refuse(start, vertex_index);
    text_.move_to(p);
    const auto count = static_cast<std::int64_t>(model_.points().size());
    if (i > 0 && i <= count) return static_cast<std::uint32_t>(i - 1);
    if (i > count && i <= static_cast<std::int64_t>(ModelBuilder::most)) {
      // The vertex may still follow.
      if (forward_.empty() || i > forward_.back().index) forward_.push_back({i, start});
      return static_cast<std::uint32_t>(i - 1);
    }
    if (i < 0 && -i <= count) return static_cast<std::uint32_t>(count + i);
    refuse_index(start, count);
  }

  [[noreturn]] void refuse_index(const char* start, std::int64_t count) const {
    text_.refuse(start, count == 0
                            ? std::string("a vertex before the first face")
                            : "an index from 1 to " + std::to_string(count) + ", or from -1 to -" + std::to_string(count));
  }

  void read_face() {
    const char* const start = text_.position();
    std::size_t n = 0;
    for (; !text_.at_line_end(); ++n) model_.add_corner(read_index());
    if (n < 3) text_.refuse(start, "a face of " + std::to_string(n) + (n == 1 ? " corner" : " corners"), "3 or more");
    model_.end_face();
  }

  void read_polyline() {
    const char* const start = text_.position();
    std::size_t n = 0;
    std::uint32_t last = 0;
    for (; !text_.at_line_end(); ++n) {
      const std::uint32_t i = read_index();
      if (n != 0) model_.add_segment(last, i);
      last = i;
    }
    if (n < 2) text_.refuse(start, "a line of " + std::to_string(n) + (n == 1 ? " vertex" : " vertices"), "2 or more");
  }

  void read_other(std::string_view word, const char* start) {
    std::string keyword(word);  // in capitals, too
    std::transform(keyword.begin(), keyword.end(), keyword.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "f" || keyword == "fo") {  // an old word for f
      read_face();
    } else if (keyword == "l") {
      read_polyline();
    } else if (keyword == "o" || keyword == "g") {
      std::string name = text_.rest_of_joined_lines();
      if (name.empty()) name = "default";
      keyword == "o" ? model_.set_object(std::move(name)) : model_.set_group(std::move(name));
    } else if (keyword == "usemtl") {
      read_material();
    } else if (keyword == "mtllib") {
      std::vector<std::string> notes;
      materials_.load(source_, text_.rest_of_joined_lines(), notes);
      for (std::string& note : notes) model_.note(std::move(note));
    } else if (is_one_of(keyword, free_form)) {
      if (free_form_.empty()) free_form_ = keyword;
    } else if (!is_one_of(keyword, silent)) {
      if (unknown_.empty()) unknown_ = "line " + std::to_string(text_.line_of(start)) + ", " + in_quotes(word);
    }
  }

  /// Without a name: the faces that follow have no material.
  void read_material() {
    const std::string line = text_.rest_of_joined_lines();
    const std::string_view name = without_quotes(line);
    if (name.empty())
      model_.set_material({});
    else
      model_.set_material(std::string(name));
    model_.set_colour(materials_.colour(name));
    textured_ = textured_ || materials_.is_textured(name);
  }

  void check_forward_references() const {
    const auto count = static_cast<std::int64_t>(model_.points().size());
    // They ascend, so the first one that is too large is the first one in the file.
    for (const Forward& f : forward_)
      if (f.index > count) refuse_index(f.at, count);
  }

  struct Forward {
    std::int64_t index;
    const char* at;
  };

  const Source& source_;
  TextScanner text_;
  ModelBuilder model_;
  MaterialLibrary materials_;
  std::vector<Forward> forward_;  ///< references to vertices that had not been read yet, each larger than all before it
  std::size_t weights_ = 0;
  std::string free_form_;
  std::string unknown_;
  bool textured_ = false;
};

}  // namespace

Model read_obj(const Source& source) { return ObjReader(source).read(); }

}  // namespace hsr::internal::read
