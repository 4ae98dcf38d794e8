// Depth sort, told step by step by the sorter itself.
#include <algorithm>
#include <array>
#include <map>

#include "hsr/painter/sort/sort_observer.h"
#include "hsr/scene/view_parts.h"
#include "hsr/symbols/constructions.h"
#include "study/explain/explained_methods.h"
#include "study/page_texts.h"

namespace hsr::internal {

namespace {

/// As the pseudocode names the tests, by SortTest, and as a list of tests has them.
struct NamedTest {
  const char *line, *name;
};
constexpr std::array<NamedTest, 6> tests = {{{"sides", "1 images apart"},
                                             {"depths", "2 depths apart"},
                                             {"plane-of-first", "3 on one side of the first's plane"},
                                             {"plane-of-second", "4 on one side of the second's plane"},
                                             {"coplanar", "5 in one plane"},
                                             {"common", "6 compared in the common part"}}};

class Teller : public SortObserver {
 public:
  Teller(const ScenePicture& picture, const SceneView& prepared, TraceRun& run)
      : picture_(picture), prepared_(prepared), run_(run) {}

  void began(const FacePieces& pieces, const Clusters& clusters) override {
    std::map<std::uint32_t, std::uint32_t> count, seen;
    for (const FacetId facet : pieces.facet) ++count[picture_.face_of(facet)];
    TraceStep& step = run_.step("start", "start", "");
    std::vector<TraceItem> items;
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      const std::uint32_t face = picture_.face_of(pieces.facet[k]);
      std::string name = picture_.name(face);
      if (count[face] > 1) name += "(" + std::to_string(++seen[face]) + ")";
      TraceRing ring;
      Range depth;
      for (const VertexId v : pieces.rings[k]) {
        const Point3& p = prepared_.mesh().points[v];
        ring.push_back(picture_.at(p));
        depth.add(picture_.depth(p));
      }
      step.make_piece(k, face, name, ring);
      pieces_.push_back({name, face, depth, ring.size()});
      items.push_back(item(k));
    }
    step.list("faces", items);
    step.says(std::to_string(pieces.size()) +
              (pieces.size() == 1 ? " face is seen" : " faces are seen, and are to be painted from far to near") +
              (clusters.size() > 1 ? "; planes that none crosses part them into " + std::to_string(clusters.size()) +
                                         " groups, and faces of two groups are never compared."
                                   : "."));
  }

  void sorted(std::span<const std::uint32_t> pieces) override {
    TraceStep& step =
        run_.step("sort", "sort", "The faces in the order of a first guess: from far to near by the middle of their depths.");
    std::vector<TraceItem> items;
    for (const std::uint32_t k : pieces) {
      items.push_back(item(k));
      step.number("middle depth of " + name(k), pieces_[k].depth.middle());
    }
    step.list("tests of this pair", {}).list("by depth", items).list("painted", {});
  }

  void compared(std::uint32_t p, std::uint32_t q, SortTest by, Overlap how) override {
    const auto decided = static_cast<std::size_t>(by);
    TraceStep& step = run_.step("test", tests[decided].line, sentence(p, q, by, how));
    step.piece(p).piece(q).number("depths of " + name(p), depths(p)).number("depths of " + name(q), depths(q));
    std::vector<TraceItem> verdicts;
    for (std::size_t k = 0; k <= decided; ++k) {
      const bool is_asked =
          k != static_cast<std::size_t>(SortTest::depths) || (pieces_[p].corners == 3 && pieces_[q].corners == 3);
      verdicts.push_back({std::string(tests[k].name) + (!is_asked                     ? ": asked of triangles only"
                                                        : k < decided                 ? ": no"
                                                        : by == SortTest::common_part ? ""
                                                                                      : ": yes"),
                          -1});
    }
    step.list("tests of this pair", verdicts);
    relate(step, p, q, how);
    if (how != Overlap::none && ++asked_[decided] <= 2) {
      TraceQuestion question{
          name(p) + " and " + name(q) + " overlap in the image. Which test tells which of them is painted first?", {}, 0};
      for (std::size_t k = 1; k < tests.size(); ++k) {
        if (k == decided) question.right = question.choices.size();
        question.choices.emplace_back(tests[k].name + 2);
      }
      step.ask(std::move(question));
    }
  }

  void opened(std::uint32_t piece, bool is_early) override {
    if (!is_early) {
      run_.step("look", "next", name(piece) + " is the next of the list: what has to be painted before it?").piece(piece);
      waiting_ = piece;
      return;
    }
    TraceStep& step = run_.step("early", "behind",
                                name(piece) +
                                    " is behind a face that waits, and comes before its turn: now it is compared with "
                                    "all that its box touches.");
    step.piece(piece);
    if (++early_ > 3 || pieces_.size() < 3) return;
    step.ask(which(name(waiting_) + " cannot be painted yet. Which face must be painted first?", piece, {waiting_}));
  }

  void painted(std::uint32_t piece) override {
    run_.step("paint", "paint", name(piece) + " is painted: all that is behind it is there.")
        .piece(piece)
        .paint(piece)
        .add("painted", item(piece));
  }

  void met_again(std::uint32_t piece) override {
    run_.step("cycle", "met",
              "The search comes back to " + name(piece) +
                  ", which waits itself: each of these faces is to be painted before the next. No order of whole "
                  "faces is right.")
        .piece(piece)
        .unpaint()
        .list("tests of this pair", {})
        .list("painted", {});
  }

  void relates_all() override {
    run_.step("relate", "all",
              "No order of whole faces has been found so far: now pairs are related whose depths are apart, too, since cycles "
              "run through "
              "these as well.");
  }

  void found_cycle(std::span<const std::uint32_t> cycle) override {
    std::string text;
    for (const std::uint32_t k : cycle) text += name(k) + " before ";
    TraceStep& step = run_.step("cycle", "loop", "A cycle: " + text + name(cycle.front()) + ". One of these has to be cut.");
    for (const std::uint32_t k : cycle) step.piece(k);
    step.list("tests of this pair", {});
    cycle_.assign(cycle.begin(), cycle.end());
    pierced_.clear();
  }

  void found_piercing(std::uint32_t p, std::uint32_t q) override {
    run_.step("pierce", "pierce", name(p) + " and " + name(q) + " pierce each other: each is in front of the other somewhere.")
        .piece(p)
        .piece(q)
        .list("tests of this pair", {});
    cycle_.clear();
    pierced_ = {p, q};
  }

  void cut(std::uint32_t piece, std::uint32_t first, const PieceOfFacet& inside, const PieceOfFacet& outside,
           const MapLine& line) override {
    const std::string whole = name(piece);
    const std::uint32_t face = pieces_[piece].face;
    const std::string along = line.kind == MapLine::Kind::edge ? "along a side of a neighbour" : "where two planes meet";
    TraceStep& step = run_.step("split", cycle_.empty() ? "split-pierced" : "split",
                                whole + " is cut " + along + " into " + whole + ".1 and " + whole + ".2" +
                                    (cycle_.empty() ? "."
                                                    : ": what is painted before it overlaps only one of them, what is painted "
                                                      "after it only the other."));
    const std::array<const PieceOfFacet*, 2> parts = {&inside, &outside};
    std::vector<TraceRing> rings;
    for (std::uint32_t k = 0; k < 2; ++k) {
      TraceRing ring;
      Range depth;
      for (const MapPoint& p : parts[k]->shape.points) {
        const auto at = exact_point(prepared_.mesh(), prepared_.view(), parts[k]->facet, p);
        ring.push_back(picture_.at(at));
        depth.add(picture_.depth({at[0].to_double(), at[1].to_double(), at[2].to_double()}));
      }
      pieces_.resize(std::max<std::size_t>(pieces_.size(), first + k + 1U));
      pieces_[first + k] = {whole + "." + std::to_string(k + 1), face, depth};
      step.make_piece(first + k, face, name(first + k), ring);
      rings.push_back(std::move(ring));
    }
    step.drop(piece).piece(first).piece(first + 1);
    if (const auto seam = common_side(rings[0], rings[1])) step.mark(*seam);
    ++cuts_;
    const std::vector<std::uint32_t>& among = cycle_.empty() ? pierced_ : cycle_;
    if (among.size() > 1 && cuts_ <= 3) {
      TraceQuestion question{"Which of these faces is cut?", {}, 0};
      for (const std::uint32_t k : among) {
        if (k == piece) question.right = question.choices.size();
        question.choices.push_back(name(k));
      }
      step.ask(std::move(question));
    }
  }

  void related(std::uint32_t part, std::uint32_t other, Overlap how) override {
    TraceStep& step = run_.step("relate", "relate",
                                name(part) + " overlaps " + name(other) + ": " + verdict(part, other, how) +
                                    " As it was for the whole, unless they pierced.");
    step.piece(part).piece(other);
    relate(step, part, other, how);
  }

  void ordered_by_planes(std::span<const std::uint32_t> pieces, const PaintersOrder& block) override {
    std::string text;
    for (const std::uint32_t k : pieces) text += (text.empty() ? "" : ", ") + name(k);
    TraceStep& step = run_.step("planes", "planes",
                                "Cut one by one, their parts would pierce or hold one another again: " + text +
                                    " are ordered by planes at once, as a BSP tree does it, and painted as one.");
    for (const std::uint32_t k : pieces) step.piece(k).drop(k);
    std::vector<std::uint32_t> numbers;
    std::map<std::uint32_t, int> count;
    for (const OrderedPiece& p : block.pieces) {
      const std::uint32_t number = next_of_block_++, face = picture_.face_of(p.facet);
      names_of_blocks_[number] = {picture_.name(face) + "." + std::to_string(++count[face]), face, {}};
      step.make_piece(number, face, names_of_blocks_[number].name, picture_.ring(p.facet, block.corners_of(p)));
      numbers.push_back(number);
    }
    blocks_.push_back(std::move(numbers));
  }

  void ordered(std::span<const std::uint32_t> pieces, std::uint32_t blocks_from) override {
    std::vector<std::uint32_t> all;
    for (const std::uint32_t k : pieces) {
      if (k < blocks_from || blocks_from == 0xffffffffU)
        all.push_back(k);
      else
        all.insert(all.end(), blocks_[k - blocks_from].begin(), blocks_[k - blocks_from].end());
    }
    std::vector<TraceItem> items;
    for (const std::uint32_t k : all) items.push_back(item(k));
    TraceStep& first =
        run_.step("order", "topological", "The order, from far to near: whatever is behind a face comes before it.");
    first.list("tests of this pair", {}).list("order", items).unpaint().list("painted", {});
    for (const std::uint32_t k : all)
      run_.step("paint", "topological", name(k) + " is painted.").piece(k).paint(k).add("painted", item(k));
  }

 private:
  struct Range {
    double low = 1e300, high = -1e300;
    void add(double x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
    double middle() const { return (low + high) / 2; }
  };
  struct Told {
    std::string name;
    std::uint32_t face = 0;
    Range depth;
    std::size_t corners = 0;
  };

  const Told& told(std::uint32_t piece) const {
    const auto found = names_of_blocks_.find(piece);
    return found != names_of_blocks_.end() ? found->second : pieces_[piece];
  }
  const std::string& name(std::uint32_t piece) const { return told(piece).name; }
  TraceItem item(std::uint32_t piece) const { return {name(piece), static_cast<int>(told(piece).face)}; }
  std::string depths(std::uint32_t k) const {
    return trace_text(pieces_[k].depth.low) + " … " + trace_text(pieces_[k].depth.high);
  }

  std::string verdict(std::uint32_t p, std::uint32_t q, Overlap how) const {
    switch (how) {
      case Overlap::none:
        return "either may come first.";
      case Overlap::first_behind:
        return name(p) + " is painted before " + name(q) + ".";
      case Overlap::second_behind:
        return name(q) + " is painted before " + name(p) + ".";
      case Overlap::piercing:
        return "each is in front of the other somewhere: they pierce each other, and one must be cut.";
    }
    return {};
  }

  std::string sentence(std::uint32_t p, std::uint32_t q, SortTest by, Overlap how) const {
    const std::string &a = name(p), &b = name(q);
    switch (by) {
      case SortTest::image_sides:
        return "A side of " + a + " or of " + b +
               " has all of the other beyond it in the image: they do not overlap, and either may "
               "come first.";
      case SortTest::depths:
        return a + " and " + b + " overlap in the image, but not in depth: " + verdict(p, q, how);
      case SortTest::plane_of_first:
        return "All of " + b + " is on one side of the plane of " + a + ", " +
               (how == Overlap::second_behind ? "away from" : "toward") + " the viewer: " + verdict(p, q, how);
      case SortTest::plane_of_second:
        return "The plane of " + a + " passes through " + b + ", but all of " + a + " is on one side of the plane of " + b +
               ", " + (how == Overlap::first_behind ? "away from" : "toward") + " the viewer: " + verdict(p, q, how);
      case SortTest::coplanar:
        return a + " and " + b + " lie in one plane, and neither hides the other: the lower number is painted last.";
      case SortTest::common_part:
        return "Each plane passes through the other face, so only where the images of " + a + " and " + b +
               " overlap can they be compared: " + verdict(p, q, how);
    }
    return {};
  }

  /// What is before what, in a list that grows.
  void relate(TraceStep& step, std::uint32_t p, std::uint32_t q, Overlap how) const {
    if (how == Overlap::none) return;
    const bool first = how != Overlap::second_behind;
    step.add("relations",
             {(first ? name(p) : name(q)) + (how == Overlap::piercing ? " pierces " : " before ") + (first ? name(q) : name(p)),
              static_cast<int>(told(first ? p : q).face)});
  }

  TraceQuestion which(const std::string& question, std::uint32_t right, const std::vector<std::uint32_t>& without) const {
    TraceQuestion asked{question, {}, 0};
    for (std::uint32_t k = 0; k < pieces_.size() && (asked.choices.size() < 5 || k <= right); ++k) {
      if (std::find(without.begin(), without.end(), k) != without.end()) continue;
      if (k != right && asked.choices.size() >= 4 && k < right) continue;
      if (k == right) asked.right = asked.choices.size();
      asked.choices.push_back(name(k));
    }
    return asked;
  }

  /// The side that two parts of one piece have in common.
  static std::optional<TraceLine> common_side(const TraceRing& a, const TraceRing& b) {
    std::vector<TracePlace> both;
    for (const TracePlace& p : a)
      if (std::find(b.begin(), b.end(), p) != b.end()) both.push_back(p);
    if (both.size() != 2) return std::nullopt;
    return TraceLine{both[0], both[1]};
  }

  const ScenePicture& picture_;
  const SceneView& prepared_;
  TraceRun& run_;
  std::vector<Told> pieces_;
  std::map<std::uint32_t, Told> names_of_blocks_;
  std::vector<std::vector<std::uint32_t>> blocks_;
  std::uint32_t next_of_block_ = 1U << 20U;  // beyond the pieces of so few faces
  std::vector<std::uint32_t> cycle_, pierced_;
  std::array<int, tests.size()> asked_ = {};
  int early_ = 0, cuts_ = 0;
  std::uint32_t waiting_ = 0;
};

}  // namespace

std::string painted_result(const ExplainedScene& scene, const PaintersOrder& order) {
  std::string out = "{\"painted\":[";
  for (const OrderedPiece& p : order.pieces) {
    if (out.back() != '[') out += ',';
    out += std::to_string(scene.mesh.face_of[first_triangle(p.facet)].value);
  }
  return out + "]}";
}

Trace explain_depth_sort(const ExplainedScene& scene, int /*size*/) {
  check_explainable(scene);
  const ScenePicture picture(scene, 0);
  Trace trace;
  trace.scene = picture.traced(false);
  trace.pseudocode = page_text("depth-sort.txt");
  const SceneView prepared(scene.mesh, scene.view);
  for (const bool classic : {false, true}) {
    TraceRun& run = trace.run(classic ? "as the paper cuts" : "few cuts");
    Teller teller(picture, prepared, run);
    DepthSortOptions options;
    options.classic = classic;
    const DepthSort sorted = depth_sort(prepared, options, teller);
    run.result = painted_result(scene, sorted.order);
  }
  return trace;
}

}  // namespace hsr::internal
