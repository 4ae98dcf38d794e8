#include <Standard_Failure.hxx>
#include <utility>

#include "geometry/error.h"
#include "hsr/io/read/gzip.h"
#include "hsr/io/read/source.h"
#include "hsr/step/brep_kind.h"
#include "hsr/step/placed_shapes.h"
#include "hsr/step/step.h"

namespace hsr {

using namespace internal;

double BrepModel::size() const { return shapes_->size(); }

double BrepModel::millimetres() const { return shapes_->millimetres(); }

Model BrepModel::tessellated(double chord) const {
  require(chord > 0, "BrepModel::tessellated: a chord error of more than 0 expected");
  return shapes_->tessellated(chord);
}

BrepModel read_brep(const std::string& path) {
  const read::Bytes bytes = read::read_file(path);
  if (is_iges(path) && !read::is_gzip(bytes.view()))
    return BrepModel(std::make_shared<const PlacedShapes>(path, read_iges_document(path)));
  return read_brep(path, bytes.view());
}

BrepModel read_brep(const std::string& path, std::string_view bytes) {
  const read::Source source{path, bytes};
  if (bytes.empty()) source.refuse("", "found an empty file, expected a model");
  if (is_iges(path))
    source.refuse("", "found IGES that is compressed or not a file of its own, expected a file: of IGES these only are read");
  if (!read::is_gzip(bytes)) return BrepModel(std::make_shared<const PlacedShapes>(path, read_step_document(path, bytes)));
  const read::Bytes inflated = read::gunzip(source);
  return BrepModel(std::make_shared<const PlacedShapes>(path, read_step_document(path, inflated.view())));
}

}  // namespace hsr
