// Tells whether two orders of painting two squares, one above the other, are right: with a witness where one is not.
#include <hsr/hsr.h>

#include <algorithm>
#include <cstdio>

int main() {
  hsr::PaintedPolygon low{0, {{0., 0., 0.}, {2., 0., 0.}, {2., 2., 0.}, {0., 2., 0.}}};
  hsr::PaintedPolygon high{1, {{1., 1., 1.}, {3., 1., 1.}, {3., 3., 1.}, {1., 3., 1.}}};
  const hsr::View view = hsr::named_view("top");
  std::vector<hsr::PaintedPolygon> far_to_near = {low, high};
  for (int k = 0; k < 2; ++k, std::reverse(far_to_near.begin(), far_to_near.end())) {
    const hsr::Verdict verdict = hsr::verify(far_to_near, view);
    std::printf("%s\n", verdict.is_correct() ? "right" : "wrong");
    for (const hsr::Violation& v : verdict.first)
      std::printf("  at %s,%s polygon %u is painted over polygon %u, which is nearer\n", v.witness.place[0].to_string().c_str(),
                  v.witness.place[1].to_string().c_str(), v.later, v.earlier);
  }
}
