#include "hsr/drawing/page.h"

#include <catch2/catch.hpp>

#include "geometry/error.h"

using namespace hsr;

TEST_CASE("Pages are names, sizes in millimetres, or fit", "[drawing][page]") {
  CHECK(parse_page("A3").width == 297);
  CHECK(parse_page("a3").height == 420);
  CHECK(parse_page("A4").turns);
  CHECK(parse_page("300x20.5mm").width == 300);
  CHECK(parse_page("300x20.5mm").height == 20.5);
  CHECK_FALSE(parse_page("300x20.5mm").turns);
  CHECK(parse_page("fit").fits);
  for (const char* wrong :
       {"", "A7", "300x200", "x10mm", "10xmm", "-1x10mm", "0x10mm", "nanx1mm", "infx1mm", "1e9x1mm", "1x1x1mm"})
    CHECK_THROWS_AS(parse_page(wrong), InputError);
}

TEST_CASE("Scales are fit or a ratio of paper to model", "[drawing][page]") {
  CHECK_FALSE(parse_scale("fit"));
  CHECK(parse_scale("1:5") == 0.2);
  CHECK(parse_scale("2:1") == 2.0);
  CHECK(parse_scale("1:2.5") == 0.4);
  for (const char* wrong : {"", "5", "1:0", "0:1", "1:", ":1", "-1:5", "1:5x", "nan:1", "1e300:1e-300"})
    CHECK_THROWS_AS(parse_scale(wrong), InputError);
}

TEST_CASE("Units are those of models", "[drawing][page]") {
  CHECK(parse_unit("mm") == 1);
  CHECK(parse_unit("cm") == 10);
  CHECK(parse_unit("m") == 1000);
  CHECK(parse_unit("in") == 25.4);
  CHECK_THROWS_AS(parse_unit("ft"), InputError);
}
