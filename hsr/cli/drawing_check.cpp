#include "hsr/cli/drawing_check.h"

#include <fmt/core.h>

#include <string>
#include <utility>

#include "hsr/cli/messages.h"
#include "hsr/raster/capped_samples.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/cell_samples.h"
#include "hsr/raster/z_buffer.h"
#include "hsr/scene/view_parts.h"
#include "study/attempt.h"
#include "study/compared_methods.h"

namespace hsr::cli {

using namespace internal;

namespace {

std::string name(FaceId face) { return face.is_valid() ? "face " + std::to_string(face.value) : std::string("nothing"); }

void say(const std::vector<WrongSample>& samples) {
  for (const WrongSample& w : samples)
    tell("hsr: check failed: at sample {}, {}: found {}, expected {}\n", w.i, w.j, name(w.painted), name(w.cast));
}

void say(const ZBufferCheck& z, const char* numbers) {
  std::string why;
  const auto add = [&](std::uint64_t count, const char* text) {
    if (count > 0) why += fmt::format("{} {} {}", why.empty() ? ":" : ",", count, text);
  };
  add(z.depth, "where depths differ by less than it tells");
  add(z.edge, "at edges");
  add(z.unbounded, "of faces that have no area in its numbers");
  add(z.other, "unexplained");
  tell("hsr: check{}: a z-buffer of {} shows another face at {} samples{}\n", z.is_explained() ? "" : " failed", numbers,
       z.wrong, why);
  say(z.first_other);
}

/// A z-buffer knows no caps: it is looked at beside them, and in the cells of a view cell by cell, as if there were no far plane.
template <class Real>
ZBufferCheck checked(const SceneView& scene, const SampleGrid& samples, const Image<TriangleId>& nearest) {
  const TieRule ties = scene.options().coplanar;
  const auto check = [&](const SceneView& seen_by, Image<TriangleId> seen, const auto& is_left_out) {
    DepthImage<Real> image = z_buffer<Real>(scene.mesh(), seen_by.view(), samples, ties);
    for (std::size_t k = 0; k < seen.pixels.size(); ++k)
      if (is_left_out(k)) image.pixels[k].triangle = seen.pixels[k] = TriangleId();
    return check_z_buffer(scene.mesh(), seen_by.view(), samples, image, seen, ties);
  };
  if (!scene.view().has_cells()) {
    const Image<std::uint8_t> capped = capped_samples(scene, samples);
    return check(scene, nearest, [&](std::size_t k) { return !capped.pixels.empty() && capped.pixels[k] != 0; });
  }
  const Image<std::uint8_t> cell_of = cell_samples(scene, samples);
  ZBufferCheck all;
  const auto& cells = scene.parts().cells();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Image<std::uint8_t> capped = capped_samples(cells[c].scene, samples);
    const ZBufferCheck one = check(cells[c].scene, cast(cells[c].scene, samples).triangles, [&](std::size_t k) {
      return cell_of.pixels[k] != c || (!capped.pixels.empty() && capped.pixels[k] != 0);
    });
    all.samples = one.samples;
    all.covered += one.covered;
    all.wrong += one.wrong;
    all.depth += one.depth;
    all.edge += one.edge;
    all.unbounded += one.unbounded;
    all.other += one.other;
    all.first_other.insert(all.first_other.end(), one.first_other.begin(), one.first_other.end());
  }
  return all;
}

/// The driver knows no caps and no cells.
std::vector<DriverCheck> checked_by_driver(const SceneView& scene, const SampleGrid& samples,
                                           const Image<TriangleId>& nearest) {
  std::vector<DriverCheck> all;
  if (scene.view().has_section() || scene.view().has_cells()) return all;
  for (const RunnableMethod& m : opengl_methods(scene.mesh(), scene.view(), samples, scene.options().coplanar))
    // A picture may be too large for it.
    attempt([&] {
      m.solve();
      const PictureCheck check = check_picture(scene.mesh(), scene.view(), samples, m.show().triangles, nearest, m.resolution);
      all.push_back({m.method, m.numbers, check});
      all.back().check.mistakes = {};
    });
  return all;
}

void say(const DriverCheck& d) {
  std::string why;
  const auto add = [&](std::uint64_t count, const char* text) {
    if (count > 0) why += fmt::format("{} {} {}", why.empty() ? ":" : ",", count, text);
  };
  add(d.check.tie, "where depths differ by less than it tells");
  add(d.check.edge, "at edges");
  add(d.check.order, "unexplained");
  tell("hsr: check: {}, {}, shows another face at {} samples{}\n", d.method, d.numbers, d.check.wrong, why);
}

}  // namespace

DrawingCheck check_drawing(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples) {
  const Image<TriangleId> nearest = cast(scene, samples).triangles;
  return {check_fragments(scene, fragments, samples, nearest), checked<float>(scene, samples, nearest),
          checked<double>(scene, samples, nearest), checked_by_driver(scene, samples, nearest)};
}

Report::Json json_of(const DrawingCheck& check) {
  const FragmentCheck& f = check.fragments;
  const auto of = [](const ZBufferCheck& z) {
    return Report::Json{
        {"wrong", z.wrong}, {"depth", z.depth}, {"edge", z.edge}, {"unbounded", z.unbounded}, {"other", z.other}};
  };
  Report::Json json = {{"samples", f.samples},
                       {"covered", f.covered},
                       {"wrong", f.wrong},
                       {"overlapping", f.overlapping},
                       {"z_buffer", {{"float", of(check.single)}, {"double", of(check.twice)}}}};
  Report::Json driver = Report::Json::array();
  for (const DriverCheck& d : check.driver)
    driver.push_back({{"driver", d.method},
                      {"format", d.numbers},
                      {"wrong", d.check.wrong},
                      {"depth", d.check.tie},
                      {"edge", d.check.edge},
                      {"other", d.check.order}});
  if (!driver.is_empty()) json.set("opengl", driver);
  return json;
}

void say(const DrawingCheck& check) {
  const FragmentCheck& f = check.fragments;
  if (f.is_right()) {
    tell("hsr: check: the fragments show the nearest face at each of {} samples, {} of them on the model\n", f.samples,
         f.covered);
  } else {
    tell("hsr: check failed: {} of {} samples show another face than the nearest, {} are painted twice\n", f.wrong, f.samples,
         f.overlapping);
    say(f.first_wrong);
  }
  say(check.single, "floats");
  say(check.twice, "doubles");
  for (const DriverCheck& d : check.driver) say(d);
}

}  // namespace hsr::cli
