#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/face_labels.h"
#include "hsr/view/view.h"

namespace hsr {

/// Boxes, and a plane that cuts their edges at doubles only: so the same can be had with the cut already made.
struct CutBoxes {
  /// The boxes as they are, and the view with the section. Every box is an object.
  std::vector<Point3> points;
  Polygons polygons;
  FaceLabels labels;
  View view;
  /// The caps, as seen from the viewer, then what is left of the faces; and the view without the section.
  std::vector<Point3> cut_points;
  Polygons cut_polygons;
  View uncut_view;
  std::size_t caps = 0;                   ///< the first faces of cut_polygons
  std::vector<std::uint32_t> box_of_cap;  ///< by cap
  std::vector<std::uint32_t> original;    ///< of each face after the caps: which of `polygons` it is a part of
  std::string text;                       ///< for one who has to find a mistake
};

/// The same seed gives the same scene everywhere. Boxes touch, share walls, overlap and lie in one another; planes are square to an axis
/// or oblique, and go through corners, along edges and along faces.
CutBoxes cut_boxes(std::uint64_t seed);

}  // namespace hsr
