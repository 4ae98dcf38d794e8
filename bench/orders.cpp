// orders: painter's orders of generated scenes, hsr and peers in turn. Nothing passes or fails by time.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/machine.h"
#include "bench/memory.h"
#include "bench/peers/child.h"
#include "bench/peers/painters.h"
#include "bench/scenes.h"
#include "bench/seconds.h"
#include "bench/views.h"
#include "geometry/error.h"
#include "hsr/painter/bsp/bsp.h"
#include "hsr/painter/sort/depth_sort.h"

namespace hsr::bench {
namespace {

struct Request {
  std::vector<std::string> scenes;
  std::string view = "oblique";
  int threads = 1, repeat = 3;
  bool peers = true;
  Limits limits = {.seconds = 300, .gigabytes = 12};
};

struct Measured {
  PeerOrder order;
  double walk = 0;  ///< seconds of the walk alone, of a tree
  double megabytes = 0;
};

/// In a process of its own, several times: the median of the seconds, or why there is none.
struct Runs {
  std::string trouble;
  std::vector<double> seconds, walks;
  Measured last;
};

/// @param alone what holds the other threads back until then
void run_once(const std::function<Measured()>& work, const Request& request, std::optional<tbb::global_control>& alone,
              Runs& runs) {
  if (!runs.trouble.empty()) return;
  const Ended ended = run_apart(
      [&] {
        alone.reset();
        const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                          static_cast<std::size_t>(request.threads));
        reset_peak_memory();
        const double before = peak_memory();
        Measured m = work();
        m.megabytes = (peak_memory() - before) / 1e6;
        return std::string(reinterpret_cast<const char*>(&m), sizeof m);
      },
      request.limits);
  if (ended.how == Ended::How::over_time) runs.trouble = fmt::format("> {:g} s", request.limits.seconds);
  if (ended.how == Ended::How::failed) runs.trouble = ended.bytes;
  if (ended.how != Ended::How::done) return;
  require(ended.bytes.size() == sizeof runs.last, "orders: a result is cut short");
  std::memcpy(&runs.last, ended.bytes.data(), sizeof runs.last);
  runs.seconds.push_back(runs.last.order.compute);
  runs.walks.push_back(runs.last.walk);
}

struct Method {
  std::string name;
  std::function<Measured()> work;
  std::size_t rival;  ///< of hsr's two, the one to compare with
};

void measure(const std::string& name, const Request& request) {
  // No other threads before a process of its own begins: it would wait for those that it was not given.
  std::optional<tbb::global_control> alone(std::in_place, tbb::global_control::max_allowed_parallelism, 1);
  const Model model = scene(name);
  const Mesh mesh = make_mesh(model.points, model.polygons);
  const View view = view_of(request.view, mesh);
  std::vector<Method> methods = {{"hsr depth sort",
                                  [&] {
                                    Measured m;
                                    m.order.compute =
                                        elapsed([&] { m.order.pieces = depth_sort(mesh, view).order.pieces.size(); }).clock;
                                    return m;
                                  },
                                  0},
                                 {"hsr BSP",
                                  [&] {
                                    Measured m;
                                    std::vector<std::uint32_t> far_to_near;
                                    m.order.compute = elapsed([&] {
                                                        const BspTree tree(mesh);
                                                        m.walk = elapsed([&] { tree.walk(view, far_to_near); }).clock;
                                                        m.walk = elapsed([&] { tree.walk(view, far_to_near); }).clock;
                                                        m.order.pieces = tree.pieces();
                                                      }).clock -
                                                      m.walk;
                                    return m;
                                  },
                                  1}};
  if (request.peers) {
    methods.push_back({"sketch depth sort", [&] { return Measured{sketch(mesh, view, false), 0, 0}; }, 0});
    methods.push_back({"sketch BSP", [&] { return Measured{sketch(mesh, view, true), 0, 0}; }, 1});
#ifdef HSR_BENCH_GL2PS
    methods.push_back({"gl2ps BSP, best root", [&] { return Measured{gl2ps(mesh, view), 0, 0}; }, 1});
#endif
  }
  std::vector<Runs> runs(methods.size());
  double spent = 0;
  for (int k = 0; k < request.repeat && (k == 0 || spent < request.limits.seconds); ++k)
    spent += elapsed([&] {
               for (std::size_t m = 0; m < methods.size(); ++m) run_once(methods[m].work, request, alone, runs[m]);
             }).clock;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Runs& r = runs[m];
    if (!r.trouble.empty()) {
      fmt::print("| {} | {} | {} | {} | | | | |\n", name, mesh.triangles.size(), methods[m].name, r.trouble);
      continue;
    }
    const Seconds s = seconds(r.seconds);
    const Runs& rival = runs[methods[m].rival];
    const std::string ratio = rival.seconds.empty() ? "" : fmt::format("{:.1f}", s.median / seconds(rival.seconds).median);
    const double walk = seconds(r.walks).median;
    fmt::print("| {} | {} | {} | {:.3f} ± {:.3f} | {} | {} | {} | {:.0f} |\n", name, mesh.triangles.size(), methods[m].name,
               s.median, s.spread, r.last.order.pieces, m == methods[m].rival ? "" : ratio,
               walk > 0 ? fmt::format("{:.1f}", static_cast<double>(r.last.order.pieces) / walk / 1e6) : "", r.last.megabytes);
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) {
  hsr::bench::Request request;
  CLI::App app{"Painter's orders by hsr and by peers, in turn"};
  app.add_option("--scene", request.scenes,
                 "knot, city, rand or terrain and a size, as in knot100k; a city's is in boxes of 12");
  app.add_option("--view", request.view, "oblique or elevation; hsr alone: perspective, too");
  app.add_option("--threads", request.threads, "of hsr")->check(CLI::PositiveNumber);
  app.add_option("--repeat", request.repeat, "how often each is measured")->check(CLI::PositiveNumber);
  app.add_option("--time-limit", request.limits.seconds, "of each run, seconds");
  app.add_flag("!--no-peers", request.peers, "hsr alone");
  CLI11_PARSE(app, argc, argv);
  if (request.scenes.empty()) request.scenes = {"knot10k", "city1k", "rand10k"};
  try {
    fmt::print("{}\n\n", hsr::bench::machine());
    fmt::print(
        "| scene | triangles | method | s | pieces | times as long as hsr | walk, million pieces a second | MB "
        "|\n|---|---|---|---|---|---|---|---|\n");
    for (const std::string& name : request.scenes) hsr::bench::measure(name, request);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
