#include "hsr/io/read/material_library.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

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

/// A name of a file has at most so many words: each run of words of a line is tried as one.
constexpr std::size_t most_words = 16;

/// The words of a line; what is in double quotes is one.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t", at)) != std::string_view::npos;) {
    std::size_t stop = line.find_first_of(" \t", at);
    if (line[at] == '"')
      if (const std::size_t quote = line.find('"', at + 1); quote != std::string_view::npos) stop = quote + 1;
    stop = std::min(stop, line.size());
    words.push_back(line.substr(at, stop - at));
    at = stop;
  }
  return words;
}

struct NamedFile {
  std::string path;
  Bytes bytes;
};

std::optional<NamedFile> open_file(std::string path) {
  std::optional<Bytes> bytes = read_named_file(path);
  if (!bytes) return {};
  return NamedFile{std::move(path), std::move(*bytes)};
}

bool same_but_for_case(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char c, unsigned char d) { return std::tolower(c) == std::tolower(d); });
}

/// As named; with the slashes of this system; beside the model, whatever directory is named; in another case of letters.
std::optional<NamedFile> find_file(const Source& source, std::string name) {
  if (auto file = open_file(source.beside(name))) return file;
  std::replace(name.begin(), name.end(), '\\', '/');
  if (auto file = open_file(source.beside(name))) return file;
  name.erase(0, name.rfind('/') + 1);  // all of it where there is none
  if (name.empty()) return {};
  if (auto file = open_file(source.beside(name))) return file;
  const std::string directory = source.beside("");
  std::string best;
  std::error_code error;
  for (std::filesystem::directory_iterator i(directory.empty() ? "." : directory, error), end; !error && i != end;
       i.increment(error))
    if (const std::string found = i->path().filename().string();
        same_but_for_case(found, name) && (best.empty() || found < best))
      best = found;
  return best.empty() ? std::nullopt : open_file(source.beside(best));
}

}  // namespace

std::uint8_t colour_byte(double x) {
  if (!(x > 0)) return 0;
  return static_cast<std::uint8_t>(std::lround(std::min(x, 1.0) * 255));
}

std::string_view without_quotes(std::string_view name) {
  if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  return name;
}

bool MaterialLibrary::load_file(const Source& source, std::string_view name, std::vector<std::string>& notes) {
  std::optional<NamedFile> file = find_file(source, std::string(name));
  if (!file) return false;
  std::string_view bytes = file->bytes.view();
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  read({file->path, bytes}, notes);
  return true;
}

void MaterialLibrary::read(const Source& library, std::vector<std::string>& notes) {
  TextScanner text(library, {.comment = '#', .continuation = true});
  Material* material = nullptr;
  try {
    for (; text.skip_lines(); text.next_line()) {
      const std::string_view keyword = text.word();
      if (keyword == "newmtl") {
        material = &materials_[std::string(without_quotes(text.rest_of_line()))];
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
      } else if (keyword == "map_Kd") {
        material->is_textured = true;
      } else if (keyword == "Tr") {
        material->opacity = colour_byte(1 - text.number("a transparency"));
      }
    }
  } catch (const InputError& e) {
    notes.push_back(std::string(e.what()) + "; the colours behind it are passed over");
  }
}

void MaterialLibrary::load(const Source& source, std::string_view names, std::vector<std::string>& notes) {
  // One file whose name has blanks, or several files: the whole line is tried first.
  if (names.empty() || load_file(source, names, notes)) return;
  const std::vector<std::string_view> words = words_of(names);
  std::string missing;
  bool found = false;
  for (std::size_t first = 0; first < words.size();) {
    std::size_t last = std::min(words.size(), first + most_words);
    const auto name = [&] {
      return without_quotes({words[first].data(), static_cast<std::size_t>(words[last - 1].end() - words[first].begin())});
    };
    while (last > first && !load_file(source, name(), notes)) --last;
    if (last > first) {
      found = true;
      first = last;
      continue;
    }
    if (words[first].front() == '#') break;  // a comment
    missing += (missing.empty() ? "" : " ") + std::string(without_quotes(words[first]));
    ++first;
  }
  if (!missing.empty())
    notes.push_back("material library " + in_quotes(found ? std::string_view(missing) : without_quotes(names)) +
                    " is missing: its colours are left out");
}

bool MaterialLibrary::is_textured(std::string_view material) const {
  const auto at = materials_.find(std::string(material));
  return at != materials_.end() && at->second.is_textured;
}

std::optional<Colour> MaterialLibrary::colour(std::string_view material) const {
  const auto at = materials_.find(std::string(material));
  if (at == materials_.end() || !at->second.diffuse) return {};
  Colour colour = *at->second.diffuse;
  colour[3] = at->second.opacity;
  return colour;
}

}  // namespace hsr::internal::read
