// watched_methods: processor seconds of the methods that can be watched, by nobody. Two builds of this program, in turn, tell what an
// observer costs that is not there: bench/paired.
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bench/scenes.h"
#include "bench/seconds.h"
#include "bench/views.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/painter/sort/z_sort.h"
#include "hsr/raster/a_buffer.h"
#include "hsr/raster/alpha_buffer.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/depth_buffer.h"
#include "hsr/raster/facing_culling.h"
#include "hsr/raster/frustum_culling.h"
#include "hsr/raster/occlusion_culling.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/scanline.h"
#include "hsr/raster/tiled_z_buffer.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::bench {
namespace {

using namespace internal;

/// One line for each: "depth sort 0.123456". @param rounds of all, the least of which counts
void run(int rounds) {
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const Model knot = scene("knot10k"), soup = scene("rand40");
  const Mesh mesh = make_mesh(knot.points, knot.polygons), tangled = make_mesh(soup.points, soup.polygons);
  const View view = view_of("oblique", mesh), soup_view = view_of("oblique", tangled);
  const SampleGrid grid = sample_grid(view, paper_rectangle(mesh, view), 512, 512);
  const DepthRange range = depth_range(mesh, view, grid);
  const BspTree tree(mesh);
  const std::vector<Colour> colours(mesh.faces.size(), Colour{200, 100, 50, 255});
  LineOptions roberts;
  roberts.method = LineMethod::roberts;
  roberts.classes.fill(true);
  LineOptions appel = roberts;
  appel.method = LineMethod::appel;
  const std::vector<std::pair<const char*, std::function<void()>>> methods = {
      {"depth-sort", [&] { (void)depth_sort(mesh, view); }},
      {"depth-sort-with-cuts", [&] { (void)depth_sort(tangled, soup_view); }},
      {"bsp", [&] { (void)BspTree(mesh); }},
      {"bsp-walk", [&] { (void)tree.order(view); }},
      {"z-sort", [&] { (void)z_sort(mesh, view, DepthKey::centroid); }},
      {"depth-buffer-24", [&] { (void)depth_buffer(mesh, view, grid, range, {}); }},
      {"depth-buffer-float", [&] { (void)depth_buffer(mesh, view, grid, range, {.format = DepthFormat::float32}); }},
      {"depth-buffer-increments",
       [&] { (void)depth_buffer(mesh, view, grid, range, {.interpolation = DepthInterpolation::incremental}); }},
      {"row-z-buffer", [&] { (void)row_z_buffer<float>(mesh, view, grid); }},
      {"tiled-z-buffer", [&] { (void)tiled_z_buffer<float>(mesh, view, grid); }},
      {"ray-casting", [&] { (void)cast(mesh, view, grid); }},
      {"a-buffer", [&] { (void)a_buffer(mesh, view, grid, colours, 0.5); }},
      {"alpha-buffer", [&] { (void)alpha_buffer(mesh, view, grid, colours, 0.5); }},
      {"scanline", [&] { (void)scanline(mesh, view, grid); }},
      {"roberts", [&] { (void)visible_lines(mesh, view, roberts); }},
      {"appel", [&] { (void)visible_lines(mesh, view, appel); }},
      {"fragments", [&] { (void)visible_fragments(mesh, view); }},
      {"frustum", [&] { (void)frustum_culled(mesh, view, grid); }},
      {"back-faces", [&] { (void)facing_culled(mesh, view); }},
      {"occlusion", [&] { (void)occlusion_culled(mesh, view); }},
  };
  std::vector<double> least(methods.size(), 1e300);
  for (int round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < methods.size(); ++k) least[k] = std::min(least[k], elapsed(methods[k].second).processor);
  for (std::size_t k = 0; k < methods.size(); ++k) fmt::print("{} {:.7f}\n", methods[k].first, least[k]);
}

}  // namespace
}  // namespace hsr::bench

int main() {
  hsr::bench::run(9);
  return 0;
}
