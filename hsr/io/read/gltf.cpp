#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "hsr/io/read/formats.h"
#include "hsr/io/read/gltf_file.h"
#include "hsr/io/read/gltf_instances.h"
#include "hsr/io/read/gltf_paint.h"
#include "hsr/io/read/gltf_transform.h"
#include "hsr/io/read/marks.h"
#include "hsr/io/read/model_builder.h"

namespace hsr::internal::read {

namespace {

/// A small file can place one mesh many times; this many points, or faces and lines, are more than any model, and fit into
/// memory.
constexpr std::size_t most_placed = std::size_t{1} << 28;

/// The names of things, `kind` and the number for one without; the second one of a name is "name [2]".
template <class Thing>
std::vector<std::string> unlike(const std::vector<Thing>& things, const std::string& kind) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (std::size_t i = 0; i < things.size(); ++i) {
    const std::string name = things[i].name.empty() ? kind + std::to_string(i) : things[i].name;
    std::string unused = name;
    for (std::size_t k = 2; !known.insert(unused).second; ++k) unused = name + " [" + std::to_string(k) + "]";
    names.push_back(std::move(unused));
  }
  return names;
}

/// Reads the nodes of the default scene, parents before children, in the order of the file.
///
/// What is rounded: the matrix of a node is its own, or made of its translation, rotation and scale in doubles; it is
/// multiplied with the parent's in doubles, and so is that of an instance. That product is then taken as exact, and each
/// coordinate of a point that it maps is rounded once, to the nearest double. A node whose matrix is the identity leaves its
/// points as they are in the file.
class GltfReader {
 public:
  GltfReader(const Source& source, GltfFile file, bool is_glb)
      : source_(source),
        gltf_(std::move(file)),
        file_(gltf_.model),
        pictures_(source, gltf_),
        model_(source, is_glb ? "GLB" : "glTF"),
        materials_(unlike(file_.materials, "material ")) {}

  Model read(std::vector<std::string> notes) {
    for (std::string& note : notes) model_.note(std::move(note));
    read_nodes();
    if (!is_exact_)
      model_.note("points moved by nodes are rounded once, to the nearest double, by matrices composed in doubles");
    if (points_only_) model_.note("primitives of points are passed over");
    if (masked_ != 0)
      model_.note(std::to_string(masked_) +
                  " faces and lines of alphaMode MASK are below their alphaCutoff: they are not there");
    if (const std::size_t n = pictures_.missing())
      model_.note(std::to_string(n) + (n == 1 ? " texture" : " textures") +
                  " cannot be read (missing, or neither PNG nor JPEG): faces have the colour of their material");
    model_.set_units('y', 1000);
    Model model = model_.finish(masked_ != 0);
    std::uint32_t surfaces = 0;
    for (const auto& [primitive, part] : marked_) add_marks_of_part(source_, gltf_.marks.at(primitive), part, surfaces, model);
    return model;
  }

 private:
  struct Placed {
    int node;
    Affine parent;
    bool is_exact;  // no number of the matrix was rounded
  };

  [[noreturn]] void refuse(const std::string& where, const std::string& found, const std::string& expected) const {
    source_.refuse(where, "found " + found + ", expected " + expected);
  }

  void read_nodes() {
    std::vector<Placed> stack;
    const std::vector<int> roots = root_nodes();
    for (auto i = roots.rbegin(); i != roots.rend(); ++i) stack.push_back({*i, identity, true});
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
      bool is_exact = placed.is_exact;
      const Affine global = compose_or_keep(placed.parent, local_matrix(node, n, is_exact), is_exact);
      if (node.mesh >= 0) {
        is_exact_ = is_exact_ && is_exact;
        read_instances(node, n, global);
      }
      if (node.camera >= 0) read_camera(node, global);
      for (auto i = node.children.rbegin(); i != node.children.rend(); ++i) stack.push_back({*i, global, is_exact});
    }
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

  Affine local_matrix(const tinygltf::Node& node, std::size_t n, bool& is_exact) const {
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
      const auto xyz = [](const std::vector<double>& v, double otherwise) {
        return v.empty() ? Point3{otherwise, otherwise, otherwise} : Point3{v[0], v[1], v[2]};
      };
      std::array<double, 4> rotation = {0, 0, 0, 1};
      if (!node.rotation.empty()) std::copy(node.rotation.begin(), node.rotation.end(), rotation.begin());
      m = placement(xyz(node.translation, 0), rotation, xyz(node.scale, 1), is_exact);
    }
    return m;
  }

  static Affine compose_or_keep(const Affine& parent, const Affine& local, bool& is_exact) {
    if (parent == identity) return local;
    if (local == identity) return parent;
    return compose(parent, local, is_exact);
  }

  /// The mesh of a node once, or once for each of its instances, which are objects of their own.
  void read_instances(const tinygltf::Node& node, std::size_t n, const Affine& global) {
    const auto at = node.extensions.find("EXT_mesh_gpu_instancing");
    if (at == node.extensions.end()) return read_mesh(node, n, global);
    const GltfInstances instances(source_, file_, at->second, "node " + std::to_string(n));
    for (std::size_t i = 0; i < instances.size(); ++i)
      read_mesh(node, n, compose_or_keep(global, instances.placed(i, is_exact_), is_exact_));
  }

  void read_camera(const tinygltf::Node& node, const Affine& m) {
    const auto n = static_cast<std::size_t>(node.camera);
    if (n >= gltf_.cameras.size() || !gltf_.cameras[n]) return;
    const GltfCamera& given = *gltf_.cameras[n];
    for (const double x : m)
      if (!std::isfinite(x)) return;
    StoredCamera camera;
    camera.name = !node.name.empty() ? node.name : !given.name.empty() ? given.name : "camera " + std::to_string(n);
    camera.position = {m[3], m[7], m[11]};
    camera.direction = {-m[2] + 0.0, -m[6] + 0.0, -m[10] + 0.0};
    camera.up = {m[1], m[5], m[9]};
    if (given.field_of_view) camera.field_of_view = *given.field_of_view * (180 / std::numbers::pi);
    camera.aspect_ratio = given.aspect_ratio;
    camera.near = given.near;
    model_.add_camera(std::move(camera));
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
    for (std::size_t k = 0; k < mesh.primitives.size(); ++k) read_marked(node.mesh, k, global, placed);
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
    for (std::size_t i = 0; i < positions.size(); ++i) {
      Point3 p = {positions.number(i, 0), positions.number(i, 1), positions.number(i, 2)};
      check_finite(p, where, i, "a finite coordinate");
      if (!as_given) {
        p = transformed(global, p, is_exact_);
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

  /// And where it is, if its extras have marks.
  void read_marked(int m, std::size_t k, const Affine& global, std::map<int, PointRange>& placed) {
    const auto mesh = static_cast<std::size_t>(m);
    const std::string where = "mesh " + std::to_string(m) + ", primitive " + std::to_string(k);
    if (gltf_.marks.contains({mesh, k})) {
      part_ = &marked_[{mesh, k}];
      *part_ = {where + ", extras", 0, 0, {}, std::move(part_->places)};
      part_->places.push_back({0, static_cast<std::uint32_t>(model_.faces()), global});
    }
    read_primitive(file_.meshes[mesh].primitives[k], where, global, placed);
    part_ = nullptr;
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
    const GltfPaint paint(source_, gltf_, primitive, range.size, where, pictures_);
    if (primitive.material >= 0)
      model_.set_material(materials_[static_cast<std::size_t>(primitive.material)]);
    else
      model_.set_material({});
    paint_ = &paint;
    first_point_ = range.first;
    if (part_ != nullptr) {
      part_->places.back().first_point = range.first;
      part_->points = static_cast<std::uint32_t>(range.size);
    }
    add_corners(corners, primitive.mode, where);
    if (model_.faces() + model_.segments() > most_placed)
      refuse(where, "more than " + std::to_string(most_placed) + " faces and lines in all", "fewer");
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::array<std::uint32_t, 3> corners = {a - first_point_, b - first_point_, c - first_point_};
    const GltfPaint::Coat coat = paint_->of(corners.data(), corners.size());
    if (part_ != nullptr && coat.is_there) part_->numbers.push_back(part_->faces);
    if (part_ != nullptr) ++part_->faces;
    if (!coat.is_there) {
      ++masked_;
      return;
    }
    model_.set_colour(coat.colour);
    model_.add_triangle(a, b, c);
  }

  void add_segment(std::uint32_t a, std::uint32_t b) {
    const std::array<std::uint32_t, 2> ends = {a - first_point_, b - first_point_};
    if (paint_->of(ends.data(), ends.size()).is_there)
      model_.add_segment(a, b);
    else
      ++masked_;
  }

  void add_corners(const std::vector<std::uint32_t>& c, int mode, const std::string& where) {
    const std::size_t n = c.size();
    const auto need_multiple_of = [&](std::size_t k) {
      if (n % k != 0) refuse(where, std::to_string(n) + " corners", "a multiple of " + std::to_string(k));
    };
    switch (mode) {
      case TINYGLTF_MODE_LINE:
        need_multiple_of(2);
        for (std::size_t i = 0; i < n; i += 2) add_segment(c[i], c[i + 1]);
        return;
      case TINYGLTF_MODE_LINE_LOOP:
      case TINYGLTF_MODE_LINE_STRIP:
        for (std::size_t i = 1; i < n; ++i) add_segment(c[i - 1], c[i]);
        if (mode == TINYGLTF_MODE_LINE_LOOP && n > 2) add_segment(c[n - 1], c[0]);
        return;
      case TINYGLTF_MODE_TRIANGLES:
        need_multiple_of(3);
        for (std::size_t i = 0; i < n; i += 3) add_triangle(c[i], c[i + 1], c[i + 2]);
        return;
      case TINYGLTF_MODE_TRIANGLE_STRIP:
        // A triangle that repeats a vertex only turns the strip.
        for (std::size_t i = 2; i < n; ++i)
          if (c[i] != c[i - 1] && c[i] != c[i - 2] && c[i - 1] != c[i - 2])
            add_triangle(c[i - 2 + i % 2], c[i - 1 - i % 2], c[i]);
        return;
      case TINYGLTF_MODE_TRIANGLE_FAN:
        for (std::size_t i = 2; i < n; ++i) add_triangle(c[0], c[i - 1], c[i]);
        return;
      default:
        refuse(where, "mode " + std::to_string(mode), "0 to 6");
    }
  }

  const Source& source_;
  GltfFile gltf_;
  const tinygltf::Model& file_;
  GltfPictures pictures_;
  ModelBuilder model_;
  std::vector<std::string> materials_;
  const GltfPaint* paint_ = nullptr;  // of the primitive that is being read
  std::uint32_t first_point_ = 0;
  MarkedPart* part_ = nullptr;                                        // the primitive that is being read, if it has marks
  std::map<std::pair<std::size_t, std::size_t>, MarkedPart> marked_;  // by mesh and primitive
  std::size_t masked_ = 0;
  bool is_exact_ = true, points_only_ = false;
};

}  // namespace

Model read_gltf(const Source& source) {
  std::vector<std::string> notes;
  GltfFile file = load_gltf(source, notes);
  return GltfReader(source, std::move(file), source.bytes.substr(0, 4) == "glTF").read(std::move(notes));
}

}  // namespace hsr::internal::read
