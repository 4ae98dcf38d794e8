#pragma once

#include "geometry/index.h"
#include "hsr/symbols/cut.h"

namespace hsr {

/// Where two facets pierce each other: a part of the line in which their planes meet, along that line.
struct Intersection {
  FacetId s, t;  ///< s < t
  Cut from, to;  ///< of that line: view planes of sides, lines of sides seen edge-on, or the near plane

  friend bool operator==(const Intersection&, const Intersection&) = default;
};

}  // namespace hsr
