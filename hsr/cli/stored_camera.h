#pragma once

#include <string>

#include "hsr/cli/view_options.h"

namespace hsr::cli {

/// Is this the name of a view through a camera: "camera:NAME"?
bool names_camera(const std::string& view);

/// What the camera of the model sees that `options.name` names. --up, --near and --fov go before what the camera says.
///
/// A perspective camera looks at the point on its axis that is as far as the middle of the model, or at one a unit ahead if that
/// is behind it: there --scale is true. Its field of view is framed across the shorter side of its picture.
/// @throws InputError that lists the cameras, if there is none of that name
ChosenView view_through_camera(const ViewOptions& options, const Mesh& mesh, const Model& model);

}  // namespace hsr::cli
