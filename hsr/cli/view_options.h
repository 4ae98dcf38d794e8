#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "hsr/cli/command_line.h"
#include "hsr/cli/json_value.h"
#include "hsr/model.h"
#include "hsr/view/view.h"

namespace hsr::cli {

/// The options that say from where the model is looked at.
struct ViewOptions {
  std::string name, eye, target, direction, up, oblique;
  std::vector<std::string> sections;
  std::optional<double> field_of_view, near, depth;
  std::string up_axis;  ///< y or z; empty: the model's

  void add_to(Options& options);
};

/// What the options mean for a model.
struct ChosenView {
  View view;
  std::string title;  ///< "iso", "direction 1,2,3", "eye 1,2,3"
  std::optional<double> field_of_view;
  std::string note;          ///< what was chosen without being asked, or empty
  std::string up_axis_note;  ///< the same for the up axis
};

/// @throws InputError for values that are no view of this model
ChosenView choose_view(const ViewOptions& options, const Mesh& mesh, const Model& model);

/// As reports have it.
JsonValue json_of(const View& view);

/// "x=12.5", or "1,1,0@5,0,0": a normal, either way, and a point of the plane. @throws InputError naming --section
SectionPlane parse_plane(const std::string& text);

/// "1,-2.5,3e4", correctly rounded. @throws InputError naming the option
Point3 parse_point(const std::string& option, const std::string& text);

}  // namespace hsr::cli
