// The methods of image space: a z-buffer of doubles shows the faces of a cube that the exact caster shows.
#include <cstdio>

#include "cube.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/samples.h"
#include "hsr/raster/z_buffer.h"
#include "hsr/view/view.h"

int main() {
  const hsr::Mesh mesh = cube();
  const hsr::View view = hsr::named_view("iso", hsr::centre(mesh));
  const hsr::SampleGrid samples = hsr::sample_grid(view, hsr::paper_rectangle(mesh, view), 40, 30);
  const hsr::CastImage cast = hsr::cast(mesh, view, samples);
  const hsr::DepthImage<double> drawn = hsr::z_buffer<double>(mesh, view, samples);
  int covered = 0, different = 0;
  for (int j = 0; j < samples.height; ++j)
    for (int i = 0; i < samples.width; ++i) {
      const hsr::TriangleId t = drawn.at(i, j).triangle;
      covered += t.is_valid() ? 1 : 0;
      different += (t.is_valid() ? mesh.face_of[t] : hsr::FaceId()) == cast.face(mesh, i, j) ? 0 : 1;
    }
  std::printf("%d samples covered, %d differ\n", covered, different);
  return covered > 400 && different == 0 ? 0 : 1;
}
