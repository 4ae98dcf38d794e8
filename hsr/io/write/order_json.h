#pragma once

#include <string>

#include "hsr/io/write/numbers.h"
#include "hsr/painter/painters_order.h"
#include "hsr/scene/tie_rule.h"

namespace hsr {

/// A painting order as JSON, "hsr-order/1" (docs/conventions.md, "JSON"). A coordinate that is no double is written "p/q" with
/// either kind of numbers, so that the order survives the file; Numbers::exact writes all of them so.
/// @param coplanar which of coincident faces the order paints last; the file says so unless it is the first
std::string order_json(const Mesh& mesh, const View& view, const PaintersOrder& order, Numbers numbers = Numbers::rounded,
                       Coplanar coplanar = Coplanar::first);

}  // namespace hsr
