#pragma once

#include <string>

#include "study/explain/traced_scene.h"

namespace hsr::internal {

/// A small scene that shows what a method is for: "ring" (three faces that overlap in a cycle), "pierced", "house",
/// "triangles", "middle" (sorted wrongly by the middles of faces), "walls", "plates" (of which an order exists), "star" (sheets through
/// one another), "strip" (a few edges), "yard" (for culling).
/// @throws InputError for another name
ExplainedScene example_scene(const std::string& name);

}  // namespace hsr::internal
