#include "hsr/cli/model_defaults.h"

#include <fmt/core.h>

#include "hsr/drawing/page.h"
#include "hsr/up_axis.h"

namespace hsr::cli {

char up_axis_of(const std::string& option, const Model& model) {
  return option.empty() ? model.up_axis.value_or('z') : option.front();
}

std::string up_axis_note(const Model& model) {
  if (model.up_axis)
    return fmt::format("{} has {} up by its specification: --up-axis {} is the default", model.format, *model.up_axis,
                       *model.up_axis);
  if (internal::seems_y_up(model))
    return "the model seems to lie on its side: it is flat where y is least, as if it stood there. If y is up: --up-axis y";
  return {};
}

double unit_of(const std::string& option, const Model& model) {
  return option.empty() ? model.unit.value_or(1) : parse_unit(option);
}

std::string unit_note(const Model& model) {
  if (!model.unit) return {};
  const std::string unit = name_of_unit(*model.unit);
  // These say it file by file, and it is what one expects.
  if (model.format.starts_with("STEP") || model.format.starts_with("IGES"))
    return unit == "mm" ? std::string() : fmt::format("the file has a unit of {}: --unit {} is the default", unit, unit);
  return fmt::format("{} has a unit of {} by its specification: --unit {} is the default", model.format, unit, unit);
}

}  // namespace hsr::cli
