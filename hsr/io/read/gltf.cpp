#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hsr/io/read/formats.h"
#include "hsr/io/read/gltf_file.h"
#include "hsr/io/read/gltf_transform.h"
#include "hsr/io/read/material_library.h"
#include "hsr/io/read/model_builder.h"

namespace hsr::internal::read {

namespace {

/// A small file can place one mesh many times; this many points, or faces and lines, are more than any model, and fit into
/// memory.
constexpr std::size_t most_placed = std::size_t{1} << 28;

/// Reads the nodes of the default scene, parents before children, in the order of the file.
///
/// What is rounded: the matrix of a node is its own, or made of its translation, rotation and scale in doubles; it is
/// multiplied with the parent's in doubles. That product is then taken as exact, and each coordinate of a point that it maps is
/// rounded once, to the nearest double. A node whose matrix is the identity leaves its points as they are in the file.
class GltfReader {
 public:
  GltfReader(const Source& source, tinygltf::Model file, bool is_glb)
      : source_(source), file_(std::move(file)), model_(source, is_glb ? "GLB" : "glTF") {}

  Model read(std::vector<std::string> notes) {
    for (std::string& note : notes) model_.note(std::move(note));
    std::vector<Placed> stack;
    const std::vector<int> roots = root_nodes();
    for (auto i = roots.rbegin(); i != roots.rend(); ++i) stack.push_back({*i, identity});
    std::vector<bool> visited(file_.nodes.size(), false);
    while (!stack.empty()) {
      const Placed placed = stack.back();
      stack.pop_back();
      if (placed.node < 0 || static_cast<std::size_t>(placed.node) >= file_.nodes.size())
        refuse("", "node " + std::to_string(placed.node), "one of " + std::to_string(file_.nodes.size()));
      const auto n = static_cast<std::size_t>(placed.node);
      if (visited[n]) refuse("node " + std::to_string(n), "a second parent or a cycle", "a tree of nodes");
      visited[n] = true;
      const tinygltf::Node& node = file_.nodes[n];
      if (node.extensions.count("EXT_mesh_gpu_instancing") != 0) instanced_ = true;
      const Affine global = compose_or_keep(placed.parent, local_matrix(node, n));
      if (node.mesh >= 0) read_mesh(node, n, global);
      for (auto i = node.children.rbegin(); i != node.children.rend(); ++i) stack.push_back({*i, global});
    }
    if (rounded_) model_.note("points moved by nodes are rounded once, to the nearest double, by matrices composed in doubles");
    if (points_only_) model_.note("primitives of points are passed over");
    if (instanced_) model_.note("instances of EXT_mesh_gpu_instancing are passed over: one of each is drawn");
    return model_.finish();
  }

 private:
  struct Placed {
    int node;
    Affine parent;
  };

  [[noreturn]] void refuse(const std::string& where, const std::string& found, const std::string& expected) const {
    source_.refuse(where, "found " + found + ", expected " + expected);
  }

  std::vector<int> root_nodes() const {
    if (!file_.scenes.empty()) {
      const int scene = file_.defaultScene < 0 ? 0 : file_.defaultScene;
      if (static_cast<std::size_t>(scene) >= file_.scenes.size())
        refuse("", "scene " + std::to_string(scene), "one of " + std::to_string(file_.scenes.size()));
      return file_.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<bool> is_child(file_.nodes.size(), false);
    for (const tinygltf::Node& node : file_.nodes)
      for (const int child : node.children)
        if (child >= 0 && static_cast<std::size_t>(child) < is_child.size()) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
      if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
  }

  Affine local_matrix(const tinygltf::Node& node, std::size_t n) const {
    Affine m = identity;
    if (!node.matrix.empty()) {
      if (node.matrix.size() != 16)
        refuse("node " + std::to_string(n), "a matrix of " + std::to_string(node.matrix.size()) + " numbers", "16");
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j) m[4 * i + j] = node.matrix[4 * j + i];
    } else {
      const auto check = [&](const std::vector<double>& v, std::size_t size, const char* what) {
        if (!v.empty() && v.size() != size)
          refuse("node " + std::to_string(n), std::string("a ") + what + " of " + std::to_string(v.size()) + " numbers",
                 std::to_string(size));
      };
      check(node.translation, 3, "translation");
      check(node.rotation, 4, "rotation");
      check(node.scale, 3, "scale");
      if (!node.rotation.empty()) {
        const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
        m = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     0,
             2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     0,
             2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), 0};
      }
      if (!node.scale.empty())
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) m[4 * i + j] *= node.scale[j];
      if (!node.translation.empty())
        for (std::size_t i = 0; i < 3; ++i) m[4 * i + 3] = node.translation[i];
    }
    return m;
  }

  static Affine compose_or_keep(const Affine& parent, const Affine& local) {
    if (parent == identity) return local;
    if (local == identity) return parent;
    return compose(parent, local);
  }

  void read_mesh(const tinygltf::Node& node, std::size_t n, const Affine& global) {
    if (static_cast<std::size_t>(node.mesh) >= file_.meshes.size())
      refuse("node " + std::to_string(n), "mesh " + std::to_string(node.mesh), "one of " + std::to_string(file_.meshes.size()));
    for (const double x : global)
      if (!std::isfinite(x)) refuse("node " + std::to_string(n), "a matrix with NaN or infinity", "finite numbers");
    const tinygltf::Mesh& mesh = file_.meshes[static_cast<std::size_t>(node.mesh)];
    const std::string& name = !node.name.empty() ? node.name : mesh.name;
    model_.start_object(name.empty() ? "node " + std::to_string(n) : name);
    std::map<int, PointRange> placed;  // primitives of a mesh often share their points
    for (std::size_t k = 0; k < mesh.primitives.size(); ++k)
      read_primitive(mesh.primitives[k], "mesh " + std::to_string(node.mesh) + ", primitive " + std::to_string(k), global,
                     placed);
  }

  struct PointRange {
    std::uint32_t first = 0;
    std::size_t size = 0;
  };

  PointRange place_points(int accessor, const std::string& where, const Affine& global) {
    const GltfAccessor positions(source_, file_, accessor, 3, where);
    const std::size_t first = model_.points().size();
    if (positions.size() > most_placed - first)
      refuse(where, "more than " + std::to_string(most_placed) + " points in all", "fewer");
    const bool as_given = global == identity;
    if (!as_given) rounded_ = true;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      Point3 p = {positions.number(i, 0), positions.number(i, 1), positions.number(i, 2)};
      check_finite(p, where, i, "a finite coordinate");
      if (!as_given) {
        p = transformed(global, p);
        check_finite(p, where, i, "a coordinate that is finite after its node has moved it");
      }
      model_.add_point(p.x, p.y, p.z);
    }
    return {static_cast<std::uint32_t>(first), positions.size()};
  }

  void check_finite(const Point3& p, const std::string& where, std::size_t i, const char* expected) const {
    for (const double c : {p.x, p.y, p.z})
      if (!std::isfinite(c)) refuse(where + ", vertex " + std::to_string(i), std::isnan(c) ? "NaN" : "infinity", expected);
  }

  void read_primitive(const tinygltf::Primitive& primitive, const std::string& where, const Affine& global,
                      std::map<int, PointRange>& placed) {
    if (primitive.extensions.count("KHR_draco_mesh_compression") != 0)
      refuse(where, "geometry compressed with KHR_draco_mesh_compression", "it uncompressed");
    if (primitive.mode == TINYGLTF_MODE_POINTS) {
      points_only_ = true;
      return;
    }
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) refuse(where, "no attribute POSITION", "one");
    auto at = placed.find(position->second);
    if (at == placed.end()) at = placed.emplace(position->second, place_points(position->second, where, global)).first;
    const PointRange range = at->second;

    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
      const GltfAccessor indices(source_, file_, primitive.indices, 1, where);
      corners.reserve(indices.size());
      for (std::size_t i = 0; i < indices.size(); ++i) {
        const std::uint32_t index = indices.index(i);
        if (index >= range.size)
          refuse(where + ", corner " + std::to_string(i), "index " + std::to_string(index),
                 range.size == 0 ? "no corner without points" : "0 to " + std::to_string(range.size - 1));
        corners.push_back(range.first + index);
      }
    } else {
      for (std::size_t i = 0; i < range.size; ++i) corners.push_back(static_cast<std::uint32_t>(range.first + i));
    }
    model_.set_colour(base_colour(primitive, where));
    add_corners(corners, primitive.mode, where);
    if (model_.faces() + model_.segments() > most_placed)
      refuse(where, "more than " + std::to_string(most_placed) + " faces and lines in all", "fewer");
  }

  std::optional<Colour> base_colour(const tinygltf::Primitive& primitive, const std::string& where) const {
    if (primitive.material < 0) return {};
    if (static_cast<std::size_t>(primitive.material) >= file_.materials.size())
      refuse(where, "material " + std::to_string(primitive.material), "one of " + std::to_string(file_.materials.size()));
    const std::vector<double>& rgba =
        file_.materials[static_cast<std::size_t>(primitive.material)].pbrMetallicRoughness.baseColorFactor;
    if (rgba.size() != 4) return {};
    return Colour{colour_byte(rgba[0]), colour_byte(rgba[1]), colour_byte(rgba[2]), colour_byte(rgba[3])};
  }

  void add_corners(const std::vector<std::uint32_t>& c, int mode, const std::string& where) {
    const std::size_t n = c.size();
    const auto need_multiple_of = [&](std::size_t k) {
      if (n % k != 0) refuse(where, std::to_string(n) + " corners", "a multiple of " + std::to_string(k));
    };
    switch (mode) {
      case TINYGLTF_MODE_LINE:
        need_multiple_of(2);
        for (std::size_t i = 0; i < n; i += 2) model_.add_segment(c[i], c[i + 1]);
        return;
      case TINYGLTF_MODE_LINE_LOOP:
      case TINYGLTF_MODE_LINE_STRIP:
        for (std::size_t i = 1; i < n; ++i) model_.add_segment(c[i - 1], c[i]);
        if (mode == TINYGLTF_MODE_LINE_LOOP && n > 2) model_.add_segment(c[n - 1], c[0]);
        return;
      case TINYGLTF_MODE_TRIANGLES:
        need_multiple_of(3);
        for (std::size_t i = 0; i < n; i += 3) model_.add_triangle(c[i], c[i + 1], c[i + 2]);
        return;
      case TINYGLTF_MODE_TRIANGLE_STRIP:
        // A triangle that repeats a vertex only turns the strip.
        for (std::size_t i = 2; i < n; ++i)
          if (c[i] != c[i - 1] && c[i] != c[i - 2] && c[i - 1] != c[i - 2])
            model_.add_triangle(c[i - 2 + i % 2], c[i - 1 - i % 2], c[i]);
        return;
      case TINYGLTF_MODE_TRIANGLE_FAN:
        for (std::size_t i = 2; i < n; ++i) model_.add_triangle(c[0], c[i - 1], c[i]);
        return;
      default:
        refuse(where, "mode " + std::to_string(mode), "0 to 6");
    }
  }

  const Source& source_;
  tinygltf::Model file_;
  ModelBuilder model_;
  bool rounded_ = false, points_only_ = false, instanced_ = false;
};

}  // namespace

Model read_gltf(const Source& source) {
  std::vector<std::string> notes;
  tinygltf::Model file = load_gltf(source, notes);
  return GltfReader(source, std::move(file), source.bytes.substr(0, 4) == "glTF").read(std::move(notes));
}

}  // namespace hsr::internal::read
