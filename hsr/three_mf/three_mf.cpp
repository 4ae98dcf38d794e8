#include "hsr/three_mf/three_mf.h"

#include <algorithm>
#include <array>
#include <new>
#include <stdexcept>

#include "geometry/error.h"
#include "hsr/three_mf/build_reader.h"

namespace hsr {

using namespace internal;

namespace {

/// Those of eModelUnit in turn: millimetres, and whether hsr has the unit.
struct Unit {
  const char* name;
  double millimetres;
  bool is_known;
};
constexpr std::array<Unit, 6> units = {{{"micron", 0.001, false},
                                        {"millimeter", 1, true},
                                        {"centimeter", 10, true},
                                        {"inch", 25.4, true},
                                        {"foot", 304.8, false},
                                        {"meter", 1000, true}}};

/// What lib3mf says is wrong, as the end of a sentence in brackets.
std::string last_error(const Lib3mfHandle& at) {
  DWORD code = 0;
  const char* text = nullptr;
  if (NMR::lib3mf_getlasterror(at.get(), &code, &text) != 0 || text == nullptr || *text == '\0') return "";
  return " (" + read::printable(text, 80) + ")";
}

Model read_package(const read::Source& source) {
  Lib3mfHandle model, reader;
  if (NMR::lib3mf_createmodel(model.place()) != 0 || NMR::lib3mf_model_queryreader(model.get(), "3mf", reader.place()) != 0)
    source.refuse("", "lib3mf cannot be used");
  // It is only read.
  auto* const bytes = reinterpret_cast<BYTE*>(const_cast<char*>(source.bytes.data()));
  if (NMR::lib3mf_reader_readfrombuffer(reader.get(), bytes, source.bytes.size()) != 0)
    source.refuse("", "found a file that lib3mf cannot read" + last_error(reader) + ", expected 3MF");
  DWORD number = 0;
  NMR::lib3mf_model_getunit(model.get(), &number);
  const Unit& unit = units[std::min<std::size_t>(number, units.size() - 1)];
  read::ModelBuilder builder(source, "3MF");
  builder.set_units('z', unit.is_known ? unit.millimetres : 1);
  if (!unit.is_known) builder.note(std::string("lengths in the file's unit (") + unit.name + ") are converted to mm");
  BuildReader(source, model, builder, unit.is_known ? 1 : unit.millimetres).read();
  DWORD warnings = 0;
  NMR::lib3mf_reader_getwarningcount(reader.get(), &warnings);
  if (warnings > 0) builder.note("lib3mf passed over what it does not understand: " + std::to_string(warnings));
  return builder.finish();
}

}  // namespace

bool is_three_mf(const std::string& path, std::string_view bytes) {
  if (!bytes.empty()) return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
  if (path.size() < 4) return false;
  std::string ending = path.substr(path.size() - 4);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return ending == ".3mf";
}

Model read_three_mf(const std::string& path) {
  const read::Bytes bytes = read::read_file(path);
  return read_three_mf(path, bytes.view());
}

Model read_three_mf(const std::string& path, std::string_view bytes) {
  const read::Source source{path, bytes};
  if (bytes.empty()) source.refuse("", "found an empty file, expected a model");
  try {
    return read_package(source);
  } catch (const std::bad_alloc&) {
    source.refuse("", "found a model that is too large for the memory, expected a smaller one");
  } catch (const std::length_error&) {
    source.refuse("", "found a model that is too large for the memory, expected a smaller one");
  }
}

}  // namespace hsr
