#include "bench/peers/probes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "bench/peers/image.h"

namespace hsr::bench {

namespace {

std::vector<ImagePoint> images(const Mesh& mesh, const Image& image) {
  std::vector<ImagePoint> points;
  points.reserve(mesh.points.size());
  for (const Point3& p : mesh.points) points.push_back(image(p));
  return points;
}

struct Box {
  double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;

  void add(const ImagePoint& p) {
    low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
  }
};

enum class Hides { no, yes, perhaps };

/// Whether a triangle lies before p, as far as that can be told with a `margin` in the image and the same in nearness.
Hides hides(const std::array<ImagePoint, 3>& corners, const ImagePoint& p, double margin) {
  const auto& [a, b, c] = corners;
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  const double nearest = std::max({a.nearness, b.nearness, c.nearness});
  double sides[3], perimeter = 0;
  bool inside = true;
  double weight[3];
  for (int k = 0; k < 3; ++k) {
    const ImagePoint &from = corners[static_cast<std::size_t>(k + 1) % 3], &to = corners[static_cast<std::size_t>(k + 2) % 3];
    sides[k] = std::hypot(to.x - from.x, to.y - from.y);
    perimeter += sides[k];
    weight[k] = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    if (area < 0) weight[k] = -weight[k];
  }
  if (std::fabs(area) <= margin * perimeter) {  // seen edge-on: all there is to say is that p may be behind it
    for (int k = 0; k < 3; ++k)
      if (std::fabs(weight[k]) > 2 * margin * perimeter) return Hides::no;
    Box box;
    for (const ImagePoint& q : corners) box.add(q);
    const bool near = p.x >= box.low_x - margin && p.x <= box.high_x + margin && p.y >= box.low_y - margin &&
                      p.y <= box.high_y + margin && nearest > p.nearness - margin;
    return near ? Hides::perhaps : Hides::no;
  }
  for (int k = 0; k < 3; ++k) {
    if (weight[k] < -margin * sides[k]) return Hides::no;
    if (weight[k] < margin * sides[k]) inside = false;
  }
  const double there = (weight[0] * a.nearness + weight[1] * b.nearness + weight[2] * c.nearness) / std::fabs(area);
  // By how much the nearness changes within the margin.
  const double bz = b.nearness - a.nearness, cz = c.nearness - a.nearness;
  const double slope = std::hypot(bz * (c.y - a.y) - cz * (b.y - a.y), cz * (b.x - a.x) - bz * (c.x - a.x)) / std::fabs(area);
  const double before = there - p.nearness, unsure = margin * (1 + slope);
  if (before < -unsure) return Hides::no;
  return inside && before > unsure ? Hides::yes : Hides::perhaps;
}

}  // namespace

std::vector<Probe> make_probes(const Mesh& mesh, const View& view, std::size_t count) {
  const Image image(view);
  const std::vector<ImagePoint> at = images(mesh, image);
  const auto length = [&](const Edge& e) {
    return e.of_face ? std::hypot(at[e.b.value].x - at[e.a.value].x, at[e.b.value].y - at[e.a.value].y) : 0.0;
  };
  double all = 0;
  for (const Edge& e : mesh.edges) all += length(e);
  std::vector<Probe> probes;
  const double step = all / static_cast<double>(count);
  double before = 0;
  for (std::size_t e = 0; e < mesh.edges.size() && probes.size() < count; ++e) {
    const Edge& edge = mesh.edges[EdgeId(e)];
    const double l = length(edge);
    // One third of a step in, so that no probe is the middle of an edge, where symmetric scenes have their ties.
    for (; probes.size() < count;) {
      const double s = ((static_cast<double>(probes.size()) + 1.0 / 3) * step - before) / l;
      if (!(s < 1)) break;
      const double t = image.parameter_in_space(mesh.points[edge.a], mesh.points[edge.b], std::max(s, 0.0));
      probes.push_back({EdgeId(e), t});
    }
    before += l;
  }
  return probes;
}

std::vector<Answer> truth(const Mesh& mesh, const View& view, const std::vector<Probe>& probes) {
  const Image image(view);
  const std::vector<ImagePoint> at = images(mesh, image);
  Box all;
  for (const ImagePoint& p : at) all.add(p);
  const double size = std::max({all.high_x - all.low_x, all.high_y - all.low_y, 1e-300}), margin = 1e-9 * size;

  // Probes by the cell of the image they are in, so that a triangle asks only those near it.
  constexpr int cells = 256;
  const auto cell = [&](double x, double low) { return std::clamp(static_cast<int>((x - low) / size * cells), 0, cells - 1); };
  struct Asked {
    std::size_t probe;
    ImagePoint at;
  };
  std::vector<std::vector<Asked>> grid(static_cast<std::size_t>(cells) * cells);
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const Edge& edge = mesh.edges[probes[k].edge];
    const Point3 &a = mesh.points[edge.a], &b = mesh.points[edge.b];
    const auto between = [&](double p, double q) { return p + probes[k].t * (q - p); };
    const ImagePoint p = image({between(a.x, b.x), between(a.y, b.y), between(a.z, b.z)});
    grid[static_cast<std::size_t>(cell(p.y, all.low_y)) * cells + static_cast<std::size_t>(cell(p.x, all.low_x))].push_back(
        {k, p});
  }
  std::vector<Answer> answers(probes.size(), Answer::visible);
  for (const std::array<VertexId, 3>& triangle : mesh.triangles) {
    const std::array<ImagePoint, 3> corners = {at[triangle[0].value], at[triangle[1].value], at[triangle[2].value]};
    Box box;
    for (const ImagePoint& p : corners) box.add(p);
    const int left = cell(box.low_x - margin, all.low_x), right = cell(box.high_x + margin, all.low_x);
    const int low = cell(box.low_y - margin, all.low_y), high = cell(box.high_y + margin, all.low_y);
    for (int j = low; j <= high; ++j)
      for (int i = left; i <= right; ++i)
        for (const Asked& asked : grid[static_cast<std::size_t>(j) * cells + static_cast<std::size_t>(i)]) {
          if (answers[asked.probe] == Answer::hidden) continue;
          const Edge& edge = mesh.edges[probes[asked.probe].edge];
          const auto has = [&](VertexId v) { return triangle[0] == v || triangle[1] == v || triangle[2] == v; };
          if (has(edge.a) && has(edge.b)) continue;
          const Hides h = hides(corners, asked.at, margin);
          if (h == Hides::yes) answers[asked.probe] = Answer::hidden;
          if (h == Hides::perhaps) answers[asked.probe] = Answer::none;
        }
  }
  return answers;
}

}  // namespace hsr::bench
