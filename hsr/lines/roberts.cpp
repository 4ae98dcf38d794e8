#include "hsr/lines/roberts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <span>
#include <string>

#include "geometry/box_tree.h"
#include "geometry/error.h"
#include "hsr/lines/edge_class.h"
#include "hsr/lines/shadows.h"
#include "hsr/sight.h"

namespace hsr {

namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t block = 512;  // edges handled together; fixed, so that counts are the same for any number of threads

/// The triangles that can hide something: not those wholly before the near plane.
struct Occluders {
  std::vector<TriangleId> triangles;
  BoxTree tree;

  explicit Occluders(const Sight& sight) {
    const Mesh& mesh = sight.mesh();
    triangles.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (sight.reaches_beyond_near(TriangleId(i))) triangles.emplace_back(i);
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
      : occluders_(occluders), options_(options), shadows_(sight) {}

  void add(EdgeId edge, EdgeClass edge_class, const ImageBox& box);
  Predicates& exact() { return shadows_.exact(); }
  VisibleLines take() {
    result_.decisions = exact().counts();
    return std::move(result_);
  }

 private:
  void unite(std::vector<Shadow>& cast);
  void check_ascending(std::span<const Shadow> hidden);
  void name_occluders(std::span<const Shadow> hidden, std::span<const Shadow> by_face);

  const Occluders& occluders_;
  const LineOptions& options_;
  Shadows shadows_;
  std::vector<Shadow> cast_, by_face_, one_face_;
  VisibleLines result_;
};

/// Sorts `cast` and replaces what overlaps or touches by its union.
void Tiling::unite(std::vector<Shadow>& cast) {
  if (cast.size() < 2) return;
  // stable_sort stays within bounds even where --arithmetic double gives no order at all.
  std::stable_sort(cast.begin(), cast.end(),
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

/// Property (1) of the result, where the build checks its invariants.
void Tiling::check_ascending([[maybe_unused]] std::span<const Shadow> hidden) {
#ifdef HSR_CHECKS
  if (options_.arithmetic == Arithmetic::double_only) return;  // it promises nothing
  const DecisionCounts before = exact().counts();              // the report is the same in every build
  const Bound* reached = &shadows_.first();
  for (const Shadow& s : hidden) {
    const Sign gap = shadows_.order(*reached, s.from);
    if (gap == Sign::positive || (gap == Sign::zero && &s != hidden.data()) || shadows_.order(s.from, s.to) != Sign::negative)
      throw InvariantError("roberts: hidden intervals that are empty, touch or overlap");
    reached = &s.to;
  }
  if (shadows_.order(*reached, shadows_.last()) == Sign::positive)
    throw InvariantError("roberts: a hidden interval beyond the end of its edge");
  exact().counts() = before;
#endif
}

/// Greedy: of the faces whose shadow covers the start, the one that reaches furthest, the lowest index first. One sweep over
/// the shadows of the faces, which ascend by their start, then by face.
void Tiling::name_occluders(std::span<const Shadow> hidden, std::span<const Shadow> by_face) {
  std::size_t next = 0;
  const Shadow* furthest = nullptr;
  for (const Shadow& interval : hidden) {
    Bound reached = interval.from;
    while (shadows_.order(reached, interval.to) == Sign::negative) {
      for (; next < by_face.size() && shadows_.order(by_face[next].from, reached) != Sign::positive; ++next) {
        const Shadow& s = by_face[next];
        const Sign further = furthest == nullptr ? Sign::negative : shadows_.order(furthest->to, s.to);
        if (further == Sign::negative || (further == Sign::zero && s.face < furthest->face)) furthest = &s;
      }
      if (furthest == nullptr || shadows_.order(reached, furthest->to) != Sign::negative)
        throw InvariantError("roberts: a hidden interval without an occluder");
      result_.occluders.push_back({furthest->face, furthest->from.cut, furthest->to.cut});
      reached = furthest->to;
    }
  }
}

void Tiling::add(EdgeId edge, EdgeClass edge_class, const ImageBox& box) {
  LineOfEdge line;
  line.edge = edge;
  line.edge_class = edge_class;
  line.first_cut = static_cast<std::uint32_t>(result_.cuts.size());
  line.first_occluder = static_cast<std::uint32_t>(result_.occluders.size());
  if (shadows_.start(edge)) {
    cast_.clear();
    bool all_hidden = false;
    std::size_t united = 0;  // of cast_, when it was last united
    occluders_.tree.visit(box, [&](std::uint32_t i) {
      ++result_.pairs;
      const std::size_t before = cast_.size();
      shadows_.cast(occluders_.triangles[i], cast_);
      if (options_.why || cast_.size() == before) return true;
      all_hidden = shadows_.covers_all(cast_.back());
      // Now and then the shadows so far are united: together they may hide the whole edge. As their number doubles, so that a
      // long edge behind many separate faces costs no more than sorting them a few times.
      if (!all_hidden && cast_.size() >= 2 * united + 4) {
        unite(cast_);
        united = cast_.size();
        all_hidden = shadows_.covers_all(cast_.back());
      }
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
      std::stable_sort(by_face_.begin(), by_face_.end(),
                       [&](const Shadow& x, const Shadow& y) { return shadows_.order(x.from, y.from) == Sign::negative; });
    }
    unite(cast_);
    check_ascending(cast_);
    if (options_.why) name_occluders(cast_, by_face_);

    auto& cuts = result_.cuts;
    cuts.push_back(shadows_.first().cut);
    line.starts_hidden = !cast_.empty() && shadows_.order(shadows_.first(), cast_.front().from) == Sign::zero;
    for (const Shadow& s : cast_) {
      if (&s != &cast_.front() || !line.starts_hidden) cuts.push_back(s.from.cut);
      cuts.push_back(s.to.cut);
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

/// The edges that are asked for, ascending, and their boxes.
struct Requested {
  std::vector<EdgeId> edges;
  std::vector<EdgeClass> classes;
  std::vector<ImageBox> boxes;
  DecisionCounts decisions;

  Requested(const Sight& sight, const LineOptions& options) {
    const Mesh& mesh = sight.mesh();
    constexpr std::uint8_t none = 0xff;
    std::vector<std::uint8_t> edge_classes(mesh.edges.size(), none);
    std::vector<DecisionCounts> counts((mesh.edges.size() + block - 1) / block);
    tbb::parallel_for(Range(0, counts.size(), 1), [&](const Range& range) {
      for (std::size_t part = range.begin(); part < range.end(); ++part) {
        Predicates exact = sight.predicates();
        const std::size_t end = std::min((part + 1) * block, mesh.edges.size());
        for (std::size_t e = part * block; e < end; ++e) {
          const auto found = edge_class(sight, exact, EdgeId(e), options.crease);
          if (found && options.classes[static_cast<std::size_t>(*found)]) edge_classes[e] = static_cast<std::uint8_t>(*found);
        }
        counts[part] = exact.counts();
      }
    });
    for (const DecisionCounts& c : counts) decisions += c;
    for (std::size_t e = 0; e < edge_classes.size(); ++e) {
      if (edge_classes[e] == none) continue;
      edges.emplace_back(e);
      classes.push_back(static_cast<EdgeClass>(edge_classes[e]));
    }
    boxes.resize(edges.size());
    tbb::parallel_for(Range(0, edges.size(), 1024), [&](const Range& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        boxes[i] = sight.box(mesh.edges[edges[i]].a, mesh.edges[edges[i]].b);
    });
  }
};

/// Puts the lines of all parts in the order of their edges. @param place where each edge's line is: part and line in it
VisibleLines joined(const std::vector<VisibleLines>& parts, const std::vector<std::array<std::uint32_t, 2>>& place) {
  VisibleLines all;
  std::size_t cuts = 0, occluders = 0;
  for (const VisibleLines& part : parts) {
    cuts += part.cuts.size();
    occluders += part.occluders.size();
    all.pairs += part.pairs;
    all.decisions += part.decisions;
  }
  if (cuts > 0xffffffffU || occluders > 0xffffffffU)
    throw InputError("the drawing has " + std::to_string(std::max(cuts, occluders)) +
                     " interval ends, expected fewer than 2^32");
  all.lines.reserve(place.size());
  all.cuts.reserve(cuts);
  all.occluders.reserve(occluders);
  for (const auto& [part, at] : place) {
    LineOfEdge line = parts[part].lines[at];
    const auto line_cuts = parts[part].cuts_of(line);
    const auto line_occluders = parts[part].occluders_of(line);
    line.first_cut = static_cast<std::uint32_t>(all.cuts.size());
    line.first_occluder = static_cast<std::uint32_t>(all.occluders.size());
    all.cuts.insert(all.cuts.end(), line_cuts.begin(), line_cuts.end());
    all.occluders.insert(all.occluders.end(), line_occluders.begin(), line_occluders.end());
    line.end_cut = static_cast<std::uint32_t>(all.cuts.size());
    line.end_occluder = static_cast<std::uint32_t>(all.occluders.size());
    all.lines.push_back(line);
  }
  return all;
}

}  // namespace

VisibleLines roberts(const Mesh& mesh, const View& view, const LineOptions& options) {
  const Sight sight(mesh, view, options.arithmetic);
  const Occluders occluders(sight);
  const Requested requested(sight, options);
  // Neighbours in the image meet the same triangles: in this order they are still in the cache.
  const std::vector<std::uint32_t> order = z_order(requested.boxes);
  std::vector<VisibleLines> parts((order.size() + block - 1) / block);
  std::vector<std::array<std::uint32_t, 2>> place(order.size());
  Progress progress(options.progress, order.size());
  tbb::parallel_for(Range(0, parts.size(), 1), [&](const Range& range) {
    for (std::size_t part = range.begin(); part < range.end(); ++part) {
      Tiling tiling(sight, occluders, options);
      const std::size_t begin = part * block, end = std::min(begin + block, order.size());
      for (std::size_t k = begin; k < end; ++k) {
        const std::uint32_t i = order[k];
        place[i] = {static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(k - begin)};
        tiling.add(requested.edges[i], requested.classes[i], requested.boxes[i]);
      }
      parts[part] = tiling.take();
      progress.advance(end - begin);
    }
  });
  VisibleLines all = joined(parts, place);
  all.decisions += requested.decisions;
  return all;
}

}  // namespace hsr
