#pragma once

#include <set>
#include <tuple>

#include "hsr/raster/nearness_sample.h"
#include "study/explain/picture_result.h"

namespace hsr::internal {

/// Tells the spans of z-buffers that hold nearness: each is one step, once all of its samples are known.
class NearnessSpans {
 public:
  NearnessSpans(const ScenePicture& picture, TraceRun& run)
      : picture_(picture), run_(run), holders_(picture.samples().width, picture.samples().height, -1) {}

  void begin(TriangleId t, int row, int begin, int end);
  void add(const NearnessSample& sample);
  /// The step of the span that is open, if one is.
  void finish();

 private:
  const ScenePicture& picture_;
  TraceRun& run_;
  Image<int> holders_;  // the face that a sample shows
  bool is_open_ = false;
  std::uint32_t face_ = 0;
  int row_ = 0, begin_ = 0, end_ = 0, passed_ = 0;
  std::vector<TraceCell> cells_;
  std::string found_text_, held_text_;
  bool has_question_ = false;
  NearnessSample asked_sample_;
  int asked_holder_ = -1;
  std::set<std::tuple<int, std::uint32_t, bool>> asked_;
};

}  // namespace hsr::internal
