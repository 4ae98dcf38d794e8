#include "hsr/painter/components.h"

#include <algorithm>

namespace hsr {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

}  // namespace

std::vector<std::uint32_t> topological_order(const Graph& graph) {
  std::vector<std::uint32_t> before(graph.size(), 0), order;
  for (const std::uint32_t t : graph.targets) ++before[t];
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    if (before[i] == 0) order.push_back(i);
  for (std::size_t next = 0; next < order.size(); ++next)
    for (const std::uint32_t t : graph[order[next]])
      if (--before[t] == 0) order.push_back(t);
  return order;
}

std::vector<std::vector<std::uint32_t>> cyclic_components(const Graph& graph) {
  struct Visit {
    std::uint32_t node, edge;
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
    path.push_back({node, graph.first[node]});
  };
  for (std::uint32_t root = 0; root < graph.size(); ++root) {
    if (index[root] != none) continue;
    enter(root);
    while (!path.empty()) {
      const std::uint32_t node = path.back().node;
      if (path.back().edge < graph.first[node + 1]) {
        const std::uint32_t target = graph.targets[path.back().edge++];
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

std::vector<std::uint32_t> shortest_cycle(const Graph& graph, std::uint32_t node) {
  std::vector<std::uint32_t> from(graph.size(), none), reached = {node};
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (const std::uint32_t t : graph[reached[next]]) {
      if (t == node) {
        std::vector<std::uint32_t> cycle = {reached[next]};
        while (cycle.back() != node) cycle.push_back(from[cycle.back()]);
        std::reverse(cycle.begin(), cycle.end());
        return cycle;
      }
      if (from[t] != none) continue;
      from[t] = reached[next];
      reached.push_back(t);
    }
  return {};
}

}  // namespace hsr
