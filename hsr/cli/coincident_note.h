#pragma once

#include <string>

#include "hsr/model.h"
#include "hsr/scene/scene.h"
#include "hsr/surfaces/coincident_faces.h"

namespace hsr::cli {

using namespace internal;

/// How many faces lie under coincident ones of another colour, material or object, and how to turn that; empty: none.
std::string coincident_note(const SceneView& scene, const Model& model, Coincidence which);

}  // namespace hsr::cli
