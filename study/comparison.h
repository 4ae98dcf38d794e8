#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/check/picture_check.h"
#include "hsr/image.h"
#include "hsr/lines/plan.h"
#include "hsr/raster/samples.h"
#include "hsr/scene/tie_rule.h"
#include "hsr/view/view.h"
#include "study/colour_comparison.h"
#include "study/image_stages.h"

namespace hsr::internal {

/// One method at one resolution, with one kind of numbers: a point of a work-precision diagram.
struct ComparedMethod {
  std::string method;   ///< "z-buffer", "depth sort", ...
  std::string numbers;  ///< depth format or arithmetic: "fixed 24", "float", "exact", ...
  bool is_object_space = false;
  bool is_exact = false;        ///< it promises the nearest face at each sample
  bool is_variant = false;      ///< lies beside another method in diagrams: it is left to the tables
  int size = 0;                 ///< samples each way; of object-space methods, of the picture that it is checked with
  std::vector<double> seconds;  ///< of each run, ascending
  std::size_t peak_bytes = 0;   ///< at most, of the first run, beside the scene and what was there before
  std::uint64_t samples = 0, covered = 0, wrong = 0, edge = 0, tie = 0, order = 0;  ///< PictureCheck
  /// Of the visible area. Image space: pixels taken as squares. Object space has no pixels: the share of wrong samples.
  double wrong_area_share = 0;
  double edge_error = 0;  ///< image space: pixels of this size; AreaCheck::edge_error
  std::string note;       ///< pieces, cuts; or empty
  int picture = -1;       ///< of Comparison::pictures, or none

  std::string name() const { return method + ", " + numbers; }
  double median() const { return seconds.empty() ? 0 : seconds[seconds.size() / 2]; }
  double wrong_share() const {
    return covered == 0 ? (wrong == 0 ? 0.0 : 1.0) : static_cast<double>(wrong) / static_cast<double>(covered);
  }
};

struct ComparedPicture {
  Image<TriangleId> shown;
  Image<Mistake> mistakes;
  Image<std::uint8_t> depth;  ///< 0 near ... 255 far; empty: the method has none
};

/// A method on parts of the scene: the first faces of a shuffled list.
struct Growth {
  std::string method;
  std::vector<double> faces, seconds, wrong_share;
  double slope = 0;  ///< seconds grow as this power of the number of faces
};

struct Comparison {
  std::size_t faces = 0, triangles = 0;
  int size = 0, threads = 1;
  std::vector<ComparedMethod> methods;
  std::vector<ComparedPicture> pictures;  ///< all of one size; the first is the truth
  std::vector<Growth> growth;
  std::vector<ComparedStage> stages;
  std::vector<ComparedColours> supersampling, transparency;  ///< at a quarter of the size
  std::vector<LeftOut> left_out;  ///< what was not run or refused, and what the plan of a drawing does without
};

struct ComparisonOptions {
  int size = 1024;  ///< the largest pictures are twice this
  int runs = 3;     ///< of each method, all shuffled; slow ones run once
  int threads = 1;  ///< of what is timed
  std::uint64_t seed = 1;
  Coplanar coplanar = Coplanar::first;                                  ///< which of coincident faces every method shows
  std::function<void(const std::string& stage, double done)> progress;  ///< may throw to cancel
};

/// All methods on one scene: how wrong each is, and what it takes.
///
/// @param grid gives the samples of a size
/// @throws PreconditionError as cast() does
/// Cost: dominated by the slowest methods; what would take minutes is left out, and said. The measures are described at their
/// functions: check_picture(), check_area().
Comparison compare(const Mesh& mesh, const View& view, const std::function<SampleGrid(int size)>& grid,
                   const ComparisonOptions& options = {});

}  // namespace hsr::internal
