#include "study/image_stages.h"

#include <algorithm>
#include <array>

#include "hsr/lines/visible_lines.h"
#include "hsr/raster/depth_buffer.h"
#include "hsr/raster/facing_culling.h"
#include "hsr/raster/frustum_culling.h"
#include "hsr/raster/importance_culling.h"
#include "hsr/raster/occlusion_culling.h"
#include "hsr/raster/row_z_buffer.h"
#include "hsr/raster/scanline.h"
#include "hsr/raster/tiled_z_buffer.h"

namespace hsr::internal {

namespace {

/// The middle one of three; slow work runs once.
double median_of(const Timer& timed, const std::function<void()>& work) {
  constexpr double slow = 0.5;
  std::array<double, 3> all = {timed(work)};
  if (all[0] > slow) return all[0];
  for (std::size_t k = 1; k < 3; ++k) all[k] = timed(work);
  std::sort(all.begin(), all.end());
  return all[1];
}

SampleGrid middle_quarter(const SampleGrid& grid) {
  SampleGrid part = grid;
  part.origin = grid.at(grid.width / 4, grid.height / 4);
  part.width = std::max(1, grid.width / 2);
  part.height = std::max(1, grid.height / 2);
  return part;
}

/// Samples that show another triangle.
std::size_t different(const DepthImage<float>& a, const DepthImage<float>& b) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < a.pixels.size(); ++k) count += a.pixels[k].triangle != b.pixels[k].triangle ? 1U : 0U;
  return count;
}

std::string kilobytes(std::size_t bytes) { return std::to_string((bytes + 500) / 1000) + " kB"; }

}  // namespace

std::vector<ComparedStage> culling_stages(const Mesh& mesh, const View& view, const SampleGrid& grid, const Timer& timed) {
  std::vector<ComparedStage> stages;
  const auto add = [&](const std::string& name, const SampleGrid& samples, const std::function<Culled()>& cull) {
    DepthImage<float> whole, part;
    Culled culled;
    const double without = median_of(timed, [&] { whole = z_buffer<float>(mesh, view, samples); });
    const double with = median_of(timed, [&] {
      culled = cull();
      part = z_buffer<float>(mesh, view, samples, culled.kept);
    });
    const std::size_t changed = different(whole, part);
    stages.push_back({name, "culling", with, without,
                      std::to_string(culled.culled) + " of " + std::to_string(mesh.triangles.size()) + " triangles culled by " +
                          std::to_string(culled.tests) + " tests; " +
                          (changed == 0 ? "changes nothing" : "changes " + std::to_string(changed) + " samples")});
  };
  const SampleGrid window = middle_quarter(grid);
  add("view frustum of the middle quarter, by boxes", window,
      [&] { return frustum_culled(mesh, view, window, {.bounds = Bounds::boxes}); });
  add("view frustum of the middle quarter, by spheres", window,
      [&] { return frustum_culled(mesh, view, window, {.bounds = Bounds::spheres}); });
  // Of a body that points inward the front faces are the far ones: the side to cull is the one that is missed less.
  const DepthImage<float> whole = z_buffer<float>(mesh, view, grid);
  const auto missed = [&](Facing culled) {
    return different(whole, z_buffer<float>(mesh, view, grid, facing_culled(mesh, view, culled).kept));
  };
  const bool is_inward = missed(Facing::front) < missed(Facing::back);
  const Facing away = is_inward ? Facing::front : Facing::back;
  for (const auto& [name, space] : {std::pair("world", FacingSpace::world), std::pair("eye", FacingSpace::eye),
                                    std::pair("projection", FacingSpace::projection)})
    add(std::string(is_inward ? "front faces (the model is inside out)" : "back faces") + ", in " + name + " space", grid,
        [&, s = space] { return facing_culled(mesh, view, away, s); });
  add("occlusion, by tiles and their farthest depth", grid, [&] { return occlusion_culled(mesh, view); });
  double lost = 0;
  add("importance: seen smaller than 2 samples", grid, [&] {
    ImportanceCulled culled = importance_culled(mesh, view, grid, 2);
    lost = culled.lost_area;
    return culled;
  });
  stages.back().result += "; dropped an area of " + std::to_string(static_cast<std::uint64_t>(lost)) + " samples, seen or not";
  return stages;
}

std::vector<ComparedStage> coherence_stages(const Mesh& mesh, const View& view, const SampleGrid& grid, const Timer& timed) {
  std::vector<ComparedStage> stages;
  const auto add = [&](const std::string& name, const std::function<void()>& with, const std::function<void()>& without,
                       const std::function<std::string()>& result) {
    const double seconds = median_of(timed, with), seconds_without = median_of(timed, without);
    stages.push_back({name, "coherence", seconds, seconds_without, result()});
  };

  const SampleGrid window = middle_quarter(grid);
  Culled blocks, singles;
  add(
      "object: bounds of 64 triangles at once, instead of each (frustum culling)",
      [&] { blocks = frustum_culled(mesh, view, window); }, [&] { singles = frustum_culled(mesh, view, window, {.block = 1}); },
      [&] {
        return std::to_string(blocks.tests) + " tests instead of " + std::to_string(singles.tests) + "; culls " +
               std::to_string(blocks.culled) + " triangles instead of " + std::to_string(singles.culled);
      });

  const DepthRange range = depth_range(mesh, view, grid);
  const auto draw = [&](DepthInterpolation interpolation) {
    (void)depth_buffer(mesh, view, grid, range, {.format = DepthFormat::float32, .interpolation = interpolation});
  };
  add(
      "face: depth by the plane of the face, instead of by the corners at each sample (depth buffer)",
      [&] { draw(DepthInterpolation::plane); }, [&] { draw(DepthInterpolation::barycentric); },
      [] { return "changes the last digits of depths"; });

  std::uint64_t appel_pairs = 0, roberts_pairs = 0;
  add(
      "edge: what hides it changes only at outlines (lines by appel), instead of asking all faces (roberts)",
      [&] { appel_pairs = visible_lines(mesh, view, {.method = LineMethod::appel}).pairs; },
      [&] { roberts_pairs = visible_lines(mesh, view, {.method = LineMethod::roberts}).pairs; },
      [&] {
        return std::to_string(appel_pairs) + " pairs of edges and faces instead of " + std::to_string(roberts_pairs) +
               "; changes nothing";
      });

  RowZBuffer<float> row;
  DepthImage<float> plain;
  const auto draw_plain = [&] { plain = z_buffer<float>(mesh, view, grid); };
  add(
      "scanline: triangles stay active from row to row (row z-buffer), instead of depths for the whole picture",
      [&] { row = row_z_buffer<float>(mesh, view, grid); }, draw_plain,
      [&] {
        const std::size_t pixel = sizeof(DepthPixel<float>);
        return "depths of " + kilobytes(static_cast<std::size_t>(grid.width) * pixel) + " instead of " +
               kilobytes(plain.pixels.size() * pixel) + "; " + kilobytes(row.bytes) + " in all beside the picture; " +
               (row.image == plain ? "changes nothing" : "changes the picture");
      });

  TiledZBuffer<float> tiled;
  add(
      "area: what is seen close together is drawn together (tiled z-buffer)",
      [&] { tiled = tiled_z_buffer<float>(mesh, view, grid); }, draw_plain,
      [&] {
        return std::to_string(tiled.entries) + " entries in tiles, " + kilobytes(tiled.bytes) + "; " +
               (tiled.image == plain ? "changes nothing" : "changes the picture");
      });

  Scanline spans;
  std::uint64_t drawn = 0;
  add(
      "span: one comparison where a span begins (scanline algorithm), instead of one at each sample (z-buffer of doubles)",
      [&] { spans = scanline(mesh, view, grid); }, [&] { (void)z_buffer<double>(mesh, view, grid); },
      [&] {
        for (std::size_t k = 0; k < spans.triangles.pixels.size(); ++k) drawn += spans.triangles.pixels[k].is_valid() ? 1U : 0U;
        return std::to_string(spans.depth_comparisons) + " comparisons and " + std::to_string(spans.spans) + " spans for " +
               std::to_string(drawn) + " covered samples; wrong where faces pierce";
      });

  add(
      "depth: added up along sides and spans, instead of from the plane in each row (depth buffer)",
      [&] { draw(DepthInterpolation::incremental); }, [&] { draw(DepthInterpolation::plane); },
      [] { return "changes the last digits of depths and sides"; });
  return stages;
}

}  // namespace hsr::internal
