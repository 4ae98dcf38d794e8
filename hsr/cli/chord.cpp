#include "hsr/cli/chord.h"

#include <algorithm>
#include <cmath>

#include "geometry/vector3.h"
#include "hsr/raster/samples.h"

namespace hsr::cli {

using namespace internal;

namespace {

/// How much larger what is nearest to the eye is drawn than the target.
double magnification(const Mesh& mesh, const View& view) {
  if (!view.is_perspective()) return 1;
  constexpr double most = 20;
  const Point3& eye = view.viewpoint.at;
  const Point3 to_target = minus(view.target, eye);
  const double distance = dot(to_target, to_target);
  double nearest = distance;
  for (const auto& corners : mesh.triangles)
    for (const VertexId v : corners) nearest = std::min(nearest, dot(minus(mesh.points[v], eye), to_target));
  return nearest > distance / most ? distance / nearest : most;
}

/// The largest scale at which the picture fits the page, mm to a unit of the frame.
double fitting(double width, double height, const DrawingOptions& options) {
  const Page& page = options.page;
  double area_width = page.width - 2 * page.margin, area_height = page.height - 2 * page.margin;
  if ((page.turns || page.fits || options.field_of_view) && (width > height) != (area_width > area_height))
    std::swap(area_width, area_height);
  return std::min(area_width / width, area_height / height);
}

}  // namespace

double chord_for(const Mesh& coarse, const View& view, const DrawingOptions& page, double on_paper) {
  double width = 0, height = 0;
  if (const auto frame = frame_size(view, page)) {
    width = 2 * frame->half_width;
    height = 2 * frame->half_height;
  } else {
    const PaperRectangle all = paper_rectangle(coarse, view);
    width = all.right - all.left;
    height = all.top - all.bottom;
  }
  const double scale = page.scale ? *page.scale * page.unit : fitting(width, height, page);
  const double chord = on_paper / (scale * magnification(coarse, view));
  return std::isfinite(chord) && chord > 0 ? chord : on_paper;
}

}  // namespace hsr::cli
