#include "hsr/cli/sheet_json.h"

#include <fmt/core.h>

#include <array>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "hsr/cli/view_options.h"

namespace hsr::cli {

namespace {

struct NamedField {
  const char* name;
  std::string TitleBlock::*field;
};
constexpr std::array<NamedField, 12> fields_by_name = {{{"owner", &TitleBlock::owner},
                                                        {"title", &TitleBlock::title},
                                                        {"subtitle", &TitleBlock::subtitle},
                                                        {"number", &TitleBlock::number},
                                                        {"creator", &TitleBlock::creator},
                                                        {"approver", &TitleBlock::approver},
                                                        {"type", &TitleBlock::document_type},
                                                        {"material", &TitleBlock::material},
                                                        {"date", &TitleBlock::date},
                                                        {"revision", &TitleBlock::revision},
                                                        {"language", &TitleBlock::language},
                                                        {"sheet", &TitleBlock::sheet}}};

void set(TitleBlock& fields, const std::string& name, const std::string& value, const std::string& where) {
  std::string known;
  for (const NamedField& f : fields_by_name) {
    if (name == f.name) {
      fields.*f.field = value;
      return;
    }
    known += std::string(known.empty() ? "" : ", ") + f.name;
  }
  throw InputError(where + ": found the field \"" + name + "\", expected one of " + known);
}

JsonValue json_of(const Point2& p) { return JsonValue::array({p.x, p.y}); }
JsonValue json_of(const Point3& p) { return JsonValue::array({p.x, p.y, p.z}); }
JsonValue json_of(const PaperFrame& f) { return {{"left", f.left}, {"top", f.top}, {"right", f.right}, {"bottom", f.bottom}}; }

}  // namespace

JsonValue json_of(const Sheet& sheet, const SheetOptions& options) {
  JsonValue views = JsonValue::array(), dimensions = JsonValue::array();
  for (const PlacedView& v : sheet.views)
    views.push_back({{"name", v.name},
                     {"label", v.label},
                     {"view", json_of(v.view)},
                     {"origin", json_of(v.origin)},
                     {"scale_mm_per_unit", v.scale},
                     {"box", json_of(v.box)}});
  for (const PlacedDimension& d : sheet.dimensions)
    dimensions.push_back({{"view", d.view},
                          {"text", d.text},
                          {"points", JsonValue::array({json_of(d.points[0]), json_of(d.points[1])})},
                          {"line", JsonValue::array({json_of(d.line[0]), json_of(d.line[1])})}});
  return {{"format", "hsr-sheet/1"},
          {"page", {{"name", options.format.name}, {"width", options.format.width}, {"height", options.format.height}}},
          {"angle", options.angle == ProjectionAngle::first ? "first" : "third"},
          {"scale", sheet.scale},
          {"unit_mm", options.unit},
          {"frame", json_of(sheet.frame)},
          {"title_block", json_of(sheet.title_block)},
          {"views", std::move(views)},
          {"dimensions", std::move(dimensions)}};
}

void set_title_field(const std::string& text, TitleBlock& fields) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw InputError("--title: found \"" + text + "\", expected FIELD=TEXT such as title=Bracket");
  set(fields, text.substr(0, equals), text.substr(equals + 1), "--title");
}

void read_title_block(const std::string& contents, const std::string& name, TitleBlock& fields) {
  const auto json = nlohmann::json::parse(contents, nullptr, false);
  if (json.is_discarded() || !json.is_object())
    throw InputError(name + ": found no object of JSON, expected fields such as {\"title\": \"Bracket\"}");
  for (const auto& [key, value] : json.items()) {
    if (!value.is_string())
      throw InputError(fmt::format("{}: found a field \"{}\" that is no text, expected \"...\"", name, key));
    set(fields, key, value.get<std::string>(), name);
  }
}

}  // namespace hsr::cli
