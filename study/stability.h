#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hsr/image.h"
#include "study/depth_remedies.h"
#include "study/stability_scenes.h"

namespace hsr::internal {

/// What a method did at one value of a knob.
enum class Outcome : std::uint8_t {
  right,
  wrong,       ///< some sample shows another face than the nearest
  broke_down,  ///< it contradicted itself, and shows nothing
  refused,     ///< it said that it cannot do this scene
  left_out,    ///< not run
};
/// "right", "wrong", "broke down", ...
std::string_view name(Outcome outcome);

struct StabilityPoint {
  Outcome outcome = Outcome::right;
  std::uint64_t wrong = 0, edge = 0, tie = 0, order = 0;  ///< PictureCheck
  double wrong_share = 0;                                 ///< of the covered samples; broken down: 1
  double seconds = 0;
  std::string why;  ///< refused, broken down or left out

  bool is_broken() const { return outcome == Outcome::wrong || outcome == Outcome::broke_down; }
};

/// A method along a knob.
struct StabilityRow {
  std::string method, numbers;
  bool is_object_space = false, is_exact = false;
  std::vector<StabilityPoint> points;  ///< one for each value
  /// Depth buffers, in families with closest depths: where these are one step of the format apart. Nothing: nowhere.
  std::optional<double> predicted;

  std::string name() const { return method + ", " + numbers; }
};

/// One value of a knob.
struct StabilityValue {
  double value = 0;
  std::size_t triangles = 0;        ///< that are left of the scene in doubles
  std::uint64_t covered = 0;        ///< samples with a face
  std::uint64_t known = 0;          ///< samples at which the construction tells what is seen
  std::uint64_t caster_errors = 0;  ///< of them, where the exact caster sees another face
};

struct FamilyResult {
  StabilityFamily family;
  std::vector<StabilityValue> values;
  std::vector<StabilityRow> rows;
  Image<FaceId> sketch;  ///< the scene from StabilityFamily::sketch_from
  double seconds = 0;

  /// The first value with a wrong sample.
  std::optional<double> breakdown(const StabilityRow& row) const;
};

struct Stability {
  int size = 0;
  bool quick = false;
  std::vector<FamilyResult> families;
  std::vector<MeasuredGap> gaps;
  std::vector<MeasuredBias> biases;

  /// A line for each exact method, the caster included, that is wrong at some value: a mistake in hsr.
  std::vector<std::string> defects() const;
};

struct RunnableMethod;  // study/compared_methods.h

struct StabilityOptions {
  std::vector<std::string> families = {};  ///< empty: all
  int size = 128;                          ///< samples each way
  bool quick = false;                      ///< fewer values, and slow methods left out sooner
  /// Instead of all methods.
  std::function<std::vector<RunnableMethod>(const Mesh& mesh, const View& view, const SampleGrid& grid)> methods = {};
  std::function<void(const std::string& stage, double done)> progress = {};  ///< may throw to cancel
};

/// Where each method breaks: every method on every scene of the families, against the exact caster, and the caster against what
/// is known from how the scene was made.
///
/// @throws InputError for a family that is none, naming those there are, and as sample_grid() does for the size
/// Cost: a method that took long at a value is left out at harder ones, and says so.
Stability stability(const StabilityOptions& options = {});

}  // namespace hsr::internal
