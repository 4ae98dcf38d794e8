#include "geometry/ragged.h"

#include <catch2/catch.hpp>
#include <random>
using namespace hsr;

namespace {

using Values = std::vector<int>;

Values row(const Ragged<int>& ragged, std::size_t k) { return {ragged[k].begin(), ragged[k].end()}; }

}  // namespace

TEST_CASE("rows end where the next ones begin", "[geometry][ragged]") {
  Ragged<int> ragged;
  CHECK(ragged.size() == 0);
  ragged.end_row();
  ragged.push_back(1);
  ragged.push_back(2);
  ragged.end_row();
  ragged.push_back(3);
  CHECK(ragged.size() == 2);  // the third has not ended
  ragged.end_row();
  CHECK(ragged.size() == 3);
  CHECK(row(ragged, 0).empty());
  CHECK(row(ragged, 1) == Values{1, 2});
  CHECK(row(ragged, 2) == Values{3});
  ragged[1][0] = 4;
  CHECK(ragged.values() == Values{4, 2, 3});
  CHECK(ragged.begin(1) == 0);
  CHECK(ragged.begin(2) == 2);
  CHECK(ragged.begin(3) == 3);
}

TEST_CASE("rows are added whole, and all rows of another after them", "[geometry][ragged]") {
  Ragged<int> ragged, more;
  ragged.push_row(Values{1, 2});
  more.push_row(Values{});
  more.push_row(Values{3});
  more.push_row(Values{4, 5, 6});
  ragged.append(more);
  ragged.append(Ragged<int>());
  REQUIRE(ragged.size() == 4);
  CHECK(row(ragged, 0) == Values{1, 2});
  CHECK(row(ragged, 1).empty());
  CHECK(row(ragged, 2) == Values{3});
  CHECK(row(ragged, 3) == Values{4, 5, 6});
  ragged.clear();
  CHECK(ragged.size() == 0);
  CHECK(ragged.values().empty());
  ragged.append(more);
  CHECK(row(ragged, 2) == Values{4, 5, 6});
}

TEST_CASE("values are sorted into rows and stay in order there, again and again", "[geometry][ragged]") {
  std::mt19937 random(3);
  Ragged<int> ragged;
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const std::size_t rows = random() % 20;
    std::vector<Values> expected(rows);
    std::vector<std::size_t> row_of(rows == 0 ? 0 : random() % 50);
    for (std::size_t i = 0; i < row_of.size(); ++i) {
      row_of[i] = random() % rows;
      expected[row_of[i]].push_back(static_cast<int>(i));
    }
    ragged.assign(rows, [&](const auto& add) {
      for (std::size_t i = 0; i < row_of.size(); ++i) add(row_of[i], static_cast<int>(i));
    });
    REQUIRE(ragged.size() == rows);
    CHECK(ragged.values().size() == row_of.size());
    for (std::size_t k = 0; k < rows; ++k) CHECK(row(ragged, k) == expected[k]);
  }
}
