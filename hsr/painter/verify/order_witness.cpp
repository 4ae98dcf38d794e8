#include "hsr/painter/verify/order_witness.h"

#include <algorithm>

namespace hsr::internal {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// The precedences by their first polygon.
struct Next {
  std::vector<std::uint32_t> begin, numbers;

  Next(std::uint32_t polygons, const std::vector<Precedence>& all) : begin(polygons + 1, 0), numbers(all.size()) {
    for (const Precedence& p : all) ++begin[p.first + 1];
    for (std::uint32_t i = 0; i < polygons; ++i) begin[i + 1] += begin[i];
    std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
    for (std::uint32_t k = 0; k < all.size(); ++k) numbers[at[all[k].first]++] = k;
  }
};

/// By polygon: a number of its component.
std::vector<std::uint32_t> components_of(std::uint32_t n, const std::vector<Precedence>& all, const Next& next) {
  std::vector<std::uint32_t> entered(n, none), low(n, none), component(n, none), waiting, path, at(next.begin);
  std::uint32_t clock = 0;
  for (std::uint32_t root = 0; root < n; ++root) {
    if (entered[root] != none) continue;
    path.push_back(root);
    while (!path.empty()) {
      const std::uint32_t i = path.back();
      if (entered[i] == none) {
        entered[i] = low[i] = clock++;
        waiting.push_back(i);
      }
      if (at[i] < next.begin[i + 1]) {
        const std::uint32_t k = all[next.numbers[at[i]]].second;
        if (entered[k] == none) {
          path.push_back(k);  // and look at k again when it is done
          continue;
        }
        if (component[k] == none) low[i] = std::min(low[i], low[k]);
        ++at[i];
        continue;
      }
      path.pop_back();
      if (low[i] != entered[i]) continue;
      for (std::uint32_t last = none; last != i;) {
        last = waiting.back();
        waiting.pop_back();
        component[last] = i;
      }
    }
  }
  return component;
}

class CycleSearch {
 public:
  CycleSearch(const std::vector<Precedence>& all, const Next& next, const std::vector<std::uint32_t>& component)
      : all_(all),
        next_(next),
        component_(component),
        seen_(component.size(), none),
        by_(component.size()),
        steps_(component.size()) {}

  /// Looks for a cycle through i that is shorter than the shortest so far.
  void through(std::uint32_t i) {
    std::vector<std::uint32_t> queue = {i};
    seen_[i] = i;
    steps_[i] = 0;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const std::uint32_t from = queue[head];
      if (!best_.empty() && steps_[from] + 1 >= best_.size()) return;
      for (std::uint32_t at = next_.begin[from]; at < next_.begin[from + 1]; ++at, ++work_) {
        const std::uint32_t number = next_.numbers[at], to = all_[number].second;
        if (to == i) return close(i, number);
        if (component_[to] != component_[i] || seen_[to] == i) continue;
        seen_[to] = i;
        by_[to] = number;
        steps_[to] = steps_[from] + 1;
        queue.push_back(to);
      }
    }
  }
  bool is_done() const { return best_.size() == 2 || work_ > most_work; }
  std::vector<std::uint32_t> best() && { return std::move(best_); }

 private:
  static constexpr std::uint64_t most_work = 100'000'000;

  void close(std::uint32_t i, std::uint32_t last) {
    best_ = {last};
    for (std::uint32_t at = all_[last].first; at != i; at = all_[by_[at]].first) best_.push_back(by_[at]);
    std::reverse(best_.begin(), best_.end());
  }

  const std::vector<Precedence>& all_;
  const Next& next_;
  const std::vector<std::uint32_t>& component_;
  std::vector<std::uint32_t> seen_, by_,
      steps_;  // by polygon: the search that came there, through which precedence, after how many
  std::vector<std::uint32_t> best_;
  std::uint64_t work_ = 0;
};

}  // namespace

OrderWitness order_witness(std::uint32_t polygons, const std::vector<Precedence>& all) {
  const Next next(polygons, all);
  const std::vector<std::uint32_t> component = components_of(polygons, all, next);
  std::vector<std::uint32_t> size(polygons, 0), place(polygons, none);
  for (const std::uint32_t c : component) ++size[c];
  OrderWitness out;
  CycleSearch search(all, next, component);
  for (std::uint32_t i = 0; i < polygons; ++i) {
    const std::uint32_t c = component[i];
    if (size[c] < 2) continue;
    if (place[c] == none) {
      place[c] = static_cast<std::uint32_t>(out.components.size());
      out.components.emplace_back();
    }
    out.components[place[c]].push_back(i);
    if (!search.is_done()) search.through(i);
  }
  out.cycle = std::move(search).best();
  return out;
}

}  // namespace hsr::internal
