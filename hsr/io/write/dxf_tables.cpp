#include "hsr/io/write/dxf_tables.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>

#include "hsr/io/write/dxf_pens.h"
#include "hsr/io/write/svg_text.h"
#include "hsr/utf8.h"

namespace hsr::internal {

void DxfText::add(int code, std::string_view value) {
  text += std::to_string(code);
  text += '\n';
  text += value;
  text += '\n';
}

void DxfText::add(int code, std::int64_t value) { add(code, std::to_string(value)); }

void DxfText::add_number(int code, double value) {
  std::string number;
  append_length(number, value + 0.0);  // never -0
  if (number.find('.') == std::string::npos) number += ".0";
  add(code, number);
}

void DxfText::add_point(double x, double y, int code) {
  add_number(code, x);
  add_number(code + 10, y);
  add_number(code + 20, 0);
}

void DxfText::add_handle(int code, std::uint64_t handle) {
  char digits[20];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, handle, 16);
  std::transform(digits, end, digits, [](char c) { return c >= 'a' ? char(c - 'a' + 'A') : c; });
  add(code, std::string_view(digits, static_cast<std::size_t>(end - digits)));
}

std::uint64_t DxfText::begin(std::string_view type, std::uint64_t owner, int handle_code) {
  add(0, type);
  if (!is_2000()) return 0;
  add_handle(handle_code, handle_);
  add_handle(330, owner);
  return handle_++;
}

void DxfText::add_class(std::string_view name) {
  if (is_2000()) add(100, name);
}

namespace {

/// As AutoCAD writes what is beyond its code page: four digits, beyond 16 bits as two surrogates.
std::string escaped(std::uint32_t code) {
  const auto unit = [](std::uint32_t u) {
    std::string digits = "\\U+";
    for (int shift = 12; shift >= 0; shift -= 4) digits += "0123456789ABCDEF"[u >> shift & 15U];
    return digits;
  };
  if (code < 0x10000) return unit(code);
  return unit(0xD800 + ((code - 0x10000) >> 10)) + unit(0xDC00 + ((code - 0x10000) & 0x3FFU));
}

}  // namespace

std::string dxf_string(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const Utf8Character c = utf8_character(text, i);
    i += c.bytes > 0 ? c.bytes : 1;
    std::string part;
    if (c.bytes == 0)
      part = "?";
    else if (c.code < 0x80)
      part = c.code < 0x20 || c.code == 0x7F ? ' ' : static_cast<char>(c.code);
    else
      part = escaped(c.code);
    if (out.size() + part.size() > 255) break;
    out += part;
  }
  return out;
}

std::string dxf_layer_name(const Layer& layer) {
  std::string name = layer.name('_');
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return name;
}

namespace {

constexpr int white = 7, grey = 8;  // white is black on white paper

/// A table and its entries, each begun by `entry`.
class DxfTable {
 public:
  DxfTable(DxfText& out, std::string_view name, std::size_t entries) : out_(out), name_(name) {
    out_.add(0, "TABLE");
    out_.add(2, name);
    if (out_.is_2000()) {
      handle_ = out_.take_handle();
      out_.add_handle(5, handle_);
      out_.add(330, "0");
    }
    out_.add_class("AcDbSymbolTable");
    out_.add(70, static_cast<std::int64_t>(entries));
  }
  /// @param subclass as release 2000 names the entry
  std::uint64_t entry(std::string_view subclass, std::string_view name, int flags = 0) {
    const std::uint64_t handle = out_.begin(name_, handle_, name_ == "DIMSTYLE" ? 105 : 5);
    out_.add_class("AcDbSymbolTableRecord");
    out_.add_class(subclass);
    out_.add(2, name);
    if (name_ != "BLOCK_RECORD") out_.add(70, std::int64_t{flags});
    return handle;
  }
  void end() { out_.add(0, "ENDTAB"); }

 private:
  DxfText& out_;
  std::string_view name_;
  std::uint64_t handle_ = 0;
};

/// What a reader shows first: all of the drawing.
void append_viewport(DxfText& out, const DxfExtent& e) {
  DxfTable table(out, "VPORT", 1);
  table.entry("AcDbViewportTableRecord", "*ACTIVE");
  const auto pair = [&](int code, double x, double y) {
    out.add_number(code, x);
    out.add_number(code + 10, y);
  };
  pair(10, 0, 0);
  pair(11, 1, 1);
  pair(12, (e.left + e.right) / 2, (e.bottom + e.top) / 2);
  pair(13, 0, 0);
  pair(14, 1, 1);
  pair(15, 1, 1);
  for (const int code : {16, 17}) {  // looked at from above, at the origin
    pair(code, 0, 0);
    out.add_number(code + 20, code == 16 ? 1 : 0);
  }
  const double height = std::max({e.top - e.bottom, (e.right - e.left) / 1.5, 1e-9});
  out.add_number(40, 1.1 * height);
  out.add_number(41, 1.5);  // of the window's width to its height
  table.end();
}

void append_line_types(DxfText& out, std::span<const Layer> layers, double dash_unit) {
  std::map<std::string, DxfLineType> dashed;
  dashed["ACAD_ISO02W100"] = {"ACAD_ISO02W100", {12, 3}};
  for (const Layer& layer : layers)
    if (layer.pen.is_dashed()) {
      const DxfLineType type = dxf_line_type(layer, dash_unit);
      dashed[type.name] = type;
    }
  DxfTable table(out, "LTYPE", (out.is_2000() ? 3 : 1) + dashed.size());
  const auto plain = [&](const char* name, const char* words) {
    table.entry("AcDbLinetypeTableRecord", name);
    out.add(3, words);
    out.add(72, std::int64_t{65});
    out.add(73, std::int64_t{0});
    out.add_number(40, 0);
  };
  if (out.is_2000()) {
    plain("ByBlock", "");
    plain("ByLayer", "");
  }
  plain("CONTINUOUS", "Solid line");
  for (const auto& [name, type] : dashed) {
    table.entry("AcDbLinetypeTableRecord", name);
    out.add(3, name == "ACAD_ISO02W100" ? "ISO dash __ __ __ __ __ __ __ __ __ __ __ __ __" : name);
    out.add(72, std::int64_t{65});
    out.add(73, static_cast<std::int64_t>(type.dashes.size()));
    out.add_number(40, std::accumulate(type.dashes.begin(), type.dashes.end(), 0.0));
    for (std::size_t k = 0; k < type.dashes.size(); ++k) {
      out.add_number(49, k % 2 == 0 ? type.dashes[k] : -type.dashes[k]);
      if (out.is_2000()) out.add(74, std::int64_t{0});
    }
  }
  table.end();
}

void append_layer(DxfText& out, DxfTable& table, const std::string& name, int colour, const std::string& type, double width) {
  table.entry("AcDbLayerTableRecord", name);
  out.add(62, std::int64_t{colour});
  out.add(6, type);
  if (out.is_2000()) out.add(370, std::int64_t{dxf_line_weight(width)});
}

void append_layers(DxfText& out, std::span<const Layer> layers, double dash_unit) {
  DxfTable table(out, "LAYER", layers.size() + 1);
  append_layer(out, table, "0", white, "CONTINUOUS", 0.25);
  for (const Layer& layer : layers) {
    const int colour = layer.pen.has_colour ? dxf_colour(layer.pen.colour) : layer.hidden ? grey : white;
    append_layer(out, table, dxf_layer_name(layer), colour, dxf_line_type(layer, dash_unit).name, layer.pen.width);
  }
  table.end();
}

void append_styles(DxfText& out) {
  DxfTable table(out, "STYLE", 1);
  table.entry("AcDbTextStyleTableRecord", "STANDARD");
  out.add_number(40, 0);
  out.add_number(41, 1);
  out.add_number(50, 0);
  out.add(71, std::int64_t{0});
  out.add_number(42, 2.5);
  out.add(3, "txt");
  out.add(4, "");
  table.end();
}

void append_applications(DxfText& out) {
  DxfTable table(out, "APPID", 2);
  for (const char* name : {"ACAD", "HSR"}) table.entry("AcDbRegAppTableRecord", name);
  table.end();
}

/// What release 2000 wants besides, all empty but the blocks of model and paper.
std::uint64_t append_blocks(DxfText& out) {
  DxfTable dimensions(out, "DIMSTYLE", 1);
  out.add_class("AcDbDimStyleTable");
  dimensions.entry("AcDbDimStyleTableRecord", "STANDARD");
  dimensions.end();
  DxfTable records(out, "BLOCK_RECORD", 2);
  const char* const names[] = {"*Model_Space", "*Paper_Space"};
  std::uint64_t owners[2];
  for (std::size_t k = 0; k < 2; ++k) {
    owners[k] = records.entry("AcDbBlockTableRecord", names[k]);
    out.add(340, "0");
  }
  records.end();
  out.add(0, "ENDSEC");
  out.add(0, "SECTION");
  out.add(2, "BLOCKS");
  for (std::size_t k = 0; k < 2; ++k) {
    out.begin("BLOCK", owners[k]);
    out.add_class("AcDbEntity");
    if (k == 1) out.add(67, std::int64_t{1});
    out.add(8, "0");
    out.add_class("AcDbBlockBegin");
    out.add(2, names[k]);
    out.add(70, std::int64_t{0});
    out.add_point(0, 0);
    out.add(3, names[k]);
    out.add(1, "");
    out.begin("ENDBLK", owners[k]);
    out.add_class("AcDbEntity");
    if (k == 1) out.add(67, std::int64_t{1});
    out.add(8, "0");
    out.add_class("AcDbBlockEnd");
  }
  return owners[0];
}

}  // namespace

void append_dxf_header(DxfText& out, const DxfExtent& e, const DxfOptions& options, double dash_unit, std::uint64_t handles) {
  const auto variable = [&](const char* name) { out.add(9, name); };
  out.add(999, "hsr");
  out.add(0, "SECTION");
  out.add(2, "HEADER");
  variable("$ACADVER");
  out.add(1, out.is_2000() ? "AC1015" : "AC1009");
  if (out.is_2000()) {
    variable("$DWGCODEPAGE");
    out.add(3, "ANSI_1252");
  }
  variable("$INSBASE");
  out.add_point(0, 0);
  variable("$EXTMIN");
  out.add_point(e.left, e.bottom);
  variable("$EXTMAX");
  out.add_point(e.right, e.top);
  variable("$LTSCALE");
  const double dashes = dash_unit / options.page_scale;
  out.add_number(40, dashes > 0 && std::isfinite(dashes) ? dashes : 1);
  const double unit = options.unit;
  const int code = unit == 1 ? 4 : unit == 10 ? 5 : unit == 1000 ? 6 : unit == 25.4 ? 1 : 0;
  variable("$INSUNITS");
  out.add(70, std::int64_t{code});
  if (out.is_2000()) {
    variable("$MEASUREMENT");
    out.add(70, std::int64_t{code == 1 ? 0 : 1});
    variable("$LWDISPLAY");
    out.add(290, std::int64_t{1});
    variable("$HANDSEED");
    out.add_handle(5, handles);
  }
  out.add(0, "ENDSEC");
}

std::uint64_t append_dxf_tables(DxfText& out, std::span<const Layer> layers, double dash_unit, const DxfExtent& extent) {
  if (out.is_2000()) {
    out.add(0, "SECTION");
    out.add(2, "CLASSES");
    out.add(0, "ENDSEC");
  }
  out.add(0, "SECTION");
  out.add(2, "TABLES");
  append_viewport(out, extent);
  append_line_types(out, layers, dash_unit);
  append_layers(out, layers, dash_unit);
  append_styles(out);
  for (const char* empty : {"VIEW", "UCS"}) DxfTable(out, empty, 0).end();
  append_applications(out);
  const std::uint64_t model = out.is_2000() ? append_blocks(out) : 0;
  if (!out.is_2000()) {
    out.add(0, "ENDSEC");
    out.add(0, "SECTION");
    out.add(2, "BLOCKS");
  }
  out.add(0, "ENDSEC");
  return model;
}

void append_dxf_objects(DxfText& out) {
  if (!out.is_2000()) return;
  out.add(0, "SECTION");
  out.add(2, "OBJECTS");
  const std::uint64_t root = out.begin("DICTIONARY");
  out.add_class("AcDbDictionary");
  out.add(281, std::int64_t{1});
  out.add(3, "ACAD_GROUP");
  out.add_handle(350, out.next_handle());
  out.begin("DICTIONARY", root);
  out.add_class("AcDbDictionary");
  out.add(281, std::int64_t{1});
  out.add(0, "ENDSEC");
}

}  // namespace hsr::internal
