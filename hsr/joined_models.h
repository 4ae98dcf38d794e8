#pragma once

#include <string>
#include <vector>

#include "hsr/model.h"

namespace hsr::internal {

/// A model that becomes a part of a scene, and what its coordinates mean.
struct ModelToJoin {
  Model model;
  std::string unit = "mm";  ///< mm, cm, m or in
  bool is_y_up = false;     ///< else z is up
};

/// Several models as one, and what its coordinates mean.
struct JoinedModels {
  Model model;
  std::string unit = "mm";
  bool is_y_up = false;
};

/// One model of all of them: points, faces and wires follow one another in the order of the models.
///
///   (1) a single model stays as it is
///   (2) the up axis is the first model's; models of the other one are turned (x, y, z to x, -z, y, or back), which rounds nothing
///   (3) the unit is the first of the models' units to which every coordinate of every model converts without rounding
///   (4) every face is of an object: the one that the file names, or else one that is named like the file (without directories);
///       a name that two models have gets the file's name and a colon in front in each of them
///   (5) materials of one name are one material; a camera whose name is taken gets the file's name and a colon in front
///   (6) the model says what its unit and up axis are where it would not be mm and z, or a model said so
///
/// @throws InputError if there is no such unit: the file, the point, what was found and what was expected; if a unit is not known;
/// or if there is more than 32 bits can count
/// @pre there is a model
/// Exact: yes. Cost: O(n).
JoinedModels joined(std::vector<ModelToJoin> models);

}  // namespace hsr::internal
