#include "hsr/io/write/section_json.h"

#include <cstdint>

#include "hsr/io/write/json_text.h"

namespace hsr::internal {

void append_section(std::string& out, const Section& section, Numbers numbers, bool has_planes) {
  out += ", \"section\": {\"open_outlines\": " + std::to_string(section.open_outlines) + ", \"caps\": [";
  for (std::size_t k = 0; k < section.caps.size(); ++k) {
    const SectionCap& cap = section.caps[k];
    out += k > 0 ? ",\n" : "\n";
    out += "{\"object\": " + std::to_string(cap.object) + ", \"face\": " + std::to_string(cap.face.value);
    if (has_planes) out += ", \"plane\": " + std::to_string(cap.plane);
    out += ", \"rings\": [";
    for (std::uint32_t r = cap.first_ring; r < cap.end_ring; ++r) {
      out += r > cap.first_ring ? ", [" : "[";
      for (std::size_t i = 0; i < section.rings[r].size(); ++i) {
        if (i > 0) out += ", ";
        for (std::size_t axis = 0; axis < 3; ++axis) {
          out += axis > 0 ? ", " : "[";
          append_rational(out, section.rings[r][i][axis], numbers);
        }
        out += ']';
      }
      out += ']';
    }
    out += "]}";
  }
  out += "\n]}";
}

}  // namespace hsr::internal
