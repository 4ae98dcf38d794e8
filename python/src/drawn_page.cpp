#include "python/src/drawn_page.h"

#include <pybind11/stl.h>

#include <algorithm>

#include "geometry/error.h"
#include "hsr/cli/page_writing.h"
#include "hsr/io/write/output_file.h"
#include "hsr/io/write/write.h"

namespace hsr::python {

std::string DrawnPage::bytes(Format format) const {
  const auto needs = [&](bool is_there) {
    if (is_there) return;
    const std::string name = name_of(format);
    throw InputError(name + ": the drawing was made without it, expected an output that ends in ." + name);
  };
  if (format == Format::json) {
    needs(!json.empty());
    return json;
  }
  WriteOptions options = cli::page_options(format, captions, scale, size);
  if (format != Format::dxf) return written(drawing, name_of(format), options);
  needs(in_model_units.has_value());
  cli::add_dxf(options, dxf_release, unit, drawing.scale);
  return written(*in_model_units, name_of(format), options);
}

OutputPaths::OutputPaths(const Arguments& a, std::span<const Format> expected)
    : paths(a.get<std::vector<std::string>>("outputs", {})) {
  for (const std::string& path : paths) formats.push_back(format_of(path, expected));
}

bool OutputPaths::wants(Format format) const { return std::find(formats.begin(), formats.end(), format) != formats.end(); }

void OutputPaths::write(const DrawnPage& page) const {
  std::vector<std::unique_ptr<OutputFile>> files;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    files.push_back(std::make_unique<OutputFile>(paths[i]));
    files.back()->write(page.bytes(formats[i]));
  }
  for (const auto& file : files) file->commit();
}

}  // namespace hsr::python
