// A BSP tree, told by the builder and by the walk themselves.
#include <algorithm>
#include <map>

#include "geometry/error.h"
#include "hsr/painter/bsp/bsp_nodes.h"
#include "hsr/painter/bsp/bsp_observer.h"
#include "hsr/scene/view_parts.h"
#include "study/explain/explained_methods.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

struct Part {
  std::string name;
  std::uint32_t face = 0;
};

struct Node {
  std::string text;
  std::string label;  // in the picture of the tree
  int face = -1;
  int parent = -1;
  bool is_before = false;
  std::vector<std::uint32_t> inside;
};

/// What building told, for the walks.
struct Built {
  std::map<std::uint32_t, Part> parts;
  std::vector<Node> nodes;
  std::vector<std::uint32_t> piece_part;  // by piece of the tree: the part that it is
};

class BuildTeller : public BspObserver {
 public:
  BuildTeller(const ScenePicture& picture, TraceRun& run, Built& built) : picture_(picture), run_(run), built_(built) {}

  void added_part(std::uint32_t part, FacetId facet, std::span<const PieceCorner> corners) override {
    const std::uint32_t face = picture_.face_of(facet);
    const int nth = ++count_[face];
    std::string name = picture_.name(face);
    if (nth > 1) name += "(" + std::to_string(nth) + ")";
    if (run_.steps.empty())
      run_.step("start", "start", "The faces, before anything is divided: the tree is built once, for every viewer.");
    run_.steps.back().make_piece(part, face, name, picture_.ring(facet, corners)).add("faces", {name, static_cast<int>(face)});
    facet_[part] = facet;
    built_.parts[part] = {name, face};
  }

  void opened(std::span<const std::uint32_t> parts, std::uint32_t parent, bool is_before) override {
    tried_ = 0;
    std::string where = built_.nodes.empty() ? "The root"
                        : is_before          ? "What is in front of " + built_.nodes[parent].text
                                             : "What is behind " + built_.nodes[parent].text;
    TraceStep& step =
        run_.step("open", "node",
                  where + " has " + std::to_string(parts.size()) +
                      (parts.size() == 1 ? " face: its plane is the last here." : " faces: by which plane are they divided?"));
    std::vector<TraceItem> items;
    for (const std::uint32_t k : parts) {
      step.piece(k);
      items.push_back(item(k));
    }
    step.list("this node's faces", items).list("planes tried", {});
  }

  void tried(const Cut& plane, const BspScore& s) override {
    const std::uint32_t face = face_of_plane(plane);
    const std::string name = "plane of " + picture_.name(face);
    TraceStep& step =
        run_.step("try", "score",
                  "The plane of " + picture_.name(face) + " would have " + std::to_string(s.behind) + " behind it and " +
                      std::to_string(s.before) + " in front of it, and cut " + std::to_string(s.cut) + ": it costs 8 · " +
                      std::to_string(s.cut) + " + the difference of the sides = " + std::to_string(s.score) + ".");
    step.face(face).number("behind", static_cast<double>(s.behind)).number("in front", static_cast<double>(s.before));
    step.number("cut", static_cast<double>(s.cut)).number("cost", static_cast<double>(s.score));
    step.add("planes tried", {name + ": " + std::to_string(s.score), static_cast<int>(face)});
    ++tried_;
    tries_.resize(static_cast<std::size_t>(tried_ - 1));
    tries_.push_back({face, s.score});
  }

  void split(std::uint32_t part, std::uint32_t behind, std::span<const PieceCorner> corners_behind, std::uint32_t before,
             std::span<const PieceCorner> corners_before) override {
    const Part whole = built_.parts[part];
    const FacetId facet = facet_[part];
    TraceStep& step = run_.step("split", "split",
                                whole.name + " is on both sides of the plane and is cut: " + whole.name + ".1 is behind it, " +
                                    whole.name + ".2 in front of it.");
    built_.parts[behind] = {whole.name + ".1", whole.face};
    built_.parts[before] = {whole.name + ".2", whole.face};
    facet_[behind] = facet_[before] = facet;
    const TraceRing a = picture_.ring(facet, corners_behind), b = picture_.ring(facet, corners_before);
    step.make_piece(behind, whole.face, built_.parts[behind].name, a);
    step.make_piece(before, whole.face, built_.parts[before].name, b);
    if (part != behind && part != before) step.drop(part);
    step.piece(behind).piece(before);
  }

  void added_node(std::uint32_t node, std::uint32_t parent, bool is_before, const Cut& plane,
                  std::span<const std::uint32_t> inside) override {
    Node added;
    if (plane.kind == Cut::Kind::face) {
      const std::uint32_t face = face_of_plane(plane);
      added.text = picture_.name(face);
      added.face = static_cast<int>(face);
    } else {
      added.text =
          std::string(1, "xyz"[plane.axis]) + " = " + trace_text(picture_.scene().mesh.points[VertexId(plane.u)][plane.axis]);
    }
    added.parent = node == 0 ? -1 : static_cast<int>(parent);
    added.is_before = is_before;
    added.inside = {inside.begin(), inside.end()};
    for (const std::uint32_t k : inside) built_.piece_part.push_back(k);
    std::string names;
    for (const std::uint32_t k : inside) names += (names.empty() ? "" : ", ") + name(k);
    TraceStep& step = run_.step(
        "node", "add",
        "Node " + std::to_string(node) + ": the plane " + of(added) + (inside.empty() ? "" : ". In it: " + names) + ".");
    // A part of a face that other nodes have, too, by its own name.
    added.label = inside.size() == 1 ? name(inside.front()) : added.text;
    step.node(node, added.parent, is_before, added.label, added.face);
    for (const std::uint32_t k : inside) step.piece(k);
    ask_for_plane(step, added);
    built_.nodes.resize(std::max<std::size_t>(built_.nodes.size(), node + 1U));
    built_.nodes[node] = std::move(added);
  }

  void walked(std::uint32_t, bool, bool) override {}
  void visited(std::uint32_t, std::uint32_t) override {}

 private:
  std::uint32_t face_of_plane(const Cut& plane) const { return picture_.scene().mesh.face_of[TriangleId(plane.u)].value; }
  static std::string of(const Node& node) { return node.face >= 0 ? "of " + node.text : node.text + ", across an axis"; }
  const std::string& name(std::uint32_t part) { return built_.parts[part].name; }
  TraceItem item(std::uint32_t part) { return {name(part), static_cast<int>(built_.parts[part].face)}; }

  /// Where several were tried and one is the best.
  void ask_for_plane(TraceStep& step, const Node& node) {
    if (tried_ < 2 || node.face < 0 || ++asked_ > 4) {
      tried_ = 0;
      return;
    }
    TraceQuestion question{"Which plane is taken?", {}, 0};
    bool is_there = false;
    for (const auto& t : tries_) {
      if (static_cast<int>(t.face) == node.face) {
        question.right = question.choices.size();
        is_there = true;
      }
      question.choices.push_back("the plane of " + picture_.name(t.face) + " (cost " + std::to_string(t.score) + ")");
    }
    tried_ = 0;
    if (is_there) step.ask(std::move(question));
  }

  struct Try {
    std::uint32_t face;
    std::size_t score;
  };

  const ScenePicture& picture_;
  TraceRun& run_;
  Built& built_;
  std::map<std::uint32_t, FacetId> facet_;
  std::map<std::uint32_t, int> count_;
  std::vector<Try> tries_;
  int tried_ = 0, asked_ = 0;
};

class WalkTeller : public BspObserver {
 public:
  WalkTeller(const ProjectedMesh& projected, const BspNodes& tree, TraceRun& run, Built& built)
      : projected_(projected), tree_(tree), run_(run), built_(built) {}

  void added_part(std::uint32_t, FacetId, std::span<const PieceCorner>) override {}
  void opened(std::span<const std::uint32_t>, std::uint32_t, bool) override {}
  void tried(const Cut&, const BspScore&) override {}
  void split(std::uint32_t, std::uint32_t, std::span<const PieceCorner>, std::uint32_t, std::span<const PieceCorner>) override {
  }
  void added_node(std::uint32_t, std::uint32_t, bool, const Cut&, std::span<const std::uint32_t>) override {}

  void walked(std::uint32_t node, bool is_leaf, bool viewer_is_before) override {
    const Node& n = built_.nodes[node];
    if (is_leaf) {
      run_.step("leaf", "leaf", "Nothing is on either side of the plane of " + n.text + ".")
          .number("node", static_cast<double>(node));
      return;
    }
    const std::string near = viewer_is_before ? "in front of" : "behind", far = viewer_is_before ? "behind" : "in front of";
    TraceStep& step = run_.step("walk", "side",
                                "The viewer is " + near + " the plane of " + n.text + ": what is " + far +
                                    " it is painted first, then what lies in it, then what is " + near + " it.");
    step.number("node", static_cast<double>(node));
    for (const std::uint32_t k : n.inside) step.piece(k);
    if (++asked_ <= 4)
      step.ask({"The viewer is " + near + " the plane of " + n.text + ". What is painted first?",
                {"what is in front of the plane", "what lies in the plane", "what is behind the plane"},
                viewer_is_before ? 2U : 0U});
  }

  void visited(std::uint32_t first_piece, std::uint32_t end_piece) override {
    for (std::uint32_t piece = end_piece; piece-- > first_piece;) {
      const std::uint32_t k = built_.piece_part[piece];
      const Part& part = built_.parts[k];
      if (projected_.facing(tree_.pieces[piece].facet) == Sign::zero) {
        run_.step("edge-on", "paint", part.name + " is seen edge-on: there is nothing to paint.").piece(k);
        continue;
      }
      run_.step("paint", "paint", part.name + " is painted.")
          .piece(k)
          .paint(k)
          .add("painted", {part.name, static_cast<int>(part.face)});
    }
  }

 private:
  const ProjectedMesh& projected_;
  const BspNodes& tree_;
  TraceRun& run_;
  Built& built_;
  int asked_ = 0;
};

/// A walk begins with the tree as it was built, and its pieces as this picture has them.
void add_walk(Trace& trace, const std::string& name, const ExplainedScene& scene, const BspNodes& tree, Built& built) {
  const ScenePicture picture(scene, 0);
  TraceRun& run = trace.run(name);
  run.scene = picture.traced(false);
  TraceStep& start = run.step(
      "start", "walk",
      "The tree stands; now it is walked for this viewer, who sees " + std::to_string(built.piece_part.size()) + " pieces.");
  for (std::uint32_t piece = 0; piece < built.piece_part.size(); ++piece) {
    const OrderedPiece& p = tree.pieces[piece];
    std::vector<PieceCorner> ring;
    for (std::uint32_t c = p.first_corner; c < p.end_corner; ++c) ring.push_back(tree.corner(tree.corners[c]));
    const Part& part = built.parts[built.piece_part[piece]];
    start.make_piece(built.piece_part[piece], part.face, part.name, picture.ring(p.facet, ring));
  }
  for (std::uint32_t k = 0; k < built.nodes.size(); ++k) {
    const Node& n = built.nodes[k];
    start.node(k, n.parent, n.is_before, n.label, n.face);
  }
  start.list("painted", {});
  const SceneView prepared(scene.mesh, scene.view);
  const ProjectedMesh& projected = prepared.parts().projected();
  WalkTeller teller(projected, tree, run, built);
  PaintersOrder order;
  append_far_to_near(tree, projected, scene.view, order, &teller);
  run.result = painted_result(scene, order);
}

/// The same scene for a viewer who has walked around it.
ExplainedScene seen_from(const ExplainedScene& scene, const Point3& direction) {
  ExplainedScene moved = scene;
  const Point3 up = direction.x == 0 && direction.y == 0 ? Point3{0, 1, 0} : Point3{0, 0, 1};
  moved.view = parallel_view(direction, up, scene.view.target);
  return moved;
}

}  // namespace

Trace explain_bsp(const ExplainedScene& scene, int /*size*/) {
  check_explainable(scene);
  const ScenePicture picture(scene, 0);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("bsp.txt");
  Built built;
  BspNodes tree;
  {
    TraceRun& run = trace.run("build the tree");
    BuildTeller teller(picture, run, built);
    tree = build_nodes(scene.mesh, {}, nullptr, &teller);
    tree.prepare_planes();
    run.result = "{\"nodes\":" + std::to_string(tree.nodes.size()) + ",\"pieces\":" + std::to_string(tree.pieces.size()) +
                 ",\"splits\":" + std::to_string(tree.splits) + "}";
  }
  add_walk(trace, "walk it: the view asked for", scene, tree, built);
  add_walk(trace, "walk it: from the other side", seen_from(scene, Point3{1, -2, 1.5}), tree, built);
  add_walk(trace, "walk it: from below", seen_from(scene, Point3{-1.5, 1, -1}), tree, built);
  return trace;
}

}  // namespace hsr::internal
