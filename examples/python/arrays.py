"""Prints the hidden parts of the edges of a floor under a roof, from two arrays."""

import numpy

import hsr

points = numpy.array([[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0], [1, -1, 1], [2, -1, 1], [2, 3, 1], [1, 3, 1]])
lines = hsr.visible_lines((points, [[0, 1, 2, 3], [4, 5, 6, 7]]), "top")
for i in numpy.flatnonzero(~lines.visible):
    print(f"edge {lines.edge[i]}: hidden from {lines.exact(i)[0]} to {lines.exact(i)[1]} by faces {lines.occluders(i)}")
