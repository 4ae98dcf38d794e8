#pragma once

#include <cstddef>
#include <string>

#include "hsr/model.h"

namespace hsr::bench {

/// The scenes of the benchmarks. The same bits on every platform: own generator, own sine, only IEEE operations.
///
///   (1) coordinates are float32 values, as in real files; those of `city` are integers
///   (2) knot, city and terrain have shared vertices, as a welded file has; of crossing triangles each has its own three
///   (3) about as many triangles as asked for: within 2 % from 1000 triangles on

/// A tube along the torus knot (2, 3): closed, every face generic, about 5 layers deep.
Model knot(std::size_t triangles);

/// Axis-aligned boxes of 12 triangles and random height, in a square grid of lots, all standing on z = 0.
Model city(std::size_t boxes);

/// Equilateral triangles of random orientation in the unit cube, that pierce one another and are as large as makes about 8
/// layers everywhere in a straight view, for every n.
Model crossing_triangles(std::size_t triangles);

/// A height field over an integer grid: value noise of as many octaves as the grid has, so that it is rough at every scale.
Model terrain(std::size_t triangles);

/// A plate with a square grid of round holes of 16 corners. Top and bottom are one polygon each: bridges, which the polygon runs
/// along twice, join the holes of each row, the first holes of the rows, and one corner of the plate. @pre full rows
Model plate(std::size_t holes);

/// The same plate of quads: 16 around each hole, to the border of its cell.
Model quad_plate(std::size_t holes);

/// A scene by its name: knot, city, rand, terrain, plate or quadplate, and a size such as 500, 10k or 1M (of a city: boxes; of
/// plates: holes, a square number).
/// @throws InputError for another name
Model scene(const std::string& name);

/// The name of a scene without its size.
std::string family(const std::string& scene);

}  // namespace hsr::bench
