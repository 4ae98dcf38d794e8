#include "hsr/cli/drawing_check.h"

#include <fmt/core.h>

#include <string>
#include <utility>

#include "hsr/cli/messages.h"
#include "hsr/raster/capped_samples.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/z_buffer.h"

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

}  // namespace

DrawingCheck check_drawing(const SceneView& scene, const VisibleFragments& fragments, const SampleGrid& samples) {
  const Mesh& mesh = scene.mesh();
  const View& view = scene.view();
  const TieRule ties = scene.options().coplanar;
  const Image<TriangleId> nearest = cast(scene, samples).triangles;
  // A z-buffer knows no caps: it is looked at beside them.
  const Image<std::uint8_t> capped = capped_samples(scene, samples);
  const auto without_caps = [&](auto image) {
    for (std::size_t k = 0; k < capped.pixels.size(); ++k)
      if (capped.pixels[k] != 0) image.pixels[k].triangle = TriangleId();
    return image;
  };
  return {check_fragments(scene, fragments, samples, nearest),
          check_z_buffer(mesh, view, samples, without_caps(z_buffer<float>(mesh, view, samples, ties)), nearest, ties),
          check_z_buffer(mesh, view, samples, without_caps(z_buffer<double>(mesh, view, samples, ties)), nearest, ties)};
}

Report::Json json_of(const DrawingCheck& check) {
  const FragmentCheck& f = check.fragments;
  const auto of = [](const ZBufferCheck& z) {
    return Report::Json{
        {"wrong", z.wrong}, {"depth", z.depth}, {"edge", z.edge}, {"unbounded", z.unbounded}, {"other", z.other}};
  };
  return {{"samples", f.samples},
          {"covered", f.covered},
          {"wrong", f.wrong},
          {"overlapping", f.overlapping},
          {"z_buffer", {{"float", of(check.single)}, {"double", of(check.twice)}}}};
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
}

}  // namespace hsr::cli
