// The z-buffers of a lecture, with its numbers: what each holds after each face, and what the depth transform does to depths.
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/depth_buffer.h"
#include "hsr/raster/row_z_buffer.h"

namespace {

/// Faces over a grid of samples at whole numbers, seen from above: (column, row, height). A depth d is the height -d.
class Scene {
 public:
  Scene(int width, int height) : grid_{{0.5, -0.5, 0}, {1, 0, 0}, {0, -1, 0}, width, height} {}

  void add(const std::vector<std::array<double, 3>>& corners) {
    for (const auto& [x, y, z] : corners) {
      polygons_.corners.push_back(static_cast<std::uint32_t>(points_.size()));
      points_.push_back({x, -y, z});
    }
    polygons_.first.push_back(static_cast<std::uint32_t>(polygons_.corners.size()));
  }
  hsr::Mesh mesh() const { return hsr::make_mesh(points_, polygons_); }
  const hsr::View& view() const { return view_; }
  const hsr::SampleGrid& grid() const { return grid_; }

  /// Rows of depths, 0 at the near and `far` at the far plane.
  void print_depths(double far, int digits = 0) const {
    const hsr::internal::DepthBuffer buffer = hsr::internal::depth_buffer(mesh(), view_, grid_, {.near = 0, .far = -far},
                                                                          {.format = hsr::internal::DepthFormat::fixed16});
    for (int j = 0; j < grid_.height; ++j) {
      for (int i = 0; i < grid_.width; ++i)
        std::cout << std::fixed << std::setprecision(digits) << std::setw(5) << buffer.depths.at(i, j) * far;
      std::cout << '\n';
    }
    std::cout << '\n';
  }

 private:
  std::vector<hsr::Point3> points_;
  hsr::Polygons polygons_;
  hsr::View view_ = hsr::parallel_view({0, 0, 1}, {0, 1, 0});
  hsr::SampleGrid grid_;
};

void whole_numbers() {
  std::cout << "Near 0, far 255: a triangle of depth 64, then one of 127\n";
  Scene scene(5, 5);
  scene.add({{0, 0, -64}, {5, 0, -64}, {0, 5, -64}});
  scene.print_depths(255);
  scene.add({{5, 0, -127}, {5, 5, -127}, {0, 0, -127}});
  scene.print_depths(255);
}

void piercing() {
  std::cout << "Far 64: a triangle of depth 5, then one from 2 to 7 that pierces it\n";
  Scene scene(8, 8);
  scene.add({{0, 0, -5}, {8, 0, -5}, {0, 8, -5}});
  scene.print_depths(64);
  scene.add({{0, 0.75, -7.25}, {0, 7, -1}, {6.25, 7, -7.25}});
  scene.print_depths(64);
}

void one_row() {
  std::cout << "One row, -1 where nothing is, the larger value wins: 3, then 5, then 1 ... 7\n";
  Scene scene(10, 1);
  const auto add_and_print = [&](double left, double right, double at_left, double at_right) {
    scene.add({{left, 1, at_left}, {right, 1, at_right}, {right, 0, at_right}, {left, 0, at_left}});
    const hsr::internal::RowZBuffer<float> buffer =
        hsr::internal::row_z_buffer<float>(scene.mesh(), scene.view(), scene.grid());
    for (const auto& pixel : buffer.image.pixels)
      std::cout << std::setw(4) << (pixel.triangle.is_valid() ? pixel.nearness : -1);
    std::cout << '\n';
  };
  std::cout << std::setprecision(0);
  add_and_print(1, 7, 3, 3);
  add_and_print(4, 9, 5, 5);
  add_and_print(2, 9, 0.5, 7.5);
  std::cout << "The same with the colours behind, black and half transparent on white\n";
  const hsr::Mesh mesh = scene.mesh();
  const std::vector<hsr::Colour> black(3, {0, 0, 0, 255});
  const hsr::internal::AlphaBuffer buffer = hsr::internal::alpha_buffer(mesh, scene.view(), scene.grid(), black, 0.5);
  for (const hsr::Colour& c : buffer.picture.pixels) std::cout << std::setw(4) << int{c[0]};
  std::cout << "\n\n";
}

void three_depths() {
  std::cout << "Far 1: triangles of depth 0.5, 0.75 and 0.25, one after the other\n";
  Scene scene(2, 1);
  for (const double depth : {0.5, 0.75, 0.25}) {
    scene.add({{0, 0, -depth}, {8, 0, -depth}, {0, 8, -depth}});
    scene.print_depths(1, 2);
  }
}

void compression() {
  std::cout << "z' = (c - z) / (z + z c), c = -n / f, for n = 0.1 and f = 1\n";
  for (const double z : {-0.1, -0.19, -0.5, -0.91, -1.0})
    std::cout << std::setprecision(2) << std::setw(6) << z << " -> " << std::setprecision(4)
              << hsr::internal::transformed_depth(z, 0.1, 1) + 0.0 << '\n';
}

}  // namespace

int main() {
  whole_numbers();
  piercing();
  one_row();
  three_depths();
  compression();
}
