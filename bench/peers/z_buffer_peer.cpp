#include <algorithm>
#include <cmath>

#include "bench/peers/image.h"
#include "bench/peers/peer.h"
#include "bench/peers/z_buffer.h"

namespace hsr::bench {

namespace {

/// From the paper to pixels: everything in view, y down, a margin of two pixels.
struct Framing {
  double scale = 1, x = 0, y = 0;

  Framing(const Mesh& mesh, const Image& image, int width) {
    double low_x = 1e300, high_x = -1e300, low_y = 1e300, high_y = -1e300;
    for (const Point3& p : mesh.points) {
      const ImagePoint at = image(p);
      low_x = std::min(low_x, at.x), high_x = std::max(high_x, at.x);
      low_y = std::min(low_y, at.y), high_y = std::max(high_y, at.y);
    }
    scale = (width - 4) / std::max({high_x - low_x, high_y - low_y, 1e-300});
    x = width / 2.0 - scale * (low_x + high_x) / 2;
    y = width / 2.0 + scale * (low_y + high_y) / 2;
  }

  PixelPoint operator()(const ImagePoint& p) const {
    return {static_cast<float>(x + scale * p.x), static_cast<float>(y - scale * p.y), static_cast<float>(scale * p.nearness)};
  }
};

/// What faces are pushed back by where lines are drawn over them: by how much the face changes within a pixel, and a unit of
/// float; as glPolygonOffset(1, 1) does.
float offset(const std::array<VertexId, 3>& triangle, const std::vector<PixelPoint>& points, float unit) {
  const PixelPoint &a = points[triangle[0].value], &b = points[triangle[1].value], &c = points[triangle[2].value];
  const float bx = b.x - a.x, by = b.y - a.y, bz = b.nearness - a.nearness;
  const float cx = c.x - a.x, cy = c.y - a.y, cz = c.nearness - a.nearness;
  const float area = bx * cy - by * cx;
  if (area == 0) return unit;
  return std::max(std::fabs((bz * cy - cz * by) / area), std::fabs((cz * bx - bz * cx) / area)) + unit;
}

/// Clears the buffer, projects and draws. The buffer is there, and its memory touched, before the clock starts; so is the scale
/// of the picture.
Result z_buffer(const Task& task, int width) {
  const Image image(task.view);
  Result result;
  std::vector<PixelPoint> points(task.mesh.points.size());
  const Framing framing(task.mesh, image, width);
  ZBuffer z(width, width);
  result.compute = elapsed([&] {
    z.clear();
    for (std::size_t v = 0; v < points.size(); ++v) points[v] = framing(image(task.mesh.points[VertexId(v)]));
    z.draw(points, task.mesh.triangles);
  });
  result.visible = static_cast<std::uint64_t>(
      std::count_if(z.pixels.begin(), z.pixels.end(), [](const Pixel& p) { return p.triangle != 0xffffffffU; }));
  const float unit = static_cast<float>(width) * 0x1p-23F;
  for (const Probe& probe : task.probes) {
    const Edge& edge = task.mesh.edges[probe.edge];
    const Point3 &a = task.mesh.points[edge.a], &b = task.mesh.points[edge.b];
    const auto between = [&](double p, double q) { return p + probe.t * (q - p); };
    const PixelPoint at = framing(image({between(a.x, b.x), between(a.y, b.y), between(a.z, b.z)}));
    const Pixel& pixel = z.at(static_cast<int>(at.x), static_cast<int>(at.y));
    const bool visible = pixel.triangle == 0xffffffffU ||
                         at.nearness >= pixel.nearness - offset(task.mesh.triangles[TriangleId(pixel.triangle)], points, unit);
    result.answers.push_back(visible ? Answer::visible : Answer::hidden);
  }
  return result;
}

}  // namespace

Result z_buffer_1024(const Task& task) { return z_buffer(task, 1024); }
Result z_buffer_4096(const Task& task) { return z_buffer(task, 4096); }

}  // namespace hsr::bench
