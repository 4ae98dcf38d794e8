#include "hsr/drawing/pens.h"

#include <catch2/catch.hpp>

#include "geometry/error.h"
#include "tests/drawing/hand_made_lines.h"

using namespace hsr;

namespace {

Pens pens_of(const std::string& text) {
  Pens pens;
  pens.set(parse_pens(text));
  return pens;
}

}  // namespace

TEST_CASE("Pens are those of ISO 128 unless others are asked for", "[drawing][pens][D7]") {
  const Pens pens;
  CHECK(pens.of(false, EdgeClass::outline).width == 0.5);
  CHECK_FALSE(pens.of(false, EdgeClass::outline).is_dashed());
  CHECK(pens.of(false, EdgeClass::smooth).width == 0.25);
  CHECK(pens.of(false, EdgeClass::joint).width == 0.25);
  CHECK(pens.of(true, EdgeClass::sharp).width == 0.25);
  CHECK(pens.of(true, EdgeClass::sharp).dashes == std::vector<double>{3, 0.75});
  CHECK_FALSE(Pens(0.5, HiddenLines::solid).of(true, EdgeClass::sharp).is_dashed());
  CHECK(Pens(1).of(true, EdgeClass::sharp).dashes == std::vector<double>{6, 1.5});
}

TEST_CASE("The line group is that of the sheet", "[drawing][pens][D7]") {
  for (const auto& [page, wide] : {std::pair{"A0", 1.0},
                                   {"A1", 0.7},
                                   {"A2", 0.5},
                                   {"A3", 0.5},
                                   {"A4", 0.5},
                                   {"letter", 0.5},
                                   {"A5", 0.35},
                                   {"A6", 0.25},
                                   {"fit", 0.5},
                                   {"40x30mm", 0.5},
                                   {"30x700mm", 0.7}})
    CHECK(line_group(parse_page(page)) == wide);
  HandMadeLines h;
  h.add({-10, 0, 0}, {10, 0, 0});
  const Mesh m = h.mesh();
  DrawingOptions options;
  options.page = parse_page("A0");
  options.pens = parse_pens("outline=:red");
  const Pen pen = draw(m, named_view("front"), h.lines(m), options).pens.of(false, EdgeClass::outline);
  CHECK(pen.width == 1);
  CHECK(pen.colour == Colour{255, 0, 0, 255});
}

TEST_CASE("The pen that says most of which lines are meant counts, part by part", "[drawing][pens][D15]") {
  const Pens pens = pens_of("hidden-sharp=0.18,sharp=0.6:#123456,hidden=0.2:red:dotted,visible=0.35,visible=0.4");
  CHECK(pens.of(false, EdgeClass::outline).width == 0.4);  // of two that say as much, the last
  CHECK(pens.of(false, EdgeClass::sharp).width == 0.6);
  CHECK(pens.of(true, EdgeClass::outline).width == 0.2);
  CHECK(pens.of(true, EdgeClass::sharp).width == 0.18);
  CHECK(pens.of(true, EdgeClass::sharp).colour == Colour{0x12, 0x34, 0x56, 255});
  CHECK(pens.of(true, EdgeClass::outline).colour == Colour{255, 0, 0, 255});
  CHECK_FALSE(pens.of(false, EdgeClass::outline).has_colour);
  // Dashes go by the width of the line, unless they are lengths.
  CHECK(pens.of(true, EdgeClass::sharp).dashes[1] == Approx(0.54));
  CHECK(pens_of("hidden=0.5").of(true, EdgeClass::wire).dashes == std::vector<double>{6, 1.5});
  CHECK(pens_of("hidden=0.5::2-1").of(true, EdgeClass::wire).dashes == std::vector<double>{2, 1});
  CHECK(pens_of("hidden=::solid").of(true, EdgeClass::wire).dashes.empty());
  CHECK(pens_of("smooth=::chain").of(false, EdgeClass::smooth).dashes == std::vector<double>{6, 0.75, 0.125, 0.75});
  CHECK(pens_of("smooth=0.1:#abc").of(false, EdgeClass::smooth).colour == Colour{0xaa, 0xbb, 0xcc, 255});
}

TEST_CASE("What is no pen is refused with what is known", "[drawing][pens][D15]") {
  for (const auto& [wrong, why] : {std::pair{"hiden=0.2", "found \"hiden\", expected visible, hidden, outline, sharp"},
                                   {"hidden-hidden=0.2", "found \"hidden-hidden\", expected visible"},
                                   {"visibleoutline=1", "found \"visibleoutline\""},
                                   {"sharp", "expected NAME=MM"},
                                   {"sharp=0", "found \"0\", expected a width"},
                                   {"sharp=-1", "expected a width"},
                                   {"sharp=nan", "expected a width"},
                                   {"sharp=0.2mm", "expected a width"},
                                   {"sharp=0.2:pink", "found \"pink\", expected a colour: #rgb, #rrggbb, black"},
                                   {"sharp=0.2:#12", "expected a colour"},
                                   {"sharp=0.2:#12345g", "expected a colour"},
                                   {"sharp=0.2::dash", "found \"dash\", expected solid, dashed"},
                                   {"sharp=0.2::3-1-2", "expected solid, dashed"},
                                   {"sharp=0.2::3-0", "expected solid, dashed"},
                                   {"sharp=0.2:red:solid:x", "expected NAME=MM"},
                                   {"sharp=0.2,", "expected NAME=MM"}})
    CHECK_THROWS_WITH(parse_pens(wrong), Catch::Contains(why));
}

TEST_CASE("A file of pens has one to a line, and its errors their line", "[drawing][pens][D15]") {
  const auto settings = parse_pens_file("# mine\r\n\n  visible = 0.35 : #555\r\n\thidden-sharp=0.18::dotted\n", "my.pens");
  REQUIRE(settings.size() == 2);
  CHECK(*settings[0].width == 0.35);
  CHECK(settings[1].edge_class == EdgeClass::sharp);
  CHECK(parse_pens_file("", "my.pens").empty());
  CHECK_THROWS_WITH(parse_pens_file("visible=1\n\nedges=2\n", "my.pens"), Catch::Contains("my.pens:3: pen: found \"edges\""));
}
