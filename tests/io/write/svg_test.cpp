#include "hsr/io/write/svg.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "geometry/error.h"
#include "hsr/io/write/format.h"
#include "hsr/io/write/png.h"
#include "tests/drawing/hand_made_lines.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

/// Tags open and close in order, attributes are quoted, & starts an entity: what a drawing of ours can break.
bool is_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size();) {
    if (xml[i] == '&') {
      const auto end = xml.find(';', i);
      const std::string entity = end == std::string::npos ? "" : xml.substr(i + 1, end - i - 1);
      if (entity != "lt" && entity != "gt" && entity != "amp" && entity != "quot") return false;
    }
    if (xml[i] != '<') {
      if (xml[i] == '>' || static_cast<unsigned char>(xml[i]) < 9) return false;
      ++i;
      continue;
    }
    const auto end = xml.find('>', i);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(i + 1, end - i - 1);
    i = end + 1;
    if (tag.empty() || tag.find('<') != std::string::npos) return false;
    if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return false;
    const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag[0] == '?') continue;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  return open.empty();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Drawing example() {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0});
  h.add({-10, 0, 5}, {10, 0, 5.25}, EdgeClass::sharp, true);
  h.add({-10, 0, -5}, {10, 0, -5.25}, EdgeClass::smooth);
  return h.draw();
}

}  // namespace

TEST_CASE("An SVG has the page in millimetres and a layer for each visibility and class, hidden first", "[write][svg][D7]") {
  const std::string text = svg(example(), {.title = "three lines", .description = "front"});
  CHECK(is_well_formed(text));
  CHECK(contains(text, R"(width="100mm" height="100mm" viewBox="0 0 100 100")"));
  CHECK(contains(text, "<title>three lines</title>\n<desc>front</desc>"));
  CHECK(
      contains(text, R"(<g id="hidden-sharp" class="hidden sharp" inkscape:groupmode="layer" inkscape:label="hidden sharp")"));
  CHECK(contains(text, R"(stroke-width="0.25" stroke-dasharray="3 0.75")"));
  CHECK(contains(text, R"(<path d="M40 50 60 50" data-edge="0-1" data-face=""/>)"));
  CHECK(contains(text, R"(<path d="M40 45 60 44.75" stroke-dasharray="2.7086 0.75" data-edge="2-3" data-face=""/>)"));
  const auto pen = [&](const std::string& layer) {
    const std::string width = "stroke-width=\"";
    const std::size_t at = text.find(width, text.find("id=\"" + layer)) + width.size();
    return text.substr(at, text.find('"', at) - at);
  };
  CHECK(pen("visible-outline") == "0.5");
  CHECK(pen("visible-smooth") == "0.25");
  CHECK(text.find("hidden-sharp") < text.find("visible-outline"));
  CHECK(text.find("visible-outline") < text.find("visible-smooth"));
}

TEST_CASE("Hidden lines are dashed or solid", "[write][svg]") {
  Drawing d = example();
  CHECK(contains(svg(d), "stroke-dasharray"));
  d.pens = Pens(0.5, HiddenLines::solid);
  CHECK_FALSE(contains(svg(d), "stroke-dasharray"));
}

TEST_CASE("Any title makes valid XML", "[write][svg]") {
  const Drawing d = example();
  for (const char* title :
       {"<a> & \"b\" ]]>", "\x01\x1f", "\xff\xfe", "\xC0\x80", "caf\xC3\xA9", "\xED\xA0\x80", "\xE2\x82", "--&#0;"}) {
    const std::string text = svg(d, {.title = title, .description = title});
    CHECK(is_well_formed(text));
  }
  CHECK(contains(svg(d, {.title = "caf\xC3\xA9"}), "<title>caf\xC3\xA9</title>"));
  CHECK(contains(svg(d, {.title = "<&>"}), "<title>&lt;&amp;&gt;</title>"));
  CHECK(contains(svg(d, {.title = "\xC0\x80"}), "<title>\xEF\xBF\xBD\xEF\xBF\xBD</title>"));
}

TEST_CASE("Coordinates have three decimals at most and no trailing zeros", "[write][svg]") {
  Drawing d;
  d.points = {{-1, 0}, {1234567, -1500}, {10, 100}, {-2000, 1}};
  Polyline p;
  p.end_point = 4;
  p.closed = true;
  d.polylines = {p};
  CHECK(contains(svg(d), R"(d="M-0.001 0 1234.567 -1.5 0.01 0.1 -2 0.001Z")"));
}

TEST_CASE("An empty drawing is an empty page", "[write][svg]") {
  const std::string text = svg({});
  CHECK(is_well_formed(text));
  CHECK(contains(text, R"(viewBox="0 0 210 297")"));
  CHECK_FALSE(contains(text, "<g"));
}

TEST_CASE("A PNG has the size that was asked for, or 150 dots to the inch", "[write][png]") {
  const auto size_of = [](const std::string& file) {
    REQUIRE(file.size() > 24);
    CHECK(file.substr(1, 3) == "PNG");
    const auto number = [&](std::size_t at) {
      int n = 0;
      for (std::size_t k = at; k < at + 4; ++k) n = n * 256 + static_cast<unsigned char>(file[k]);
      return n;
    };
    return std::make_pair(number(16), number(20));
  };
  CHECK(size_of(png(example())) == std::make_pair(591, 591));
  CHECK(size_of(png(example(), PixelSize{320, 200})) == std::make_pair(320, 200));
  Drawing wide = example();
  wide.width = 1e6;
  CHECK(size_of(png(wide)) == std::make_pair(16384, 2));
}

TEST_CASE("Sizes in pixels are two whole numbers", "[write][png]") {
  CHECK(parse_size("1600x1200").width == 1600);
  CHECK(parse_size("1600x1200").height == 1200);
  for (const char* wrong : {"", "x", "10x", "x10", "10", "0x10", "-1x10", "10x10px", "1.5x2", "99999x1", "1x99999999999"})
    CHECK_THROWS_AS(parse_size(wrong), InputError);
}

TEST_CASE("A file's ending chooses its format", "[write][format]") {
  const std::array expected = {Format::svg, Format::png, Format::json};
  CHECK(format_of("a.svg", expected) == Format::svg);
  CHECK(format_of("dir.png/a.JSON", expected) == Format::json);
  CHECK(format_of("a.svg.png", expected) == Format::png);
  CHECK(format_of("a.csv", std::array{Format::csv}) == Format::csv);
  const std::array lines = {Format::pdf, Format::eps, Format::dxf, Format::tex, Format::hpgl};
  CHECK(format_of("a.PDF", lines) == Format::pdf);
  CHECK(format_of("a.eps", lines) == Format::eps);
  CHECK(format_of("a.dxf", lines) == Format::dxf);
  CHECK(format_of("a.tex", lines) == Format::tex);
  CHECK(format_of("a.hpgl", lines) == Format::hpgl);
  CHECK(format_of("a.plt", lines) == Format::hpgl);
  for (const char* wrong : {"a", "a.", "a.svg/b", "a.obj", "a.csv", "a.pdf"})
    CHECK_THROWS_WITH(format_of(wrong, expected), Catch::Contains("expected .svg, .png or .json"));
}
