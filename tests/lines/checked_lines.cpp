#include "tests/lines/checked_lines.h"

#include <exception>

#include "hsr/lines/roberts.h"

namespace hsr {

namespace {

const oracle::SeenEdge* find(const std::vector<oracle::SeenEdge>& edges, VertexId a, VertexId b) {
  if (b < a) std::swap(a, b);
  for (const auto& e : edges)
    if (e.a == a && e.b == b) return &e;
  return nullptr;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string one_or_both(const std::string& found, const std::string& expected) {
  return found == expected ? found : "roberts: " + found + " | oracle: " + expected;
}

}  // namespace

CheckedLines::CheckedLines(const scenes::TestScene& scene, const LineOptions& options) : mesh_(scene.mesh()) {
  const VisibleLines lines = roberts(mesh_, scene.view, options);
  found_ = oracle::seen_edges(mesh_, scene.view, lines);
  expected_ = oracle::seen_by_oracle(mesh_, scene.view, options);
  differences_ = wrong_with(scene, options);
}

std::string CheckedLines::operator()(std::uint32_t a, std::uint32_t b) const {
  const auto text = [&](const std::vector<oracle::SeenEdge>& edges) {
    const auto* e = find(edges, mesh_.merged[VertexId(a)], mesh_.merged[VertexId(b)]);
    return e == nullptr ? std::string("absent") : oracle::to_text(e->edge_class) + (": " + oracle::intervals_text(*e));
  };
  return one_or_both(text(found_), text(expected_));
}

std::string CheckedLines::intervals(std::uint32_t a, std::uint32_t b) const {
  const auto text = [&](const std::vector<oracle::SeenEdge>& edges) {
    const auto* e = find(edges, mesh_.merged[VertexId(a)], mesh_.merged[VertexId(b)]);
    return e == nullptr ? std::string("absent") : oracle::intervals_text(*e);
  };
  return one_or_both(text(found_), text(expected_));
}

std::string wrong_with(const scenes::TestScene& scene, const LineOptions& options) {
  try {
    const Mesh mesh = scene.mesh();
    std::string wrong;
    const auto ask = [&](LineMethod method, When stages, When convex_body) {
      LineOptions chosen = options;
      chosen.method = method;
      chosen.stages.fill(stages);
      chosen.when(LineStage::convex_body) = convex_body;
      chosen.why = options.why && method == LineMethod::roberts;
      const auto lines = visible_lines(mesh, scene.view, chosen);
      const std::string text = joined(oracle::compare_with_oracle(mesh, scene.view, lines, chosen));
      if (!text.empty()) wrong += lines.plan.method + (stages == When::always ? ", stages:\n" : ":\n") + text;
    };
    for (const LineMethod method : {LineMethod::roberts, LineMethod::appel})
      for (const When stages : {When::never, When::always}) ask(method, stages, When::never);
    ask(LineMethod::automatic, When::automatic, When::always);
    return wrong;
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what() + "\n";
  }
}

}  // namespace hsr
