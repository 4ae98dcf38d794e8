#include "hsr/io/write/json.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <span>

#include "hsr/drawing/cut_parameter.h"
#include "hsr/io/write/interval_places.h"
#include "hsr/io/write/json_text.h"
#include "hsr/io/write/section_json.h"
#include "hsr/symbols/constructions.h"

namespace hsr {

using namespace internal;

namespace {

/// The object of what is written, if it is of one.
void append_object(std::string& out, std::uint32_t object) {
  if (object == SceneObjects::none) return;
  out += ", \"object\": ";
  append_integer(out, object);
}

/// Writes one line after the other; one writer per thread.
class LineWriter {
 public:
  LineWriter(const Mesh& mesh, const View& view, const VisibleLines& lines, const JsonOptions& options)
      : mesh_(mesh),
        view_(view),
        lines_(lines),
        objects_(options.objects),
        numbers_(options.numbers),
        point_numbers_(options.point_numbers),
        face_numbers_(options.face_numbers),
        why_(options.why),
        places_(mesh, view, options.numbers) {}

  void append(std::string& out, const Line& line) {
    support_ = supporting_line_of(mesh_, lines_, line);
    if (support_.is_edge()) {
      out += "{\"edge\": [";
      append_integer(out, number(point_numbers_, support_.a.value));
      out += ", ";
      append_integer(out, number(point_numbers_, support_.b.value));
    } else {
      out += "{\"points\": [";
      append_point(out, exact_point(mesh_, view_, support_, support_.meet.from));
      out += ", ";
      append_point(out, exact_point(mesh_, view_, support_, support_.meet.to));
    }
    out += "], \"class\": \"";
    out += name_of(line.edge_class);
    out += "\", \"faces\": [";
    const std::vector<FaceId> faces = faces_at(mesh_, lines_, line);
    append_faces(out, faces);
    out += ']';
    if (objects_ != nullptr) append_object(out, object_of(*objects_, line, faces));
    out += ", \"visible\": [";
    append_intervals(out, line, false);
    out += "], \"hidden\": [";
    append_intervals(out, line, true);
    out += ']';
    places_.append(out, lines_, line, support_);
    if (why_) {
      out += ", \"by\": [";
      const char* comma = "";
      for (const Occluder& o : lines_.occluders_of(line)) {
        out += comma;
        comma = ", ";
        out += '[';
        append_integer(out, number(face_numbers_, o.face.value));
        out += ", ";
        append_parameter(out, o.from);
        out += ", ";
        append_parameter(out, o.to);
        out += ']';
      }
      out += ']';
    }
    out += '}';
  }

 private:
  void append_point(std::string& out, const std::array<Rational, 3>& p) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      out += axis == 0 ? "[" : ", ";
      append_rational(out, p[axis], numbers_);
    }
    out += ']';
  }

  static std::uint32_t number(std::span<const std::uint32_t> numbers, std::uint32_t i) {
    return numbers.empty() ? i : numbers[i];
  }
  void append_faces(std::string& out, std::span<const FaceId> faces) const {
    const char* comma = "";
    for (const FaceId f : faces) {
      out += comma;
      comma = ", ";
      append_integer(out, number(face_numbers_, f.value));
    }
  }

  void append_intervals(std::string& out, const Line& line, bool hidden) {
    const auto cuts = lines_.cuts_of(line);
    const char* comma = "";
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (line.hidden(k) != hidden) continue;
      out += comma;
      comma = ", ";
      out += '[';
      append_parameter(out, cuts[k]);
      out += ", ";
      append_parameter(out, cuts[k + 1]);
      out += ']';
    }
  }

  void append_parameter(std::string& out, const Cut& cut) {
    const bool is_end = cut.kind == Cut::Kind::end;
    if (is_end || cut.kind == Cut::Kind::start) {
      out += numbers_ == Numbers::exact ? (is_end ? "\"1\"" : "\"0\"") : (is_end ? "1" : "0");
    } else if (numbers_ == Numbers::exact) {
      append_rational(out, exact_parameter(mesh_, view_, support_, cut), numbers_);
    } else {
      append_number(out, rounded_parameter(mesh_, view_, support_, cut), numbers_);
    }
  }

  const Mesh& mesh_;
  const View& view_;
  const VisibleLines& lines_;
  const SceneObjects* objects_;
  Numbers numbers_;
  std::span<const std::uint32_t> point_numbers_, face_numbers_;
  bool why_;
  IntervalPlaces places_;
  SupportingLine support_;  // of the line at hand
};

/// A fragment as text, and what it is sorted by.
struct FragmentText {
  std::uint32_t face = 0;
  std::array<Rational, 3> start;
  std::string text;
};

/// The rings in space, each from its smallest point on.
FragmentText fragment_text(const Mesh& mesh, const View& view, const VisibleFragments& all, const Fragment& f,
                           const JsonOptions& options) {
  const Numbers numbers = options.numbers;
  FragmentText out;
  out.face = mesh.face_of[first_triangle(f.facet)].value;
  out.text = "{\"face\": ";
  append_integer(out.text, options.face_numbers.empty() ? out.face : options.face_numbers[out.face]);
  if (options.objects != nullptr)
    append_object(out.text, options.objects->object_of(std::array{mesh.face_of[first_triangle(f.facet)]}));
  out.text += ", \"rings\": [";
  for (std::uint32_t r = f.first_ring; r < f.end_ring; ++r) {
    std::vector<std::array<Rational, 3>> ring;
    for (const MapCorner& c : all.rings[r]) ring.push_back(exact_point(mesh, view, f.facet, c.at));
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    if (r == f.first_ring) out.start = ring.front();
    out.text += r == f.first_ring ? "[" : ", [";
    for (std::size_t k = 0; k < ring.size(); ++k) {
      out.text += k == 0 ? "[" : ", [";
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axis > 0) out.text += ", ";
        append_rational(out.text, ring[k][axis], numbers);
      }
      out.text += ']';
    }
    out.text += ']';
  }
  out.text += "]}";
  return out;
}

void append_fragments(std::string& out, const Mesh& mesh, const View& view, const VisibleFragments& all,
                      const JsonOptions& options) {
  std::vector<FragmentText> texts(all.fragments.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, texts.size(), 256), [&](const auto& range) {
    for (std::size_t k = range.begin(); k != range.end(); ++k)
      texts[k] = fragment_text(mesh, view, all, all.fragments[k], options);
  });
  std::sort(texts.begin(), texts.end(), [](const FragmentText& x, const FragmentText& y) {
    return x.face != y.face ? x.face < y.face : x.start < y.start;
  });
  out += ", \"fragments\": [\n";
  for (std::size_t k = 0; k < texts.size(); ++k) {
    if (k > 0) out += ",\n";
    out += texts[k].text;
  }
  out += "\n]";
}

void append_names(std::string& out, const SceneObjects* objects) {
  if (objects == nullptr || !objects->are_told_apart()) return;
  out += ", \"objects\": [";
  const char* comma = "";
  for (const std::string& name : objects->names) {
    out += comma;
    comma = ", ";
    append_string(out, name);
  }
  out += ']';
}

}  // namespace

namespace {

void append_plane(std::string& out, const char* before, const SectionPlane& plane, Numbers numbers) {
  out += before;
  out += "{\"point\": ";
  append_point(out, plane.point, numbers);
  out += ", \"normal\": ";
  append_point(out, plane.normal, numbers);
  out += '}';
}

}  // namespace

const char* name_of(EdgeClass edge_class) { return edge_class_names[static_cast<std::size_t>(edge_class)]; }

std::string view_json(const View& view, Numbers numbers) {
  const Point3& e = view.viewpoint.at;
  std::string out = "{\"eye\": [";
  for (const double x : {e.x, e.y, e.z}) {
    append_number(out, x, numbers);
    out += ", ";
  }
  append_number(out, view.viewpoint.w(), numbers);
  out += "], \"target\": ";
  append_point(out, view.target, numbers);
  out += ", \"up\": ";
  append_point(out, view.up, numbers);
  out += ", \"frame\": {\"origin\": ";
  append_point(out, view.frame.origin, numbers);
  out += ", \"right\": ";
  append_point(out, view.frame.right, numbers);
  out += ", \"up\": ";
  append_point(out, view.frame.up, numbers);
  out += "}, \"near\": ";
  if (view.is_perspective())
    append_number(out, view.near, numbers);
  else
    out += "null";
  if (view.section) append_plane(out, ", \"section\": ", *view.section, numbers);
  for (std::size_t k = 0; k < view.planes.size(); ++k)
    append_plane(out, k == 0 ? ", \"sections\": [" : ", ", view.planes[k], numbers);
  if (!view.planes.empty()) out += ']';
  if (view.far) append_plane(out, ", \"far\": ", *view.far, numbers);
  out += '}';
  return out;
}

std::string lines_json(const Mesh& mesh, const View& view, const VisibleLines& lines, const JsonOptions& options) {
  constexpr std::size_t chunk = 4096;
  std::vector<std::string> parts((lines.lines.size() + chunk - 1) / chunk);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    LineWriter writer(mesh, view, lines, options);
    for (std::size_t i = p * chunk; i < std::min(lines.lines.size(), (p + 1) * chunk); ++i) {
      if (i > 0) parts[p] += ",\n";
      writer.append(parts[p], lines.lines[i]);
    }
  });
  std::string out = "{\"format\": \"hsr-lines/1\", \"view\": " + view_json(view, options.numbers);
  append_names(out, options.objects);
  out += ", \"lines\": [\n";
  std::size_t size = out.size() + 8;
  for (const std::string& part : parts) size += part.size();
  out.reserve(size);
  for (std::string& part : parts) {
    out += part;
    part = {};
  }
  out += "\n]";
  if (options.fragments != nullptr) append_fragments(out, mesh, view, *options.fragments, options);
  if (options.section != nullptr) append_section(out, *options.section, options.numbers, !view.planes.empty());
  out += "}\n";
  return out;
}

}  // namespace hsr
