#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>

#include "bench/peers/child.h"
#include "bench/peers/image.h"
#include "bench/peers/peer.h"
#include "bench/peers/probes.h"

using hsr::EdgeId;
using hsr::Mesh;
using hsr::Point3;
using hsr::View;
using hsr::bench::Answer;
using hsr::bench::Ended;
using hsr::bench::Probe;
using hsr::bench::run_apart;

namespace {

/// A square at z = 1 over a larger one at z = 0; edges ascend by their vertices.
hsr::Model two_squares() {
  hsr::Model model;
  model.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 1}, {5, 1, 1}, {5, 3, 1}, {1, 3, 1}};
  model.polygons.corners = {0, 1, 2, 3, 4, 5, 6, 7};
  model.polygons.first = {0, 4, 8};
  return model;
}

EdgeId edge(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    if (mesh.edges[EdgeId(e)].a.value == a && mesh.edges[EdgeId(e)].b.value == b) return EdgeId(e);
  throw std::logic_error("no such edge");
}

const View& from_above() {
  static const View view = hsr::parallel_view({0, 0, 1}, {0, 1, 0});
  return view;
}

}  // namespace

TEST_CASE("the truth about two squares, and what is too near to call", "[bench][peers]") {
  const hsr::Model model = two_squares();
  const Mesh mesh = hsr::make_mesh(model.points, model.polygons);
  // From (4, 0) to (4, 4): hidden from 1 to 3.
  const EdgeId side = edge(mesh, 1, 2);
  const std::vector<Probe> probes = {{side, 0.1}, {side, 0.24999}, {side, 0.25},           {side, 0.25001},
                                     {side, 0.5}, {side, 0.9},     {edge(mesh, 4, 5), 0.5}};
  CHECK(hsr::bench::truth(mesh, from_above(), probes) == std::vector<Answer>{Answer::visible, Answer::visible, Answer::none,
                                                                             Answer::hidden, Answer::hidden, Answer::visible,
                                                                             Answer::visible});
  CHECK(hsr::bench::hsr_all_edges({model, mesh, from_above(), probes}).answers ==
        std::vector<Answer>{Answer::visible, Answer::visible, Answer::hidden, Answer::hidden, Answer::hidden, Answer::visible,
                            Answer::visible});
  CHECK(hsr::bench::z_buffer_1024({model, mesh, from_above(), probes}).answers[4] == Answer::hidden);
}

TEST_CASE("hsr and the truth agree at every probe of a perspective view", "[bench][peers]") {
  const hsr::Model model = two_squares();
  const Mesh mesh = hsr::make_mesh(model.points, model.polygons);
  const View view = hsr::perspective_view({9, -7, 8}, {2, 2, 0}, {0, 0, 1});
  const auto probes = hsr::bench::make_probes(mesh, view, 500);
  REQUIRE(probes.size() == 500);
  CHECK(hsr::bench::hsr_all_edges({model, mesh, view, probes}).answers == hsr::bench::truth(mesh, view, probes));
}

TEST_CASE("what no visible part covers is hidden", "[bench][peers]") {
  const hsr::Model model = two_squares();
  const Mesh mesh = hsr::make_mesh(model.points, model.polygons);
  const std::vector<Probe> probes = {{EdgeId(2), 0.2}, {EdgeId(2), 0.6}, {EdgeId(3), 0.5}};
  CHECK(hsr::bench::answers_of({{EdgeId(2), 0.7, 0.5}}, {model, mesh, from_above(), probes}) ==
        std::vector<Answer>{Answer::hidden, Answer::visible, Answer::hidden});
}

TEST_CASE("the parameter in space of a place in the image is where the image of that point is", "[bench][peers]") {
  const View view = hsr::perspective_view({0, 0, 10}, {0, 0, 0}, {0, 1, 0});
  const hsr::bench::Image image(view);
  const Point3 p = {1, 2, 3}, q = {4, -1, -6};
  const double t = image.parameter_in_space(p, q, 0.3);
  const auto there = image({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)});
  CHECK(there.x == Approx(image(p).x + 0.3 * (image(q).x - image(p).x)));
  CHECK(there.nearness == Approx(image(p).nearness + 0.3 * (image(q).nearness - image(p).nearness)));
}

TEST_CASE("work in a process of its own returns, fails, crashes or is ended", "[bench][peers]") {
  const std::string large(1 << 20, 'x');
  const Ended done = run_apart([&] { return large; }, {.seconds = 60});
  CHECK(done.how == Ended::How::done);
  CHECK(done.bytes == large);
  const Ended failed = run_apart([]() -> std::string { throw std::runtime_error("no"); }, {.seconds = 60});
  CHECK(failed.how == Ended::How::failed);
  CHECK(failed.bytes == "no");
  const auto crash = []() -> std::string {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
    return "still here";
  };
  CHECK(run_apart(crash, {.seconds = 60}).how == Ended::How::failed);
  const auto sleep = []() -> std::string {
    for (;;) pause();
  };
  CHECK(run_apart(sleep, {.seconds = 0.1}).how == Ended::How::over_time);
}
