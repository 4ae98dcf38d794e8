// A tree of planes built once, and the faces of a model ordered from far to near for a whole turn around it.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>

#include "hsr/io/read/read.h"
#include "hsr/painter/bsp/bsp.h"

int main(int argc, char** argv) try {
  const hsr::Model model = hsr::read_model(argc > 1 ? argv[1] : "part.obj");
  const hsr::Mesh mesh = hsr::make_mesh(model.points, model.polygons);
  const auto start = std::chrono::steady_clock::now();
  const hsr::BspTree tree(mesh);
  const auto built = std::chrono::steady_clock::now();
  constexpr int frames = 36;
  std::vector<std::uint32_t> far_to_near;  // numbers of pieces; draw them in this order
  for (int frame = 0; frame < frames; ++frame) {
    const double angle = 2 * std::numbers::pi * frame / frames;
    tree.walk(hsr::parallel_view({std::cos(angle), std::sin(angle), 0.5}, {0, 0, 1}), far_to_near);
  }
  const auto seconds = [](auto from, auto to) { return std::chrono::duration<double>(to - from).count(); };
  std::cout << tree.pieces() << " pieces of " << mesh.faces.size() << " faces: built in " << seconds(start, built)
            << " s, ordered " << frames << " times in " << seconds(built, std::chrono::steady_clock::now()) << " s\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
