#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "hsr/io/read/source.h"
#include "hsr/model.h"

namespace hsr::internal::read {

/// The colours of the materials of MTL files: Kd, and d or 1 - Tr as opacity.
///
/// A statement names one file or several. Names may have blanks, alone or in double quotes; of several names the longest that is
/// a file counts. A name with directories of another system, or with letters of another case, finds the file of that name beside
/// the model.
class MaterialLibrary {
 public:
  /// Adds what the statement `mtllib names` of `source` names. A file that is missing or a line that does not fit is a note.
  void load(const Source& source, std::string_view names, std::vector<std::string>& notes);

  /// Nothing for a material that is unknown or has no Kd.
  std::optional<Colour> colour(std::string_view material) const;
  /// The colour is that of a picture: map_Kd.
  bool is_textured(std::string_view material) const;

 private:
  bool load_file(const Source& source, std::string_view name, std::vector<std::string>& notes);
  void read(const Source& library, std::vector<std::string>& notes);

  struct Material {
    std::optional<Colour> diffuse;
    std::uint8_t opacity = 255;
    bool is_textured = false;
  };
  std::unordered_map<std::string, Material> materials_;
};

/// Without the double quotes around it, if it has them.
std::string_view without_quotes(std::string_view name);

/// 0 ... 1 to 0 ... 255, rounded, clamped.
std::uint8_t colour_byte(double x);

}  // namespace hsr::internal::read
