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
  return lines;
}

cli::SceneArguments Arguments::scene() const {
  cli::SceneArguments scene;
  scene.coplanar = word("coplanar", "", {"first", "last"});
  return scene;
}

}  // namespace hsr::python
