#include "study/explain/picture_result.h"

#include "hsr/io/write/json_text.h"
#include "hsr/io/write/svg_text.h"

namespace hsr::internal {

namespace {

template <class T, class Text>
std::string rows_json(const Image<T>& image, const Text& text) {
  std::string out = "[";
  for (int j = 0; j < image.height; ++j) {
    out += j == 0 ? "[" : ",[";
    for (int i = 0; i < image.width; ++i) out += (i == 0 ? "" : ",") + text(image.at(i, j));
    out += "]";
  }
  return out + "]";
}

}  // namespace

std::string faces_json(const ScenePicture& picture, const Image<TriangleId>& triangles) {
  return rows_json(triangles, [&](TriangleId t) {
    return t.is_valid() ? std::to_string(picture.scene().mesh.face_of[t].value) : std::string("-1");
  });
}

std::string faces_result(const ScenePicture& picture, const Image<TriangleId>& triangles) {
  return "{\"faces\":" + faces_json(picture, triangles) + "}";
}

std::string numbers_json(const Image<double>& numbers) {
  return rows_json(numbers, [](double x) {
    std::string text;
    append_number(text, x, Numbers::rounded);
    return text;
  });
}

std::string colours_json(const Image<Colour>& picture) {
  return rows_json(picture, [](const Colour& c) {
    std::string text = "\"";
    append_colour(text, c);
    return text + "\"";
  });
}

std::vector<Colour> colours_of(const TracedScene& scene) {
  std::vector<Colour> colours;
  for (const TracedFace& face : scene.faces) colours.push_back(face.colour);
  return colours;
}

std::string columns_text(int begin, int end) {
  return begin + 1 == end ? "column " + std::to_string(begin)
                          : "columns " + std::to_string(begin) + " … " + std::to_string(end - 1);
}

std::string colour_text(const Colour& c) {
  return "(" + std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]) + ")";
}

void mark_frame(TraceStep& step, int left, int top, int right, int bottom) {
  const double l = left, t = top, r = right, b = bottom;
  step.mark({{l, t}, {r, t}}).mark({{r, t}, {r, b}}).mark({{r, b}, {l, b}}).mark({{l, b}, {l, t}});
}

}  // namespace hsr::internal
