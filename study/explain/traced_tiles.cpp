#include "study/explain/traced_tiles.h"

#include <cmath>

#include "hsr/scene/affine_depth.h"

namespace hsr::internal {

namespace {

/// The image in which tiles lie is the picture but for an affine map: three samples tell which.
class ToPicture {
 public:
  ToPicture(const ScenePicture& picture, const ProjectedMesh& projected) : samples_(picture.samples()) {
    const auto image = [&](int i, int j) { return projected.image(projected.scaled(samples_.at(i, j)), 0).p; };
    origin_ = image(0, 0);
    const ImagePoint right = image(samples_.width, 0), down = image(0, samples_.height);
    right_ = {right.x - origin_.x, right.y - origin_.y};
    down_ = {down.x - origin_.x, down.y - origin_.y};
  }
  TracePlace operator()(double x, double y) const {
    const double dx = x - origin_.x, dy = y - origin_.y, det = right_.x * down_.y - right_.y * down_.x;
    return {0.5 + samples_.width * (dx * down_.y - dy * down_.x) / det,
            0.5 + samples_.height * (right_.x * dy - right_.y * dx) / det};
  }

 private:
  const SampleGrid& samples_;
  ImagePoint origin_, right_, down_;
};

/// Depth over nearness, as boxes have both: a straight line through the nearest and the farthest vertex.
class ToDepth {
 public:
  ToDepth(const ScenePicture& picture, const ProjectedMesh& projected) {
    for (const auto& corners : picture.scene().mesh.triangles)
      for (const VertexId v : corners) {
        const double nearness = projected.box(v).nearest, depth = picture.depth(picture.scene().mesh.points[v]);
        if (nearness < low_) low_ = nearness, depth_at_low_ = depth;
        if (nearness > high_) high_ = nearness, depth_at_high_ = depth;
      }
  }
  double operator()(float nearness) const {
    if (nearness == no_occluder) return HUGE_VAL;
    return low_ < high_ ? depth_at_low_ + (nearness - low_) / (high_ - low_) * (depth_at_high_ - depth_at_low_) : depth_at_low_;
  }

 private:
  double low_ = HUGE_VAL, high_ = -HUGE_VAL, depth_at_low_ = 0, depth_at_high_ = 0;
};

}  // namespace

TraceTiles traced_tiles(const ScenePicture& picture, const ProjectedMesh& projected, const OcclusionPyramid::Grid& grid) {
  const ToPicture place(picture, projected);
  const ToDepth depth(picture, projected);
  const auto away = [&](double columns, double rows) {
    return place(grid.corner.x + columns * grid.column, grid.corner.y + rows * grid.row);
  };
  TraceTiles tiles{away(0, 0), away(1, 0), away(0, 1), grid.columns, grid.rows, {}};
  for (TracePlace* const p : {&tiles.column, &tiles.row})
    for (const std::size_t k : {0U, 1U}) (*p)[k] -= tiles.corner[k];
  for (const float nearness : grid.nearness) tiles.depths.push_back(depth(nearness));
  return tiles;
}

}  // namespace hsr::internal
