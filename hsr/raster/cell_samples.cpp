#include "hsr/raster/cell_samples.h"

#include <vector>

#include "geometry/parallel.h"
#include "hsr/scene/view_parts.h"

namespace hsr::internal {

namespace {

/// On which side of planes through the viewpoint samples are, each moved by less than anything.
class SampleSides {
 public:
  SampleSides(const ProjectedMesh& projected, const SampleGrid& samples)
      : projected_(projected), samples_(samples), exact_(projected.predicates()) {}

  Sign operator()(const Plane& plane, const PlaneFilter& filter, int i, int j) {
    for (const auto& [column, row] : {std::pair{i, j}, std::pair{i + 1, j}, std::pair{i, j + 1}}) {
      const Point3 p = projected_.scaled(samples_.at(column, row));
      const ErrorBounded x = filter(p);
      const Sign side = x.is_certain() ? sign_of(x.value) : exact_.side_beyond_filter(plane, p);
      if (side != Sign::zero) return side;
    }
    return Sign::zero;
  }
  Sign operator()(const Plane& plane, int i, int j) { return (*this)(plane, projected_.filter(plane), i, j); }

 private:
  const ProjectedMesh& projected_;
  const SampleGrid& samples_;
  Predicates exact_;
};

}  // namespace

Image<std::uint8_t> cell_samples(const SceneView& scene, const SampleGrid& samples) {
  const ProjectedMesh& projected = scene.parts().with(samples.bit_range()).projected();
  struct Side {
    Plane plane;
    PlaneFilter filter;
    Sign kept;
  };
  std::vector<std::vector<Side>> sides;  // by cell
  for (const ViewParts::Cell& cell : scene.parts().cells()) {
    auto& own = sides.emplace_back();
    for (const CellSide& side : cell.cell.sides) {
      const Plane plane = projected.fold_plane(side.u, side.v);
      own.push_back({plane, projected.filter(plane), side.kept});
    }
  }
  Image<std::uint8_t> image(samples.width, samples.height, no_cell);
  parallel_for_each(static_cast<std::size_t>(samples.height), [&](std::size_t row) {
    SampleSides side_of(projected, samples);
    const int j = static_cast<int>(row);
    for (int i = 0; i < samples.width; ++i)
      for (std::size_t k = 0; k < sides.size() && image.at(i, j) == no_cell; ++k) {
        bool is_in = true;
        for (const Side& side : sides[k]) is_in = is_in && side_of(side.plane, side.filter, i, j) * side.kept == Sign::positive;
        if (is_in) image.at(i, j) = static_cast<std::uint8_t>(k);
      }
  });
  return image;
}

void leave_out_beyond_far(const SceneView& scene, const SampleGrid& samples, Image<TriangleId>& seen) {
  if (!scene.view().far) return;
  const ProjectedMesh& projected = scene.parts().with(samples.bit_range()).projected();
  const Plane far = projected.cutting_plane(View::far_number);
  parallel_for_each(static_cast<std::size_t>(samples.height), [&](std::size_t row) {
    SampleSides side_of(projected, samples);
    const int j = static_cast<int>(row);
    for (int i = 0; i < samples.width; ++i) {
      TriangleId& t = seen.at(i, j);
      if (!t.is_valid()) continue;
      const Plane line = far.line_with(projected.face_plane(t));
      if (side_of(line, i, j) * projected.facing(t) == Sign::positive) t = TriangleId();
    }
  });
}

}  // namespace hsr::internal
