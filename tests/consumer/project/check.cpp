// The checks: visible fragments and a depth sort of a cube show the nearest face at each sample.
#include <cstdio>

#include "cube.h"
#include "hsr/check/sample_checks.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/surfaces/visible_fragments.h"
#include "hsr/view/view.h"

int main() {
  const hsr::Mesh mesh = cube();
  const hsr::View view = hsr::named_view("iso", hsr::centre(mesh));
  const hsr::SampleGrid samples = hsr::sample_grid(view, hsr::paper_rectangle(mesh, view), 40, 30);
  const hsr::FragmentCheck fragments = hsr::check_fragments(mesh, view, hsr::visible_fragments(mesh, view), samples);
  const hsr::OrderCheck order = hsr::check_order(mesh, view, hsr::depth_sort(mesh, view).order, samples);
  std::printf("%d samples covered\n", static_cast<int>(fragments.covered));
  return fragments.covered > 400 && fragments.is_right() && order.covered == fragments.covered && order.wrong == 0 ? 0 : 1;
}
