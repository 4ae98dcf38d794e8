// part_model OUT.obj: writes the part that examples/run draws.
#include <exception>
#include <fstream>
#include <iostream>

#include "examples/part.h"
#include "geometry/error.h"

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw hsr::InputError("usage: part_model OUT.obj");
    const hsr::Model part = hsr::examples::part();
    std::ofstream out(argv[1]);
    out.precision(17);
    out << "# A spur gear on a flange; millimetres, Z up\no part\n";
    for (const hsr::Point3& p : part.points) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (std::size_t f = 0; f < part.polygons.size(); ++f) {
      out << 'f';
      for (const auto corner : part.polygons[f]) out << ' ' << corner + 1;
      out << '\n';
    }
    if (!out.flush()) throw hsr::InputError(std::string(argv[1]) + ": cannot be written");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
