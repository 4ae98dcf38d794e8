#pragma once

#include <array>

#include "geometry/mesh.h"
#include "hsr/view/view.h"

namespace hsr::internal {

/// Which edges are certainly outside a picture: four planes through the eye, a little outside its borders. Conservative.
class ViewFrustum {
 public:
  /// @pre a perspective view
  ViewFrustum(const Mesh& mesh, const View& view, const FrameSize& size);

  /// No point of the edge that is beyond the near plane is in the picture.
  bool contains(const Edge& e) const;

 private:
  const Mesh& mesh_;
  Point3 eye_;
  std::array<Point3, 4> normals_;  // outward
};

}  // namespace hsr::internal
