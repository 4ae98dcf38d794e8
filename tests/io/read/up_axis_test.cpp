#include "hsr/up_axis.h"

#include <catch2/catch.hpp>

#include "hsr/io/read/read.h"

using namespace hsr;
using namespace hsr::internal;

namespace {

/// A house with a floor, walls and a pitched roof, in OBJ; `axes` says which of width, depth and height are x, y and z.
std::string house(const std::string& axes) {
  const std::vector<std::array<double, 3>> whd = {{0, 0, 0}, {8, 0, 0}, {8, 6, 0}, {0, 6, 0}, {0, 0, 3},
                                                  {8, 0, 3}, {8, 6, 3}, {0, 6, 3}, {0, 3, 5}, {8, 3, 5}};
  std::string text;
  for (const auto& p : whd) {
    text += "v";
    for (const char axis : axes) text += " " + std::to_string(p[axis == 'w' ? 0 : axis == 'd' ? 1 : 2]);
    text += "\n";
  }
  return text + "f 1 2 3 4\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 10 6\nf 4 1 5 9 8\nf 5 6 10 9\nf 7 8 9 10\n";
}

bool seems(const std::string& obj) { return seems_y_up(read_model("a.obj", obj)); }

}  // namespace

TEST_CASE("A house whose floor is at the least y seems to lie on its side", "[read][up_axis][R16]") {
  CHECK(seems(house("whd")));
  CHECK(seems(house("dhw")));
  CHECK_FALSE(seems(house("wdh")));
  CHECK_FALSE(seems(house("dwh")));
  CHECK_FALSE(seems(house("hwd")));
  // A box, a plate, a tetrahedron and nothing are not judged.
  CHECK_FALSE(
      seems("v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\nf 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\n"
            "f 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"));
  CHECK_FALSE(seems("v 0 0 0\nv 2 0 0\nv 2 0 3\nf 1 2 3\n"));
  CHECK_FALSE(seems("v 0 0 0\nv 2 0 1\nv 2 1 3\nv 0 5 0\nf 1 2 3\nf 1 2 4\n"));
  CHECK_FALSE(seems("v 0 0 0\nv 2 0 0\nl 1 2\n"));
}
