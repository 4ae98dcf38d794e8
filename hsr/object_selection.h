#pragma once

#include <string>
#include <vector>

#include "hsr/model.h"

namespace hsr::internal {

/// Objects of a model, by name.
struct ObjectSelection {
  std::vector<std::string> only = {};   ///< no others are there, but ghosts; empty: all are
  std::vector<std::string> hide = {};   ///< not there
  std::vector<std::string> ghost = {};  ///< drawn, and hide nothing

  bool is_empty() const { return only.empty() && hide.empty() && ghost.empty(); }
};

/// Makes the faces of objects that are not wanted faces without corners, so that all others keep their numbers, takes out their
/// wires, and marks the faces of ghosts: wires hide nothing anyway. A model without objects is one object, named like its file.
/// @throws InputError for a name that is none of the model's (the line lists these), or that is hidden and asked for
void select(Model& model, const ObjectSelection& selection);

}  // namespace hsr::internal
