#pragma once

#include <vector>

#include "geometry/mesh.h"
#include "hsr/view/view.h"
#include "tests/oracle/exact_vector.h"

namespace hsr::oracle {

/// A segment along which two facets pierce each other; from the lexicographically smaller end.
struct Piercing {
  FacetId s, t;  ///< s < t
  Vec from, to;
};

/// All of them beyond the near plane, in rationals: where a point of the line of both planes is inside both pieces.
std::vector<Piercing> piercings(const Mesh& mesh, const View& view);

}  // namespace hsr::oracle
