#include "python/src/arguments.h"

#include <pybind11/stl.h>

#include "geometry/error.h"

namespace hsr::python {

namespace {

/// @throws InputError as the command refuses the word
std::string one_of(const char* name, const std::string& found, std::initializer_list<const char*> words) {
  std::string list;
  for (const char* word : words) {
    if (found == word) return found;
    list += (list.empty() ? "" : ", ") + std::string(word);
  }
  throw InputError(std::string(name) + ": found \"" + found + "\", expected one of " + list);
}

}  // namespace

std::string Arguments::word(const char* name, const std::string& otherwise, std::initializer_list<const char*> words) const {
  return has(name) ? one_of(name, get<std::string>(name, {}), words) : otherwise;
}

Control Arguments::control() const {
  return {has("threads") ? std::optional(named_["threads"].cast<int>()) : std::nullopt,
          has("progress") ? named_["progress"].cast<py::object>() : py::none()};
}

cli::LineArguments Arguments::lines() const {
  cli::LineArguments lines;
  lines.edges = get<std::string>("edges", lines.edges);
  lines.crease = get<std::string>("crease", lines.crease);
  lines.tolerance = get<double>("tolerance", 0);
  lines.method = word("method", lines.method, {"auto", "appel", "roberts"});
  lines.stages = get<std::string>("stages", "");
  return lines;
}

cli::SceneArguments Arguments::scene() const {
  cli::SceneArguments scene;
  scene.coplanar = word("coplanar", "", {"first", "last"});
  return scene;
}

cli::PageArguments Arguments::page() const {
  cli::PageArguments page;
  page.page = get<std::string>("page", page.page);
  page.scale = get<std::string>("scale", page.scale);
  page.unit = word("unit", "", {"mm", "cm", "m", "in"});
  page.margin = get<double>("margin", page.margin);
  page.min_length = get<double>("min_length", page.min_length);
  page.fit_arcs = get<std::string>("fit_arcs", "");
  page.size = get<std::string>("size", "");
  page.pens = get<std::vector<std::string>>("pen", {});
  page.pens_file = get<std::string>("pens", "");
  page.sort = word("sort", page.sort, {"none", "pen"});
  return page;
}

internal::Shading Arguments::shading() const {
  return word("shade", "slope", {"slope", "none"}) == "none" ? internal::Shading::none : internal::Shading::slope;
}

}  // namespace hsr::python
