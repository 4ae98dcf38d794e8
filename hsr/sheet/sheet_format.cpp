#include "geometry/error.h"
#include "hsr/sheet/sheet.h"

namespace hsr {

SheetFormat sheet_format(const std::string& name) {
  static const SheetFormat formats[] = {
      {"A0", 1189, 841},        {"A1", 841, 594},         {"A2", 594, 420}, {"A3", 420, 297}, {"A4", 210, 297, 20, 10, false},
      {"ANSI-A", 279.4, 215.9}, {"ANSI-B", 431.8, 279.4},
  };
  for (const SheetFormat& format : formats)
    if (format.name == name) return format;
  throw InputError("page: found \"" + name + "\", expected A0 ... A4, ANSI-A or ANSI-B");
}

}  // namespace hsr
