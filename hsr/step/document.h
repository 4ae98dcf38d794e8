#pragma once

#include <Standard_Handle.hxx>
#include <TDocStd_Document.hxx>
#include <string>
#include <string_view>
#include <vector>

namespace hsr::internal {

/// What Open CASCADE makes of a file.
struct BrepDocument {
  Handle(TDocStd_Document) shapes;
  std::string format;      ///< "STEP" or "IGES"
  double millimetres = 1;  ///< in a unit of the shapes
  std::vector<std::string> notes;
};

/// Open CASCADE keeps its settings for a whole process: one file is read at a time.
/// @throws InputError in one line
BrepDocument read_step_document(const std::string& path, std::string_view bytes);
BrepDocument read_iges_document(const std::string& path);

}  // namespace hsr::internal
