#include <catch2/catch.hpp>
#include <cmath>

#include "hsr/step/step.h"
#include "tests/io/read/temporary_directory.h"
#include "tests/step/shapes.h"
#include "tests/step/surface_lines.h"

// Drawings of shapes compared with those of Open CASCADE's exact hidden-line removal, which knows the surfaces themselves. What may
// differ, and why, is in docs/decisions/20-step.md.

namespace hsr {
namespace {

using namespace shapes;

Lengths by_hsr(const TopoDS_Shape& shape, double chord) {
  const test::TemporaryDirectory directory;
  write_step(shape, directory.file("part.step"));
  return lengths_by_hsr(read_brep(directory.file("part.step")).tessellated(chord), compared_view());
}

Lengths by_occt(const TopoDS_Shape& shape) {
  SurfaceLines surfaces(shape);
  surfaces.find(compared_view());
  return surfaces.lengths();
}

TEST_CASE("visible lines are as long as those of Open CASCADE's exact hidden-line removal", "[step][peer]") {
  for (const ComparedShape& compared : compared_shapes()) {
    if (compared.is_beyond_occt) continue;
    const Lengths expected = by_occt(compared.shape);
    for (const double chord : {0.02, 0.002}) {
      if (compared.name == "spring" && chord < 0.01) continue;  // whose triangles take Open CASCADE ten seconds
      const Lengths found = by_hsr(compared.shape, chord);
      INFO(compared.name << ", chord " << chord << ": edges " << found.edges << ", OCCT " << expected.edges << "; smooth "
                         << found.smooth << ", OCCT " << expected.smooth);
      CHECK(std::fabs(found.edges - expected.edges) <= bound_of(compared, chord));
      // A tangent edge that runs along just behind an outline, or before it, is hidden or visible in one piece. Of edges that are more
      // than tangent Open CASCADE says nothing.
      if (chord < 0.01 && compared.name != "ridge")
        CHECK(std::fabs(found.smooth - expected.smooth) <= bound_of(compared, chord));
    }
  }
}

TEST_CASE("a ridge is no outline because the parameters of its surfaces run slowly beside it", "[step][peer]") {
  // Open CASCADE draws all 40 mm of it as one, and is asked about the same surfaces with even parameters. Triangles that are narrower than
  // their chords are far from the surface lean to the side, and make an outline of what lies nearest to that of the surface.
  const Lengths expected = by_occt(ridge(0.1)), found = by_hsr(ridge(0.0002), 0.002);
  CHECK(by_occt(ridge(0.0002)).edges > expected.edges + 39);
  CHECK(found.edges < expected.edges + 15);
  CHECK(found.smooth > 25);
}

}  // namespace
}  // namespace hsr
