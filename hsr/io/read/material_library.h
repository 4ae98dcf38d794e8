#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "hsr/io/read/source.h"
#include "hsr/model.h"

namespace hsr::internal::read {

/// The colours of the materials of MTL files: Kd, and d or 1 - Tr as opacity.
class MaterialLibrary {
 public:
  /// Adds what the statement `mtllib names` of `source` names. A file that is missing or a line that does not fit is a note.
  void load(const Source& source, std::string_view names, std::vector<std::string>& notes);

  /// Nothing for a material that is unknown or has no Kd.
  std::optional<Colour> colour(std::string_view material) const;

 private:
  bool load_file(const Source& source, std::string_view name, std::vector<std::string>& notes);

  struct Material {
    std::optional<Colour> diffuse;
    std::uint8_t opacity = 255;
  };
  std::unordered_map<std::string, Material> materials_;
};

/// 0 ... 1 to 0 ... 255, rounded, clamped.
std::uint8_t colour_byte(double x);

}  // namespace hsr::internal::read
