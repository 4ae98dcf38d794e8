#include "hsr/step/placed_shapes.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <Standard_Failure.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs.hxx>
#include <XCAFPrs_DocumentExplorer.hxx>
#include <XCAFPrs_IndexedDataMapOfShapeStyle.hxx>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/error.h"
#include "geometry/index.h"
#include "hsr/step/fault_guard.h"
#include "hsr/step/part_builder.h"
#include "hsr/step/shape_mesh.h"

namespace hsr::internal {

namespace {

std::optional<Colour> colour_of(const XCAFPrs_Style& style) {
  if (!style.IsSetColorSurf()) return std::nullopt;
  const Quantity_ColorRGBA& c = style.GetColorSurfRGBA();
  double r = 0, g = 0, b = 0;
  c.GetRGB().Values(r, g, b, Quantity_TOC_sRGB);
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255)); };
  return Colour{byte(r), byte(g), byte(b), byte(static_cast<double>(c.Alpha()))};
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  const TCollection_ExtendedString& text = name->Get();
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  char* bytes = utf8.data();
  text.ToUTF8CString(bytes);
  utf8.resize(utf8.find('\0'));
  return utf8;
}

/// The names from below the root down to where the explorer is: "Gearbox/Bolt".
std::string path_of(const XCAFPrs_DocumentExplorer& at) {
  std::string path;
  const int depth = at.CurrentDepth();
  for (int k = std::min(1, depth); k < depth; ++k) path += name_of(at.Current(k).RefLabel) + "/";
  return path + name_of(at.Current().RefLabel);
}

/// The colours that parts of a shape have, not the shape as a whole, which an instance may have in another one: what is larger has its
/// colour first, what is smaller another one after that.
std::vector<std::optional<Colour>> colours_of(const TDF_Label& label, const TopoDS_Shape& whole,
                                              const TopTools_IndexedMapOfShape& faces) {
  std::vector<std::optional<Colour>> colours(static_cast<std::size_t>(faces.Extent()));
  XCAFPrs_IndexedDataMapOfShapeStyle styles;
  XCAFPrs::CollectStyleSettings(label, TopLoc_Location(), styles);
  std::vector<std::pair<TopoDS_Shape, Colour>> ordered;
  for (int k = 1; k <= styles.Extent(); ++k)
    if (const auto colour = colour_of(styles(k)); colour && !styles.FindKey(k).IsPartner(whole))
      ordered.emplace_back(styles.FindKey(k), *colour);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& x, const auto& y) { return x.first.ShapeType() < y.first.ShapeType(); });
  for (const auto& [shape, colour] : ordered) {
    TopTools_IndexedMapOfShape of_shape;
    TopExp::MapShapes(shape, TopAbs_FACE, of_shape);
    for (int k = 1; k <= of_shape.Extent(); ++k)
      if (const int f = faces.FindIndex(of_shape(k)); f > 0) colours[static_cast<std::size_t>(f - 1)] = colour;
  }
  return colours;
}

}  // namespace

PlacedShapes::PlacedShapes(std::string path, BrepDocument document) : path_(std::move(path)), document_(std::move(document)) {
  try {
    survive_faults([&] {
      add_parts();
      for (const DefinedShape& d : definitions_) find_tangent_edges(d.shape);
      measure();
    });
  } catch (const Standard_Failure& failure) {
    throw InputError(path_ + ": found a shape that Open CASCADE cannot take apart (" + failure.DynamicType()->Name() +
                     "), expected surfaces or solids");
  }
  if (parts_.empty() || !(size_ > 0)) throw InputError(path_ + ": found no shape with a size, expected surfaces or solids");
}

std::string PlacedShapes::with_number(const std::string& name) const {
  const auto is_taken = [&](const std::string& text) {
    return std::any_of(parts_.begin(), parts_.end(), [&](const PlacedShape& p) { return p.name == text; });
  };
  if (!is_taken(name)) return name;
  for (int k = 2;; ++k)
    if (std::string numbered = name + " [" + std::to_string(k) + "]"; !is_taken(numbered)) return numbered;
}

std::size_t PlacedShapes::definition_of(const TDF_Label& label, const TopoDS_Shape& shape) {
  for (std::size_t k = 0; k < definitions_.size(); ++k)
    if (definitions_[k].shape.IsPartner(shape)) return k;
  DefinedShape& added = definitions_.emplace_back();
  added.shape = shape;
  TopExp::MapShapes(shape, TopAbs_FACE, added.faces);
  added.colours = colours_of(label, shape, added.faces);
  return definitions_.size() - 1;
}

void PlacedShapes::add_parts() {
  for (XCAFPrs_DocumentExplorer at(document_.shapes, XCAFPrs_DocumentExplorerFlags_OnlyLeafNodes); at.More(); at.Next()) {
    const XCAFPrs_DocumentNode& node = at.Current();
    TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(node.RefLabel);
    if (shape.IsNull()) continue;
    shape.Location(TopLoc_Location());
    std::string name = path_of(at);
    if (name.empty() || name.ends_with('/')) name += "part " + std::to_string(parts_.size() + 1);
    parts_.push_back({definition_of(node.RefLabel, shape), node.Location, with_number(name), colour_of(node.Style)});
  }
}

void PlacedShapes::measure() {
  Bnd_Box box;
  for (const PlacedShape& part : parts_) {
    Bnd_Box of_part;
    BRepBndLib::AddOptimal(definitions_[part.definition].shape, of_part, false, false);
    if (!of_part.IsVoid()) box.Add(of_part.Transformed(part.location.Transformation()));
  }
  if (!box.IsVoid()) size_ = std::sqrt(box.SquareExtent());
}

Model PlacedShapes::tessellated(double chord) const {
  const std::scoped_lock lock(mutex_);
  try {
    PartBuilder builder(path_, document_.format);
    std::vector<ShapeMesh> meshes;
    survive_faults([&] {
      for (const DefinedShape& d : definitions_) meshes.push_back(mesh_of(d.shape, d.faces, chord));
    });
    for (const PlacedShape& part : parts_) builder.add(part, definitions_[part.definition], meshes[part.definition]);
    Model model = builder.finish();
    model.unit = document_.millimetres;
    model.notes.insert(model.notes.begin(), document_.notes.begin(), document_.notes.end());
    return model;
  } catch (const Standard_Failure& failure) {
    throw InputError(path_ + ": found a shape of which Open CASCADE makes no mesh (" + failure.DynamicType()->Name() +
                     "), expected surfaces or solids");
  }
}

}  // namespace hsr::internal
