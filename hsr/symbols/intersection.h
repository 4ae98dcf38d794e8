#pragma once

#include "geometry/mesh.h"
#include "hsr/symbols/cut.h"

namespace hsr {

/// Where two triangles pierce each other: a part of the line in which their planes meet, along that line.
struct Intersection {
  TriangleId s, t;  ///< s < t, of two facets
  Cut from, to;     ///< of that line: view planes of sides, lines of sides seen edge-on, or the near plane

  friend bool operator==(const Intersection&, const Intersection&) = default;
};

}  // namespace hsr
