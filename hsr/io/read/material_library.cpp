#include "hsr/io/read/material_library.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "hsr/io/read/text_scanner.h"

namespace hsr::internal::read {

namespace {

/// The numbers up to the line's end, at most three of them. @throws InputError
std::vector<double> numbers(TextScanner& text, const char* expected) {
  std::vector<double> found;
  do found.push_back(text.number(expected));
  while (found.size() < 3 && !text.at_line_end());
  return found;
}

}  // namespace

std::uint8_t colour_byte(double x) {
  if (!(x > 0)) return 0;
  return static_cast<std::uint8_t>(std::lround(std::min(x, 1.0) * 255));
}

bool MaterialLibrary::load_file(const Source& source, std::string_view name, std::vector<std::string>& notes) {
  std::string file(name);
  std::optional<Bytes> bytes = read_named_file(source.beside(file));
  if (!bytes && file.find('\\') != std::string::npos) {
    std::replace(file.begin(), file.end(), '\\', '/');
    bytes = read_named_file(source.beside(file));
  }
  if (!bytes) return false;
  const Source library{source.beside(file), bytes->view()};
  TextScanner text(library, {.comment = '#', .continuation = true});
  Material* material = nullptr;
  try {
    for (; text.skip_lines(); text.next_line()) {
      const std::string_view keyword = text.word();
      if (keyword == "newmtl") {
        material = &materials_[std::string(text.rest_of_line())];
        *material = {};
      } else if (material == nullptr) {
        continue;
      } else if (keyword == "Kd") {
        // "Kd spectral FILE" and "Kd xyz ..." are colours of another kind.
        if (text.at_line_end() || *text.position() == 's' || *text.position() == 'x') continue;
        const std::vector<double> rgb = numbers(text, "a colour of 1 or 3 numbers");
        const double g = rgb.size() > 1 ? rgb[1] : rgb[0];
        const double b = rgb.size() > 2 ? rgb[2] : g;
        material->diffuse = Colour{colour_byte(rgb[0]), colour_byte(g), colour_byte(b), 255};
      } else if (keyword == "d") {
        if (!text.at_line_end() && *text.position() == '-') text.word();  // d -halo
        material->opacity = colour_byte(text.number("an opacity"));
      } else if (keyword == "Tr") {
        material->opacity = colour_byte(1 - text.number("a transparency"));
      }
    }
  } catch (const InputError& e) {
    notes.push_back(std::string(e.what()) + "; the colours behind it are passed over");
  }
  return true;
}

void MaterialLibrary::load(const Source& source, std::string_view names, std::vector<std::string>& notes) {
  // One file whose name has blanks, or several files: the whole line is tried first.
  if (names.empty() || load_file(source, names, notes)) return;
  bool found = false;
  std::string missing;
  for (std::size_t at = 0; at < names.size();) {
    const std::size_t stop = std::min(names.find_first_of(" \t", at), names.size());
    const std::string_view name = names.substr(at, stop - at);
    if (name.size() < names.size() && load_file(source, name, notes))
      found = true;
    else
      missing += (missing.empty() ? "" : " ") + std::string(name);
    at = std::min(names.find_first_not_of(" \t", stop), names.size());
  }
  if (!missing.empty())
    notes.push_back("material library " + in_quotes(found ? std::string_view(missing) : names) +
                    " is missing: its colours are left out");
}

std::optional<Colour> MaterialLibrary::colour(std::string_view material) const {
  const auto at = materials_.find(std::string(material));
  if (at == materials_.end() || !at->second.diffuse) return {};
  Colour colour = *at->second.diffuse;
  colour[3] = at->second.opacity;
  return colour;
}

}  // namespace hsr::internal::read
