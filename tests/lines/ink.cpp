#include "tests/lines/ink.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "tests/oracle/exact_vector.h"
#include "tests/oracle/seen_edges.h"

namespace hsr {

namespace {

using oracle::Q;
using oracle::Vec;

using Image = std::array<Q, 2>;

class ExactFrame {
 public:
  explicit ExactFrame(const View& view)
      : is_perspective_(view.is_perspective()),
        eye_(view.viewpoint.at),
        origin_(view.frame.origin),
        right_(view.frame.right),
        up_(view.frame.up),
        axis_(Vec(view.target) - eye_) {}

  Image operator()(const std::array<Rational, 3>& point) const {
    const Vec p(oracle::exact(point[0]), oracle::exact(point[1]), oracle::exact(point[2]));
    const Vec from = p - (is_perspective_ ? eye_ : origin_);
    Image at = {dot(from, right_), dot(from, up_)};
    if (!is_perspective_) return at;
    const Q depth = dot(from, axis_);
    at[0] /= depth;
    at[1] /= depth;
    return at;
  }

 private:
  bool is_perspective_;
  Vec eye_, origin_, right_, up_, axis_;
};

struct Part {
  Q from, to;
  int rank;  // what is drawn over what
  std::string style;
};

int rank_of(EdgeClass c, bool hidden) {
  const std::array order = {EdgeClass::outline,  EdgeClass::boundary, EdgeClass::sharp, EdgeClass::intersection,
                            EdgeClass::material, EdgeClass::wire,     EdgeClass::joint, EdgeClass::smooth};
  return static_cast<int>(std::find(order.begin(), order.end(), c) - order.begin()) + (hidden ? 100 : 0);
}

/// a x + b y = c, the first of a and b that is not 0 being 1.
std::array<Q, 3> line_through(const Image& p, const Image& q) {
  Q a = p[1] - q[1], b = q[0] - p[0];
  const Q first = sgn(a) != 0 ? a : b;
  a /= first;
  b /= first;
  const Q c = a * p[0] + b * p[1];
  return {a, b, c};
}

std::string text_of(const std::vector<Part>& parts) {
  std::vector<Q> places;
  for (const Part& p : parts) {
    places.push_back(p.from);
    places.push_back(p.to);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::string text, open;
  Q start;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Part* top = nullptr;
    for (const Part& p : parts)
      if (k + 1 < places.size() && p.from <= places[k] && places[k + 1] <= p.to && (top == nullptr || p.rank < top->rank))
        top = &p;
    const std::string style = top == nullptr ? "" : top->style;
    if (style == open) continue;
    if (!open.empty()) text += "  " + open + " " + start.get_str() + " to " + places[k].get_str() + "\n";
    open = style;
    start = places[k];
  }
  return text;
}

}  // namespace

std::string ink_of(const SceneView& scene, double tolerance) {
  LineOptions options;
  options.tolerance = tolerance;
  options.classes.fill(true);
  options.classes[static_cast<std::size_t>(EdgeClass::smooth)] = false;
  const VisibleLines lines = visible_lines(scene, options);
  const ExactFrame frame(scene.view());
  std::map<std::array<Q, 3>, std::vector<Part>> on_line;
  for (const Line& line : lines.lines) {
    const SupportingLine support = supporting_line_of(scene.mesh(), lines, line);
    const auto cuts = lines.cuts_of(line);
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      Image p = frame(exact_point(scene.mesh(), scene.view(), support, cuts[k]));
      Image q = frame(exact_point(scene.mesh(), scene.view(), support, cuts[k + 1]));
      if (p == q) continue;
      const auto key = line_through(p, q);
      const std::size_t along = sgn(key[1]) != 0 ? 0 : 1;
      Part part{std::min(p[along], q[along]), std::max(p[along], q[along]), rank_of(line.edge_class, line.hidden(k)),
                (line.hidden(k) ? "hidden " : "visible ") + std::string(oracle::to_text(line.edge_class))};
      on_line[key].push_back(std::move(part));
    }
  }
  std::string text;
  for (const auto& [line, parts] : on_line)
    text += line[0].get_str() + " x + " + line[1].get_str() + " y = " + line[2].get_str() + "\n" + text_of(parts);
  return text;
}

}  // namespace hsr
