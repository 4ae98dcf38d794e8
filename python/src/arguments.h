#pragma once

#include <pybind11/pybind11.h>

#include <initializer_list>
#include <string>

#include "hsr/cli/line_arguments.h"
#include "hsr/cli/page_arguments.h"
#include "hsr/cli/scene_arguments.h"
#include "hsr/drawing/shading.h"
#include "python/src/scene_data.h"
#include "python/src/work.h"

namespace hsr::python {

/// The arguments that several functions have in common, as hsr/_arguments.py hands them over by name. Each is a word of the command,
/// and means what it means there.
class Arguments {
 public:
  explicit Arguments(const py::dict& named) : named_(named) {}

  bool has(const char* name) const { return named_.contains(name) && !named_[name].is_none(); }
  template <class T>
  T get(const char* name, T otherwise) const {
    return has(name) ? named_[name].cast<T>() : otherwise;
  }
  /// One of the words. @throws InputError for another
  std::string word(const char* name, const std::string& otherwise, std::initializer_list<const char*> words) const;
  Control control() const;
  cli::ViewOptions view() const { return view_options(named_["view"].cast<py::dict>()); }
  cli::LineArguments lines() const;
  cli::SceneArguments scene() const;
  cli::PageArguments page() const;
  internal::Shading shading() const;

 private:
  const py::dict& named_;
};

}  // namespace hsr::python
