// A view with a section against the same scene with the cut already made: the same ink, the same visible areas.
#include "hsr/surfaces/section.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <sstream>

#include "hsr/lines/visible_lines.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/oracle/exact_vector.h"
#include "tests/section/cut_boxes.h"

namespace hsr {
namespace {

using oracle::Q;
using Place = std::array<Q, 2>;

/// The straight lines of the image that are inked, and where, in a form that does not depend on what drew them.
class Ink {
 public:
  explicit Ink(const View& view) : view_(view) {}

  void add(const std::array<Rational, 3>& p, const std::array<Rational, 3>& q) {
    const Place a = image_of(p), b = image_of(q);
    Q x = b[1] - a[1], y = a[0] - b[0];
    if (sgn(x) == 0 && sgn(y) == 0) return;
    const Q first = sgn(x) != 0 ? x : y;
    x /= first;
    y /= first;
    const Q c = x * a[0] + y * a[1];
    // Along the line, by the coordinate that changes.
    const int k = sgn(y) != 0 ? 0 : 1;
    parts_[{x, y, c}].push_back(std::minmax(a[k], b[k]));
  }
  /// Calls add(from, to) for what is visible, by default the one above.
  template <class Add>
  static void for_each_visible(const SceneView& scene, const Add& add) {
    LineOptions options;
    options.classes.fill(true);
    const VisibleLines lines = visible_lines(scene, options);
    for (const Line& line : lines.lines)
      for (std::uint32_t k = 0; k < line.intervals(); ++k)
        if (!line.hidden(k)) add(exact_point(scene, lines, line, k), exact_point(scene, lines, line, k + 1));
  }
  std::string text() const {
    std::string all;
    for (const auto& [line, parts] : parts_) {
      auto sorted = parts;
      std::sort(sorted.begin(), sorted.end());
      std::string of_line;
      Q from = sorted.front().first, to = sorted.front().second;
      const auto end = [&] { of_line += " " + from.get_str() + ".." + to.get_str(); };
      for (const auto& [low, high] : sorted) {
        if (low > to) {
          end();
          from = low;
          to = high;
        }
        to = std::max(to, high);
      }
      end();
      all += line[0].get_str() + "," + line[1].get_str() + "," + line[2].get_str() + ":" + of_line + "\n";
    }
    return all;
  }
  /// What one has and the other has not, line by line.
  static std::string differences(const Ink& found, const Ink& expected) {
    const auto lines_of = [](const Ink& ink) {
      std::set<std::string> lines;
      std::istringstream in(ink.text());
      for (std::string line; std::getline(in, line);) lines.insert(line);
      return lines;
    };
    const std::set<std::string> a = lines_of(found), b = lines_of(expected);
    std::string all;
    for (const std::string& line : a)
      if (!b.contains(line)) all += "found    " + line + "\n";
    for (const std::string& line : b)
      if (!a.contains(line)) all += "expected " + line + "\n";
    return all;
  }

 private:
  Place image_of(const std::array<Rational, 3>& p) const {
    const auto at = image(view_, p);
    return {oracle::exact(at[0]), oracle::exact(at[1])};
  }

  const View& view_;
  std::map<std::array<Q, 3>, std::vector<std::pair<Q, Q>>> parts_;
};

Rational dot(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
std::array<Rational, 3> difference(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
std::array<Rational, 3> cross(const std::array<Rational, 3>& a, const std::array<Rational, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// What is in the plane lies behind the caps, which are moved towards the viewer by less than anything: here they are in the plane, and
/// hide nothing in it. So of a line in the plane that is no border of a cap only what no cap covers is expected.
void add_expected(Ink& ink, const CutBoxes& boxes, const std::array<Rational, 3>& p, const std::array<Rational, 3>& q) {
  const SectionPlane& plane = *boxes.view.section;
  const std::array<Rational, 3> at = {plane.point.x, plane.point.y, plane.point.z},
                                normal = {plane.normal.x, plane.normal.y, plane.normal.z};
  std::vector<std::pair<Rational, Rational>> left = {{0.0, 1.0}};
  const bool is_in_plane =
      dot(difference(p, at), normal).sign() == Sign::zero && dot(difference(q, at), normal).sign() == Sign::zero;
  std::vector<std::pair<Rational, Rational>> borders;
  for (std::size_t cap = 0; is_in_plane && cap < boxes.caps; ++cap) {
    Rational low = 0.0, high = 1.0;
    bool is_border = false;
    const auto ring = boxes.cut_polygons[cap];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto corner = [&](std::size_t i) -> std::array<Rational, 3> {
        const Point3& c = boxes.cut_points[ring[i % ring.size()]];
        return {c.x, c.y, c.z};
      };
      const auto inward = cross(difference(corner(k + 1), corner(k)), normal);
      const Rational at_p = dot(inward, difference(p, corner(k))), at_q = dot(inward, difference(q, corner(k)));
      is_border = is_border || (at_p.sign() == Sign::zero && at_q.sign() == Sign::zero);
      if (at_p.sign() != Sign::negative && at_q.sign() != Sign::negative) continue;
      if (at_p.sign() != Sign::positive && at_q.sign() != Sign::positive) low = 2.0;
      if (low == Rational(2.0)) break;
      const Rational cut = at_p / (at_p - at_q);
      if (at_p.sign() == Sign::negative) low = std::max(low, cut);
      if (at_q.sign() == Sign::negative) high = std::min(high, cut);
    }
    if (!(low < high)) continue;
    if (is_border) borders.emplace_back(low, high);
    std::vector<std::pair<Rational, Rational>> rest;
    for (const auto& [from, to] : left) {
      if (from < low) rest.emplace_back(from, std::min(to, low));
      if (to > high) rest.emplace_back(std::max(from, high), to);
    }
    left = rest;
  }
  left.insert(left.end(), borders.begin(), borders.end());
  const auto along = difference(q, p);
  const auto place = [&](const Rational& t) {
    return std::array<Rational, 3>{p[0] + t * along[0], p[1] + t * along[1], p[2] + t * along[2]};
  };
  for (const auto& [from, to] : left) ink.add(place(from), place(to));
}

Rational area_of_rings(const View& view, const Section& section, const SectionCap& cap) {
  Rational twice;
  for (std::uint32_t r = cap.first_ring; r < cap.end_ring; ++r) {
    const auto ring = section.rings[r];
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto p = image(view, ring[k]), q = image(view, ring[(k + 1) % ring.size()]);
      twice = twice + (p[0] * q[1] - p[1] * q[0]);
    }
  }
  return twice * Rational(0.5);
}

template <class Check>
void on_cut_boxes(const Check& check) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    const CutBoxes boxes = cut_boxes(seed);
    INFO("seed " << seed << "\n" << boxes.text);
    check(boxes, Scene(make_mesh(boxes.points, boxes.polygons), boxes.labels));
  }
}

TEST_CASE("a section inks what the scene with the cut made inks", "[section][random][X1][X5]") {
  on_cut_boxes([](const CutBoxes& boxes, const Scene& scene) {
    const SceneView cut(scene, boxes.view);
    const Mesh made = make_mesh(boxes.cut_points, boxes.cut_polygons);
    Ink expected(boxes.view), found(boxes.view);
    Ink::for_each_visible(SceneView(made, boxes.uncut_view),
                          [&](const auto& from, const auto& to) { add_expected(expected, boxes, from, to); });
    Ink::for_each_visible(cut, [&](const auto& from, const auto& to) { found.add(from, to); });
    for (const SectionLine& line : section(cut).lines) {
      found.add(line.ends[0], line.ends[1]);
      add_expected(expected, boxes, line.ends[0], line.ends[1]);
    }
    CHECK(Ink::differences(found, expected) == "");
  });
}

TEST_CASE("a section shows what the scene with the cut made shows of each face", "[section][random]") {
  on_cut_boxes([](const CutBoxes& boxes, const Scene& scene) {
    const SceneView cut(scene, boxes.view);
    const Mesh made = make_mesh(boxes.cut_points, boxes.cut_polygons);
    const SceneView with_faces(made, boxes.uncut_view);
    std::map<std::uint32_t, Rational> expected, found;
    const VisibleFragments of_made = visible_fragments(with_faces), of_cut = visible_fragments(cut);
    const auto made_areas = visible_areas(made, boxes.uncut_view, of_made);
    for (std::size_t k = 0; k < made_areas.size(); ++k) {
      const std::uint32_t face = made.face_of[first_triangle(of_made.fragments[k].facet)].value;
      if (face < boxes.caps) continue;
      Rational& sum = expected[boxes.original[face - boxes.caps]];
      sum = sum + made_areas[k];
    }
    const auto cut_areas = visible_areas(scene.mesh(), boxes.view, of_cut);
    for (std::size_t k = 0; k < cut_areas.size(); ++k) {
      Rational& sum = found[scene.mesh().face_of[first_triangle(of_cut.fragments[k].facet)].value];
      sum = sum + cut_areas[k];
    }
    CHECK(found == expected);
  });
}

TEST_CASE("caps are as large as the cut faces", "[section][random][X3]") {
  on_cut_boxes([](const CutBoxes& boxes, const Scene& scene) {
    const Section found = section(SceneView(scene, boxes.view));
    CHECK(found.open_outlines == 0);
    std::map<std::uint32_t, Rational> of_object, expected;
    for (const SectionCap& cap : found.caps) of_object[cap.object] = area_of_rings(boxes.view, found, cap);
    for (std::size_t k = 0; k < boxes.caps; ++k) {
      Rational twice;
      const auto ring = boxes.cut_polygons[k];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto at = [&](std::size_t c) {
          const Point3& p = boxes.cut_points[ring[c % ring.size()]];
          return image(boxes.view, {p.x, p.y, p.z});
        };
        const auto p = at(i), q = at(i + 1);
        twice = twice + (p[0] * q[1] - p[1] * q[0]);
      }
      expected[boxes.box_of_cap[k]] = twice * Rational(0.5);
    }
    CHECK(of_object == expected);
  });
}

}  // namespace
}  // namespace hsr
