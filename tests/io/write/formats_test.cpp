#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "geometry/error.h"
#include "hsr/io/write/dxf.h"
#include "hsr/io/write/dxf_pens.h"
#include "hsr/io/write/eps.h"
#include "hsr/io/write/hpgl.h"
#include "hsr/io/write/layers.h"
#include "hsr/io/write/pdf.h"
#include "hsr/io/write/tikz.h"
#include "tests/drawing/hand_made_lines.h"

// other_programs_test shows the files to other programs; here is what can be seen by reading them.

using namespace hsr;
using namespace hsr::internal;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Drawing example() {
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0});
  h.add({-10, 0, 5}, {10, 0, 5.25}, EdgeClass::sharp, true);
  h.add({-10, 0, -5}, {10, 0, -5.25}, EdgeClass::smooth);
  return h.draw();
}

Drawing example_in_frame_units(double factor = 1) {
  HandMadeLines h;
  h.add({-10 * factor, 0, 0}, {10 * factor, 0, 0});
  h.add({-10 * factor, 0, 5 * factor}, {10 * factor, 0, 5.25 * factor}, EdgeClass::sharp, true);
  const Mesh m = h.mesh();
  DrawingOptions options;
  options.hidden = HiddenLines::dashed;
  options.in_frame_units = true;
  return draw(m, named_view("front"), h.lines(m), options);
}

}  // namespace

TEST_CASE("Layers are runs of one visibility and class, hidden first, with their pens", "[write][D11]") {
  const Drawing d = example();
  const auto layers = layers_of(d);
  REQUIRE(layers.size() == 3);
  CHECK(layers[0].name() == "hidden sharp");
  CHECK(layers[1].name('_') == "visible_outline");
  CHECK(layers[2].name('-') == "visible-smooth");
  CHECK(layers[0].pen.is_dashed());
  CHECK(layers[1].pen.width == 0.5);
  CHECK(layers[2].pen.width == 0.25);
  CHECK(layers_of({}).empty());
}

TEST_CASE("A PDF has the same bytes each time, no date, and a page that PDF can have", "[write][pdf][D12]") {
  const std::string text = pdf(example(), "three");
  CHECK(text == pdf(example(), "three"));
  CHECK(text.starts_with("%PDF-1.5\n"));
  CHECK(text.ends_with("%%EOF\n"));
  CHECK_FALSE(contains(text, "Date"));
  CHECK(contains(text, "/MediaBox [0 0 283.464566929 283.464566929]"));
  CHECK(contains(text, "/Title <FEFF00740068007200650065>"));
  CHECK(contains(pdf({}, "\xF0\x9F\x98\x80\xFF"), "<FEFFD83DDE00FFFD>"));
  CHECK_FALSE(contains(pdf({}), "/OCG"));
  Drawing wide = example();
  wide.width = 5081;
  CHECK_THROWS_WITH(pdf(wide), Catch::Contains("5081 x 100 mm") && Catch::Contains("at most 5080 mm"));
}

TEST_CASE("An EPS has the page as its bounding box", "[write][eps][D12]") {
  const std::string text = eps(example(), "caf\xC3\xA9");
  CHECK(text.starts_with("%!PS-Adobe-3.0 EPSF-3.0\n"));
  CHECK(contains(text, "%%BoundingBox: 0 0 284 284\n%%HiResBoundingBox: 0 0 283.464566929 283.464566929\n"));
  CHECK(contains(text, "%%Title: caf??\n"));
  CHECK(contains(text, "% layer: hidden sharp\n0 0 0 RG\n0.25 w 0 J\n40 45 m\n42.708 44.966 l\n"));
}

TEST_CASE("DXF coordinates are those of the view's frame, to a millionth of the drawing or finer", "[write][dxf][D13]") {
  const std::string text = dxf(example_in_frame_units(), {.unit = 1, .page_scale = 2});
  CHECK(contains(text, "LINE\n8\nVISIBLE_OUTLINE\n10\n-10.0\n20\n0.0\n30\n0.0\n11\n10.0\n21\n0.0\n31\n0.0\n"));
  CHECK(contains(text,
                 "LINE\n8\nHIDDEN_SHARP\n10\n-10.0\n20\n5.0\n30\n0.0\n11\n10.0\n21\n5.25\n31\n0.0\n1001\nHSR\n"
                 "1000\nedges\n1071\n2\n1071\n3\n1000\nfaces\n"));
  CHECK(contains(text, "$LTSCALE\n40\n0.125\n"));
  // Of any size.
  CHECK(contains(dxf(example_in_frame_units(0x1p-40)), "10\n-0.00000000000909495\n"));
  CHECK(contains(dxf(example_in_frame_units(0x1p60)), "10\n-11529220000000000000.0\n"));
  const std::string huge = dxf(example_in_frame_units(0x1p200)), tiny = dxf(example_in_frame_units(0x1p-1000));
  CHECK(
      contains(huge, "10\n-16069379999999999326938274962309974812006020084880558612545536.0\n"));  // the double of 1.606938e61
  for (const std::string& any : {huge, tiny})
    CHECK(std::all_of(any.begin(), any.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
  CHECK(contains(dxf({}, {DxfVersion::r2000}), "AC1015"));
}

TEST_CASE("TikZ has a scope and a style for each layer", "[write][tikz][D11]") {
  const std::string text = tikz(example());
  CHECK(contains(
      text, "\\hsrstyle{hidden sharp}{line width=0.25mm, line join=round, line cap=butt, dash pattern=on 3mm off 0.75mm}"));
  CHECK(contains(text, "\\begin{scope}[hsr visible outline]\n\\draw (40,50)\n--(60,50);\n\\end{scope}"));
}

TEST_CASE("HPGL has 40 units to the millimetre, y up, and a pen for each layer", "[write][hpgl][D14]") {
  CHECK(hpgl(example()) ==
        "IN;\nSP1;\n"
        "PU1600,2200;PD1708,2201;\nPU1738,2202;PD1847,2203;\nPU1877,2203;PD1985,2205;\nPU2015,2205;PD2123,2207;\n"
        "PU2153,2207;PD2262,2208;\nPU2292,2209;PD2400,2210;\n"
        "SP2;\nPU1600,2000;PD2400,2000;\nSP3;\nPU1600,1800;PD2400,1790;\nPU;SP0;\n");
}

TEST_CASE("Objects are told apart within layers by PDF, DXF, EPS and TikZ", "[write][O8]") {
  Drawing d = example();
  d.objects = {"n\xC3\xA4h (1", "a\nb", ""};
  d.polylines[0].object = 0;
  d.polylines[1].object = 1;
  d.polylines[2].object = 2;
  const std::string file = pdf(d);
  CHECK(contains(file, "/Name <FEFF006E00E40068002000280031>"));
  CHECK(contains(file, "/Name <FEFF0061000A0062>"));
  // Layers, the last drawn first, each with its objects.
  CHECK(contains(file, "/OCGs [ 6 0 R 7 0 R 8 0 R 9 0 R 10 0 R ] /D << /Order [ 10 0 R 8 0 R [ 9 0 R ] 6 0 R [ 7 0 R ] ] >>"));
  CHECK(contains(eps(d), "% layer: hidden sharp\n0 0 0 RG\n0.25 w 0 J\n% object: n??h (1\n"));
  CHECK(contains(tikz(d), "\\begin{scope}[hsr visible outline]\n% object: a?b\n\\draw "));

  Drawing in_units = example_in_frame_units();
  in_units.objects = d.objects;
  in_units.polylines[0].object = 0;
  in_units.polylines[1].object = 1;
  const std::string lines = dxf(in_units);
  CHECK(contains(lines, "1000\nfaces\n1000\nobject\n1000\nn\\U+00E4h (1\n"));
  CHECK(contains(lines, "1000\nobject\n1000\na b\n"));
  CHECK_FALSE(contains(dxf(example_in_frame_units()), "object"));
}

TEST_CASE("DXF has the nearest numbered colour, the nearest line weight, and line types for other dashes",
          "[write][dxf][D15]") {
  Drawing d = example_in_frame_units();
  d.pens.set(parse_pens("hidden=0.33:#808080:2-1,visible=0.6:#fe0102"));
  const std::string text = dxf(d, {DxfVersion::r2000, 1, 2});
  CHECK(contains(text, "HIDDEN_SHARP\n70\n0\n62\n8\n6\nHIDDEN_SHARP\n370\n35\n"));
  CHECK(contains(text, "VISIBLE_OUTLINE\n70\n0\n62\n1\n6\nCONTINUOUS\n370\n60\n"));
  CHECK(contains(text, "HIDDEN_SHARP\n70\n0\n3\nHIDDEN_SHARP\n72\n65\n73\n2\n40\n12.0\n49\n8.0\n74\n0\n49\n-4.0\n"));
  for (const auto& [colour, number] : {std::pair{Colour{0, 0, 0, 255}, 7},
                                       {{255, 255, 255, 255}, 255},
                                       {{255, 127, 0, 255}, 30},
                                       {{0, 0, 189, 255}, 172},
                                       {{255, 170, 170, 255}, 11},
                                       {{52, 50, 51, 255}, 250}})
    CHECK(dxf_colour(colour) == number);
}

TEST_CASE("A hidden line that is short in DXF has dashes to scale, where the release can say so", "[write][dxf][D13]") {
  HandMadeLines h;
  h.add({0, 0, 0}, {1, 0, 0}, EdgeClass::sharp, true);
  h.add({0, 0, 3}, {100, 0, 3}, EdgeClass::sharp, true);
  const Mesh m = h.mesh();
  DrawingOptions options;
  options.hidden = HiddenLines::dashed;
  options.in_frame_units = true;
  const Drawing d = draw(m, named_view("front"), h.lines(m), options);
  const std::string text = dxf(d, {DxfVersion::r2000, 1, 2});
  CHECK(contains(text, "8\nHIDDEN_SHARP\n48\n0.2963\n100\nAcDbLine\n"));  // 2 mm of 6.75
  CHECK(contains(text, "8\nHIDDEN_SHARP\n100\nAcDbLine\n"));
  CHECK_FALSE(contains(dxf(d, {DxfVersion::r12, 1, 2}), "\n48\n"));
}
