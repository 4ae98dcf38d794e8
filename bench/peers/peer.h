#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bench/seconds.h"
#include "geometry/mesh.h"
#include "hsr/model.h"
#include "hsr/view/view.h"

namespace hsr::bench {

/// A place on an edge at which everyone is asked: is it visible? t = 0 at edge.a, 1 at edge.b.
struct Probe {
  EdgeId edge;
  double t = 0;
};

enum class Answer : std::uint8_t { hidden, visible, none };

/// What everyone is given. Times do not include reading a file or writing one.
struct Task {
  const Model& model;
  const Mesh& mesh;  ///< of the model: what a peer is handed as points, triangles and edges
  const View& view;
  std::span<const Probe> probes;
};

struct Result {
  Elapsed prepare;  ///< a peer: the mesh turned into its structures, not counted against it; hsr: make_mesh, counted
  Elapsed compute;
  std::uint64_t visible = 0;    ///< segments, or pixels
  std::uint64_t hidden = 0;     ///< segments
  std::vector<Answer> answers;  ///< one for each probe; found after the clock has stopped
};

/// A part of an edge that is visible, t along the edge in space.
struct VisiblePart {
  EdgeId edge;
  double from = 0, to = 0;
};

/// The answers of one that returns visible parts: what no part covers is not drawn, hence hidden.
std::vector<Answer> answers_of(const std::vector<VisiblePart>& parts, const Task& task);

/// Blender's. @throws InputError where Blender is missing or fails
Result line_art(const Task& task);
bool has_line_art();  ///< Blender is there
Result z_buffer_1024(const Task& task);
Result z_buffer_4096(const Task& task);
Result occt_poly(const Task& task);
Result occt_poly_compound(const Task& task);
Result occt_exact(const Task& task);
Result hsr_all_edges(const Task& task);
Result hsr_outlines(const Task& task);

}  // namespace hsr::bench
