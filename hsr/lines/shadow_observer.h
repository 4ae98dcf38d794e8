#pragma once

#include <cstdint>
#include <span>

#include "hsr/lines/hidden_intervals.h"
#include "hsr/lines/visible_lines.h"

namespace hsr::internal {

/// What becomes of a shadow when the shadows of a line, sorted by where they begin, are united.
enum class Uniting : std::uint8_t {
  begins,   ///< it begins beyond all before: an interval of its own
  reaches,  ///< it begins within the last interval and makes it longer
  within,   ///< the last interval covers it
};

/// Is told how the hidden parts of lines are found by casting shadows, in the order in which that is done.
class ShadowObserver {
 public:
  ShadowObserver() = default;
  ShadowObserver(const ShadowObserver&) = delete;
  ShadowObserver& operator=(const ShadowObserver&) = delete;
  virtual ~ShadowObserver() = default;

  /// A line is looked at, from `first` to `last`: what of it is beyond the near plane.
  virtual void began(const LineTask& line, const Breakpoint& first, const Breakpoint& last) = 0;
  /// What a triangle that overlaps the line in the image hides of it; nothing: it is behind, or beside it.
  virtual void cast(TriangleId triangle, std::span<const HiddenInterval> shadows) = 0;
  /// A shadow of the sorted list joins the union. @param last the last interval of the union then
  virtual void joined(const HiddenInterval& shadow, Uniting how, const HiddenInterval& last) = 0;
  /// The result. @param cuts between its intervals, which are hidden and visible in turn
  virtual void ended(const Line& line, std::span<const Cut> cuts) = 0;
};

/// visible_lines() by Roberts, watched, in one thread: it does the same and gives the same.
/// @pre options.method is roberts and options.why is set, so that every shadow is cast; the view has no cells
VisibleLines visible_lines(const SceneView& scene, const LineOptions& options, ShadowObserver& observer);

}  // namespace hsr::internal
