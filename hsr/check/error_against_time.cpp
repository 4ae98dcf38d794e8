#include "hsr/check/error_against_time.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>

#include "hsr/check/measure.h"
#include "hsr/check/sample_checks.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/z_buffer.h"
#include "hsr/surfaces/visible_fragments.h"

namespace hsr::internal {

namespace {

template <class Real>
ErrorAgainstTime of_z_buffer(const char* numbers, const SceneView& scene, const VisibleFragments& fragments,
                             const SampleGrid& grid, const Image<TriangleId>& nearest, int runs) {
  const TieRule ties = scene.options().coplanar;
  ErrorAgainstTime row;
  row.method = "z-buffer";
  row.numbers = numbers;
  row.width = grid.width;
  row.height = grid.height;
  DepthImage<Real> image;
  row.seconds = seconds_of_runs(runs, [&] {
    image = {};  // or two are held at once
    image = z_buffer<Real>(scene.mesh(), scene.view(), grid, ties);
  });
  row.samples = check_z_buffer(scene.mesh(), scene.view(), grid, image, nearest, ties);
  Image<TriangleId> shown(grid.width, grid.height);
  std::transform(image.pixels.begin(), image.pixels.end(), shown.pixels.begin(), [](const auto& p) { return p.triangle; });
  row.area = check_area(scene, fragments, grid, shown);
  return row;
}

}  // namespace

std::vector<ErrorAgainstTime> error_against_time(const SceneView& scene, const VisibleFragments& fragments,
                                                 const std::function<SampleGrid(int size)>& grid,
                                                 const ErrorAgainstTimeOptions& options) {
  std::vector<ErrorAgainstTime> rows;
  ErrorAgainstTime exact;
  double all = 1, done = 0;
  for (const int size : options.sizes) all += static_cast<double>(size) * size;
  const auto show = [&] {
    if (options.progress) options.progress(std::min(1.0, done / all));
  };
  for (const int size : options.sizes) {
    show();
    const SampleGrid samples = grid(size);
    const Image<TriangleId> nearest = cast(scene, samples).triangles;
    const FragmentCheck check = check_fragments(scene, fragments, samples, nearest);
    exact.samples.samples += check.samples;
    exact.samples.covered += check.covered;
    exact.samples.wrong += check.wrong + check.overlapping;
    rows.push_back(of_z_buffer<float>("float", scene, fragments, samples, nearest, options.runs));
    done += 0.5 * size * size;
    show();
    rows.push_back(of_z_buffer<double>("double", scene, fragments, samples, nearest, options.runs));
    done += 0.5 * size * size;
  }
  exact.method = "fragments";
  exact.numbers = "exact";
  exact.threads = static_cast<int>(std::min<std::size_t>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism), tbb::info::default_concurrency()));
  exact.samples.other = exact.samples.wrong;  // nothing would excuse it
  exact.seconds = seconds_of_runs(options.runs, [&] {
    (void)visible_fragments(SceneView(scene.mesh(), scene.view(), {.coplanar = scene.options().coplanar}));
  });
  if (!rows.empty()) exact.area.visible = rows.back().area.visible;
  rows.push_back(std::move(exact));
  show();
  return rows;
}

}  // namespace hsr::internal
