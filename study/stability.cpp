#include "study/stability.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>

#include "geometry/error.h"
#include "hsr/check/measure.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/depth_format.h"
#include "study/attempt.h"
#include "study/compared_methods.h"

namespace hsr::internal {

namespace {

std::vector<RunnableMethod> all_methods(const Mesh& mesh, const View& view, const SampleGrid& grid) {
  std::vector<RunnableMethod> all = image_space_methods(mesh, view, grid), more = object_space_methods(mesh, view, grid);
  for (RunnableMethod& m : opengl_methods(mesh, view, grid)) all.push_back(std::move(m));
  std::move(more.begin(), more.end(), std::back_inserter(all));
  return all;
}

/// The scene from aside.
Image<FaceId> sketch(const StabilityFamily& family) {
  constexpr int width = 220;
  StiffScene scene = family.scene(family.sketch_value, 16);
  std::vector<std::uint32_t>& first = scene.polygons.first;
  first.resize(first.size() - scene.only_for_range);
  scene.polygons.corners.resize(first.back());
  const Mesh mesh = make_mesh(scene.points, scene.polygons);
  const View view = parallel_view(family.sketch_from, {0, 0, 1});
  const PaperRectangle part = paper_rectangle(mesh, view);
  const double shape = (part.top - part.bottom) / (part.right - part.left);
  const int height = std::clamp(static_cast<int>(std::ceil(shape * width)), 1, width);
  const CastImage seen = cast(mesh, view, sample_grid(view, part, width, height));
  Image<FaceId> image(width, height);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) image.at(i, j) = seen.face(mesh, i, j);
  return image;
}

/// How many steps of the format the closest depths of a scene are apart, where its steps are largest.
double steps_apart(const ClosestDepths& depths, const DepthResolution& resolution) {
  const auto step_at = [&](double nearness) { return step(resolution.format, resolution.range, nearness); };
  return depths.difference / std::max(step_at(depths.nearest), step_at(depths.farthest));
}

class FamilyRunner {
 public:
  FamilyRunner(const StabilityFamily& family, const StabilityOptions& options)
      : options_(options), most_seconds_(options.quick ? 0.5 : 8) {
    result_.family = family;
  }

  FamilyResult run(const std::function<void(double done)>& progress) {
    result_.seconds = seconds_of([&] {
      result_.sketch = sketch(result_.family);
      const std::vector<double> values = result_.family.values(options_.quick);
      for (std::size_t k = 0; k < values.size(); ++k) {
        progress(static_cast<double>(k) / static_cast<double>(values.size()));
        run_at(values[k]);
      }
    });
    return std::move(result_);
  }

 private:
  void run_at(double value) {
    const StiffScene scene = result_.family.scene(value, options_.size);
    const Mesh mesh = make_mesh(scene.points, scene.polygons);
    const CastImage nearest = cast(mesh, scene.view, scene.grid);
    check_caster(value, scene, mesh, nearest);
    std::vector<RunnableMethod> methods =
        options_.methods ? options_.methods(mesh, scene.view, scene.grid) : all_methods(mesh, scene.view, scene.grid);
    if (result_.rows.empty()) {
      for (const RunnableMethod& m : methods)
        result_.rows.push_back({m.method, m.numbers, m.is_object_space, m.is_exact, {}, {}});
      steps_.assign(methods.size(), HUGE_VAL);
    }
    for (std::size_t k = 0; k < methods.size(); ++k) {
      StabilityRow& row = result_.rows[k];
      if (scene.closest && methods[k].resolution &&
          (methods[k].method == "depth buffer" || methods[k].method.rfind("OpenGL", 0) == 0))
        predict(row, steps_[k], steps_apart(*scene.closest, *methods[k].resolution), value);
      row.points.push_back(run_method(methods[k], row, scene, mesh, nearest));
    }
  }

  void check_caster(double value, const StiffScene& scene, const Mesh& mesh, const CastImage& nearest) {
    StabilityValue at{value, mesh.triangles.size(), 0, 0, 0};
    for (int j = 0; j < scene.grid.height; ++j)
      for (int i = 0; i < scene.grid.width; ++i) {
        const FaceId seen = nearest.face(mesh, i, j);
        at.covered += seen.is_valid() ? 1U : 0U;
        const std::optional<FaceId> known = scene.known ? scene.known(i, j) : std::nullopt;
        if (!known) continue;
        ++at.known;
        at.caster_errors += *known != seen ? 1U : 0U;
      }
    result_.values.push_back(at);
  }

  /// Between two values the number of steps is taken for a power of the knob.
  void predict(StabilityRow& row, double& before, double now, double value) {
    if (!row.predicted && now < 1) {
      row.predicted = value;
      if (std::isfinite(before) && before > 1) {
        const double last = result_.values[result_.values.size() - 2].value;
        row.predicted = last * std::pow(value / last, std::log(before) / std::log(before / now));
      }
    }
    before = now;
  }

  StabilityPoint run_method(const RunnableMethod& method, const StabilityRow& row, const StiffScene& scene, const Mesh& mesh,
                            const CastImage& nearest) const {
    StabilityPoint point;
    if (!row.points.empty() && (row.points.back().outcome == Outcome::left_out || row.points.back().seconds > most_seconds_)) {
      point.outcome = Outcome::left_out;
      point.why = row.points.back().why.empty()
                      ? "took " + std::to_string(std::lround(row.points.back().seconds * 1000)) + " ms at the value before"
                      : row.points.back().why;
      return point;
    }
    ShownPicture picture;
    point.seconds = seconds_of([&] {
      const Attempt tried = attempt([&] {
        method.solve();
        picture = method.show();
      });
      point.why = tried.why;
      if (tried.ending == Ending::refused) point.outcome = Outcome::refused;
      if (tried.ending == Ending::broke_down) point.outcome = Outcome::broke_down;
    });
    method.forget();
    if (point.outcome == Outcome::broke_down) point.wrong_share = 1;
    if (point.outcome != Outcome::right) return point;
    const PictureCheck check =
        check_picture(mesh, scene.view, scene.grid, picture.triangles, nearest.triangles, method.resolution);
    point.wrong = check.wrong;
    point.edge = check.edge;
    point.tie = check.tie;
    point.order = check.order;
    if (check.wrong > 0) {
      point.outcome = Outcome::wrong;
      point.wrong_share = static_cast<double>(check.wrong) / static_cast<double>(std::max(check.covered, check.wrong));
    }
    return point;
  }

  const StabilityOptions& options_;
  double most_seconds_;
  FamilyResult result_;
  std::vector<double> steps_;  // between the closest depths at the value before, by row
};

std::string text(double x) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), x);
  return {digits.data(), end};
}

std::vector<StabilityFamily> chosen_families(const std::vector<std::string>& names) {
  const std::span<const StabilityFamily> all = stability_families();
  const auto unknown = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return std::none_of(all.begin(), all.end(), [&](const StabilityFamily& f) { return name == f.name; });
  });
  if (unknown != names.end()) {
    std::string expected;
    for (const StabilityFamily& f : all) expected.append(expected.empty() ? "" : ", ").append(f.name);
    throw InputError("family: found \"" + *unknown + "\", expected one of " + expected);
  }
  std::vector<StabilityFamily> chosen;
  for (const StabilityFamily& f : all)
    if (names.empty() || std::find(names.begin(), names.end(), f.name) != names.end()) chosen.push_back(f);
  return chosen;
}

}  // namespace

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::right:
      return "right";
    case Outcome::wrong:
      return "wrong";
    case Outcome::broke_down:
      return "broke down";
    case Outcome::refused:
      return "refused";
    case Outcome::left_out:
      return "left out";
  }
  return "";
}

std::optional<double> FamilyResult::breakdown(const StabilityRow& row) const {
  const auto broken = std::find_if(row.points.begin(), row.points.end(), [](const StabilityPoint& p) { return p.is_broken(); });
  if (broken == row.points.end()) return {};
  return values[static_cast<std::size_t>(broken - row.points.begin())].value;
}

std::vector<std::string> Stability::defects() const {
  std::vector<std::string> all;
  for (const FamilyResult& f : families) {
    const auto say = [&](const std::string& who, double value, const std::string& what) {
      std::string line = "family ";
      line.append(f.family.name).append(", ").append(f.family.knob).append(" ").append(text(value)).append(": ");
      line.append(who).append(" ").append(what);
      all.push_back(std::move(line));
    };
    const auto differs = std::find_if(f.values.begin(), f.values.end(), [](const auto& v) { return v.caster_errors > 0; });
    if (differs != f.values.end())
      say("ray casting", differs->value,
          "differs from the known answer at " + std::to_string(differs->caster_errors) + " samples");
    for (const StabilityRow& row : f.rows)
      for (std::size_t k = 0; k < row.points.size(); ++k) {
        const StabilityPoint& p = row.points[k];
        if (!row.is_exact || !p.is_broken()) continue;
        say(row.name(), f.values[k].value,
            p.outcome == Outcome::broke_down
                ? p.why
                : "shows another face than the nearest at " + std::to_string(p.wrong) + " samples");
        break;
      }
  }
  return all;
}

Stability stability(const StabilityOptions& options) {
  const std::vector<StabilityFamily> families = chosen_families(options.families);
  Stability result{options.size, options.quick, {}, measured_gaps(), measured_biases()};
  for (const StabilityFamily& family : families) {
    const std::string stage = std::string(family.name) + " (" + std::to_string(result.families.size() + 1) + " of " +
                              std::to_string(families.size()) + ")";
    result.families.push_back(FamilyRunner(family, options).run([&](double done) {
      if (options.progress) options.progress(stage, done);
    }));
  }
  return result;
}

}  // namespace hsr::internal
