#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "hsr/scene/scene.h"
#include "hsr/view/view.h"

namespace hsr {

/// How visible lines are found. All give the same intervals and classes.
enum class LineMethod : unsigned char {
  automatic,  ///< appel where the mesh gives it an advantage, else roberts
  appel,
  roberts,
};

/// The class of an edge in a view (docs/conventions.md, "Classes of edges"). Does not depend on visibility.
/// The last three are of drawings with a section: the border of a cap, its hatching, and what was taken away, see with_overhead().
enum class EdgeClass : std::uint8_t {
  outline,
  sharp,
  boundary,
  intersection,
  wire,
  smooth,
  material,
  joint,
  section,
  hatching,
  overhead
};
constexpr std::size_t edge_class_count = 11;

constexpr std::array<const char*, edge_class_count> edge_class_names = {
    "outline", "sharp", "boundary", "intersection", "wire", "smooth", "material", "joint", "section", "hatching", "overhead"};

/// Some classes, by EdgeClass.
using EdgeClasses = std::array<bool, edge_class_count>;
/// What a drawing has unless more or less is asked for: no smooth edges, and no joints.
constexpr EdgeClasses drawn_classes = {true, true, true, true, true, false, true, false, true, true, true};

struct LineOptions {
  LineMethod method = LineMethod::automatic;  ///< for visible_lines()
  /// Perspective: only this is looked at; the result may lack edges that are wholly outside. Nothing: all edges.
  std::optional<FrameSize> frame = {};

  EdgeClasses classes = drawn_classes;  ///< which to compute
  /// Also every diagonal of a face that is cut into triangles, and every edge within one surface, as a smooth line where it is no
  /// outline, and where faces of one shape pierce each other: no drawing has them, but fragments are bounded by them.
  bool diagonals = false;
  double crease = 30;  ///< degrees; edges that deviate more from flat are sharp
  /// Degrees, at most `crease`: an edge that deviates more than this is sharp, too, if others of its kind lead from it to a sharp one,
  /// as along a fillet whose angle hovers at the crease (hysteresis, Canny 1986). Nothing: the same as `crease`.
  std::optional<double> crease_goes_on = {};
  /// In units of the model: for classes, an edge within this of a face or of an edge lies in it, and a face that reaches less than
  /// this away from an edge is not there. Noise of the input, not of the computation: what hides what stays exact. 0: none.
  double tolerance = 0;
  bool why = false;                                ///< name the faces that hide each hidden interval; roberts only
  std::function<void(double done)> progress = {};  ///< called now and then with the share done, 0 ... 1; may throw to cancel
  std::stop_token stop = {};                       ///< once it is asked to stop, the work ends in a CancelledError
};

/// What visible lines take, and what they do without.
struct LinePlan {
  std::string method;  ///< "appel" or "roberts"; "none" for one convex body
  std::vector<LeftOut> left_out;
};

}  // namespace hsr
