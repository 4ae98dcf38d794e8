#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "geometry/predicates.h"
#include "hsr/view/view.h"

namespace hsr {

/// How visible lines are found. All give the same intervals and classes.
enum class LineMethod : unsigned char {
  automatic,  ///< appel where the mesh gives it an advantage, else roberts
  appel,
  roberts,
};

/// A stage that leaves out what the scene does not need. None changes the result.
enum class LineStage : unsigned char {
  frame,         ///< edges that are outside the picture
  convex_body,   ///< all tests, where the scene is one convex body
  back_faces,    ///< the far sides of closed bodies
  hidden_tiles,  ///< what is hidden behind large faces
  far_faces,     ///< faces away from the edges that are asked for
};
constexpr std::size_t line_stages = 5;

/// Whether a stage is run; automatic, where it pays.
enum class When : unsigned char { automatic, always, never };

struct LineOptions {
  LineMethod method = LineMethod::automatic;  ///< for visible_lines()
  std::array<When, line_stages> stages = {};  ///< by LineStage
  /// Perspective: only this is looked at; the result may lack edges that are wholly outside. Nothing: all edges.
  std::optional<FrameSize> frame = {};

  /// Which classes to compute; by default all but smooth.
  std::array<bool, 6> classes = {true, true, true, true, true, false};
  double crease = 30;  ///< degrees; edges that deviate more from flat are sharp
  bool why = false;    ///< name the faces that hide each hidden interval; roberts only
  Arithmetic arithmetic = Arithmetic::staged;
  std::function<void(double done)> progress;  ///< called now and then with the share done, 0 ... 1; may throw to cancel

  When& when(LineStage stage) { return stages[static_cast<std::size_t>(stage)]; }
  When when(LineStage stage) const { return stages[static_cast<std::size_t>(stage)]; }
};

}  // namespace hsr
