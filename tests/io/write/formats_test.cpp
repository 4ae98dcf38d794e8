#include <catch2/catch.hpp>
#include <sstream>

#include "geometry/error.h"
#include "hsr/io/write/dashes.h"
#include "hsr/io/write/dxf.h"
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
  CHECK(layers[0].style.is_dashed());
  CHECK(layers[1].style.width == 0.5);
  CHECK(layers[2].style.width == 0.25);
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
  CHECK(contains(text, "% layer: hidden sharp\n0 0 0 RG\n0.25 w 0 J [3 0.75] 0 d\n40 45 m\n60 44.75 l\nS\n"));
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
        "PU1600,2200;PD1720,2201;\nPU1750,2202;PD1870,2203;\nPU1900,2204;PD2020,2205;\nPU2050,2206;PD2170,2207;\n"
        "PU2200,2207;PD2320,2209;\nPU2350,2209;PD2400,2210;\n"
        "SP2;\nPU1600,2000;PD2400,2000;\nSP3;\nPU1600,1800;PD2400,1790;\nPU;SP0;\n");
}

TEST_CASE("Dashes run on over corners", "[write][D14]") {
  const std::vector<PaperPoint> corner = {{0, 0}, {2000, 0}, {2000, 2500}};
  const auto dashes = dashes_of(corner, {0.25, 3, 0.75});
  REQUIRE(dashes.size() == 2);
  CHECK(dashes[0] == std::vector<PaperPoint>{{0, 0}, {2000, 0}, {2000, 1000}});
  CHECK(dashes[1] == std::vector<PaperPoint>{{2000, 1750}, {2000, 2500}});
}
