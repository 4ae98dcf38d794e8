#include "hsr/lines/roberts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>

#include "geometry/box_tree.h"
#include "geometry/error.h"
#include "hsr/lines/edge_class.h"
#include "hsr/lines/shadows.h"
#include "hsr/sight.h"

namespace hsr {

namespace {

using Range = tbb::blocked_range<std::size_t>;

/// The triangles that can hide something: not those wholly before the near plane.
struct Occluders {
  std::vector<TriangleId> triangles;
  BoxTree tree;

  explicit Occluders(const Sight& sight) {
    const Mesh& mesh = sight.mesh();
    triangles.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& c = mesh.triangles[TriangleId(i)];
      if (std::any_of(c.begin(), c.end(), [&](VertexId v) { return sight.beyond_near(v) != Sign::negative; }))
        triangles.emplace_back(i);
    }
    std::vector<ImageBox> boxes(triangles.size());
    tbb::parallel_for(Range(0, boxes.size(), 1024), [&](const Range& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) boxes[i] = sight.box(triangles[i]);
    });
    tree = BoxTree(boxes);
  }
};

/// Sorts the shadows of one edge along it, and of these makes the hidden intervals.
class Tiling {
 public:
  Tiling(const Sight& sight, const Occluders& occluders, const LineOptions& options)
      : sight_(sight), occluders_(occluders), options_(options), shadows_(sight) {}

  void add(EdgeId edge, EdgeClass edge_class);
  Predicates& exact() { return shadows_.exact(); }
  VisibleLines take() {
    result_.decisions = exact().counts();
    return std::move(result_);
  }

 private:
  void unite(std::vector<Shadow>& cast);
  void name_occluders(const Shadow& hidden, const std::vector<Shadow>& by_face);

  const Sight& sight_;
  const Occluders& occluders_;
  const LineOptions& options_;
  Shadows shadows_;
  std::vector<Shadow> cast_, by_face_, one_face_;
  VisibleLines result_;
};

/// Sorts `cast` and replaces what overlaps or touches by its union.
void Tiling::unite(std::vector<Shadow>& cast) {
  if (cast.size() < 2) return;
  std::sort(cast.begin(), cast.end(),
            [&](const Shadow& x, const Shadow& y) { return shadows_.order(x.from, y.from) == Sign::negative; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < cast.size(); ++i) {
    if (shadows_.order(cast[i].from, cast[last].to) == Sign::positive)
      cast[++last] = cast[i];
    else if (shadows_.order(cast[last].to, cast[i].to) == Sign::negative)
      cast[last].to = cast[i].to;
  }
  cast.resize(last + 1);
}

/// Greedy: of the faces whose shadow covers the start, the one that reaches furthest, the lowest index first.
void Tiling::name_occluders(const Shadow& hidden, const std::vector<Shadow>& by_face) {
  Bound reached = hidden.from;
  while (shadows_.order(reached, hidden.to) == Sign::negative) {
    const Shadow* best = nullptr;
    for (const Shadow& s : by_face) {
      if (shadows_.order(s.from, reached) == Sign::positive || shadows_.order(s.to, reached) != Sign::positive) continue;
      if (best == nullptr || shadows_.order(best->to, s.to) == Sign::negative) best = &s;
    }
    if (best == nullptr) throw InvariantError("roberts: a hidden interval without an occluder");
    result_.occluders.push_back({best->face, best->from.cut, best->to.cut});
    reached = best->to;
  }
}

void Tiling::add(EdgeId edge, EdgeClass edge_class) {
  LineOfEdge line;
  line.edge = edge;
  line.edge_class = edge_class;
  line.first_cut = static_cast<std::uint32_t>(result_.cuts.size());
  line.first_occluder = static_cast<std::uint32_t>(result_.occluders.size());
  if (shadows_.start(edge)) {
    const Edge& e = sight_.mesh().edges[edge];
    cast_.clear();
    bool all_hidden = false;
    occluders_.tree.visit(sight_.box(e.a, e.b), [&](std::uint32_t i) {
      ++result_.pairs;
      shadows_.cast(occluders_.triangles[i], cast_);
      all_hidden = !options_.why && !cast_.empty() && shadows_.covers_all(cast_.back());
      return !all_hidden;
    });
    if (all_hidden) {
      cast_.front() = cast_.back();
      cast_.resize(1);
    }
    if (options_.why) {
      by_face_.clear();
      std::stable_sort(cast_.begin(), cast_.end(), [](const Shadow& x, const Shadow& y) { return x.face < y.face; });
      for (auto i = cast_.begin(); i != cast_.end();) {
        const auto end = std::find_if(i, cast_.end(), [&](const Shadow& s) { return s.face != i->face; });
        one_face_.assign(i, end);
        unite(one_face_);
        by_face_.insert(by_face_.end(), one_face_.begin(), one_face_.end());
        i = end;
      }
    }
    unite(cast_);

    auto& cuts = result_.cuts;
    cuts.push_back(shadows_.first().cut);
    line.starts_hidden = !cast_.empty() && shadows_.order(shadows_.first(), cast_.front().from) == Sign::zero;
    for (const Shadow& s : cast_) {
      if (&s != &cast_.front() || !line.starts_hidden) cuts.push_back(s.from.cut);
      cuts.push_back(s.to.cut);
      if (options_.why) name_occluders(s, by_face_);
    }
    if (cast_.empty() || shadows_.order(cast_.back().to, shadows_.last()) != Sign::zero) cuts.push_back(shadows_.last().cut);
  }
  line.end_cut = static_cast<std::uint32_t>(result_.cuts.size());
  line.end_occluder = static_cast<std::uint32_t>(result_.occluders.size());
  result_.lines.push_back(line);
}

/// Calls the progress function from one thread at a time, each time another hundredth is done.
class Progress {
 public:
  Progress(const std::function<void(double)>& report, std::size_t total) : report_(report), total_(total) {}

  void advance(std::size_t n) {
    if (!report_) return;
    const std::size_t before = done_.fetch_add(n), after = before + n;
    if (before * 100 / total_ == after * 100 / total_) return;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock) report_(static_cast<double>(after) / static_cast<double>(total_));
  }

 private:
  const std::function<void(double)>& report_;
  std::size_t total_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
};

VisibleLines joined(std::vector<VisibleLines>& parts) {
  VisibleLines all;
  std::size_t lines = 0, cuts = 0, occluders = 0;
  for (const VisibleLines& part : parts) {
    lines += part.lines.size();
    cuts += part.cuts.size();
    occluders += part.occluders.size();
  }
  if (cuts > 0xffffffffU || occluders > 0xffffffffU)
    throw InputError("the drawing has " + std::to_string(std::max(cuts, occluders)) + " interval ends, expected at most 2^32");
  all.lines.reserve(lines);
  all.cuts.reserve(cuts);
  all.occluders.reserve(occluders);
  for (VisibleLines& part : parts) {
    for (LineOfEdge line : part.lines) {
      line.first_cut += static_cast<std::uint32_t>(all.cuts.size());
      line.end_cut += static_cast<std::uint32_t>(all.cuts.size());
      line.first_occluder += static_cast<std::uint32_t>(all.occluders.size());
      line.end_occluder += static_cast<std::uint32_t>(all.occluders.size());
      all.lines.push_back(line);
    }
    all.cuts.insert(all.cuts.end(), part.cuts.begin(), part.cuts.end());
    all.occluders.insert(all.occluders.end(), part.occluders.begin(), part.occluders.end());
    all.pairs += part.pairs;
    all.decisions += part.decisions;
    part = {};
  }
  return all;
}

}  // namespace

VisibleLines roberts(const Mesh& mesh, const View& view, const LineOptions& options) {
  const Sight sight(mesh, view, options.arithmetic);
  const Occluders occluders(sight);
  constexpr std::size_t block = 512;
  std::vector<VisibleLines> parts((mesh.edges.size() + block - 1) / block);
  Progress progress(options.progress, mesh.edges.size());
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      Tiling tiling(sight, occluders, options);
      const std::size_t end = std::min((part + 1) * block, mesh.edges.size());
      for (std::size_t e = part * block; e < end; ++e) {
        const auto edge_class = hsr::edge_class(sight, tiling.exact(), EdgeId(e), options.crease);
        if (edge_class && options.classes[static_cast<std::size_t>(*edge_class)]) tiling.add(EdgeId(e), *edge_class);
      }
      parts[part] = tiling.take();
      progress.advance(end - part * block);
    }
  });
  return joined(parts);
}

}  // namespace hsr
