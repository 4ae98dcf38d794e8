#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "tests/lines/labelled_scene.h"
#include "tests/scenes/random_scenes.h"

// Bodies that touch are one body of their shape, and faces that are stored twice are one.

namespace hsr {

namespace {

/// Boxes of whole numbers with disjoint insides: what a grid of unit cells holds of them.
struct Blocks {
  static constexpr int size = 4;
  std::array<std::array<std::array<int, size>, size>, size> box_at{};  // 0: none
  int count = 0;

  explicit Blocks(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<std::uint64_t>(n)); };
    for (int tries = 0; tries < 12; ++tries) {
      std::array<int, 3> low{}, high{};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = below(size);
        high[k] = low[k] + 1 + below(size - low[k]);
      }
      if (is_free(low, high)) fill(low, high, ++count);
    }
  }
  int at(int x, int y, int z) const {
    const auto is_inside = [](int i) { return 0 <= i && i < size; };
    return is_inside(x) && is_inside(y) && is_inside(z)
               ? box_at[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)][static_cast<std::size_t>(z)]
               : 0;
  }
  template <class Visit>
  static void cells(const std::array<int, 3>& low, const std::array<int, 3>& high, const Visit& visit) {
    for (int x = low[0]; x < high[0]; ++x)
      for (int y = low[1]; y < high[1]; ++y)
        for (int z = low[2]; z < high[2]; ++z) visit(x, y, z);
  }
  bool is_free(const std::array<int, 3>& low, const std::array<int, 3>& high) const {
    bool is = true;
    cells(low, high, [&](int x, int y, int z) { is = is && at(x, y, z) == 0; });
    return is;
  }
  void fill(const std::array<int, 3>& low, const std::array<int, 3>& high, int box) {
    cells(low, high, [&](int x, int y, int z) {
      box_at[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)][static_cast<std::size_t>(z)] = box;
    });
    boxes.push_back({low, high});
  }
  std::vector<std::pair<std::array<int, 3>, std::array<int, 3>>> boxes;

  Labelled apart() const {
    Labelled x;
    for (const auto& [low, high] : boxes)
      x.add_box({double(low[0]), double(low[1]), double(low[2])}, {double(high[0]), double(high[1]), double(high[2])});
    return x;
  }
  /// The surface of all of them together, a square for each side of a cell that has nothing beside it.
  Labelled together() const {
    Labelled x;
    cells({0, 0, 0}, {size, size, size}, [&](int i, int j, int k) {
      if (at(i, j, k) == 0) return;
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int step : {0, 1}) {
          std::array<int, 3> beside = {i, j, k};
          beside[axis] += step == 0 ? -1 : 1;
          if (at(beside[0], beside[1], beside[2]) != 0) continue;
          std::vector<Point3> corners;
          for (const auto& [u, v] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
            std::array<int, 3> p = {i, j, k};
            p[axis] += step;
            p[(axis + 1) % 3] += u;
            p[(axis + 2) % 3] += v;
            corners.push_back({double(p[0]), double(p[1]), double(p[2])});
          }
          x.add_face(corners);
        }
    });
    return x;
  }
};

void check_blocks(std::uint64_t first_seed, std::uint64_t seeds) {
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    const Blocks blocks(seed);
    Labelled apart = blocks.apart(), together = blocks.together();
    for (const View& view :
         {scenes::from_direction({1, -1, 1}), scenes::from_direction({2, -3, 1}), scenes::from_direction({0, -1, 0}),
          scenes::from_direction({0, 0, 1}), scenes::from_eye({7, -9, 6}, {2, 2, 2})}) {
      apart.scene.view = together.scene.view = view;
      INFO("seed " << seed << ", " << blocks.count << " boxes\n" << scenes::to_text(apart.scene));
      CHECK(difference(apart.ink(), together.ink()) == "");
    }
  }
}

TEST_CASE("bodies that touch are drawn as one body of their shape", "[lines][metamorphic][shape][C17][C21]") {
  check_blocks(730'000, 40);
}

TEST_CASE("many bodies that touch are drawn as one body of their shape", "[lines][metamorphic][shape][.][long]") {
  check_blocks(740'000, 2000);
}

/// The straight lines of an ink, each with what is drawn of it.
std::set<std::string> lines_in(const std::string& ink) {
  std::set<std::string> all;
  for (std::size_t at = 0; at < ink.size();) {
    std::size_t end = at;
    do end = ink.find('\n', end) + 1;
    while (end < ink.size() && ink[end] == ' ');
    all.insert(ink.substr(at, end - at));
    at = end;
  }
  return all;
}

std::set<std::string> without(std::set<std::string> all, const std::set<std::string>& known) {
  for (const std::string& line : known) all.erase(line);
  return all;
}

TEST_CASE("a box whose upper part is there a second time keeps its hidden lines", "[lines][shape][C21][C22]") {
  Labelled box;
  box.add_box({0, 0, 0}, {3, 3, 4});
  Labelled twice = box;
  twice.add_box({0, 0, 2}, {3, 3, 4});  // its walls coincide with those of the box, on the same side
  for (const View& view : {scenes::from_direction({2, -3, 1}), scenes::from_eye({9, -12, 7}, {1, 1, 2})}) {
    box.scene.view = twice.scene.view = view;
    INFO(twice.ink());
    CHECK(without(lines_in(box.ink()), lines_in(twice.ink())).empty());
  }
}

TEST_CASE("where bodies touch nothing is drawn, though one that overlaps another touches there, too",
          "[lines][shape][C21][C22]") {
  Labelled four;
  four.add_box({0, 0, 0}, {10, 6, 3});
  four.add_box({10, 0, 0}, {14, 6, 3});
  four.add_box({0, 6, 0}, {10, 9, 3});
  four.add_box({10, 6, 0}, {14, 9, 3});
  Labelled more = four;
  more.add_box({10, 1, 1}, {11, 4, 2});
  four.scene.view = more.scene.view = scenes::from_direction({2, -3, 1});
  CHECK(lines_in(four.ink()).size() == 12);
  INFO(more.ink());
  CHECK(without(lines_in(four.ink()), lines_in(more.ink())).empty());
  CHECK(without(lines_in(more.ink()), lines_in(four.ink())).size() == 12);  // its own edges
}

/// Every face a second time, behind all others or beside its first, every other one turned over.
Labelled stored_twice(const Labelled& x, bool beside) {
  Labelled y = without_faces(x);
  const auto add = [&](std::size_t f, bool turned) {
    Ring ring(x.scene.polygons[f].begin(), x.scene.polygons[f].end());
    if (turned) std::reverse(ring.begin(), ring.end());
    y.add_face(ring, x.labels.object[f], x.labels.material[f]);
  };
  for (std::size_t f = 0; f < x.scene.polygons.size(); ++f) {
    add(f, false);
    if (beside) add(f, f % 2 == 0);
  }
  for (std::size_t f = 0; !beside && f < x.scene.polygons.size(); ++f) add(f, f % 2 == 0);
  return y;
}

void check_twice(std::uint64_t first_seed, std::uint64_t seeds) {
  for (const scenes::Family& family : scenes::families())
    for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
      const Labelled x = labelled(family.make(seed), seed % 2 == 0);
      INFO(family.name << " " << seed << "\n" << scenes::to_text(x.scene));
      CHECK(difference(x.ink(), stored_twice(x, seed % 3 == 0).ink()) == "");
    }
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    Labelled x = Blocks(seed).apart();
    x.scene.view = scenes::from_direction({1, -1, 1});
    CHECK(difference(x.ink(), stored_twice(x, false).ink()) == "");
  }
}

TEST_CASE("a file in which every face is stored twice is drawn as with each once", "[lines][metamorphic][shape][C21]") {
  check_twice(750'000, 12);
}

TEST_CASE("a box that is stored twice on a floor keeps its hidden lines", "[lines][shape][C21]") {
  Labelled once, twice;
  for (Labelled* x : {&once, &twice}) {
    x->add_face({{-5, -5, 0}, {9, -5, 0}, {9, 9, 0}, {-5, 9, 0}});
    x->add_box({0, 0, 0}, {3, 3, 3});
    x->scene.view = scenes::from_direction({1, -1, 1});
  }
  twice.add_box({0, 0, 0}, {3, 3, 3});
  // Of a box on a floor the foot is hidden twice, and an edge that goes up.
  CHECK(lines_of(once, "hidden") == 3);
  CHECK(by_visibility(once.ink()) == by_visibility(twice.ink()));
}

TEST_CASE("the corner of a doubled sheet on a floor is no place where bodies touch", "[lines][shape][C21]") {
  Labelled x;
  x.add_face({{-5, -5, 0}, {9, -5, 0}, {9, 9, 0}, {-5, 9, 0}});
  for (int k = 0; k < 2; ++k) {
    x.add_face({{0, 0, 0}, {3, 0, 0}, {3, 0, 2}, {0, 0, 2}});
    x.add_face({{0, 0, 0}, {0, 4, 0}, {0, 4, 2}, {0, 0, 2}});
  }
  x.scene.view = scenes::from_direction({1, -2, -1});  // from below: the floor hides all of it
  INFO(x.ink());
  CHECK(lines_of(x, "hidden boundary") == 4);  // its ends and its upper side
  CHECK(lines_of(x, "hidden outline") == 1);   // its corner; at its foot it may be a body on either side
}

TEST_CASE("many files in which every face is stored twice are drawn as with each once",
          "[lines][metamorphic][shape][.][long]") {
  check_twice(760'000, 200);
}

}  // namespace
}  // namespace hsr
