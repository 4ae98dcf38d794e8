#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "hsr/lines/classified_edges.h"
#include "hsr/lines/line_options.h"
#include "hsr/lines/triangle_occlusion.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/scene/occluders.h"
#include "hsr/scene/occlusion_pyramid.h"

namespace hsr::internal {

/// What is tiled: an edge, or the part of one that is of one class; or where two faces pierce each other.
struct LineTask {
  EdgeId edge;
  EdgeClass edge_class = EdgeClass::smooth;
  bool is_behind = false;
  Cut from{Cut::Kind::start}, to{Cut::Kind::end};
  std::uint32_t intersection = 0;

  LineTask(const RequestedPart& p)
      : edge(p.edge),
        edge_class(p.edge_class),
        is_behind(p.is_behind),
        from(p.from),
        to(p.to) {}  // NOLINT(google-explicit-constructor)
  /// A line that has been found, to be tiled anew.
  LineTask(const Line& line, const Cut& first, const Cut& last)
      : edge(line.edge),
        edge_class(line.edge_class),
        is_behind(line.is_behind),
        from(first),
        to(last),
        intersection(line.intersection) {}
  LineTask(std::uint32_t i, const Intersection& meet)
      : edge_class(EdgeClass::intersection), from(meet.from), to(meet.to), intersection(i) {}
};

/// Sorts the shadows of one line at a time along it, and of these makes the hidden and visible intervals. One object for each
/// block of lines.
class HiddenIntervals {
 public:
  /// @param observer is told of each shadow that is cast; null: nobody is
  HiddenIntervals(const ProjectedMesh& projected, const LineOptions& options, ShadowObserver* observer = nullptr)
      : projected_(projected), options_(options), occlusion_(projected), observer_(observer) {}

  /// The line as all the triangles that overlap it in the image leave it. @param pyramid what is known to be hidden, or nullptr
  void add_by_casting(const RequestedPart& part, const ImageBox& box, const Occluders& occluders,
                      const OcclusionPyramid* pyramid = nullptr);
  void add_by_casting(std::uint32_t i, const Intersection& meet, const ImageBox& box, const Occluders& occluders);
  /// The line with these shadows, which are sorted and united here. @pre shadows().start() of it was true
  void add(const LineTask& line, std::vector<HiddenInterval>& occlusion);
  /// A line wholly beyond the near plane that is hidden, or visible, all along.
  void add_whole(const LineTask& line, bool is_hidden);
  /// An edge without intervals: its image is a point, or the near plane cuts all of it away.
  void add_nothing(const LineTask& line);

  TriangleOcclusion& occlusion() { return occlusion_; }
  Predicates& exact() { return occlusion_.exact(); }
  std::uint64_t& pairs() { return result_.pairs; }
  VisibleLines take() {
    result_.decisions = exact().counts();
    return std::move(result_);
  }

 private:
  /// A part of the line, in parameters that are known within `error`; infinite: to an end of the line.
  struct Stretch {
    double from, to;
    double error = 0;
  };

  void check_ascending(std::span<const HiddenInterval> hidden);
  void sort_by_face();
  void name_occluders(std::span<const HiddenInterval> hidden, std::span<const HiddenInterval> by_face);
  Line begun(const LineTask& tiled) const;
  void cast_all(const LineTask& line, const ImageBox& box, const Occluders& occluders);
  Stretch stretch(const Edge& edge, double from_share, double to_share) const;
  ImageBox box_of(const Edge& edge, const Stretch& stretch) const;
  void cast_watched(const ImageBox& box, const Occluders& occluders);
  void cast_on(const Stretch& stretch, const ImageBox& box, const Occluders& occluders);
  bool covers(const HiddenInterval& s, const Stretch& stretch) const;
  bool cast_unhidden(const LineTask& line, const Occluders& occluders, const OcclusionPyramid& pyramid);
  bool close_gaps();
  void end(Line line);

  const ProjectedMesh& projected_;
  const LineOptions& options_;
  TriangleOcclusion occlusion_;
  std::vector<HiddenInterval> cast_, by_face_, one_face_;
  std::vector<UnhiddenInterval> unhidden_;
  std::vector<Stretch> unhidden_stretches_, looked_at_;  // what may be seen; each a little longer
  VisibleLines result_;
  ShadowObserver* observer_;
};

/// The lines of edges that do not depend on one another, in blocks in parallel. @param order the edges to tile, near ones near
/// @param add tiles one of them @param observer is told, in one thread; null: nobody is
VisibleLines intervals_in_blocks(const ProjectedMesh& projected, const LineOptions& options,
                                 std::span<const std::uint32_t> order,
                                 const std::function<void(HiddenIntervals&, std::uint32_t)>& add,
                                 ShadowObserver* observer = nullptr);

/// The lines of all parts in order. @param place where each line is: part, and line in it
/// @throws InputError beyond 2^32 - 1 interval ends
VisibleLines joined(const std::vector<VisibleLines>& parts, const std::vector<std::array<std::uint32_t, 2>>& place);

}  // namespace hsr::internal
