#include <algorithm>

#include "hsr/coordinates/coordinates.h"
#include "hsr/lines/triangle_occlusion.h"
#include "hsr/scene/facet.h"
#include "hsr/scene/view_parts.h"

namespace hsr {

using namespace internal;

std::vector<FaceId> occluders_of(const SceneView& scene, const VisibleLines& lines, const Segment& segment) {
  std::vector<FaceId> faces;
  if (!segment.is_hidden) return faces;
  const Mesh& mesh = scene.mesh();
  const ViewParts& parts = scene.parts();
  const ProjectedMesh& projected = parts.projected();
  const Line& line = lines.lines.at(segment.line);
  const SupportingLine support = supporting_line_of(mesh, lines, line);
  TriangleOcclusion occlusion(projected);
  if (!(support.is_edge() ? occlusion.start(line.edge) : occlusion.start(support.meet))) return faces;

  ImageBox box = ImageBox::nothing();
  if (support.is_edge())
    box = projected.box(support.a, support.b);
  else  // it is within the box of either facet
    for (TriangleId t = first_triangle(support.meet.s); t < facet_end(mesh, support.meet.s); ++t.value)
      box.add(projected.box(t));
  std::vector<HiddenInterval> shadows;
  const Occluders& occluders = parts.occluders(Excluded::none);
  occluders.tree.visit(box, [&](std::uint32_t i) {
    occlusion.cast(occluders.triangles[i], shadows);
    return true;
  });
  const auto cuts = lines.cuts_of(line);
  const auto at = [&](const Cut& cut) { return exact_parameter(mesh, scene.view(), support, cut); };
  const Rational from = at(cuts[segment.interval]), to = at(cuts[segment.interval + 1]);
  for (const HiddenInterval& shadow : shadows)
    if (at(shadow.from.cut) < to && from < at(shadow.to.cut)) faces.push_back(shadow.face);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace hsr
