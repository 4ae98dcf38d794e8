#include "hsr/scene/star_shaped_bodies.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>

#include "geometry/parallel.h"
#include "geometry/vector3.h"
#include "geometry/weighted_disjoint_sets.h"

namespace hsr::internal {

namespace {

using Range = tbb::blocked_range<std::size_t>;

/// What is known of a component of faces.
struct Component {
  Point3 middle;  // the mean of the corners of its triangles
  std::uint32_t corners = 0;
  TriangleId first;
  std::uint8_t is_broken = 0;  // not closed, or not consistently oriented
  std::uint8_t seen = 0;       // the middle is 1: on the positive side of a triangle; 2: on the negative side; 4: who knows

  // The ray from the middle through the first triangle, and two planes through it.
  Point3 on_ray;
  PlaneFilter across, along;
  std::uint32_t on_the_ray = 0;     // triangles that it may meet
  std::uint8_t is_ray_unclear = 0;  // it may pass through a side

  bool turns_one_way() const { return is_broken == 0 && (seen == 1 || seen == 2); }
  bool is_body() const { return turns_one_way() && on_the_ray == 1 && is_ray_unclear == 0; }
  Sign inside() const { return seen == 1 ? Sign::positive : Sign::negative; }
};

/// Which component each triangle belongs to: its faces are connected by edges of two triangles. A face that is connected to no
/// other is in none, so that soups cost little.
struct Components {
  static constexpr std::uint32_t none = 0xffffffffU;

  std::vector<std::uint32_t> of;  // by triangle
  std::vector<Component> all;

  explicit Components(const Mesh& mesh) : of(mesh.triangles.size()) {
    WeightedDisjointSets faces(mesh.faces.size());  // only for its sets
    std::vector<std::uint8_t> is_joined(mesh.faces.size(), 0);
    parallel_for_each(mesh.edges.size(), [&](std::size_t e) {
      const auto sides = mesh.triangles_at(EdgeId(e));
      if (sides.size() != 2) return;
      const FaceId f = mesh.face_of[sides[0]], g = mesh.face_of[sides[1]];
      if (f == g) return;
      faces.join(f.value, g.value, 0);
      for (const FaceId h : {f, g}) std::atomic_ref<std::uint8_t>(is_joined[h.value]).store(1, std::memory_order_relaxed);
    });
    std::vector<std::uint32_t> root(mesh.faces.size());
    const auto roots =
        parallel_collect<std::uint32_t>(root.size(), [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& part) {
          for (std::size_t f = begin; f < end; ++f) {
            root[f] = faces.find(static_cast<std::uint32_t>(f)).root;
            if (root[f] == f && is_joined[f] != 0) part.push_back(root[f]);
          }
        });
    std::vector<std::uint32_t> number(root.size(), none);
    parallel_for_each(roots.size(), [&](std::size_t k) { number[roots[k]] = static_cast<std::uint32_t>(k); });
    parallel_for_each(of.size(), [&](std::size_t t) { of[t] = number[root[mesh.face_of[TriangleId(t)].value]]; });
    all.resize(roots.size());
  }
  Component* at(TriangleId t) { return of[t.value] == none ? nullptr : &all[of[t.value]]; }
};

void set_bits(std::uint8_t& place, std::uint8_t bits) {
  std::atomic_ref<std::uint8_t> atomic(place);
  if ((atomic.load(std::memory_order_relaxed) & bits) != bits) atomic.fetch_or(bits, std::memory_order_relaxed);
}

/// At each edge, as many triangles of a component run along it as against it: the component is a cycle of triangles.
void find_broken(const ScaledMesh& scaled, Components& components) {
  constexpr std::size_t most_sides = 8;
  const Mesh& mesh = scaled.mesh();
  parallel_for_each(mesh.edges.size(), [&](std::size_t i) {
    const EdgeId e(i);
    const auto sides = mesh.triangles_at(e);
    for (const TriangleId t : sides) {
      Component* const c = components.at(t);
      if (c == nullptr) continue;
      int balance = 0;
      if (sides.size() <= most_sides)
        for (const TriangleId s : sides)
          if (components.of[s.value] == components.of[t.value]) balance += mesh.runs_along(s, mesh.edges[e]) ? 1 : -1;
      if (balance != 0 || sides.size() > most_sides) set_bits(c->is_broken, 1);
    }
  });
}

/// Sums of neighbouring triangles first, then of those: the same for any number of threads.
void find_middles(const ScaledMesh& scaled, Components& components) {
  struct Sum {
    std::uint32_t component;
    Point3 of_points;
    std::uint32_t corners;
    TriangleId first;
  };
  const Mesh& mesh = scaled.mesh();
  const auto sums =
      parallel_collect<Sum>(mesh.triangles.size(), [&](std::size_t begin, std::size_t end, std::vector<Sum>& part) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::uint32_t component = components.of[i];
          if (component == Components::none || components.all[component].is_broken != 0) continue;
          if (part.empty() || part.back().component != component) part.push_back({component, {}, 0, TriangleId(i)});
          Sum& sum = part.back();
          for (const VertexId v : mesh.triangles[TriangleId(i)]) sum.of_points = plus(sum.of_points, scaled.point(v));
          sum.corners += 3;
        }
      });
  for (const Sum& sum : sums) {
    Component& c = components.all[sum.component];
    if (c.corners == 0) c.first = sum.first;
    c.middle = plus(c.middle, sum.of_points);
    c.corners += sum.corners;
  }
  for (Component& c : components.all) {
    if (c.corners == 0) continue;
    const double n = c.corners;
    c.middle = {c.middle.x / n, c.middle.y / n, c.middle.z / n};
  }
}

void look_from_the_middles(const ScaledMesh& scaled, Components& components) {
  parallel_for_each(scaled.mesh().triangles.size(), [&](std::size_t i) {
    Component* const c = components.at(TriangleId(i));
    if (c == nullptr || c->is_broken != 0 || std::atomic_ref<std::uint8_t>(c->seen).load(std::memory_order_relaxed) > 2) return;
    const ErrorBounded side = scaled.filter(scaled.face_plane(TriangleId(i)))(c->middle);
    set_bits(c->seen, !side.is_certain() ? 4 : side.value > 0 ? 1 : 2);
  });
}

/// Of a cycle of triangles that all turn the same way around a point, as many lie in one direction as in any other: where one
/// direction meets one triangle, the cycle is star-shaped.
void count_on_rays(const ScaledMesh& scaled, Components& components) {
  const Mesh& mesh = scaled.mesh();
  parallel_for_each(components.all.size(), [&](std::size_t i) {
    Component& c = components.all[i];
    if (!c.turns_one_way()) return;
    const auto& t = mesh.triangles[c.first];
    const Point3 &p = scaled.point(t[0]), &q = scaled.point(t[1]), &r = scaled.point(t[2]);
    c.on_ray = {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3, (p.z + q.z + r.z) / 3};
    c.across = scaled.filter(Plane::of_face(c.middle, c.on_ray, p));
    c.along = scaled.filter(Plane::of_face(c.middle, c.on_ray, q));
  });
  parallel_for_each(mesh.triangles.size(), [&](std::size_t i) {
    if (components.of[i] == Components::none) return;
    Component& c = components.all[components.of[i]];
    if (!c.turns_one_way()) return;
    const auto& t = mesh.triangles[TriangleId(i)];
    const std::array<Point3, 3> p = {scaled.point(t[0]), scaled.point(t[1]), scaled.point(t[2])};
    for (const PlaneFilter* plane : {&c.across, &c.along}) {
      const std::array<ErrorBounded, 3> side = {(*plane)(p[0]), (*plane)(p[1]), (*plane)(p[2])};
      const auto all = [&](const auto& holds) { return std::all_of(side.begin(), side.end(), holds); };
      if (all([](ErrorBounded x) { return x.value > x.error; }) || all([](ErrorBounded x) { return x.value < -x.error; }))
        return;
    }
    // Orientation(middle, p0, p1, p2) is minus the side of the middle.
    const double turn = c.seen == 1 ? -1 : 1;
    bool is_clear = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const ErrorBounded side = scaled.filter(Plane::of_face(c.middle, p[k], p[(k + 1) % 3]))(c.on_ray);
      if (side.is_certain() && side.value * turn < 0) return;
      is_clear = is_clear && side.is_certain();
    }
    if (!is_clear) set_bits(c.is_ray_unclear, 1);
    std::atomic_ref<std::uint32_t>(c.on_the_ray).fetch_add(1, std::memory_order_relaxed);
  });
}

/// Of a star-shaped body with all faces: whether it is convex, too, and there are no wires. Exact.
bool is_convex(const ScaledMesh& scaled, Sign inside) {
  const Mesh& mesh = scaled.mesh();
  std::atomic<bool> is_convex = true;
  tbb::parallel_for(Range(0, mesh.edges.size(), 1024), [&](const Range& range) {
    Predicates exact = scaled.predicates();
    for (std::size_t i = range.begin(); i < range.end() && is_convex.load(std::memory_order_relaxed); ++i) {
      const EdgeId e(i);
      const auto all = mesh.triangles_at(e);
      if (all.size() == 2) {
        const Plane plane = scaled.face_plane(all[0]);
        const Point3& apex = scaled.point(mesh.apex(all[1], mesh.edges[e]));
        const ErrorBounded at = scaled.filter(plane)(apex);
        // Flat is convex: triangles that fold back upon one another would not both turn around the middle.
        if ((at.is_certain() ? sign_of(at.value) : exact.side_beyond_filter(plane, apex)) != -inside) continue;
      }
      is_convex.store(false, std::memory_order_relaxed);
    }
  });
  return is_convex;
}

}  // namespace

StarShapedBodies::StarShapedBodies(const ScaledMesh& scaled) {
  Components components(scaled.mesh());
  find_broken(scaled, components);
  find_middles(scaled, components);
  look_from_the_middles(scaled, components);
  count_on_rays(scaled, components);
  std::vector<std::uint32_t> number(components.all.size(), none);
  for (std::size_t k = 0; k < number.size(); ++k) {
    const Component& c = components.all[k];
    if (!c.is_body()) continue;
    number[k] = static_cast<std::uint32_t>(inside_.size());
    inside_.push_back(c.inside());
  }
  body_of_.assign(components.of.size(), none);
  parallel_for_each(body_of_.size(), [&](std::size_t t) {
    if (components.of[t] != Components::none) body_of_[t] = number[components.of[t]];
  });
  is_one_convex_body_ = inside_.size() == 1 && std::find(body_of_.begin(), body_of_.end(), none) == body_of_.end() &&
                        is_convex(scaled, inside_.front());
}

}  // namespace hsr::internal
