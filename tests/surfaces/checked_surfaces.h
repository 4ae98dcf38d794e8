#pragma once

#include <string>
#include <vector>

#include "hsr/scene/tie_rule.h"
#include "hsr/surfaces/visible_fragments.h"
#include "tests/scenes/test_scene.h"

namespace hsr {

/// What is wrong with the fragments by both methods on this scene: their differences to the oracle, or the exception. Empty:
/// nothing.
/// @param coplanar which of coincident faces is visible
std::string wrong_fragments(const scenes::TestScene& scene, Coplanar coplanar = Coplanar::first);

/// The fragments as text, in their order: for each its face and its rings of exact points in space.
std::string exact_text(const Mesh& mesh, const View& view, const VisibleFragments& fragments);
/// The same with each ring from its smallest point on, fragments and holes ascending: equal in whatever frame they were found.
std::string sorted_text(const Mesh& mesh, const View& view, const VisibleFragments& fragments);

/// The exact areas of the visible parts of faces, "1/2 3", where the view's frame is one of unit axes; "-" for none.
std::string areas(const scenes::TestScene& scene, Coplanar coplanar = Coplanar::first);

}  // namespace hsr
