#include "study/stability.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "hsr/raster/caster.h"
#include "study/compared_methods.h"
#include "study/stability_csv.h"
#include "study/stability_page.h"
#include "study/stability_plots.h"

namespace hsr {

using namespace internal;

namespace {

const StabilityFamily& family(const std::string& name) {
  const auto all = stability_families();
  return *std::find_if(all.begin(), all.end(), [&](const StabilityFamily& f) { return name == f.name; });
}

const StabilityRow& row(const FamilyResult& f, const std::string& name) {
  const auto found = std::find_if(f.rows.begin(), f.rows.end(), [&](const StabilityRow& r) { return r.name() == name; });
  REQUIRE(found != f.rows.end());
  return *found;
}

TEST_CASE("the values of every knob run one way and cover its range", "[check][stability]") {
  for (const StabilityFamily& f : stability_families())
    for (const bool quick : {true, false}) {
      INFO(f.name << " " << quick);
      const std::vector<double> values = f.values(quick);
      REQUIRE(values.size() >= 5);
      CHECK(values.front() > 0);
      CHECK((std::is_sorted(values.begin(), values.end(), std::less_equal<>()) ||
             std::is_sorted(values.begin(), values.end(), std::greater_equal<>())));
      CHECK(values.front() == f.values(false).front());
    }
  const auto ends = [](const char* name) {
    return std::pair(family(name).values(true).front(), family(name).values(true).back());
  };
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const char* name : {"gap", "slope", "grazing"}) CHECK(ends(name) == std::pair(1.0, least));
  CHECK(ends("ulp") == std::pair(1.0, 0x1p-52));
  CHECK(ends("ratio") == std::pair(1.0, 1e300));
  CHECK(ends("large") == std::pair(1.0, 0x1p1000));
  CHECK(ends("small") == std::pair(1.0, 0x1p-1000));
  CHECK(ends("offset") == std::pair(1.0, 1e300));
  CHECK(ends("sliver").second == 0x1p53);
}

/// All that promise to be exact, but the two that are only slower.
std::vector<RunnableMethod> exact_methods(const Mesh& mesh, const View& view, const SampleGrid& grid) {
  std::vector<RunnableMethod> all = object_space_methods(mesh, view, grid);
  all.erase(std::remove_if(all.begin(), all.end(),
                           [](const RunnableMethod& m) { return m.numbers == "intervals" || m.numbers == "rationals only"; }),
            all.end());
  return all;
}

TEST_CASE("exact methods are right on every value of every knob", "[check][stability]") {
  StabilityOptions options{.size = 16, .quick = true, .methods = exact_methods};
  for (const StabilityFamily& f : stability_families())
    if (f.name != std::string("layers") && f.name != std::string("soup")) options.families.emplace_back(f.name);
  const Stability result = stability(options);
  CHECK(result.defects() == std::vector<std::string>());
  for (const FamilyResult& f : result.families) {
    INFO(f.family.name);
    std::uint64_t known = 0, exact = 0;
    for (const StabilityValue& v : f.values) known += v.known;
    CHECK(known >= 16 * 16);
    for (const StabilityRow& r : f.rows) {
      if (!r.is_exact) continue;
      ++exact;
      for (const StabilityPoint& p : r.points) CHECK(p.outcome == Outcome::right);
    }
    CHECK(exact == 4);
  }
}

TEST_CASE("all methods on scenes of many faces: the exact ones are right", "[check][stability][long]") {
  CHECK(stability({.families = {"layers", "cycle", "soup"}, .size = 64, .quick = true}).defects().empty());
}

TEST_CASE("the caster sees what is known of many faces", "[check][stability]") {
  const auto none = [](const Mesh&, const View&, const SampleGrid&) { return std::vector<RunnableMethod>(); };
  const Stability result = stability({.families = {"layers", "soup", "cycle"}, .size = 64, .methods = none});
  CHECK(result.defects().empty());
  for (const FamilyResult& f : result.families)
    for (const StabilityValue& v : f.values) {
      CHECK(v.caster_errors == 0);
      CHECK(v.known > 64 * 64 * 9 / 10);
    }
}

FaceId known_face(const StiffScene& scene) {
  for (int j = 0; j < scene.grid.height; ++j)
    for (int i = 0; i < scene.grid.width; ++i)
      if (const auto known = scene.known(i, j); known && known->is_valid()) return *known;
  FAIL("nothing is known");
  return {};
}

TEST_CASE("a face that is missing differs from what is known", "[check][stability]") {
  for (const StabilityFamily& f : stability_families()) {
    INFO(f.name);
    const double value = f.values(true)[1];
    StiffScene scene = f.scene(value, 32);
    const FaceId missing = known_face(scene);
    for (std::uint32_t c = scene.polygons.first[missing.value]; c < scene.polygons.first[missing.value + 1]; ++c)
      scene.polygons.corners[c] = scene.polygons.corners[scene.polygons.first[missing.value]];
    const Mesh mesh = make_mesh(scene.points, scene.polygons);
    const CastImage seen = cast(mesh, scene.view, scene.grid);
    int differences = 0;
    for (int j = 0; j < 32; ++j)
      for (int i = 0; i < 32; ++i)
        if (const auto known = scene.known(i, j)) differences += *known != seen.face(mesh, i, j) ? 1 : 0;
    CHECK(differences > 0);
  }
}

/// Shows triangle 0, which is the lower square of the gap, where the two are closer than `gap`; else what is seen.
RunnableMethod planted(const Mesh& mesh, const View& view, const SampleGrid& grid, double gap) {
  RunnableMethod m;
  m.method = "planted";
  m.numbers = "at " + std::to_string(gap);
  m.is_exact = true;
  m.solve = m.forget = [] {};
  m.show = [&mesh, &view, grid, gap] {
    ShownPicture picture{cast(mesh, view, grid).triangles, {}};
    if (mesh.points[VertexId(4)].z < gap) picture.triangles.at(3, 3) = TriangleId(0);
    return picture;
  };
  return m;
}

TEST_CASE("planted mistakes give breakdown points, refusals do not", "[check][stability]") {
  StabilityOptions options{.families = {"gap"}, .size = 16, .quick = true};
  options.methods = [](const Mesh& mesh, const View& view, const SampleGrid& grid) {
    std::vector<RunnableMethod> all;
    for (const double gap : {2.0, 1e-3, 0.0}) all.push_back(planted(mesh, view, grid, gap));
    all.push_back(planted(mesh, view, grid, 0));
    all.back().solve = [] { throw InputError("too much"); };
    all.push_back(planted(mesh, view, grid, 0));
    all.back().solve = [] { throw InvariantError("rings are open"); };
    all.push_back(all.back());
    all.back().is_exact = false;
    return all;
  };
  const Stability result = stability(options);
  const FamilyResult& f = result.families.at(0);
  CHECK(f.breakdown(f.rows[0]) == 1.0);
  CHECK(f.breakdown(f.rows[1]) == 1e-4);
  CHECK_FALSE(f.breakdown(f.rows[2]));
  CHECK_FALSE(f.breakdown(f.rows[3]));
  CHECK(f.breakdown(f.rows[4]) == 1.0);
  CHECK(f.breakdown(f.rows[5]) == 1.0);
  CHECK(f.rows[1].points.back().wrong == 1);
  CHECK(f.rows[1].points.back().wrong_share == 1 / 256.0);
  CHECK(f.rows[3].points.back().outcome == Outcome::refused);
  CHECK(f.rows[3].points.back().why == "refused: too much");
  CHECK(f.rows[4].points.back().outcome == Outcome::broke_down);
  CHECK(f.rows[4].points.back().wrong_share == 1);
  const std::vector<std::string> defects = result.defects();  // one a method
  REQUIRE(defects.size() == 3);
  CHECK(defects[0] == "family gap, gap 1: planted, at 2.000000 shows another face than the nearest at 1 samples");
  CHECK(defects[1].find("gap 1e-04: planted, at 0.001") != std::string::npos);
  CHECK(defects[2].find("rings are open") != std::string::npos);
}

TEST_CASE("a caster that differs from what is known is a defect", "[check][stability]") {
  Stability result;
  result.families.push_back({family("gap"), {{0.5, 4, 256, 256, 0}, {0.25, 4, 256, 256, 7}}, {}, {}, 0});
  REQUIRE(result.defects().size() == 1);
  CHECK(result.defects()[0] == "family gap, gap 0.25: ray casting differs from the known answer at 7 samples");
}

std::vector<RunnableMethod> methods(const Mesh& mesh, const View& view, const SampleGrid& grid) {
  return image_space_methods(mesh, view, grid);
}

TEST_CASE("depth buffers break where one step of their format predicts", "[check][stability]") {
  const Stability result = stability({.families = {"gap", "ulp", "distance"}, .size = 64, .methods = methods});
  for (const FamilyResult& f : result.families)
    for (const char* name :
         {"depth buffer, fixed 16", "depth buffer, fixed 24", "depth buffer, fixed 32", "depth buffer, float 32"}) {
      INFO(f.family.name << ", " << name);
      const StabilityRow& r = row(f, name);
      REQUIRE(f.breakdown(r));
      REQUIRE(r.predicted);
      // The values are up to a factor of ten apart, and two depths that are a step apart may still be rounded apart.
      CHECK(*f.breakdown(r) < 2 * *r.predicted);
      CHECK(*f.breakdown(r) > *r.predicted / 20);
    }
  // The formula of the books, z^2 / (n 2^b), where the wall is farthest; there the gap is 1 / 0.75 of that in the middle.
  const double z = 128 / 0.75, n = 0.125;
  CHECK(row(result.families[2], "depth buffer, fixed 24").predicted.value() ==
        Approx(0.75 * z * z / (n * 0x1p24)).epsilon(0.03));
  CHECK_FALSE(row(result.families[2], "z-buffer, float").predicted);
}

TEST_CASE("plain doubles break somewhere, exact fragments nowhere", "[check][stability]") {
  const Stability result = stability({.families = {"slope"}, .size = 16, .quick = true, .methods = exact_methods});
  const FamilyResult& f = result.families.at(0);
  CHECK(f.breakdown(row(f, "visible fragments, doubles only")));
  CHECK_FALSE(f.breakdown(row(f, "visible fragments, exact, staged")));
}

TEST_CASE("mistakes where a format tells nothing apart, or slopes are beyond the doubles, are ties", "[check][stability]") {
  const Stability result = stability({.families = {"ratio", "grazing"}, .size = 16, .quick = true, .methods = methods});
  for (const FamilyResult& f : result.families) {
    const StabilityPoint& last = row(f, "z-buffer, float").points.back();
    CHECK(last.outcome == Outcome::wrong);
    CHECK(last.order == 0);
  }
}

TEST_CASE("a family that is none is refused with the names there are", "[check][stability]") {
  CHECK_THROWS_WITH(stability({.families = {"gap", "gaps"}}),
                    Catch::Contains("found \"gaps\"") && Catch::Contains("ulp, distance"));
}

TEST_CASE("page, plots and table have every family, and only numbers in their coordinates", "[check][stability][write]") {
  const Stability result = stability({.families = {"gap", "large"}, .size = 16, .quick = true, .methods = methods});
  const std::string page = stability_page(result, {"Title & more", {"a fact"}});
  for (const char* part :
       {"Title &amp; more", "a fact", "A gap between parallel faces", "Large coordinates", "5e-324", "2^1000"})
    CHECK(page.find(part) != std::string::npos);
  const std::vector<NamedPlot> plots = stability_plots(result);
  REQUIRE(plots.size() == 2);
  CHECK(plots[0].name == "gap");
  for (const NamedPlot& p : plots) {
    CHECK(p.plot.series.size() >= 8);
    const std::string svg = plot_svg(p.plot);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(svg.find("all exact methods") != std::string::npos);
    // A file has colours that any program knows.
    CHECK(svg.find("var(--c0,#3566c4)") != std::string::npos);
    const std::string file = plot_file(p.plot);
    CHECK(file.find("var(") == std::string::npos);
    CHECK(file.find("stroke=\"#3566c4\"") != std::string::npos);
    CHECK(file.rfind("</svg>\n") == file.size() - 7);
  }
  CHECK(plot_svg(plots[0].plot).find(">5e-324</text>") != std::string::npos);  // the knob's last value, at the axis' end
  CHECK(plot_svg(plots[0].plot).find("stroke-dasharray") != std::string::npos);
  const std::string csv = stability_csv(result);
  std::size_t rows = 1;
  for (const FamilyResult& f : result.families) rows += f.rows.size() * f.values.size();
  CHECK(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) == rows);
}

}  // namespace
}  // namespace hsr
