#include "study/compared_methods.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "hsr/check/sample_checks.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/depth_buffer.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/scanline.h"
#include "hsr/raster/tiled_z_buffer.h"
#include "hsr/raster/z_buffer.h"
#include "hsr/surfaces/roberts_surfaces.h"
#include "hsr/surfaces/visible_fragments.h"
#include "study/opengl_buffer.h"

namespace hsr::internal {

namespace {

constexpr const char* name(Arithmetic a) {
  switch (a) {
    case Arithmetic::staged:
      return "exact, staged";
    case Arithmetic::double_only:
      return "doubles only";
    case Arithmetic::interval:
      return "intervals";
    case Arithmetic::rational:
      return "rationals only";
  }
  return "";
}

/// Makes a method of what computes a result and what shows it.
template <class Result>
RunnableMethod runnable(std::string method, std::string numbers, std::function<Result()> solve,
                        std::function<ShownPicture(const Result&)> show, std::function<std::string(const Result&)> note = {}) {
  const auto result = std::make_shared<std::optional<Result>>();
  RunnableMethod m;
  m.method = std::move(method);
  m.numbers = std::move(numbers);
  m.solve = [result, solve = std::move(solve)] {
    result->reset();
    result->emplace(solve());
  };
  m.show = [result, show = std::move(show)] { return show(**result); };
  m.note = [result, note = std::move(note)] { return note ? note(**result) : std::string(); };
  m.forget = [result] { result->reset(); };
  return m;
}

ShownPicture shown(const DepthBuffer& buffer) {
  ShownPicture picture{buffer.triangles, Image<std::uint8_t>(buffer.depths.width, buffer.depths.height)};
  std::transform(buffer.depths.pixels.begin(), buffer.depths.pixels.end(), picture.depth.pixels.begin(),
                 [](double d) { return static_cast<std::uint8_t>(std::clamp(std::floor(d * 256), 0.0, 255.0)); });
  return picture;
}

template <class Real>
ShownPicture shown_of_z_buffer(const DepthImage<Real>& image) {
  ShownPicture picture{Image<TriangleId>(image.width, image.height), {}};
  std::transform(image.pixels.begin(), image.pixels.end(), picture.triangles.pixels.begin(),
                 [](const auto& p) { return p.triangle; });
  return picture;
}

ShownPicture shown_order(const Mesh& mesh, const View& view, const SampleGrid& grid, const PaintersOrder& order) {
  const Image<std::uint32_t> pieces = paint(mesh, view, order, grid);
  ShownPicture picture{Image<TriangleId>(grid.width, grid.height), {}};
  std::transform(pieces.pixels.begin(), pieces.pixels.end(), picture.triangles.pixels.begin(),
                 [&](std::uint32_t p) { return p == no_piece ? TriangleId() : first_triangle(order.pieces[p].facet); });
  return picture;
}

/// Makes the scene anew for each method, so that all do all of their work. @pre mesh and view outlive it
auto views_of(const Mesh& mesh, const View& view, Coplanar coplanar) {
  return [&mesh, &view, coplanar](Arithmetic arithmetic = Arithmetic::staged) {
    return SceneView(mesh, view, {.arithmetic = arithmetic, .coplanar = coplanar});
  };
}

std::string working_storage(std::size_t bytes) { return std::to_string((bytes + 500) / 1000) + " kB beside the picture"; }

std::string pieces(std::size_t n) { return std::to_string(n) + (n == 1 ? " piece" : " pieces"); }

}  // namespace

std::vector<RunnableMethod> image_space_methods(const Mesh& mesh, const View& view, const SampleGrid& grid, Coplanar coplanar) {
  std::vector<RunnableMethod> methods;
  const auto scene = views_of(mesh, view, coplanar);
  const DepthRange range = depth_range(mesh, view, grid);
  const auto resolution = [&](DepthFormat format) {
    const bool is_single =
        format == DepthFormat::float32 || format == DepthFormat::reversed_float32 || format == DepthFormat::logarithmic_float32;
    // Corners are within the picture or not far from it, and take a few roundings to a sample.
    return DepthResolution{format, range, (is_single ? 0x1p-22 : 0x1p-51) * std::max(grid.width, grid.height)};
  };
  methods.push_back(runnable<DepthImage<float>>(
      "z-buffer", "float", [&mesh, &view, grid, coplanar] { return z_buffer<float>(mesh, view, grid, coplanar); },
      shown_of_z_buffer<float>));
  methods.back().resolution = resolution(DepthFormat::float32);
  methods.push_back(runnable<DepthImage<double>>(
      "z-buffer", "double", [&mesh, &view, grid, coplanar] { return z_buffer<double>(mesh, view, grid, coplanar); },
      shown_of_z_buffer<double>));
  methods.back().resolution = resolution(DepthFormat::float64);
  methods.back().is_variant = true;
  methods.push_back(runnable<RowZBuffer<float>>(
      "row z-buffer", "float", [&mesh, &view, grid, coplanar] { return row_z_buffer<float>(mesh, view, grid, coplanar); },
      [](const RowZBuffer<float>& b) { return shown_of_z_buffer(b.image); },
      [](const RowZBuffer<float>& b) { return working_storage(b.bytes); }));
  methods.back().resolution = resolution(DepthFormat::float32);
  methods.back().is_variant = true;
  methods.push_back(runnable<TiledZBuffer<float>>(
      "tiled z-buffer", "float", [&mesh, &view, grid, coplanar] { return tiled_z_buffer<float>(mesh, view, grid, coplanar); },
      [](const TiledZBuffer<float>& b) { return shown_of_z_buffer(b.image); },
      [](const TiledZBuffer<float>& b) { return working_storage(b.bytes); }));
  methods.back().resolution = resolution(DepthFormat::float32);
  const auto show_scanline = [](const Scanline& s) { return ShownPicture{s.triangles, {}}; };
  const auto count_spans = [](const Scanline& s) {
    return std::to_string(s.spans) + " spans, " + std::to_string(s.depth_comparisons) + " comparisons; " +
           working_storage(s.bytes);
  };
  methods.push_back(runnable<Scanline>(
      "scanline, whole faces", "double", [&mesh, &view, grid, coplanar] { return scanline(mesh, view, grid, coplanar); },
      show_scanline, count_spans));
  methods.back().resolution = resolution(DepthFormat::float64);
  methods.back().is_variant = true;
  methods.push_back(runnable<Scanline>(
      "scanline, split faces", "double",
      [&mesh, &view, grid, scene, coplanar] { return scanline(mesh, view, grid, depth_sort(scene()).order, coplanar); },
      show_scanline, count_spans));
  methods.back().resolution = resolution(DepthFormat::float64);
  methods.back().cost = 4;
  const auto add = [&](const std::string& method, const std::string& numbers, const DepthBufferOptions& given) {
    DepthBufferOptions options = given;
    options.ties = coplanar;
    methods.push_back(runnable<DepthBuffer>(
        method, numbers, [&mesh, &view, grid, range, options] { return depth_buffer(mesh, view, grid, range, options); },
        shown));
    methods.back().resolution = resolution(options.format);
  };
  for (const DepthFormat format : depth_formats)
    if (format != DepthFormat::logarithmic_float32 || range.is_perspective) {
      add("depth buffer", std::string(name(format)), {.format = format});
      methods.back().is_variant =
          format != DepthFormat::fixed8 && format != DepthFormat::fixed16 && format != DepthFormat::fixed24;
    }
  add("depth buffer, increments", "float 32",
      {.format = DepthFormat::float32, .interpolation = DepthInterpolation::incremental});
  add("depth buffer, barycentric", "float 32",
      {.format = DepthFormat::float32, .interpolation = DepthInterpolation::barycentric});
  methods.back().is_variant = true;
  for (const Arithmetic arithmetic : {Arithmetic::staged, Arithmetic::double_only}) {
    methods.push_back(runnable<CastImage>(
        "ray casting", name(arithmetic), [grid, arithmetic, scene] { return cast(scene(arithmetic), grid); },
        [](const CastImage& image) {
          return ShownPicture{image.triangles, {}};
        }));
    methods.back().is_exact = arithmetic == Arithmetic::staged;
    methods.back().is_variant = !methods.back().is_exact;
  }
  const auto add_painter = [&](const std::string& method, DepthKey key) {
    methods.push_back(runnable<Image<TriangleId>>(
        method, "double",
        [&mesh, &view, grid, key, scene] { return shown_order(mesh, view, grid, z_sort(scene(), key)).triangles; },
        [](const Image<TriangleId>& image) {
          return ShownPicture{image, {}};
        }));
  };
  add_painter("painter, by the centroid", DepthKey::centroid);
  add_painter("painter, by the farthest vertex", DepthKey::farthest_vertex);
  methods.back().is_variant = true;
  methods.push_back(runnable<AlphaBuffer>(
      "painter, for each pixel", "double",
      [&mesh, &view, grid, coplanar] {
        return alpha_buffer(mesh, view, grid, std::vector<Colour>(mesh.faces.size(), Colour{0, 0, 0, 255}), 1, coplanar);
      },
      [](const AlphaBuffer& b) {
        return ShownPicture{b.nearest, {}};
      },
      [](const AlphaBuffer& b) { return std::to_string(b.layers) + " layers; " + working_storage(b.bytes); }));
  methods.back().resolution = resolution(DepthFormat::float64);
  return methods;
}

std::vector<RunnableMethod> opengl_methods(const Mesh& mesh, const View& view, const SampleGrid& grid, Coplanar coplanar,
                                           std::string* why) {
  OpenGl* const gl = opengl_driver();
  if (gl == nullptr) {
    if (why != nullptr) *why = OpenGl::why();
    return {};
  }
  std::vector<RunnableMethod> methods;
  const DepthRange range = depth_range(mesh, view, grid);
  for (const DepthFormat format : opengl_formats) {
    methods.push_back(runnable<Image<TriangleId>>(
        "OpenGL, " + gl->driver(), std::string(name(format)),
        [&mesh, &view, grid, range, format, coplanar, gl] {
          return gl->draw(mesh, view, grid, range, {.format = format, .ties = coplanar});
        },
        [](const Image<TriangleId>& image) {
          return ShownPicture{image, {}};
        },
        [gl](const Image<TriangleId>&) {
          return "samples in the middle of pixels, corners to 1/" + std::to_string(1 << gl->subpixel_bits()) + " of one";
        }));
    // Corners are rounded to floats, and by the driver to a part of a sample.
    methods.back().resolution =
        DepthResolution{format, range, std::ldexp(1.0, -gl->subpixel_bits()) + 0x1p-22 * std::max(grid.width, grid.height)};
    methods.back().is_variant = format != DepthFormat::fixed24;
  }
  return methods;
}

std::vector<RunnableMethod> object_space_methods(const Mesh& mesh, const View& view, const SampleGrid& grid,
                                                 Coplanar coplanar) {
  std::vector<RunnableMethod> methods;
  const auto scene = views_of(mesh, view, coplanar);
  const auto show_fragments = [&mesh, &view, grid](const VisibleFragments& fragments) {
    std::uint64_t overlapping = 0;
    return ShownPicture{paint(mesh, view, fragments, grid, overlapping), {}};
  };
  const auto count_fragments = [](const VisibleFragments& f) { return std::to_string(f.fragments.size()) + " fragments"; };
  for (const Arithmetic arithmetic : {Arithmetic::staged, Arithmetic::double_only, Arithmetic::interval, Arithmetic::rational})
    methods.push_back(runnable<VisibleFragments>(
        "visible fragments", name(arithmetic), [arithmetic, scene] { return visible_fragments(scene(arithmetic)); },
        show_fragments, count_fragments));
  // Other arithmetic than the staged one is for comparison.
  methods[2].cost = 500;
  methods[3].cost = 3000;
  methods.push_back(runnable<VisibleFragments>(
      "Roberts surfaces", name(Arithmetic::staged), [scene] { return roberts_surfaces(scene()); }, show_fragments,
      count_fragments));
  methods.back().cost = 60;
  methods.push_back(runnable<DepthSort>(
      "depth sort", name(Arithmetic::staged), [scene] { return depth_sort(scene()); },
      [&mesh, &view, grid](const DepthSort& s) { return shown_order(mesh, view, grid, s.order); },
      [](const DepthSort& s) {
        return pieces(s.order.pieces.size()) + ", " + std::to_string(s.counts.cuts_at_intersections + s.counts.cuts_in_cycles) +
               " cuts";
      }));
  methods.push_back(runnable<PaintersOrder>(
      "BSP", name(Arithmetic::staged), [&mesh, scene] { return BspTree(mesh).order(scene()); },
      [&mesh, &view, grid](const PaintersOrder& order) { return shown_order(mesh, view, grid, order); },
      [](const PaintersOrder& order) { return pieces(order.pieces.size()); }));
  for (RunnableMethod& m : methods) {
    m.is_object_space = true;
    m.is_exact = m.numbers != name(Arithmetic::double_only);
  }
  return methods;
}

}  // namespace hsr::internal
