#include "hsr/painter/sort/depth_order.h"

#include <array>
#include <bit>
#include <utility>

#include "geometry/parallel.h"
#include "hsr/painter/sort/components.h"
#include "hsr/painter/sort/piece_relations.h"

namespace hsr::internal {

namespace {

/// Ascending from far to near; of two boxes that are apart in depth the nearer has more. Half-way, so that few pieces come
/// before their turn.
std::uint32_t key(const ImageBox& box) {
  float depth = box.farthest / 2 + box.nearest / 2;
  if (!(depth >= box.farthest && depth <= box.nearest)) depth = box.farthest;  // not finite, or rounded too far
  // The bits of a float ascend with it, those of a negative one descend. No two zeros: they are one depth.
  const auto bits = std::bit_cast<std::uint32_t>(depth + 0.0F);
  return bits ^ (bits >> 31U != 0 ? 0xffffffffU : 0x80000000U);
}

/// The places in the order of the keys, those of one key ascending: by 11 bits after 11 bits.
std::vector<std::uint32_t> sorted_by_key(const ClusterBoxes& boxes, std::size_t n) {
  constexpr std::size_t digits = 2048;
  struct Item {
    std::uint32_t key, place;
  };
  std::vector<Item> items(n), other(n);
  std::array<std::array<std::uint32_t, digits>, 3> next = {};
  for (std::uint32_t i = 0; i < n; ++i) {
    items[i] = {key(boxes[i]), i};
    for (std::size_t k = 0; k < 3; ++k) ++next[k][items[i].key >> 11 * k & (digits - 1)];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    std::uint32_t first = 0;
    for (std::uint32_t& count : next[k]) first += std::exchange(count, first);
    for (const Item& item : items) other[next[k][item.key >> 11 * k & (digits - 1)]++] = item;
    items.swap(other);
  }
  std::vector<std::uint32_t> places(n);
  for (std::size_t i = 0; i < n; ++i) places[i] = items[i].place;
  return places;
}

class Search {
 public:
  Search(const ProjectedMesh& projected, const FacePieces& pieces, const ClusterBoxes& boxes, const ImageTriangles& images,
         const OverlapGraph& found, SortObserver* observer)
      : pieces_(pieces),
        boxes_(boxes),
        clusters_(boxes.clusters()),
        relations_(projected, pieces, images, false),
        observer_(observer),
        behind_(make_graph(pieces.size(),
                           [&](const auto& visit) {
                             found.for_each_pair([&](std::uint32_t first, std::uint32_t second) { visit(second, first); });
                           })),
        state_(pieces.size(), State::waiting),
        most_early_(pieces.size() / 8 + 64) {
    order_.reserve(pieces.size());
  }

  std::optional<std::vector<std::uint32_t>> order();
  void count(OverlapGraph& all) {
    all.candidates += compared_;
    all.overlapping += overlapping_;
    all.counts += relations_.counts();
    all.decisions += relations_.decisions();
  }

 private:
  enum class State : std::uint8_t { waiting, open, done };
  /// A piece whose order waits for those behind it: of the graph, then those that were found for it.
  struct Step {
    std::uint32_t piece, next;
    std::uint32_t first_found;
  };
  void open(std::uint32_t piece, bool is_early);
  bool finish(std::uint32_t piece);
  void find_behind(std::uint32_t piece);
  void tell_order(const std::vector<std::uint32_t>& places);

  const FacePieces& pieces_;
  const ClusterBoxes& boxes_;
  const Clusters& clusters_;
  PieceRelations relations_;
  SortObserver* observer_;
  Graph behind_;  // by piece
  std::vector<std::uint32_t> cluster_of_, place_of_;
  std::vector<State> state_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> found_;  // behind the steps that come early, those of the last step last
  std::vector<std::uint32_t> leaves_, order_;
  std::size_t most_early_, early_ = 0;
  std::uint64_t compared_ = 0, overlapping_ = 0;
};

/// What is behind a piece that comes before its turn, and has not come yet, with depths that are apart.
void Search::find_behind(std::uint32_t piece) {
  if (place_of_.empty()) {
    cluster_of_ = cluster_of_pieces(clusters_);
    place_of_.resize(pieces_.size());
    for (std::uint32_t k = 0; k < place_of_.size(); ++k) place_of_[clusters_.values()[k]] = k;
  }
  const std::uint32_t c = cluster_of_[piece], first = clusters_.begin(c);
  const ImageBox& box = boxes_[place_of_[piece]];
  const auto look_at = [&](std::uint32_t place) {
    const std::uint32_t other = clusters_.values()[place];
    if (!(boxes_[place].nearest < box.farthest) || state_[other] == State::done) return;
    if (pieces_.facet[other] == pieces_.facet[piece]) return;
    ++compared_;
    const Overlap how =
        observer_ == nullptr ? relations_.relation(piece, other) : relations_.relation(piece, other, *observer_);
    if (how == Overlap::none) return;
    ++overlapping_;
    found_.push_back(other);
  };
  if (const BoxTree* const tree = boxes_.tree(c)) {
    leaves_.clear();
    tree->leaves<BoxTree::Depth::any>(box, tree->leaf_count(), leaves_);
    for (const std::uint32_t leaf : leaves_)
      tree->visit_leaf<BoxTree::Depth::any>(leaf, box, [&](std::uint32_t k) {
        look_at(first + k);
        return true;
      });
  } else {
    for (std::uint32_t place = first; place < clusters_.begin(c + 1); ++place)
      if (touch_in_image(boxes_[place], box)) look_at(place);
  }
}

void Search::open(std::uint32_t piece, bool is_early) {
  state_[piece] = State::open;
  if (observer_ != nullptr) observer_->opened(piece, is_early);
  steps_.push_back({piece, 0, static_cast<std::uint32_t>(found_.size())});
  if (!is_early) return;
  ++early_;
  find_behind(piece);
}

/// All that is behind the piece, then itself. False: there is a cycle, or too much comes early.
bool Search::finish(std::uint32_t root) {
  open(root, false);
  while (!steps_.empty()) {
    Step& step = steps_.back();
    const auto known = behind_[step.piece];
    const std::size_t next = step.next++, end = known.size() + (found_.size() - step.first_found);
    if (next == end) {
      state_[step.piece] = State::done;
      order_.push_back(step.piece);
      if (observer_ != nullptr) observer_->painted(step.piece);
      found_.resize(step.first_found);
      steps_.pop_back();
      continue;
    }
    const std::uint32_t other = next < known.size() ? known[next] : found_[step.first_found + (next - known.size())];
    if (state_[other] == State::open) {
      if (observer_ != nullptr) observer_->met_again(other);
      return false;
    }
    if (state_[other] == State::waiting) open(other, true);
    if (early_ > most_early_) return false;
  }
  return true;
}

void Search::tell_order(const std::vector<std::uint32_t>& places) {
  std::vector<std::uint32_t> pieces;
  for (const std::uint32_t place : places) pieces.push_back(clusters_.values()[place]);
  observer_->sorted(pieces);
}

std::optional<std::vector<std::uint32_t>> Search::order() {
  const std::vector<std::uint32_t> places = sorted_by_key(boxes_, pieces_.size());
  if (observer_ != nullptr) tell_order(places);
  for (const std::uint32_t place : places) {
    const std::uint32_t piece = clusters_.values()[place];
    if (state_[piece] == State::waiting && !finish(piece)) return std::nullopt;
  }
  return std::move(order_);
}

}  // namespace

std::optional<std::vector<std::uint32_t>> depth_order(const ProjectedMesh& projected, const FacePieces& pieces,
                                                      const ClusterBoxes& boxes, const ImageTriangles& images,
                                                      OverlapGraph& found, SortObserver* observer) {
  Search search(projected, pieces, boxes, images, found, observer);
  auto order = search.order();
  if (order) search.count(found);
  return order;
}

}  // namespace hsr::internal
