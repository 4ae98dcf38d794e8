#include <catch2/catch.hpp>

#include "hsr/check/sample_checks.h"
#include "hsr/check/z_buffer_check.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/a_buffer.h"
#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/depth_buffer.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/scanline.h"
#include "hsr/raster/tiled_z_buffer.h"
#include "hsr/surfaces/visible_fragments.h"
#include "study/compared_methods.h"
#include "tests/oracle/sample_oracle.h"
#include "tests/scenes/coincident_faces.h"

// Rectangles upon one another, whose corners and depths every method computes without an error: all show the same.

namespace hsr {

using namespace internal;

namespace {

constexpr int size = 8;

/// The middles of the squares of a chessboard.
SampleGrid board() { return {{0.5, size - 0.5, 0}, {1, 0, 0}, {0, -1, 0}, size, size}; }

struct Sheets {
  Mesh mesh;
  View view;
  Coplanar coplanar;
  Image<FaceId> expected;

  Sheets(std::uint64_t seed, Coplanar rule) : coplanar(rule) {
    const scenes::TestScene scene = scenes::sheets(seed, size);
    mesh = scene.mesh();
    view = scene.view;
    expected = faces(oracle::seen_at_samples(mesh, view, board(), rule));
  }
  SceneView scene() const { return {mesh, view, {.coplanar = coplanar}}; }
  Image<FaceId> faces(const Image<TriangleId>& triangles) const {
    Image<FaceId> shown(triangles.width, triangles.height);
    for (std::size_t k = 0; k < shown.pixels.size(); ++k)
      if (triangles.pixels[k].is_valid()) shown.pixels[k] = mesh.face_of[triangles.pixels[k]];
    return shown;
  }
  template <class Real>
  Image<FaceId> faces(const DepthImage<Real>& image) const {
    Image<TriangleId> triangles(image.width, image.height);
    for (std::size_t k = 0; k < image.pixels.size(); ++k) triangles.pixels[k] = image.pixels[k].triangle;
    return faces(triangles);
  }
  Image<FaceId> faces(const PaintersOrder& order) const {
    const Image<std::uint32_t> pieces = paint(mesh, view, order, board());
    Image<TriangleId> triangles(size, size);
    for (std::size_t k = 0; k < pieces.pixels.size(); ++k)
      if (pieces.pixels[k] != no_piece) triangles.pixels[k] = first_triangle(order.pieces[pieces.pixels[k]].facet);
    return faces(triangles);
  }
  /// A colour of its own for each face, and the picture of those that are expected.
  std::vector<Colour> colours() const {
    std::vector<Colour> all;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) all.push_back({static_cast<std::uint8_t>(10 * f), 7, 99, 255});
    return all;
  }
  Image<Colour> coloured() const {
    Image<Colour> picture(size, size, {255, 255, 255, 255});
    for (std::size_t k = 0; k < picture.pixels.size(); ++k)
      if (expected.pixels[k].is_valid()) picture.pixels[k] = colours()[expected.pixels[k].value];
    return picture;
  }
};

template <class Visit>
void for_each_sheets(const Visit& visit) {
  for (const Coplanar coplanar : {Coplanar::first, Coplanar::last})
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      INFO("seed " << seed << (coplanar == Coplanar::last ? ", last" : ", first"));
      visit(Sheets(seed, coplanar));
    }
}

TEST_CASE("z-buffers of all kinds show the coincident face that the rule says", "[ties][z_buffer][G7]") {
  for_each_sheets([](const Sheets& s) {
    const SampleGrid grid = board();
    const DepthImage<float> plain = z_buffer<float>(s.mesh, s.view, grid, s.coplanar);
    CHECK(s.faces(plain) == s.expected);
    CHECK(s.faces(z_buffer<double>(s.mesh, s.view, grid, s.coplanar)) == s.expected);
    CHECK(row_z_buffer<float>(s.mesh, s.view, grid, s.coplanar).image == plain);
    CHECK(tiled_z_buffer<float>(s.mesh, s.view, grid, s.coplanar).image == plain);
    CHECK(s.faces(scanline(s.mesh, s.view, grid, s.coplanar).triangles) == s.expected);
    CHECK(s.faces(scanline(s.mesh, s.view, grid, depth_sort(s.scene()).order, s.coplanar).triangles) == s.expected);
    for (const DepthFormat format : {DepthFormat::fixed24, DepthFormat::float32, DepthFormat::reversed_float32}) {
      const DepthBuffer buffer =
          depth_buffer(s.mesh, s.view, grid, depth_range(s.mesh, s.view, grid), {.format = format, .ties = s.coplanar});
      CHECK(s.faces(buffer.triangles) == s.expected);
    }
    // The z-buffer of some triangles: of all of them, the same.
    std::vector<TriangleId> all;
    for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) all.emplace_back(t);
    CHECK(z_buffer<float>(s.mesh, s.view, grid, all, s.coplanar) == plain);
    CHECK(check_z_buffer(s.mesh, s.view, grid, plain, cast(s.scene(), grid).triangles, s.coplanar).wrong == 0);
  });
}

TEST_CASE("A-buffer and alpha-buffer have the coincident face in front that the rule says", "[ties][transparency][G7]") {
  for_each_sheets([](const Sheets& s) {
    CHECK(a_buffer(s.mesh, s.view, board(), s.colours(), 1, s.coplanar).picture == s.coloured());
    const AlphaBuffer layers = alpha_buffer(s.mesh, s.view, board(), s.colours(), 0.5, s.coplanar);
    CHECK(s.faces(layers.nearest) == s.expected);
    CHECK(layers.picture == paint(s.scene(), depth_sort(s.scene()).order, board(), s.colours(), 0.5));
  });
}

TEST_CASE("painted orders show the coincident face that the rule says, z-sort's too", "[ties][painter][P18]") {
  for_each_sheets([](const Sheets& s) {
    CHECK(s.faces(depth_sort(s.scene()).order) == s.expected);
    CHECK(s.faces(BspTree(s.mesh).order(s.scene())) == s.expected);
    for (const DepthKey key : {DepthKey::centroid, DepthKey::farthest_vertex})
      CHECK(s.faces(z_sort(s.scene(), key)) == s.expected);
    // Fragments at the same samples.
    CHECK(check_fragments(s.scene(), visible_fragments(s.scene()), board()).is_right());
  });
}

TEST_CASE("a walk through a tree ends with the coincident piece that the rule says", "[ties][painter][P18]") {
  scenes::TestScene scene = scenes::sheets(0, size);
  scene.polygons = {};
  for (int k = 0; k < 3; ++k) scene.add_face(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const BspTree tree(scene.mesh());
  std::vector<std::uint32_t> far_to_near;
  tree.walk(scene.view, far_to_near);
  CHECK(far_to_near == std::vector<std::uint32_t>{2, 1, 0});
  tree.walk(scene.view, far_to_near, Coplanar::last);
  CHECK(far_to_near == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("every method that is compared follows the rule", "[ties][study][G7]") {
  for (const Coplanar coplanar : {Coplanar::first, Coplanar::last})
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Sheets s(seed, coplanar);
      std::vector<RunnableMethod> methods = image_space_methods(s.mesh, s.view, board(), coplanar);
      for (RunnableMethod& m : object_space_methods(s.mesh, s.view, board(), coplanar)) methods.push_back(std::move(m));
      for (const RunnableMethod& method : methods) {
        if (method.method == "depth buffer, barycentric") continue;  // its weights round equal depths apart
        INFO(method.method << ", " << method.numbers);
        method.solve();
        CHECK(s.faces(method.show().triangles) == s.expected);
      }
    }
}

}  // namespace
}  // namespace hsr
