#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "hsr/model.h"
#include "hsr/view/view.h"

namespace hsr::shapes {

/// A shape whose drawings by triangles and by surfaces are compared. Where an outline ends on its own surface, or meets an edge in one
/// tangent, a chord error e moves that end by up to sqrt(2 r e), r the radius of the surface; where it turns back in a cusp, or triangles
/// are irregular, that of the triangles runs to and fro, over twice the cube root of r r e (docs/decisions/20-step.md).
struct ComparedShape {
  std::string name;
  TopoDS_Shape shape;
  double ends;                  ///< how many such ends there are, at most
  double radius;                ///< of the surfaces there, the largest
  double detours = 0;           ///< places where the outline of triangles runs to and fro
  bool is_beyond_occt = false;  ///< it is known to draw other lines than there are
};

std::vector<ComparedShape> compared_shapes();

/// From (1, -0.7, 0.8): along nothing that the shapes have.
View compared_view();

/// How much two drawings may differ for chords of that error.
double bound_of(const ComparedShape& compared, double chord);

/// Lengths on paper in units of the model.
struct Lengths {
  double edges = 0;   ///< visible outlines and sharp edges
  double smooth = 0;  ///< visible tangent edges
};

/// By Open CASCADE's exact hidden-line removal, HLRBRep_Algo, which knows the surfaces themselves.
class SurfaceLines {
 public:
  /// Marks edges of the shape as tangent, which STEP does not say; and its seams as no edges, which it would draw.
  explicit SurfaceLines(const TopoDS_Shape& shape);

  /// What takes the time.
  void find(const View& view);
  /// @pre they have been found
  Lengths lengths() const;
  TopoDS_Shape visible() const;

 private:
  TopoDS_Shape shape_;
  std::vector<TopoDS_Shape> edges_, smooth_;
};

/// By hsr, of a mesh of the shape.
Lengths lengths_by_hsr(const Model& model, const View& view);

}  // namespace hsr::shapes
