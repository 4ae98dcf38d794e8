#include "study/comparison.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

#include "geometry/error.h"
#include "hsr/check/area_check.h"
#include "hsr/check/measure.h"
#include "hsr/lines/visible_lines.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"
#include "hsr/raster/caster.h"
#include "hsr/raster/z_buffer.h"
#include "hsr/surfaces/visible_fragments.h"
#include "study/attempt.h"
#include "study/compared_methods.h"

namespace hsr::internal {

namespace {

/// A method that took longer than this is not run again, and one that may take longer than `too_long` is left out.
constexpr double slow = 2, too_long = 20;

class Comparer {
 public:
  Comparer(const Mesh& mesh, const View& view, const std::function<SampleGrid(int)>& grid, const ComparisonOptions& options)
      : mesh_(mesh), view_(view), grid_(grid), options_(options) {
    result_.faces = mesh.faces.size();
    result_.triangles = mesh.triangles.size();
    result_.size = options.size;
    result_.threads = options.threads;
  }

  Comparison run() {
    show("truth", 0);
    // What areas are measured against, and how long others may take; its own time is measured like that of the others, later.
    fragments_seconds_ = timed([&] { fragments_ = visible_fragments(scene()); });
    std::vector<int> sizes;
    for (const int size : {options_.size / 4, options_.size / 2, options_.size, 2 * options_.size})
      if (size >= 1) sizes.push_back(size);
    for (const int size : sizes) run_at(size);
    time_again();
    grow();
    compare_stages();
    return std::move(result_);
  }

 private:
  void show(const std::string& stage, double done) {
    if (options_.progress) options_.progress(stage, done);
  }

  /// Anew for each method, so that all do all of their work.
  SceneView scene() const { return {mesh_, view_, {.coplanar = options_.coplanar}}; }

  template <class Work>
  double timed(const Work& work) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options_.threads));
    return seconds_of(work);
  }

  void run_at(int size) {
    const SampleGrid grid = grid_(size);
    const Image<TriangleId> nearest = cast(scene(), grid).triangles;
    const bool is_shown = size == options_.size;
    if (is_shown) result_.pictures.push_back({nearest, Image<Mistake>(size, size, Mistake::none), {}});
    std::vector<RunnableMethod> methods = image_space_methods(mesh_, view_, grid, options_.coplanar);
    std::string no_driver;
    for (RunnableMethod& m : opengl_methods(mesh_, view_, grid, options_.coplanar, &no_driver)) methods.push_back(std::move(m));
    if (is_shown && !no_driver.empty()) result_.left_out.push_back({"OpenGL", no_driver});
    if (is_shown) {
      std::vector<RunnableMethod> more = object_space_methods(mesh_, view_, grid, options_.coplanar);
      std::move(more.begin(), more.end(), std::back_inserter(methods));
    }
    for (std::size_t k = 0; k < methods.size(); ++k) {
      const RunnableMethod& method = methods[k];
      show(method.method + ", " + method.numbers + ", " + std::to_string(size) + " x " + std::to_string(size),
           static_cast<double>(k) / static_cast<double>(methods.size()));
      if (const std::string why = why_not(method); !why.empty()) {
        result_.left_out.push_back({method.method + ", " + method.numbers, why});
        continue;
      }
      run_first(method, size, grid, nearest);
    }
  }

  std::string why_not(const RunnableMethod& method) const {
    const double most = method.cost * fragments_seconds_;
    if (method.cost <= 1 || most < too_long) return {};
    return "would take up to " + std::to_string(static_cast<int>(most)) + " s";
  }

  /// Does a piece of work that may be refused, or where plain doubles are used may contradict themselves: that is a result.
  /// @return whether it was done
  template <class Work>
  bool attempt(const std::string& what, bool is_exact, const Work& work) {
    const Attempt tried = hsr::internal::attempt(work);
    if (tried.ending == Ending::broke_down && is_exact) throw InvariantError(what + ", " + tried.why);
    if (tried.ending != Ending::done) result_.left_out.push_back({what, tried.why});
    return tried.ending == Ending::done;
  }

  void run_first(const RunnableMethod& method, int size, const SampleGrid& grid, const Image<TriangleId>& nearest) {
    ComparedMethod row;
    row.method = method.method;
    row.numbers = method.numbers;
    row.is_object_space = method.is_object_space;
    row.is_exact = method.is_exact;
    row.is_variant = method.is_variant;
    row.size = size;
    ShownPicture picture;
    const bool is_done = attempt(method.method + ", " + method.numbers, method.is_exact, [&] {
      const PeakMemory memory;
      row.seconds.push_back(timed(method.solve));
      row.peak_bytes = memory.bytes();
      picture = method.show();
      row.note = method.note();
    });
    method.forget();
    if (!is_done) return;
    PictureCheck check = check_picture(mesh_, view_, grid, picture.triangles, nearest, method.resolution);
    row.samples = check.samples;
    row.covered = check.covered;
    row.wrong = check.wrong;
    row.edge = check.edge;
    row.tie = check.tie;
    row.order = check.order;
    if (method.is_object_space) {
      row.wrong_area_share = row.wrong_share();
    } else {
      const AreaCheck area = check_area(mesh_, view_, fragments_, grid, picture.triangles);
      row.wrong_area_share = area.visible > 0 ? area.wrong / area.visible : 0;
      row.edge_error = area.edge_error();
    }
    if (size == options_.size) {
      row.picture = static_cast<int>(result_.pictures.size());
      result_.pictures.push_back({std::move(picture.triangles), std::move(check.mistakes), std::move(picture.depth)});
    }
    if (row.seconds.front() < slow)
      for (int r = 1; r < options_.runs; ++r) again_.push_back({result_.methods.size(), method});
    result_.methods.push_back(std::move(row));
  }

  /// The other runs, shuffled: what else the machine does falls on all of them alike.
  void time_again() {
    std::shuffle(again_.begin(), again_.end(), random_);
    for (std::size_t k = 0; k < again_.size(); ++k) {
      if (k % 8 == 0) show("runs in shuffled order", static_cast<double>(k) / static_cast<double>(again_.size()));
      result_.methods[again_[k].first].seconds.push_back(timed(again_[k].second.solve));
      again_[k].second.forget();
    }
    again_.clear();
    for (ComparedMethod& m : result_.methods) std::sort(m.seconds.begin(), m.seconds.end());
  }

  void grow() {
    std::vector<std::uint32_t> shuffled(mesh_.triangles.size());
    for (std::size_t k = 0; k < shuffled.size(); ++k) shuffled[k] = static_cast<std::uint32_t>(k);
    std::shuffle(shuffled.begin(), shuffled.end(), random_);
    std::array<Growth, 4> all;
    all[0].method = "z-buffer, float";
    all[1].method = "visible fragments";
    all[2].method = "depth sort";
    all[3].method = "BSP";
    const SampleGrid grid = grid_(options_.size);
    for (const std::size_t part : {16U, 8U, 4U, 2U, 1U}) {
      const std::size_t n = shuffled.size() / part;
      if (n < 8) continue;
      show("growth with the number of faces", 1.0 / static_cast<double>(part));
      Polygons polygons;
      for (std::size_t k = 0; k < n; ++k) {
        for (const VertexId v : mesh_.triangles[TriangleId(shuffled[k])]) polygons.corners.push_back(v.value);
        polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
      }
      const Mesh mesh = make_mesh({mesh_.points.begin(), mesh_.points.end()}, polygons);
      const auto part_of_scene = [&] { return SceneView(mesh, view_, {.coplanar = options_.coplanar}); };
      const auto add = [&](Growth& g, const auto& work) {
        double seconds = 0;
        if (!attempt(g.method + ", " + std::to_string(n) + " triangles", true, [&] { seconds = timed(work); })) return;
        g.faces.push_back(static_cast<double>(n));
        g.seconds.push_back(seconds);
      };
      DepthImage<float> image;
      add(all[0], [&] { image = z_buffer<float>(mesh, view_, grid, options_.coplanar); });
      const Image<TriangleId> nearest = cast(part_of_scene(), grid).triangles;
      std::size_t wrong = 0, covered = 0;
      for (std::size_t k = 0; k < nearest.pixels.size(); ++k) {
        wrong += image.pixels[k].triangle != nearest.pixels[k] ? 1U : 0U;
        covered += nearest.pixels[k].is_valid() ? 1U : 0U;
      }
      all[0].wrong_share.push_back(covered == 0 ? 0 : static_cast<double>(wrong) / static_cast<double>(covered));
      add(all[1], [&] { (void)visible_fragments(part_of_scene()); });
      add(all[2], [&] { (void)depth_sort(part_of_scene()); });
      add(all[3], [&] { (void)BspTree(mesh).order(part_of_scene()); });
    }
    for (Growth& g : all) {
      g.slope = log_log_slope(g.faces, g.seconds);
      result_.growth.push_back(std::move(g));
    }
  }

  void compare_stages() {
    show("stages", 0);
    LineOptions options;
    options.classes.fill(true);
    for (const LeftOut& l : plan_lines(scene(), options).left_out) result_.left_out.push_back(l);
    const double with = timed([&] { (void)visible_lines(mesh_, view_, options); });
    constexpr std::array<const char*, stage_count> names = {"edges outside the picture", "one convex body",
                                                            "far sides of closed bodies", "what is hidden behind large faces",
                                                            "faces away from the edges"};
    for (std::size_t s = 1; s < stage_count; ++s) {  // the first: only with a field of view
      SceneOptions without;
      without.stages[s] = When::never;
      show(names[s], static_cast<double>(s) / stage_count);
      result_.stages.push_back({std::string("lines: ") + names[s], "left out", with,
                                timed([&] { (void)visible_lines(SceneView(mesh_, view_, without), options); }),
                                "changes nothing"});
    }
    const double fragments = timed([&] { (void)visible_fragments(scene()); });
    SceneOptions all;
    all.stages.fill(When::never);
    result_.stages.push_back({"fragments: far sides, hidden faces", "left out", fragments,
                              timed([&] { (void)visible_fragments(SceneView(mesh_, view_, all)); }), "changes nothing"});
    const Timer timer = [this](const std::function<void()>& work) { return timed(work); };
    const SampleGrid grid = grid_(options_.size);
    show("culling", 0.5);
    append(culling_stages(mesh_, view_, grid, timer));
    show("coherence", 0.7);
    append(coherence_stages(mesh_, view_, grid, timer));
    turn();
    show("supersampling, transparency", 0.9);
    const int size = std::max(1, options_.size / 4);
    attempt("supersampling, transparency", true, [&] {
      PaintersOrder order;
      const double seconds = timed([&] { order = depth_sort(scene()).order; });
      result_.supersampling = compare_supersampling(mesh_, view_, order, seconds, grid_, size, timer, options_.coplanar);
      result_.transparency = compare_transparency(mesh_, view_, order, seconds, grid_, size, timer, options_.coplanar);
    });
  }
  void append(std::vector<ComparedStage> stages) {
    std::move(stages.begin(), stages.end(), std::back_inserter(result_.stages));
  }

  /// Coherence of frames: a tree for all frames of a turntable against a sort for each.
  void turn() {
    constexpr int frames = 36;
    attempt("36 frames by one BSP", true, [&] {
      std::optional<BspTree> tree;
      const double build = timed([&] { tree.emplace(mesh_); });
      std::vector<std::uint32_t> far_to_near;
      const double walks = timed([&] {
        for (int k = 0; k < frames; ++k) tree->walk(view_, far_to_near, options_.coplanar);
      });
      const double sort = timed([&] { (void)depth_sort(scene()); });
      result_.stages.push_back({"frame: 36 frames by one BSP, walked for each, instead of a depth sort for each", "coherence",
                                build + walks, frames * sort, std::to_string(tree->pieces()) + " pieces a frame"});
    });
  }

  const Mesh& mesh_;
  const View& view_;
  const std::function<SampleGrid(int)>& grid_;
  const ComparisonOptions& options_;
  Comparison result_;
  VisibleFragments fragments_;
  double fragments_seconds_ = 0;
  std::vector<std::pair<std::size_t, RunnableMethod>> again_;
  std::mt19937_64 random_{options_.seed};
};

}  // namespace

Comparison compare(const Mesh& mesh, const View& view, const std::function<SampleGrid(int size)>& grid,
                   const ComparisonOptions& options) {
  return Comparer(mesh, view, grid, options).run();
}

}  // namespace hsr::internal
