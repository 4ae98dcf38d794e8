#include "tests/lines/checked_lines.h"

#include <exception>
#include <set>

#include "hsr/lines/visible_lines.h"

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

/// The visible intervals, each with its class.
std::multiset<std::string> visible_parts(const Mesh& mesh, const View& view, const VisibleLines& lines) {
  std::multiset<std::string> parts;
  for (const Line& line : lines.lines) {
    const SupportingLine support = supporting_line_of(mesh, lines, line);
    const auto cuts = lines.cuts_of(line);
    for (std::uint32_t k = 0; k < line.intervals(); ++k) {
      if (line.hidden(k)) continue;
      std::string text = oracle::to_text(line.edge_class);
      for (const Cut& cut : {cuts[k], cuts[k + 1]})
        for (const Rational& x : exact_point(mesh, view, support, cut)) text += " " + x.to_string();
      parts.insert(text);
    }
  }
  return parts;
}

/// Few objects and materials that change from face to face, so that classes depend on them.
FaceLabels some_labels(const Mesh& mesh) {
  FaceLabels labels;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    labels.object.push_back(f / 2 % 3);
    labels.material.push_back(f % 5 == 0 ? 1 : 0);
  }
  return labels;
}

/// A scene of which hidden lines are not wanted shows what it shows with them.
std::string wrong_without_hidden_lines(const Scene& scene, const View& view, LineOptions options) {
  const Mesh& mesh = scene.mesh();
  options.why = false;
  SceneOptions visible;
  visible.stages.fill(When::always);
  visible.hidden_lines = false;
  const auto expected = visible_parts(mesh, view, visible_lines(SceneView(scene, view), options));
  const auto found = visible_parts(mesh, view, visible_lines(SceneView(scene, view, visible), options));
  std::string wrong;
  for (const std::string& part : expected)
    if (found.count(part) != expected.count(part)) wrong += "without hidden lines, not as often: " + part + "\n";
  for (const std::string& part : found)
    if (expected.count(part) == 0) wrong += "only without hidden lines: " + part + "\n";
  return wrong;
}

}  // namespace

CheckedLines::CheckedLines(const scenes::TestScene& scene, const LineOptions& options) : mesh_(scene.mesh()) {
  LineOptions by_roberts = options;
  by_roberts.method = LineMethod::roberts;
  const SceneView view(mesh_, scene.view);
  const VisibleLines lines = visible_lines(view, by_roberts);
  found_ = oracle::seen_edges(mesh_, scene.view, lines);
  expected_ = oracle::seen_by_oracle(view, options);
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
    const Scene labelled = Scene::of(mesh, some_labels(mesh));
    std::string wrong;
    const auto ask = [&](LineMethod method, When stages, When convex_body) {
      LineOptions chosen = options;
      chosen.method = method;
      chosen.why = options.why && method == LineMethod::roberts;
      SceneOptions of_scene;
      of_scene.stages.fill(stages);
      of_scene.coplanar = stages == When::always ? Coplanar::last : Coplanar::first;
      of_scene.when(Stage::convex_body) = convex_body;
      const SceneView view(labelled, scene.view, of_scene);
      const auto lines = visible_lines(view, chosen);
      const std::string text = joined(oracle::compare_with_oracle(view, lines, chosen));
      if (!text.empty()) wrong += lines.plan.method + (stages == When::always ? ", stages:\n" : ":\n") + text;
    };
    for (const LineMethod method : {LineMethod::roberts, LineMethod::appel})
      for (const When stages : {When::never, When::always}) ask(method, stages, When::never);
    ask(LineMethod::automatic, When::automatic, When::always);
    return wrong + wrong_without_hidden_lines(labelled, scene.view, options);
  } catch (const std::exception& e) {
    return std::string("exception: ") + e.what() + "\n";
  }
}

}  // namespace hsr
