#include "hsr/io/write/mesh_json.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "hsr/io/write/json_text.h"

namespace hsr::internal {

namespace {

using Side = std::array<VertexId, 2>;

bool is_diagonal(const Mesh& mesh, const Side& side) {
  const auto before = [](const Edge& e, const Side& s) { return std::tie(e.a, e.b) < std::tie(s[0], s[1]); };
  const auto e = std::lower_bound(mesh.edges.begin(), mesh.edges.end(), side, before);
  return e != mesh.edges.end() && e->a == side[0] && e->b == side[1] && e->diagonal;
}

/// The sides that two triangles of the face share.
std::vector<Side> diagonals(const Mesh& mesh, std::uint32_t first, std::uint32_t end) {
  std::vector<Side> sides, result;
  for (std::uint32_t t = first; t < end; ++t) {
    const auto& corners = mesh.triangles[TriangleId(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId a = corners[k], b = corners[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (sides[k] == sides[k - 1] && (result.empty() || result.back() != sides[k]) && is_diagonal(mesh, sides[k]))
      result.push_back(sides[k]);
  return result;
}

template <std::size_t n>
void append_indices(std::string& out, const std::array<VertexId, n>& indices) {
  out += '[';
  for (std::size_t k = 0; k < n; ++k) {
    if (k > 0) out += ", ";
    append_integer(out, indices[k].value);
  }
  out += ']';
}

template <std::size_t n>
void append_list(std::string& out, const std::vector<std::array<VertexId, n>>& list) {
  out += '[';
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (k > 0) out += ", ";
    append_indices(out, list[k]);
  }
  out += ']';
}

}  // namespace

std::string mesh_json(const Mesh& mesh, Numbers numbers) {
  std::string out = "{\"format\": \"hsr-mesh/1\", \"points\": [";
  const char* comma = "\n";
  for (const Point3& p : mesh.points) {
    out += comma;
    comma = ",\n";
    append_point(out, p, numbers);
  }
  out += "\n], \"faces\": [";
  comma = "\n";
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[FaceId(f)] == FaceUse::no_area || mesh.faces[FaceId(f)] == FaceUse::ghost) continue;
    const std::uint32_t first = mesh.first_triangle[FaceId(f)], end = mesh.first_triangle[FaceId(f + 1U)];
    out += comma;
    comma = ",\n";
    out += "{\"face\": ";
    append_integer(out, f);
    out += ", \"triangles\": ";
    append_list(out, std::vector<std::array<VertexId, 3>>(mesh.triangles.begin() + first, mesh.triangles.begin() + end));
    out += ", \"diagonals\": ";
    append_list(out, mesh.faces[FaceId(f)] == FaceUse::planar ? std::vector<Side>{} : diagonals(mesh, first, end));
    out += '}';
  }
  out += "\n], \"dropped\": [";
  comma = "\n";
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[FaceId(f)] != FaceUse::no_area) continue;
    out += comma;
    comma = ",\n";
    out += "{\"face\": ";
    append_integer(out, f);
    out += ", \"why\": \"no area\"}";
  }
  out += "\n]}\n";
  return out;
}

}  // namespace hsr::internal
