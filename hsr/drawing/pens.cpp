#include "hsr/drawing/pens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "geometry/error.h"

namespace hsr {

namespace {

constexpr double widest = 100;     // mm
constexpr double longest = 10000;  // mm, of a dash

struct NamedColour {
  const char* name;
  Colour colour;
};
constexpr std::array<NamedColour, 16> colours = {{{"black", {0, 0, 0, 255}},
                                                  {"silver", {192, 192, 192, 255}},
                                                  {"gray", {128, 128, 128, 255}},
                                                  {"white", {255, 255, 255, 255}},
                                                  {"maroon", {128, 0, 0, 255}},
                                                  {"red", {255, 0, 0, 255}},
                                                  {"purple", {128, 0, 128, 255}},
                                                  {"fuchsia", {255, 0, 255, 255}},
                                                  {"green", {0, 128, 0, 255}},
                                                  {"lime", {0, 255, 0, 255}},
                                                  {"olive", {128, 128, 0, 255}},
                                                  {"yellow", {255, 255, 0, 255}},
                                                  {"navy", {0, 0, 128, 255}},
                                                  {"blue", {0, 0, 255, 255}},
                                                  {"teal", {0, 128, 128, 255}},
                                                  {"aqua", {0, 255, 255, 255}}}};

/// Dashes in widths of the line, by ISO 128-20.
struct NamedDash {
  const char* name;
  std::array<double, 4> widths;
  std::size_t size;
};
constexpr std::array<NamedDash, 4> dashes = {
    {{"solid", {}, 0}, {"dashed", {12, 3}, 2}, {"dotted", {0.5, 3}, 2}, {"chain", {24, 3, 0.5, 3}, 4}}};

[[noreturn]] void refuse(const std::string& found, const std::string& expected) {
  throw InputError("pen: found \"" + found + "\", expected " + expected);
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == text.npos ? std::string_view() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

std::optional<double> number(std::string_view text, double most) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size() || !(x > 0 && x <= most)) return {};
  return x;
}

std::optional<EdgeClass> class_named(std::string_view name) {
  for (std::size_t k = 0; k < edge_class_count; ++k)
    if (name == edge_class_names[k]) return static_cast<EdgeClass>(k);
  return {};
}

void parse_name(std::string_view name, PenSetting& setting) {
  std::string_view rest = name;
  for (const bool hidden : {false, true}) {
    const std::string_view word = hidden ? "hidden" : "visible";
    if (!name.starts_with(word) || (name.size() > word.size() && name[word.size()] != '-')) continue;
    setting.hidden = hidden;
    if (name == word) return;
    rest = name.substr(word.size() + 1);
  }
  setting.edge_class = class_named(rest);
  if (setting.edge_class) return;
  std::string known = "visible, hidden";
  for (const char* c : edge_class_names) known += std::string(", ") + c;
  refuse(std::string(name), known + ", or two of them such as hidden-sharp");
}

std::optional<Colour> hexadecimal(std::string_view digits) {
  if (digits.size() != 3 && digits.size() != 6) return {};
  Colour colour = {0, 0, 0, 255};
  const std::size_t n = digits.size() / 3;
  for (std::size_t k = 0; k < 3; ++k) {
    unsigned value = 0;
    const char* const begin = digits.data() + k * n;
    const auto [end, error] = std::from_chars(begin, begin + n, value, 16);
    if (error != std::errc{} || end != begin + n) return {};
    colour[k] = static_cast<std::uint8_t>(n == 1 ? value * 17 : value);
  }
  return colour;
}

Colour parse_colour(std::string_view text) {
  if (text.starts_with('#'))
    if (const auto colour = hexadecimal(text.substr(1))) return *colour;
  std::string known;
  for (const NamedColour& c : colours) {
    if (text == c.name) return c.colour;
    known += std::string(", ") + c.name;
  }
  refuse(std::string(text), "a colour: #rgb, #rrggbb" + known);
}

/// Nothing: it is neither a word nor lengths.
std::optional<DashSetting> dash_named(std::string_view text) {
  for (const NamedDash& dash : dashes)
    if (text == dash.name) return DashSetting{{dash.widths.begin(), dash.widths.begin() + dash.size}, true};
  DashSetting setting;
  for (const std::string_view part : split(text, '-')) {
    const auto length = number(part, longest);
    if (!length) return {};
    setting.lengths.push_back(*length);
  }
  if (setting.lengths.size() % 2 != 0) return {};
  return setting;
}

std::vector<double> dash_lengths(const DashSetting& dash, double width) {
  std::vector<double> lengths = dash.lengths;
  if (dash.in_widths)
    for (double& length : lengths) length *= width;
  return lengths;
}

PenSetting parse_pen(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos) refuse(std::string(text), "NAME=MM[:COLOUR[:DASH]] such as hidden=0.18:#555");
  PenSetting setting;
  parse_name(trimmed(text.substr(0, equals)), setting);
  const auto parts = split(text.substr(equals + 1), ':');
  if (parts.size() > 3) refuse(std::string(text), "NAME=MM[:COLOUR[:DASH]] such as hidden=0.18:#555");
  if (!parts[0].empty()) {
    setting.width = number(parts[0], widest);
    if (!setting.width) refuse(std::string(parts[0]), "a width in mm, above 0 and at most 100");
  }
  if (parts.size() > 1 && !parts[1].empty()) setting.colour = parse_colour(parts[1]);
  if (parts.size() > 2 && !parts[2].empty()) {
    setting.dash = dash_named(parts[2]);
    if (!setting.dash)
      refuse(std::string(parts[2]), "solid, dashed, dotted, chain, or lengths of dashes and gaps in mm such as 3-0.75");
  }
  return setting;
}

/// How much a setting says of which lines are meant; nothing: others than these.
std::optional<int> weight_of(const PenSetting& s, bool hidden, EdgeClass edge_class) {
  if ((s.hidden && *s.hidden != hidden) || (s.edge_class && *s.edge_class != edge_class)) return {};
  return (s.hidden ? 1 : 0) + (s.edge_class ? 2 : 0);
}

}  // namespace

Pens::Pens(double wide, HiddenLines hidden_lines) : wide_(wide) {
  for (std::size_t k = 0; k < edge_class_count; ++k) {
    const auto c = static_cast<EdgeClass>(k);
    const bool is_narrow =
        c == EdgeClass::smooth || c == EdgeClass::joint || c == EdgeClass::hatching || c == EdgeClass::overhead;
    pens_[0][k].width = is_narrow ? wide / 2 : c == EdgeClass::section ? wide * 1.4 : wide;
    if (c == EdgeClass::overhead) pens_[0][k].dashes = dash_lengths(*dash_named("dashed"), wide / 2);
    pens_[1][k].width = wide / 2;
    if (hidden_lines != HiddenLines::solid) pens_[1][k].dashes = dash_lengths(*dash_named("dashed"), wide / 2);
  }
}

void Pens::set(const std::vector<PenSetting>& settings) {
  for (const bool hidden : {false, true})
    for (std::size_t k = 0; k < edge_class_count; ++k) {
      Pen& pen = pens_[hidden ? 1 : 0][k];
      const double width_before = pen.width;
      std::optional<DashSetting> dash;
      for (int weight = 0; weight <= 3; ++weight)
        for (const PenSetting& s : settings) {
          if (weight_of(s, hidden, static_cast<EdgeClass>(k)) != weight) continue;
          if (s.width) pen.width = *s.width;
          if (s.colour) pen.colour = *s.colour;
          if (s.colour) pen.has_colour = true;
          if (s.dash) dash = s.dash;
        }
      // Dashes are as long as the line is wide, unless their lengths were given.
      for (double& length : pen.dashes) length *= pen.width / width_before;
      if (dash) pen.dashes = dash_lengths(*dash, pen.width);
    }
}

double line_group(const Page& page) {
  if (page.fits) return 0.5;
  static constexpr struct { double longest, wide; } groups[] = {{148, 0.25}, {210, 0.35}, {594, 0.5}, {841, 0.7}};
  const double longer = std::max(page.width, page.height);
  for (const auto& group : groups)
    if (longer <= group.longest) return page.turns ? group.wide : std::max(group.wide, 0.5);
  return 1;
}

std::vector<PenSetting> parse_pens(const std::string& text) {
  std::vector<PenSetting> settings;
  for (const std::string_view part : split(text, ',')) settings.push_back(parse_pen(part));
  return settings;
}

std::vector<PenSetting> parse_pens_file(const std::string& contents, const std::string& name) {
  std::vector<PenSetting> settings;
  std::size_t line = 0;
  for (const std::string_view text : split(contents, '\n')) {
    ++line;
    if (text.empty() || text.starts_with('#')) continue;
    try {
      settings.push_back(parse_pen(text));
    } catch (const InputError& e) {
      throw InputError(name + ":" + std::to_string(line) + ": " + e.what());
    }
  }
  return settings;
}

}  // namespace hsr
