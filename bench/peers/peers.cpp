// peers: runs a peer and hsr in turn on the same scene, checks both against the truth at a few thousand places, and prints a
// table. Nothing passes or fails by time.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bench/machine.h"
#include "bench/memory.h"
#include "bench/peers/child.h"
#include "bench/peers/peer.h"
#include "bench/peers/probes.h"
#include "bench/scenes.h"
#include "bench/views.h"
#include "geometry/error.h"

namespace hsr::bench {
namespace {

struct Peer {
  const char* name;
  Result (*run)(const Task&);
};

constexpr Peer peers[] = {
    {"z-buffer-1024", z_buffer_1024}, {"z-buffer-4096", z_buffer_4096},           {"line-art", line_art},
#ifdef HSR_BENCH_OCCT
    {"occt-poly", occt_poly},         {"occt-poly-compound", occt_poly_compound}, {"occt-exact", occt_exact},
#endif
};
constexpr Peer all_edges = {"hsr all edges", hsr_all_edges}, outlines = {"hsr outlines", hsr_outlines};

struct Request {
  std::vector<std::string> scenes, views, peers;
  std::string csv, time = "clock";
  int threads = 1, repeat = 3;
  std::size_t probes = 4000;
  Limits limits = {.seconds = 300, .gigabytes = 8};
};

/// Several runs of one of them.
struct Runs {
  std::string trouble;  ///< why there is no result; empty: there is one
  Times prepare, compute, both;
  std::uint64_t visible = 0, hidden = 0;
  double megabytes = 0;  ///< at most, beyond the scene
  std::vector<Answer> answers;
};

struct Wrong {
  std::size_t asked = 0;    ///< probes whose truth is known
  std::size_t shown = 0;    ///< visible, but hidden in truth
  std::size_t missing = 0;  ///< the other way round
};

struct Row {
  std::string scene, view, peer;
  std::size_t triangles = 0, edges = 0;
  Runs of_peer, of_all, of_outlines;
  Wrong peer_wrong, hsr_wrong;
};

template <class T>
void append(std::string& bytes, const T& x) {
  bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
}

template <class T>
T take(std::string_view& bytes) {
  T x;
  require(bytes.size() >= sizeof x, "peers: a result is cut short");
  std::memcpy(&x, bytes.data(), sizeof x);
  bytes.remove_prefix(sizeof x);
  return x;
}

void run_once(const Peer& one, const Task& task, const Request& request, Runs& runs) {
  if (!runs.trouble.empty()) return;
  const auto work = [&] {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request.threads));
    reset_peak_memory();
    const double before = peak_memory();
    const Result result = one.run(task);
    std::string bytes;
    append(bytes, result.prepare);
    append(bytes, result.compute);
    append(bytes, result.visible);
    append(bytes, result.hidden);
    append(bytes, (peak_memory() - before) / 1e6);
    bytes.append(reinterpret_cast<const char*>(result.answers.data()), result.answers.size());
    return bytes;
  };
  const Ended ended = run_apart(work, request.limits);
  if (ended.how == Ended::How::over_time) runs.trouble = fmt::format("> {:g}", request.limits.seconds);
  if (ended.how == Ended::How::failed) runs.trouble = ended.bytes;
  if (ended.how != Ended::How::done) return;
  std::string_view bytes = ended.bytes;
  const auto prepare = take<Elapsed>(bytes), compute = take<Elapsed>(bytes);
  runs.prepare.add(prepare);
  runs.compute.add(compute);
  runs.both.add({prepare.clock + compute.clock, prepare.processor + compute.processor});
  runs.visible = take<std::uint64_t>(bytes);
  runs.hidden = take<std::uint64_t>(bytes);
  runs.megabytes = take<double>(bytes);
  runs.answers.resize(bytes.size());
  std::memcpy(runs.answers.data(), bytes.data(), bytes.size());
}

Wrong wrong(const std::vector<Answer>& truth, const Runs& runs) {
  Wrong wrong;
  if (!runs.trouble.empty()) return wrong;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    if (truth[k] == Answer::none || runs.answers[k] == Answer::none) continue;
    ++wrong.asked;
    if (runs.answers[k] != truth[k]) ++(truth[k] == Answer::hidden ? wrong.shown : wrong.missing);
  }
  return wrong;
}

Row measure(const Task& task, const std::vector<Answer>& truth, const Peer& peer, const Request& request) {
  Row row;
  row.peer = peer.name;
  row.triangles = task.mesh.triangles.size();
  row.edges = task.mesh.edges.size();
  double spent = 0;
  for (int k = 0; k < request.repeat && (k == 0 || spent < request.limits.seconds); ++k) {
    spent += elapsed([&] {
               run_once(peer, task, request, row.of_peer);
               run_once(all_edges, task, request, row.of_all);
               run_once(outlines, task, request, row.of_outlines);
             }).clock;
  }
  row.peer_wrong = wrong(truth, row.of_peer);
  row.hsr_wrong = wrong(truth, row.of_all);
  return row;
}

Seconds seconds_of(const Times& times, const Request& request) {
  return seconds(request.time == "clock" ? times.clock : times.processor);
}

std::string time_cell(const Runs& runs, const Times& times, const Request& request) {
  if (!runs.trouble.empty()) return runs.trouble;
  const Seconds s = seconds_of(times, request);
  return fmt::format("{:.3f} ± {:.3f}", s.median, s.spread);
}

/// Two digits at least, never 1e+02.
std::string ratio(double x) { return x < 10 ? fmt::format("{:.2g}", x) : fmt::format("{:.0f}", x); }

/// How many times as long the peer took.
std::string ratio_cell(const Row& row, const Runs& hsr, const Request& request) {
  if (!hsr.trouble.empty()) return "";
  const double own = seconds_of(hsr.both, request).median;
  if (row.of_peer.trouble.empty()) return ratio(seconds_of(row.of_peer.compute, request).median / own);
  return row.of_peer.trouble[0] == '>' ? "> " + ratio(request.limits.seconds / own) : "";
}

std::string wrong_cell(const Wrong& w) {
  if (w.asked == 0) return "";
  const auto percent = [&](std::size_t n) { return 100 * static_cast<double>(n) / static_cast<double>(w.asked); };
  return fmt::format("{:.3g} + {:.3g} %", percent(w.shown), percent(w.missing));
}

void print_row(const Row& row, const Request& request) {
  const auto memory = [](const Runs& runs) { return runs.trouble.empty() ? fmt::format("{:.0f}", runs.megabytes) : ""; };
  fmt::print("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.scene, row.view, row.triangles,
             row.edges, row.peer, time_cell(row.of_peer, row.of_peer.compute, request),
             time_cell(row.of_all, row.of_all.both, request), ratio_cell(row, row.of_all, request),
             time_cell(row.of_outlines, row.of_outlines.both, request), ratio_cell(row, row.of_outlines, request),
             wrong_cell(row.peer_wrong), wrong_cell(row.hsr_wrong), memory(row.of_peer), memory(row.of_all));
  std::fflush(stdout);
}

/// e in t ~ n^e from each size of a scene to the next; times under 0.005 s say nothing.
void print_growth(const std::vector<Row>& rows, const Request& request) {
  std::map<std::array<std::string, 3>, std::vector<const Row*>> series;
  for (const Row& row : rows) series[{family(row.scene), row.view, row.peer}].push_back(&row);
  std::string table;
  for (auto& [key, of_one] : series) {
    std::stable_sort(of_one.begin(), of_one.end(), [](const Row* a, const Row* b) { return a->triangles < b->triangles; });
    for (std::size_t k = 1; k < of_one.size(); ++k) {
      const Row &a = *of_one[k - 1], &b = *of_one[k];
      const double m = static_cast<double>(a.triangles), n = static_cast<double>(b.triangles), decade = std::log(n / m);
      if (!(decade > 0)) continue;
      const auto exponent = [&](const Times& from, const Times& to) {
        const double s = seconds_of(from, request).median, t = seconds_of(to, request).median;
        return s < 0.005 ? std::string() : t == 0 ? "?" : fmt::format("{:.2f}", std::log(t / s) / decade);
      };
      table += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} |\n", key[0], key[1], a.scene, b.scene, key[2],
                           exponent(a.of_peer.compute, b.of_peer.compute), exponent(a.of_all.both, b.of_all.both),
                           exponent(a.of_outlines.both, b.of_outlines.both), 1 + std::log(std::log(n) / std::log(m)) / decade);
    }
  }
  if (table.empty()) return;
  fmt::print(
      "\nGrowth, e in t ~ n^e:\n\n| scene | view | from | to | peer | e of peer | e of hsr, all edges | e of hsr, outlines | e "
      "of "
      "n log n |\n|---|---|---|---|---|---|---|---|---|\n{}",
      table);
}

void write_csv(const std::string& path, const std::vector<Row>& rows, const Request& request) {
  std::ofstream out(path);
  out << "scene,view,triangles,edges,threads,who,trouble,runs,prepare_seconds,compute_seconds,compute_spread,"
         "prepare_processor_seconds,compute_processor_seconds,visible,hidden,asked,wrongly_shown,missing,mb\n";
  const auto line = [&](const Row& row, const std::string& who, const Runs& runs, const Wrong& w) {
    const Seconds compute = seconds(runs.compute.clock);
    out << fmt::format("{},{},{},{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{},{},{},{},{:.1f}\n", row.scene,
                       row.view, row.triangles, row.edges, request.threads, who, runs.trouble, runs.compute.clock.size(),
                       seconds(runs.prepare.clock).median, compute.median, compute.spread,
                       seconds(runs.prepare.processor).median, seconds(runs.compute.processor).median, runs.visible,
                       runs.hidden, w.asked, w.shown, w.missing, runs.megabytes);
  };
  for (const Row& row : rows) {
    line(row, row.peer, row.of_peer, row.peer_wrong);
    line(row, std::string(all_edges.name) + " beside " + row.peer, row.of_all, row.hsr_wrong);
    line(row, std::string(outlines.name) + " beside " + row.peer, row.of_outlines, {});
  }
  if (!out.flush()) throw InputError(path + ": cannot be written");
}

void run(const Request& request) {
  // One thread, this one, until everyone has a process of its own.
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<Row> rows;
  fmt::print(
      "{}\n\nSeconds {}, median and half the range of {}; hsr: make_mesh and lines, {} thread{}. Wrong: of {} places on edges, "
      "shown though hidden + missing though visible.\n\n",
      machine(), request.time == "clock" ? "by the clock" : "of the processor", request.repeat, request.threads,
      request.threads == 1 ? "" : "s", request.probes);
  fmt::print(
      "| scene | view | triangles | edges | peer | peer s | hsr s, all edges | ratio | hsr s, outlines | ratio | peer wrong | "
      "hsr "
      "wrong | peer MB | hsr MB |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& name : request.scenes) {
    const Model model = scene(name);
    const Mesh mesh = make_mesh(model.points, model.polygons);
    for (const std::string& view_name : request.views) {
      const View view = view_of(view_name, mesh);
      const std::vector<Probe> probes = make_probes(mesh, view, request.probes);
      const std::vector<Answer> answers = truth(mesh, view, probes);
      for (const Peer& peer : peers) {
        if (std::find(request.peers.begin(), request.peers.end(), peer.name) == request.peers.end()) continue;
        Row row = measure({model, mesh, view, probes}, answers, peer, request);
        row.scene = name;
        row.view = view_name;
        print_row(row, request);
        rows.push_back(std::move(row));
      }
    }
  }
  print_growth(rows, request);
  if (!request.csv.empty()) write_csv(request.csv, rows, request);
}

}  // namespace
}  // namespace hsr::bench

int main(int argc, char** argv) {
  using hsr::bench::peers;
  hsr::bench::Request request;
  std::vector<std::string> names;
  for (const auto& peer : peers) names.emplace_back(peer.name);
  CLI::App app{"Peers and hsr in turn on generated scenes: times, and who is right"};
  app.add_option("--scene", request.scenes,
                 "knot, city, rand or terrain and a size, as in knot100k; a city's is in boxes of 12");
  app.add_option("--view", request.views, "oblique, elevation, perspective; default: oblique");
  app.add_option("--peer", request.peers, "who runs beside hsr; default: all")->check(CLI::IsMember(names));
  app.add_option("--repeat", request.repeat, "how often each is measured")->check(CLI::PositiveNumber);
  app.add_option("--threads", request.threads, "number of threads of hsr; the peers have one")->check(CLI::PositiveNumber);
  app.add_option("--time", request.time, "what the table shows: clock, or processor on a busy machine")
      ->check(CLI::IsMember({"clock", "processor"}));
  app.add_option("--time-limit", request.limits.seconds, "seconds after which a run is ended")->check(CLI::PositiveNumber);
  app.add_option("--memory-limit", request.limits.gigabytes, "GB that a run may have")->check(CLI::PositiveNumber);
  app.add_option("--probes", request.probes, "at how many places the answers are checked")->check(CLI::PositiveNumber);
  app.add_option("--csv", request.csv, "write everything measured to this file, too");
  CLI11_PARSE(app, argc, argv);
  if (request.scenes.empty()) request.scenes = {"knot1k", "knot10k", "city100", "city1k", "rand100", "rand1k"};
  if (request.views.empty()) request.views = {"oblique"};
  if (request.peers.empty()) request.peers = names;
  if (std::ranges::find(request.peers, "line-art") != request.peers.end() && !hsr::bench::has_line_art()) {
    fmt::print(stderr, "without Line Art: Blender is not on PATH; Debian's package is blender\n");
    std::erase(request.peers, "line-art");
  }
#ifndef HSR_BENCH_OCCT
  fmt::print(stderr, "built without OCCT: install libocct-modeling-algorithms-dev and configure again to have it as a peer\n");
#endif
  try {
    hsr::bench::run(request);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
