#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "bench/peers/painters.h"
#include "bench/peers/seen_points.h"
#include "geometry/error.h"

namespace hsr::bench {

PeerOrder sketch(const Mesh& mesh, const View& view, bool bsp) {
  // It looks down its z axis.
  const auto points = seen_points(mesh, view, 20);
  std::string text;
  for (const auto& corners : mesh.triangles) {
    text += "polygon[cull=false]";
    for (const VertexId v : corners)
      text += fmt::format("({:.9g},{:.9g},{:.9g})", points[v.value][0], points[v.value][1], points[v.value][2]);
    text += '\n';
  }
  std::string name = (std::filesystem::temp_directory_path() / "hsr-sketch-XXXXXX").string();
  require(::mkdtemp(name.data()) != nullptr, "sketch: no temporary directory");
  const std::filesystem::path directory = name;
  const std::string in = (directory / "in.sk").string(), out = (directory / "out.tex").string();
  std::ofstream(in) << text;
  const std::string command = fmt::format("sketch {} -o '{}' '{}' 2> /dev/null", bsp ? "-b" : "", out, in);
  const auto start = std::chrono::steady_clock::now();
  const int status = std::system(command.c_str());
  PeerOrder order;
  order.compute = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::ifstream file(out);
  for (std::string line; std::getline(file, line);)
    if (line.find("\\pspolygon") != std::string::npos) ++order.pieces;
  std::error_code ignored;
  std::filesystem::remove_all(directory, ignored);
  if (status != 0 || order.pieces == 0)
    throw InputError(fmt::format("sketch: status {}, {} polygons; is the package sketch installed?", status, order.pieces));
  return order;
}

}  // namespace hsr::bench
