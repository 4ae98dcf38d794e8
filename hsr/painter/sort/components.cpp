#include "hsr/painter/sort/components.h"

#include <algorithm>

namespace hsr::internal {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

}  // namespace

std::vector<std::uint32_t> topological_order(const Graph& graph) {
  std::vector<std::uint32_t> before(graph.size(), 0), order;
  for (const std::uint32_t t : graph.values()) ++before[t];
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    if (before[i] == 0) order.push_back(i);
  for (std::size_t next = 0; next < order.size(); ++next)
    for (const std::uint32_t t : graph[order[next]])
      if (--before[t] == 0) order.push_back(t);
  return order;
}

std::vector<std::vector<std::uint32_t>> cyclic_components(const Graph& graph) {
  struct Visit {
    std::uint32_t node, edge;  // the next of its edges
  };
  std::vector<std::uint32_t> index(graph.size(), none), low(graph.size(), 0), open;
  std::vector<std::uint8_t> is_open(graph.size(), 0);
  std::vector<Visit> path;
  std::vector<std::vector<std::uint32_t>> components;
  std::uint32_t next = 0;
  const auto enter = [&](std::uint32_t node) {
    index[node] = low[node] = next++;
    open.push_back(node);
    is_open[node] = 1;
    path.push_back({node, 0});
  };
  for (std::uint32_t root = 0; root < graph.size(); ++root) {
    if (index[root] != none) continue;
    enter(root);
    while (!path.empty()) {
      const std::uint32_t node = path.back().node;
      if (path.back().edge < graph[node].size()) {
        const std::uint32_t target = graph[node][path.back().edge++];
        if (index[target] == none)
          enter(target);
        else if (is_open[target] != 0)
          low[node] = std::min(low[node], index[target]);
        continue;
      }
      path.pop_back();
      if (!path.empty()) low[path.back().node] = std::min(low[path.back().node], low[node]);
      if (low[node] != index[node]) continue;
      std::vector<std::uint32_t> component;
      for (std::uint32_t last = none; last != node;) {
        last = open.back();
        open.pop_back();
        is_open[last] = 0;
        component.push_back(last);
      }
      if (component.size() < 2) continue;
      std::sort(component.begin(), component.end());
      components.push_back(std::move(component));
    }
  }
  return components;
}

namespace {

/// Looks for one cycle after another; what a search has marked is cleared after it.
class CycleSearch {
 public:
  explicit CycleSearch(const Graph& graph) : graph_(graph), from_(graph.size(), none) {}

  std::vector<std::uint32_t> through(std::uint32_t node) {
    reached_.assign(1, node);
    std::vector<std::uint32_t> cycle = search(node);
    for (const std::uint32_t k : reached_)
      if (from_[k] != blocked) from_[k] = none;
    return cycle;
  }
  void block(const std::vector<std::uint32_t>& nodes) {
    for (const std::uint32_t k : nodes) from_[k] = blocked;
  }
  bool is_blocked(std::uint32_t node) const { return from_[node] == blocked; }
  std::size_t edges() const { return edges_; }

 private:
  static constexpr std::uint32_t blocked = none - 1;

  std::vector<std::uint32_t> search(std::uint32_t node) {
    for (std::size_t next = 0; next < reached_.size(); ++next)
      for (const std::uint32_t t : graph_[reached_[next]]) {
        ++edges_;
        if (t == node) {
          std::vector<std::uint32_t> cycle = {reached_[next]};
          while (cycle.back() != node) cycle.push_back(from_[cycle.back()]);
          std::reverse(cycle.begin(), cycle.end());
          return cycle;
        }
        if (from_[t] != none) continue;
        from_[t] = reached_[next];
        reached_.push_back(t);
      }
    return {};
  }

  const Graph& graph_;
  std::vector<std::uint32_t> from_, reached_;
  std::size_t edges_ = 0;  // looked at
};

}  // namespace

std::vector<std::vector<std::uint32_t>> disjoint_cycles(const Graph& graph, const std::vector<std::uint32_t>& nodes) {
  const std::size_t enough = 4 * graph.values().size();
  CycleSearch search(graph);
  std::vector<std::vector<std::uint32_t>> cycles;
  for (const std::uint32_t node : nodes) {
    if (search.edges() > enough) break;
    if (search.is_blocked(node)) continue;
    std::vector<std::uint32_t> cycle = search.through(node);
    if (cycle.empty()) continue;
    search.block(cycle);
    cycles.push_back(std::move(cycle));
  }
  return cycles;
}

}  // namespace hsr::internal
