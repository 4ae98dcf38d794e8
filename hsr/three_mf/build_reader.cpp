#include "hsr/three_mf/build_reader.h"

#include <cmath>
#include <vector>

#include "geometry/error.h"

namespace hsr::internal {

namespace {

constexpr int deepest = 100;                     // components in components
constexpr std::size_t most_instances = 1000000;  // a few components that name one another twice are more than any memory holds

constexpr Placement3mf unmoved = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

Placement3mf placement_of(const NMR::MODELTRANSFORM& transform) {
  Placement3mf placement;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      placement[row][column] = static_cast<double>(transform.m_fFields[column][row]);
  return placement;
}

/// First `inner`, then `outer`.
Placement3mf then(const Placement3mf& inner, const Placement3mf& outer) {
  Placement3mf both = {};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < 3; ++k) both[row][column] += inner[row][k] * outer[k][column];
      if (row == 3) both[row][column] += outer[3][column];
    }
  return both;
}

}  // namespace

void BuildReader::check(LIB3MFRESULT result) const {
  if (result != 0)
    source_.refuse("", "found 3MF that lib3mf cannot read on (error " + std::to_string(result) + "), expected a model");
}

void BuildReader::read() {
  Lib3mfHandle items;
  check(NMR::lib3mf_model_getbuilditems(model_.get(), items.place()));
  for (BOOL has_next = 0;;) {
    check(NMR::lib3mf_builditemiterator_movenext(items.get(), &has_next));
    if (has_next == 0) break;
    Lib3mfHandle item, object;
    check(NMR::lib3mf_builditemiterator_getcurrent(items.get(), item.place()));
    check(NMR::lib3mf_builditem_getobjectresource(item.get(), object.place()));
    BOOL is_placed = 0;
    check(NMR::lib3mf_builditem_hasobjecttransform(item.get(), &is_placed));
    NMR::MODELTRANSFORM transform = {};
    if (is_placed != 0) check(NMR::lib3mf_builditem_getobjecttransform(item.get(), &transform));
    add_object(object, is_placed != 0 ? placement_of(transform) : unmoved, "", 0);
  }
  note_left_out();
}

void BuildReader::add_object(const Lib3mfHandle& object, const Placement3mf& at, const std::string& parent, int depth) {
  if (depth > deepest || ++instances_ > most_instances)
    source_.refuse("", depth > deepest ? "found components more than 100 deep, expected fewer"
                                       : "found more than a million instances of objects, expected fewer");
  DWORD type = 0;
  check(NMR::lib3mf_object_gettype(object.get(), &type));
  if (type == NMR::MODELOBJECTTYPE_SUPPORT || type == NMR::MODELOBJECTTYPE_SOLIDSUPPORT) {
    ++supports_;
    return;
  }
  const std::string name = (parent.empty() ? "" : parent + "/") + name_of(object);
  BOOL is_mesh = 0;
  check(NMR::lib3mf_object_ismeshobject(object.get(), &is_mesh));
  if (is_mesh != 0) {
    add_mesh(object, at, name);
    return;
  }
  DWORD count = 0;
  check(NMR::lib3mf_componentsobject_getcomponentcount(object.get(), &count));
  for (DWORD k = 0; k < count; ++k) {
    Lib3mfHandle component, part;
    check(NMR::lib3mf_componentsobject_getcomponent(object.get(), k, component.place()));
    check(NMR::lib3mf_component_getobjectresource(component.get(), part.place()));
    NMR::MODELTRANSFORM transform;
    check(NMR::lib3mf_component_gettransform(component.get(), &transform));
    add_object(part, then(placement_of(transform), at), name, depth + 1);
  }
}

void BuildReader::add_mesh(const Lib3mfHandle& mesh, const Placement3mf& at, const std::string& name) {
  builder_.start_object(name);
  DWORD count = 0, beams = 0;
  check(NMR::lib3mf_meshobject_getvertexcount(mesh.get(), &count));
  const std::size_t first = builder_.points().size();
  if (first + count > read::ModelBuilder::most) builder_.too_many("points");
  const bool is_placed = at != unmoved;
  is_rounded_ = is_rounded_ || is_placed;
  for (DWORD k = 0; k < count; ++k) {
    NMR::MODELMESHVERTEX vertex;
    check(NMR::lib3mf_meshobject_getvertex(mesh.get(), k, &vertex));
    std::array<double, 3> p;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] = static_cast<double>(vertex.m_fPosition[axis]);
    std::array<double, 3> placed = is_placed ? at[3] : p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_placed) placed[axis] += p[0] * at[0][axis] + p[1] * at[1][axis] + p[2] * at[2][axis];
      placed[axis] *= millimetres_;
      if (!std::isfinite(placed[axis]))
        source_.refuse("object " + read::in_quotes(name) + ", vertex " + std::to_string(k),
                       "found a coordinate that is not finite, expected a number");
    }
    builder_.add_point(placed[0], placed[1], placed[2]);
  }
  add_triangles(mesh, static_cast<std::uint32_t>(first), count);
  check(NMR::lib3mf_meshobject_getbeamcount(mesh.get(), &beams));
  beams_ += beams;
}

void BuildReader::add_triangles(const Lib3mfHandle& mesh, std::uint32_t first_point, std::uint32_t points) {
  DWORD count = 0;
  check(NMR::lib3mf_meshobject_gettrianglecount(mesh.get(), &count));
  Lib3mfHandle of_triangles, of_object;
  check(NMR::lib3mf_meshobject_createpropertyhandler(mesh.get(), of_triangles.place()));
  check(NMR::lib3mf_object_createdefaultpropertyhandler(mesh.get(), of_object.place()));
  for (DWORD k = 0; k < count; ++k) {
    NMR::MODELMESHTRIANGLE triangle;
    check(NMR::lib3mf_meshobject_gettriangle(mesh.get(), k, &triangle));
    for (const DWORD corner : triangle.m_nIndices)
      if (corner >= points)
        source_.refuse("triangle " + std::to_string(k),
                       "found vertex " + std::to_string(corner) + ", expected one of " + std::to_string(points));
    set_property(of_triangles, of_object, k);
    builder_.add_triangle(first_point + triangle.m_nIndices[0], first_point + triangle.m_nIndices[1],
                          first_point + triangle.m_nIndices[2]);
  }
}

/// The triangle's own, else its object's.
void BuildReader::set_property(const Lib3mfHandle& of_triangles, const Lib3mfHandle& of_object, std::uint32_t triangle) {
  builder_.set_colour({});
  builder_.set_material({});
  NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
  check(NMR::lib3mf_propertyhandler_getpropertytype(of_triangles.get(), triangle, &type));
  const bool is_own = type != NMR::MODELPROPERTYTYPE_NONE;
  if (!is_own) check(NMR::lib3mf_defaultpropertyhandler_getpropertytype(of_object.get(), &type));
  if (type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) {
    DWORD group = 0, index = 0;
    check(is_own ? NMR::lib3mf_propertyhandler_getbasematerial(of_triangles.get(), triangle, &group, &index)
                 : NMR::lib3mf_defaultpropertyhandler_getbasematerial(of_object.get(), &group, &index));
    set_base_material(group, index);
  } else if (type == NMR::MODELPROPERTYTYPE_COLOR) {
    NMR::MODELMESH_TRIANGLECOLOR_SRGB colours;
    if (is_own) {
      check(NMR::lib3mf_propertyhandler_getcolor(of_triangles.get(), triangle, &colours));
    } else {
      check(NMR::lib3mf_defaultpropertyhandler_getcolor(of_object.get(), 0, colours.m_Colors));
      colours.m_Colors[1] = colours.m_Colors[2] = colours.m_Colors[0];
    }
    const auto mean = [&](BYTE NMR::MODELMESHCOLOR_SRGB::*part) {
      const int sum = colours.m_Colors[0].*part + colours.m_Colors[1].*part + colours.m_Colors[2].*part;
      return static_cast<std::uint8_t>((sum + 1) / 3);
    };
    using Part = NMR::MODELMESHCOLOR_SRGB;
    builder_.set_colour(Colour{mean(&Part::m_Red), mean(&Part::m_Green), mean(&Part::m_Blue), mean(&Part::m_Alpha)});
  } else if (type != NMR::MODELPROPERTYTYPE_NONE) {
    ++textured_;
  }
}

void BuildReader::set_base_material(std::uint32_t group, std::uint32_t index) {
  Lib3mfHandle materials;
  check(NMR::lib3mf_model_getbasematerialbyid(model_.get(), group, materials.place()));
  ULONG size = 0;
  check(NMR::lib3mf_basematerial_getnameutf8(materials.get(), index, nullptr, 0, &size));
  std::vector<char> name(size + 1, '\0');
  check(NMR::lib3mf_basematerial_getnameutf8(materials.get(), index, name.data(), static_cast<ULONG>(name.size()), &size));
  Colour c;
  check(NMR::lib3mf_basematerial_getdisplaycolor(materials.get(), index, &c[0], &c[1], &c[2], &c[3]));
  builder_.set_material(name.data());
  builder_.set_colour(c);
}

std::string BuildReader::name_of(const Lib3mfHandle& object) {
  ULONG size = 0;
  check(NMR::lib3mf_object_getnameutf8(object.get(), nullptr, 0, &size));
  std::vector<char> name(size + 1, '\0');
  check(NMR::lib3mf_object_getnameutf8(object.get(), name.data(), static_cast<ULONG>(name.size()), &size));
  if (name[0] != '\0') return name.data();
  DWORD number = 0;
  check(NMR::lib3mf_resource_getresourceid(object.get(), &number));
  return "object " + std::to_string(number);
}

void BuildReader::note_left_out() {
  const auto note = [&](std::size_t count, const std::string& what) {
    if (count > 0) builder_.note(what + ": " + std::to_string(count));
  };
  if (is_rounded_) builder_.note("coordinates of placed parts are rounded to doubles");
  note(supports_, "objects that support others in a printer are left out");
  note(beams_, "beams are left out");
  note(textured_, "triangles with textures or mixed materials are drawn without a colour");
}

}  // namespace hsr::internal
