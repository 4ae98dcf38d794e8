#include "tests/oracle/sample_oracle.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

namespace {

/// An affine function at a sample: its value, and what it changes by along (right, down).
struct AtSample {
  std::array<Q, 3> x;

  int sign() const {
    for (const Q& k : x)
      if (sgn(k) != 0) return sgn(k);
    return 0;
  }
  friend AtSample operator+(const AtSample& a, const AtSample& b) {
    return {{Q(a.x[0] + b.x[0]), Q(a.x[1] + b.x[1]), Q(a.x[2] + b.x[2])}};
  }
  friend AtSample operator*(const Q& s, const AtSample& a) { return {{Q(s * a.x[0]), Q(s * a.x[1]), Q(s * a.x[2])}}; }
};

/// n . (p - o) at a moved sample p.
struct Moved {
  Vec p, right, down;
  AtSample operator()(const Vec& n, const Vec& o) const { return {{dot(n, p - o), dot(n, right), dot(n, down)}}; }
};

/// A triangle, made once for all samples.
struct Seen {
  std::array<Vec, 3> side, side_at;  // inward normals of the planes of sight, and a point of each
  Vec n, o;                          // the plane; n is toward the viewer
  Q toward;                          // n . (e - o), or n . D
};

}  // namespace

Image<std::vector<TriangleId>> layers_at_samples(const Mesh& mesh, const View& view, const SampleGrid& grid,
                                                 Coplanar coplanar) {
  const bool perspective = view.is_perspective();
  const Vec e(view.viewpoint.at);
  std::vector<Seen> all(mesh.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t) {
    std::array<Vec, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = Vec(mesh.points[mesh.triangles[TriangleId(t)][k]]);
    Seen& s = all[t];
    s.o = c[0];
    s.n = cross(c[1] - c[0], c[2] - c[0]);
    s.toward = perspective ? dot(s.n, e - s.o) : dot(s.n, e);
    if (sgn(s.toward) < 0) {
      std::swap(c[1], c[2]);
      s.n = Q(-1) * s.n;
      s.toward = -s.toward;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec &a = c[k], &b = c[(k + 1) % 3];
      s.side[k] = perspective ? cross(b - e, a - e) : cross(e, b - a);
      s.side_at[k] = a;
    }
  }
  const Vec to_target = Vec(view.target) - e;
  const Q near = Q(view.near) * dot(to_target, to_target);
  Image<std::vector<TriangleId>> image(grid.width, grid.height);
  for (int j = 0; j < grid.height; ++j) {
    for (int i = 0; i < grid.width; ++i) {
      const Moved sample = {Vec(grid.origin) + Q(i) * Vec(grid.right) + Q(j) * Vec(grid.down), Vec(grid.right), Vec(grid.down)};
      std::vector<std::pair<AtSample, TriangleId>> layers;
      for (std::size_t t = 0; t < all.size(); ++t) {
        const Seen& s = all[t];
        if (sgn(s.toward) == 0) continue;
        bool inside = true;
        for (std::size_t k = 0; k < 3 && inside; ++k) inside = sample(s.side[k], s.side_at[k]).sign() > 0;
        if (!inside) continue;
        // Seen at p - D n.(p - o) / n.D, or at e + (p - e) / nearness, nearness = n.(p - e) / n.(o - e).
        const AtSample nearness = Q(-1 / s.toward) * sample(s.n, perspective ? e : s.o);
        if (perspective) {
          // (x - e).(target - e) >= near, times the nearness, which is positive beyond the eye.
          const AtSample beyond = sample(to_target, e) + Q(-near) * nearness;
          if (nearness.sign() <= 0 || beyond.sign() < 0) continue;
        }
        layers.emplace_back(nearness, TriangleId(t));
      }
      if (coplanar == Coplanar::last) std::reverse(layers.begin(), layers.end());
      std::stable_sort(layers.begin(), layers.end(),
                       [](const auto& a, const auto& b) { return (a.first + Q(-1) * b.first).sign() > 0; });
      // A face that crosses itself covers each place of its plane once.
      std::vector<TriangleId>& seen = image.at(i, j);
      for (const auto& [nearness, t] : layers) {
        const FaceId face = mesh.face_of[t];
        const auto is_of_face = [&](TriangleId other) { return mesh.face_of[other] == face; };
        if (mesh.faces[face] != FaceUse::crosses_itself || std::none_of(seen.begin(), seen.end(), is_of_face))
          seen.push_back(t);
      }
    }
  }
  return image;
}

Image<TriangleId> seen_at_samples(const Mesh& mesh, const View& view, const SampleGrid& grid, Coplanar coplanar) {
  const Image<std::vector<TriangleId>> layers = layers_at_samples(mesh, view, grid, coplanar);
  Image<TriangleId> image(grid.width, grid.height);
  for (std::size_t k = 0; k < image.pixels.size(); ++k)
    if (!layers.pixels[k].empty()) image.pixels[k] = layers.pixels[k].front();
  return image;
}

}  // namespace hsr::oracle
