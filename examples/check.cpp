// Compares visible fragments with the nearest face at each of 100 x 100 samples, as they are, and with one fragment left out.
#include <hsr/check.h>
#include <hsr/hsr.h>
#include <hsr/raster.h>

#include <cstdio>

int main() {
  const std::vector<hsr::Point3> points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
                                           {1, 1, 1}, {3, 1, 1}, {3, 3, 1}, {1, 3, 1}};
  const std::vector<std::uint32_t> corners = {0, 1, 2, 3, 4, 5, 6, 7}, first = {0, 4, 8};
  const hsr::Mesh mesh = hsr::make_mesh(points, corners, first);
  const hsr::View view = hsr::named_view("top");
  const hsr::SceneView scene(mesh, view);
  const hsr::SampleGrid samples = hsr::sample_grid(view, hsr::paper_rectangle(mesh, view), 100, 100);

  hsr::VisibleFragments fragments = hsr::visible_fragments(scene);
  for (int k = 0; k < 2; ++k, fragments.fragments.pop_back()) {
    const hsr::FragmentCheck check = hsr::check_fragments(scene, fragments, samples);
    std::printf("%llu of %llu samples wrong\n", static_cast<unsigned long long>(check.wrong),
                static_cast<unsigned long long>(check.samples));
  }
}
