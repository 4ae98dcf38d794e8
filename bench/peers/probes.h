#pragma once

#include <cstddef>
#include <vector>

#include "bench/peers/peer.h"

namespace hsr::bench {

/// Places on the drawn edges of a mesh, spread evenly over their length in the image: a share of probes is a share of what is
/// drawn. The same for the same arguments.
std::vector<Probe> make_probes(const Mesh& mesh, const View& view, std::size_t count);

/// What is true at each probe, found without any of hsr's methods: every triangle is tried, in doubles. Where a probe lies
/// within 1e-9 of the picture's size from changing sides (beside a triangle's border, or in its plane), nobody is asked: none.
/// The triangles at the probe's own edge never hide it.
std::vector<Answer> truth(const Mesh& mesh, const View& view, const std::vector<Probe>& probes);

}  // namespace hsr::bench
