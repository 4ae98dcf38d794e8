#include "hsr/lines/near_stretches.h"

#include <algorithm>
#include <cmath>

#include "geometry/vector3.h"
#include "hsr/scene/half_space.h"

namespace hsr::internal {

namespace {

double length_of(const Point3& a) {
  const double most = norm_max(a);
  return most > 0 ? most * std::sqrt(dot(over(a, most), over(a, most))) : 0;
}

/// Those that touch a line at a parameter.
std::vector<TriangleId> touching(const auto& contacts, double at) {
  std::vector<TriangleId> some;
  for (const auto& c : contacts)
    if (c.from <= at && at <= c.to) some.push_back(c.triangle);
  return some;
}

}  // namespace

std::vector<NearStretches::Contact> NearStretches::contacts(const Point3& a, const Point3& b) const {
  std::vector<Contact> all;
  triangles_.visit_near(a, b, tolerance_, [&](TriangleId t) {
    if (const auto contact = near_contact(mesh_, t, a, b, tolerance_)) all.push_back({*contact, t});
  });
  std::sort(all.begin(), all.end(), [](const Contact& x, const Contact& y) { return x.triangle < y.triangle; });
  return all;
}

std::vector<NearStretch> NearStretches::of_line(TriangleOcclusion& occlusion, const Point3& a, const Point3& b) const {
  const double length = length_of(minus(b, a));
  const std::vector<Contact> near = contacts(a, b);
  std::vector<Breakpoint> places;
  // Where the border of a triangle crosses the line, by name; nothing where the place at the parameter `at` is not near that border.
  const auto add_place = [&](TriangleId triangle, std::size_t side, double at, double rise) {
    if (side == 3) return;
    auto place = occlusion.crossing(half_spaces(projected_, triangle, occlusion.exact())[side].cut);
    if (!place) return;
    // Of a line that ends where planes an ulp apart meet doubles may not tell where it is crossed.
    if (place->error == HUGE_VAL) place->t = at;
    if (std::fabs(place->t - at) * rise <= 8 * tolerance_) places.push_back(*place);
  };
  for (const Contact& c : near) {
    add_place(c.triangle, c.side_from, c.from, c.rise_from);
    add_place(c.triangle, c.side_to, c.to, c.rise_to);
  }
  std::stable_sort(places.begin(), places.end(),
                   [&](const Breakpoint& x, const Breakpoint& y) { return occlusion.order(x, y) == Sign::negative; });
  std::vector<NearStretch> stretches;
  Breakpoint from = occlusion.first();
  for (std::size_t k = 0; k <= places.size(); ++k) {
    const Breakpoint& to = k < places.size() ? places[k] : occlusion.last();
    // Of places nearer to one another than the tolerance, and to an end, one is enough.
    const bool is_short = (to.t - from.t) * length <= 2 * tolerance_;
    if (is_short && (k < places.size() || !stretches.empty())) continue;
    stretches.push_back({from, to, touching(near, (from.t + to.t) / 2)});
    from = to;
  }
  stretches.back().to = occlusion.last();
  return stretches;
}

}  // namespace hsr::internal
