#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "hsr/coordinates/coordinates.h"
#include "hsr/coordinates/rounded_coordinates.h"

namespace hsr {

using namespace internal;

std::vector<Segment> segments(const SceneView& scene, const VisibleLines& lines) {
  const Mesh& mesh = scene.mesh();
  const RoundedCoordinates coordinates(mesh, scene.view());
  std::vector<std::size_t> first(lines.lines.size() + 1, 0);
  for (std::size_t i = 0; i < lines.lines.size(); ++i) first[i + 1] = first[i] + lines.lines[i].intervals();
  std::vector<Segment> all(first.back());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lines.lines.size(), 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const Line& line = lines.lines[i];
      if (line.intervals() == 0) continue;
      const SupportingLine support = supporting_line_of(mesh, lines, line);
      const std::vector<FaceId> faces = faces_at(mesh, lines, line);
      const auto cuts = lines.cuts_of(line);
      PlacedPoint from = coordinates.at(support, cuts[0]);
      for (std::uint32_t k = 0; k < line.intervals(); ++k) {
        const PlacedPoint to = coordinates.at(support, cuts[k + 1]);
        all[first[i] + k] = {from,
                             to,
                             line.edge_class,
                             line.hidden(k),
                             line.is_behind,
                             support.a,
                             support.b,
                             faces,
                             static_cast<std::uint32_t>(i),
                             k};
        from = to;
      }
    }
  });
  return all;
}

}  // namespace hsr
