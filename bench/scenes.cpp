#include "bench/scenes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/error.h"

namespace hsr::bench {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Steele, Lea & Flood 2014.
std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double unit() { return static_cast<double>(splitmix64(state_) >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  int whole(int low, int high) {  // both included
    return low + static_cast<int>(splitmix64(state_) % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

struct CosSin {
  double cos, sin;
};

/// Cosine and sine of a part of a full turn. The sine of a library may differ in the last bit from one system to the next.
CosSin of_turn(double turns) {
  turns -= std::floor(turns);
  const int quarter = static_cast<int>(std::floor(turns * 4 + 0.5));
  const double x = (turns - quarter * 0.25) * 2 * pi;  // within an eighth of a turn
  double c = 1, s = x, c_term = 1, s_term = x;
  for (int k = 1; k <= 9; ++k) {
    c_term *= -x * x / ((2 * k - 1) * (2 * k));
    s_term *= -x * x / ((2 * k) * (2 * k + 1));
    c += c_term;
    s += s_term;
  }
  switch (quarter & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

Point3 operator+(const Point3& a, const Point3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point3 operator*(double s, const Point3& a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point3 cross(const Point3& a, const Point3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
Point3 unit(const Point3& a) { return (1 / std::sqrt(dot(a, a))) * a; }

/// Never inlined: g++ 12 at -O2 joins the conversions of two coordinates into a vector and then drops them.
[[gnu::noinline]] double to_float32(double x) { return static_cast<float>(x); }
Point3 to_float32(const Point3& p) { return {to_float32(p.x), to_float32(p.y), to_float32(p.z)}; }

void add_triangle(Polygons& polygons, std::size_t a, std::size_t b, std::size_t c) {
  for (const std::size_t corner : {a, b, c}) polygons.corners.push_back(static_cast<std::uint32_t>(corner));
  polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
}

Model empty_model(const std::string& name) {
  Model model;
  model.name = name;
  model.format = "generated";
  return model;
}

std::size_t rounded(double x) { return static_cast<std::size_t>(std::floor(x + 0.5)); }

/// A number in [0, 1) for each lattice point of each octave.
double lattice(std::uint64_t octave, std::uint64_t i, std::uint64_t j) {
  std::uint64_t state = (octave << 58) ^ (i << 29) ^ j;
  return static_cast<double>(splitmix64(state) >> 11) * 0x1p-53;
}

double value_noise(int octave, double x, double y) {
  const double i = std::floor(x), j = std::floor(y);
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const double u = smooth(x - i), v = smooth(y - j);
  const auto at = [&](int di, int dj) {
    return lattice(static_cast<std::uint64_t>(octave), static_cast<std::uint64_t>(i) + static_cast<std::uint64_t>(di),
                   static_cast<std::uint64_t>(j) + static_cast<std::uint64_t>(dj));
  };
  const double low = at(0, 0) + u * (at(1, 0) - at(0, 0)), high = at(0, 1) + u * (at(1, 1) - at(0, 1));
  return low + v * (high - low);
}

}  // namespace

Model knot(std::size_t triangles) {
  Model model = empty_model("knot");
  constexpr double tube = 0.4;
  // The knot is about 13 times as long as its tube is round: quads come out nearly square.
  const std::size_t around = std::max<std::size_t>(3, rounded(std::sqrt(static_cast<double>(triangles) / 2 / 13)));
  const std::size_t along = std::max<std::size_t>(3, rounded(static_cast<double>(triangles) / 2 / static_cast<double>(around)));
  for (std::size_t i = 0; i < along; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(along);
    const auto [c2, s2] = of_turn(2 * t);
    const auto [c3, s3] = of_turn(3 * t);
    const Point3 centre = {(2 + c3) * c2, (2 + c3) * s2, s3};
    const Point3 tangent = unit({-3 * s3 * c2 - 2 * (2 + c3) * s2, -3 * s3 * s2 + 2 * (2 + c3) * c2, 3 * c3});
    const Point3 normal = {c3 * c2, c3 * s2, s3};  // of the torus: it closes up without a twist
    const Point3 binormal = cross(tangent, normal);
    for (std::size_t j = 0; j < around; ++j) {
      const auto [c, s] = of_turn(static_cast<double>(j) / static_cast<double>(around));
      model.points.push_back(to_float32(centre + tube * (c * normal + s * binormal)));
    }
  }
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const std::size_t i1 = (i + 1) % along, j1 = (j + 1) % around;
      add_triangle(model.polygons, i * around + j, i1 * around + j, i1 * around + j1);
      add_triangle(model.polygons, i * around + j, i1 * around + j1, i * around + j1);
    }
  return model;
}

Model city(std::size_t boxes) {
  Model model = empty_model("city");
  constexpr int lot = 16;
  Random random(1);
  const std::size_t row = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(boxes)))));
  for (std::size_t k = 0; k < boxes; ++k) {
    const int x0 = static_cast<int>(k % row) * lot + random.whole(0, 4), x1 = x0 + random.whole(5, 11);
    const int y0 = static_cast<int>(k / row) * lot + random.whole(0, 4), y1 = y0 + random.whole(5, 11);
    const int height = random.whole(4, 24) + (random.whole(0, 9) == 0 ? random.whole(8, 40) : 0);
    const std::size_t first = model.points.size();
    for (int corner = 0; corner < 8; ++corner)
      model.points.push_back({static_cast<double>((corner & 1) != 0 ? x1 : x0),
                              static_cast<double>((corner & 2) != 0 ? y1 : y0),
                              static_cast<double>((corner & 4) != 0 ? height : 0)});
    constexpr std::array<std::array<std::size_t, 4>, 6> sides = {
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : sides) {
      add_triangle(model.polygons, first + a, first + b, first + c);
      add_triangle(model.polygons, first + a, first + c, first + d);
    }
  }
  return model;
}

Model crossing_triangles(std::size_t triangles) {
  Model model = empty_model("rand");
  Random random(2);
  const auto direction = [&] {
    for (;;) {
      const Point3 v = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      const double square = dot(v, v);
      if (square <= 1 && square > 0.01) return unit(v);
    }
  };
  // A direction seen from random sides shows half its area on average, so 8 layers over the unit square need an area of 16.
  const double area = 16.0 / static_cast<double>(triangles);
  const double radius = std::sqrt(4 * area / (3 * std::sqrt(3.0)));  // of the circle through the corners
  for (std::size_t k = 0; k < triangles; ++k) {
    const Point3 centre = {random.unit(), random.unit(), random.unit()};
    const Point3 u = direction();
    const Point3 v = unit(cross(u, direction()));
    const double h = std::sqrt(3.0) / 2;
    for (const auto& [s, t] : {std::array{1.0, 0.0}, std::array{-0.5, h}, std::array{-0.5, -h}})
      model.points.push_back(to_float32(centre + radius * (s * u + t * v)));
    add_triangle(model.polygons, 3 * k, 3 * k + 1, 3 * k + 2);
  }
  return model;
}

Model terrain(std::size_t triangles) {
  Model model = empty_model("terrain");
  const std::size_t cells = std::max<std::size_t>(1, rounded(std::sqrt(static_cast<double>(triangles) / 2)));
  const std::size_t rows = std::max<std::size_t>(1, rounded(static_cast<double>(triangles) / 2 / static_cast<double>(cells)));
  for (std::size_t i = 0; i <= rows; ++i)
    for (std::size_t j = 0; j <= cells; ++j) {
      const double x = static_cast<double>(i), y = static_cast<double>(j);
      double height = 0, wave = static_cast<double>(cells) / 2;
      for (int octave = 0; octave < 12 && wave >= 1.5; ++octave, wave /= 2)
        height += 0.35 * wave * value_noise(octave, x / wave, y / wave);
      model.points.push_back(to_float32({x, y, height}));
    }
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < cells; ++j) {
      const std::size_t a = i * (cells + 1) + j, b = a + cells + 1, c = b + 1, d = a + 1;
      add_triangle(model.polygons, a, b, c);
      add_triangle(model.polygons, a, c, d);
    }
  return model;
}

namespace {

// A plate with a square grid of holes: one cell of 4 x 4 for each, a hole of 16 corners in its middle.
constexpr std::size_t corners_of_hole = 16;
constexpr double cell = 4, thickness = 2, radius = 1.25;

void add_face(Polygons& polygons, const std::vector<std::size_t>& corners) {
  for (const std::size_t corner : corners) polygons.corners.push_back(static_cast<std::uint32_t>(corner));
  polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
}

// Every point is made twice, on the bottom and on the top: the one after it.
class PlateMaker {
 public:
  PlateMaker(Model& model, std::size_t holes)
      : model_(model), row_(std::max<std::size_t>(1, rounded(std::sqrt(static_cast<double>(holes))))), holes_(holes) {}

  void make_one_polygon();
  void make_quads();

 private:
  std::size_t add(double x, double y);
  std::size_t corner(std::size_t hole, std::size_t k) const { return 2 * (corners_of_hole * hole + k % corners_of_hole); }
  void add_holes();
  void add_both(std::vector<std::size_t> bottom);
  void walk_around(std::size_t hole, std::size_t entry, std::vector<std::size_t>& ring) const;

  Model& model_;
  std::size_t row_, holes_;
};

std::size_t PlateMaker::add(double x, double y) {
  model_.points.push_back(to_float32({x, y, 0}));
  model_.points.push_back(to_float32({x, y, thickness}));
  return model_.points.size() - 2;
}

void PlateMaker::add_holes() {
  for (std::size_t hole = 0; hole < holes_; ++hole) {
    const double x = (static_cast<double>(hole % row_) + 0.5) * cell, y = (static_cast<double>(hole / row_) + 0.5) * cell;
    for (std::size_t k = 0; k < corners_of_hole; ++k) {
      const auto [c, s] = of_turn(static_cast<double>(k) / corners_of_hole);
      add(x + radius * c, y + radius * s);
    }
    for (std::size_t k = 0; k < corners_of_hole; ++k) {
      const std::size_t a = corner(hole, k), b = corner(hole, k + 1);
      add_face(model_.polygons, {b, a, a + 1, b + 1});
    }
  }
}

// As seen from above counter-clockwise, on the bottom the other way round.
void PlateMaker::add_both(std::vector<std::size_t> ring) {
  for (std::size_t& p : ring) ++p;
  add_face(model_.polygons, ring);
  std::reverse(ring.begin(), ring.end());
  for (std::size_t& p : ring) --p;
  add_face(model_.polygons, ring);
}

// Around a hole from one of its corners and back there, clockwise; on the way across to the next hole of the row and, from the
// first of a row, to the next row.
void PlateMaker::walk_around(std::size_t hole, std::size_t entry, std::vector<std::size_t>& ring) const {
  for (std::size_t k = 0; k <= corners_of_hole; ++k) {
    const std::size_t at = (entry + corners_of_hole - k) % corners_of_hole;
    ring.push_back(corner(hole, at));
    const bool crosses_right = at == 0 && hole % row_ + 1 < row_ && hole + 1 < holes_;
    const bool crosses_up = at == corners_of_hole / 4 && hole % row_ == 0 && hole + row_ < holes_;
    if (k == corners_of_hole || (!crosses_right && !crosses_up)) continue;
    if (crosses_right)
      walk_around(hole + 1, corners_of_hole / 2, ring);
    else
      walk_around(hole + row_, 3 * corners_of_hole / 4, ring);
    ring.push_back(corner(hole, at));
  }
}

void PlateMaker::make_one_polygon() {
  add_holes();
  const double width = static_cast<double>(row_) * cell, height = static_cast<double>((holes_ + row_ - 1) / row_) * cell;
  const std::size_t a = add(0, 0), b = add(width, 0), c = add(width, height), d = add(0, height);
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}})
    add_face(model_.polygons, {from, to, to + 1, from + 1});
  std::vector<std::size_t> ring = {a};
  walk_around(0, 10, ring);  // the corner that is nearest to a
  ring.insert(ring.end(), {a, b, c, d});
  add_both(ring);
}

// Cells of 16 quads, each from a side of the hole to the border of the cell.
void PlateMaker::make_quads() {
  add_holes();
  for (std::size_t hole = 0; hole < holes_; ++hole) {
    const double x = (static_cast<double>(hole % row_) + 0.5) * cell, y = (static_cast<double>(hole / row_) + 0.5) * cell;
    std::vector<std::size_t> border;
    for (std::size_t k = 0; k < corners_of_hole; ++k) {
      const double quarter = static_cast<double>((k + 2) % 4) / 2 - 1;  // from -1 to 1 along one side of the cell
      const auto [c, s] = of_turn(static_cast<double>((k + 2) / 4) / 4);
      border.push_back(add(x + cell / 2 * (c - quarter * s), y + cell / 2 * (s + quarter * c)));
    }
    for (std::size_t k = 0; k < corners_of_hole; ++k) {
      const std::size_t next = (k + 1) % corners_of_hole;
      add_both({corner(hole, k + 1), corner(hole, k), border[k], border[next]});
      const std::size_t side = (k + 2) / 4 % 4, column = hole % row_;
      const bool is_outside = side == 0   ? column + 1 == row_ || hole + 1 == holes_
                              : side == 1 ? hole + row_ >= holes_
                              : side == 2 ? column == 0
                                          : hole < row_;
      if (is_outside) add_face(model_.polygons, {border[k], border[next], border[next] + 1, border[k] + 1});
    }
  }
}

}  // namespace

Model plate(std::size_t holes) {
  Model model = empty_model("plate");
  PlateMaker(model, holes).make_one_polygon();
  return model;
}

Model quad_plate(std::size_t holes) {
  Model model = empty_model("quadplate");
  PlateMaker(model, holes).make_quads();
  return model;
}

Model scene(const std::string& name) {
  const std::size_t digits = name.find_first_of("0123456789");
  std::size_t count = 0;
  if (digits != std::string::npos) {
    const char* end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + digits, end, count);
    const std::string unit_name(rest, end);
    if (error != std::errc() || count > 100'000'000) count = 0;
    if (unit_name == "k")
      count *= 1000;
    else if (unit_name == "M")
      count *= 1'000'000;
    else if (!unit_name.empty())
      count = 0;
  }
  const std::string family = name.substr(0, digits);
  if (count > 0 && count <= 100'000'000) {
    Model model;
    if (family == "knot") model = knot(count);
    if (family == "city") model = city(count);
    if (family == "rand") model = crossing_triangles(count);
    if (family == "terrain") model = terrain(count);
    if (family == "plate") model = plate(count);
    if (family == "quadplate") model = quad_plate(count);
    if (!model.name.empty()) {
      model.name = name;
      return model;
    }
  }
  throw InputError("scene '" + name + "': expected knot, city, rand, terrain, plate or quadplate and a size, as in knot100k");
}

std::string family(const std::string& scene) { return scene.substr(0, scene.find_first_of("0123456789")); }

}  // namespace hsr::bench
