#include <algorithm>

#include "bench/peers/peer.h"

namespace hsr::bench {

std::vector<Answer> answers_of(const std::vector<VisiblePart>& parts, const Task& task) {
  // Probes ascend by edge.
  std::vector<Answer> answers(task.probes.size(), Answer::hidden);
  for (const VisiblePart& part : parts) {
    const auto first = std::lower_bound(task.probes.begin(), task.probes.end(), part.edge,
                                        [](const Probe& probe, EdgeId edge) { return probe.edge < edge; });
    for (auto probe = first; probe != task.probes.end() && probe->edge == part.edge; ++probe)
      if (std::min(part.from, part.to) <= probe->t && probe->t <= std::max(part.from, part.to))
        answers[static_cast<std::size_t>(probe - task.probes.begin())] = Answer::visible;
  }
  return answers;
}

}  // namespace hsr::bench
