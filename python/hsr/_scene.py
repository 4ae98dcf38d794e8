"""What can be a scene, and how it becomes points and faces."""

import os

import numpy

from . import _core
from ._numbers import doubles, finite, indices

_CORNERS = {"line": 2, "triangle": 3, "quad": 4}


def scene_data(scene, chord=0):
    """A scene as the core has it: see `hsr.scene`."""
    if isinstance(scene, Scene):
        return scene._data
    if isinstance(scene, (str, os.PathLike)):
        return _core.read(os.fspath(scene), chord)
    if isinstance(scene, tuple):
        if len(scene) == 2:
            return _from_faces(scene[0], scene[1])
        if len(scene) == 3:
            return _from_offsets(*scene)
        raise _core.InputError(f"scene: found a tuple of {len(scene)}, expected (V, F) or (V, F, offsets)")
    if isinstance(scene, list):
        if not scene:
            raise _core.InputError("scene: found an empty list, expected scenes in it")
        return _core.joined([scene_data(part, chord) for part in scene])
    return _from_object(scene)


class Scene:
    """A scene that was read or converted once, for many questions: `hsr.scene(anything)`. Every function takes it.

    name, format: of the file, or "" and "arrays"; notes: what its reader passed over or repaired, a line each; points (n, 3)
    float64; faces: corners (c,) uint32 and offsets (f + 1,) uint32, face k has corners[offsets[k]:offsets[k + 1]].
    """

    __slots__ = ("_data",)

    def __init__(self, data):
        self._data = data

    @property
    def name(self):
        return self._data.name

    @property
    def format(self):
        return self._data.format

    @property
    def notes(self):
        return self._data.notes

    @property
    def objects(self):
        return self._data.objects

    @property
    def points(self):
        return self._data.arrays()[0]

    @property
    def faces(self):
        return self._data.arrays()[1:]

    def __repr__(self):
        points, _, offsets = self._data.arrays()
        name = self.name or self.format
        return f"<hsr.Scene {name}: {len(points)} points, {len(offsets) - 1} faces>"


def scene(scene, *, only=None, hide=None, ghost=None, chord=None, marks=None):
    """Reads or converts a scene once; what the functions of hsr take as `scene` is any of these.

    * the path of an OBJ, OFF, PLY, STL (each also .gz), glTF or GLB file; of STEP, IGES or 3MF where hsr is built with them
    * (V, F): V (n, 3) numbers, F (m, k) whole numbers, polygons of k corners; or a list of lists of corners
    * (V, F, offsets): F (c,) the corners of all polygons, polygon k has F[offsets[k]:offsets[k + 1]]
    * an object with .vertices and .faces, as trimesh has them
    * one with .points and .faces in VTK's padded form, [3, a, b, c, 4, d, e, f, g], as PyVista has them
    * one with .points and .cells, as meshio has them: lines, triangles, quads and polygons
    * a list of any of these: the parts become objects "0", "1", ... of one scene

    only, hide, ghost: names of objects, one or a list: no others are there; they are not; their lines are drawn, and they hide
    nothing. A ghost has no fragment, and no piece in an order. Faces keep their numbers.

    chord: of STEP and IGES, how far the triangles may be from the surfaces, in units of the model [a 20000th of its size]; marks: the path
    of a hsr-marks/1 file, of which faces are of one surface, and which edges are smooth, sharp or none.

    Floats widen exactly. Raises InputError (a ValueError) for what is no scene, and names the row of what is not finite.

    >>> scene(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    <hsr.Scene arrays: 3 points, 1 faces>
    """
    chord = 0 if chord is None else finite("chord", chord)
    if chord < 0:
        raise _core.InputError(f"chord: found {chord}, expected more than 0")
    data = scene_data(scene, chord)
    if marks is not None:
        data = _core.marked(data, os.fspath(marks))
    if only is None and hide is None and ghost is None:
        return Scene(data)
    return Scene(_core.selected(data, _names("only", only), _names("hide", hide), _names("ghost", ghost)))


def _names(option, names):
    names = [names] if isinstance(names, str) else list(names or [])
    for name in names:
        if not isinstance(name, str):
            raise _core.InputError(f"{option}: found {name!r}, expected the name of an object")
    return names


def _from_faces(points, faces):
    points = doubles("points", points)
    if isinstance(faces, numpy.ndarray) or not _is_ragged(faces):
        corners, shape = indices("faces", faces)
        if len(corners) == 0:
            return _build(points, corners, numpy.zeros(1, dtype=numpy.uint32))
        if len(shape) != 2:
            raise _core.InputError(f"faces: found an array of shape {shape}, expected (m, k), or offsets behind it")
        return _build(points, corners, numpy.arange(shape[0] + 1, dtype=numpy.uint64) * shape[1])
    rows = [indices(f"faces, row {k}", row)[0] for k, row in enumerate(faces)]
    offsets = numpy.cumsum([0] + [len(row) for row in rows])
    return _build(points, numpy.concatenate(rows), offsets)


def _is_ragged(faces):
    return len({len(row) for row in faces}) > 1


def _from_offsets(points, corners, offsets):
    corners, shape = indices("faces", corners)
    if len(shape) != 1:
        raise _core.InputError(f"faces: found an array of shape {shape}, expected (c,) where there are offsets")
    offsets, _ = indices("offsets", offsets)
    ascends = len(offsets) > 0 and offsets[0] == 0 and offsets[-1] == len(corners)
    if not ascends or (offsets[1:] < offsets[:-1]).any():
        raise _core.InputError(f"offsets: expected numbers that ascend from 0 to the {len(corners)} corners")
    return _build(doubles("points", points), corners, offsets)


def _from_object(scene):
    if hasattr(scene, "points") and hasattr(scene, "cells") and not isinstance(scene.cells, numpy.ndarray):
        return _from_cells(scene.points, scene.cells)
    if hasattr(scene, "points") and hasattr(scene, "faces"):
        return _from_padded(scene.points, scene.faces)
    if hasattr(scene, "vertices") and hasattr(scene, "faces"):
        return _from_faces(scene.vertices, scene.faces)
    raise _core.InputError(
        f"scene: found {type(scene).__name__}, expected a path, (V, F), (V, F, offsets), an object with .vertices and .faces, or "
        ".points and .cells or .faces, or a list of these"
    )


def _from_padded(points, faces):
    padded, shape = indices("faces", faces)
    if len(shape) == 2:  # of one size, [[3, a, b, c], ...], or without the count
        counts = padded[:: shape[1]] if shape[1] else padded
        if len(counts) == 0 or (counts != shape[1] - 1).any():
            return _from_faces(points, faces)
    corners, offsets, at = [], [0], 0
    while at < len(padded):
        n = int(padded[at])
        if at + 1 + n > len(padded):
            raise _core.InputError(f"faces, entry {at}: found {n} corners, expected no more than the {len(padded) - at - 1} left")
        corners.append(padded[at + 1 : at + 1 + n])
        offsets.append(offsets[-1] + n)
        at += 1 + n
    flat = numpy.concatenate(corners) if corners else numpy.zeros(0, dtype=numpy.uint32)
    return _build(doubles("points", points), flat, offsets)


def _from_cells(points, cells):
    blocks = list(cells.items()) if isinstance(cells, dict) else [_block(cell) for cell in cells]
    corners, offsets, wires = [], [0], []
    for kind, rows in blocks:
        kind = "polygon" if kind.startswith("polygon") else kind
        if kind == "vertex":
            continue
        if kind not in _CORNERS and kind != "polygon":
            raise _core.InputError(f'cells: found cells "{kind}", expected line, triangle, quad or polygon: the surface of solids')
        for row in rows:
            row, _ = indices(f"cells {kind}", row)
            if kind in _CORNERS and len(row) != _CORNERS[kind]:
                raise _core.InputError(f"cells {kind}: found {len(row)} corners, expected {_CORNERS[kind]}")
            if kind == "line":
                wires.append(row)
            else:
                corners.append(row)
                offsets.append(offsets[-1] + len(row))
    flat = numpy.concatenate(corners) if corners else numpy.zeros(0, dtype=numpy.uint32)
    return _build(doubles("points", points), flat, offsets, wires)


def _block(cell):
    return (cell.type, cell.data) if hasattr(cell, "type") else (cell[0], cell[1])


def _build(points, corners, offsets, wires=()):
    if len(corners) >= 2**32 - 1:
        raise _core.InputError(f"faces: found {len(corners)} corners, expected fewer than 2^32 - 1")
    wires = numpy.asarray(wires, dtype=numpy.uint32).reshape(-1, 2)
    for name, numbers in (("faces", corners), ("wires", wires.reshape(-1))):
        if numbers.size != 0 and numbers.max() >= len(points):
            k = int(numpy.argmax(numbers >= len(points)))
            raise _core.InputError(f"{name}, entry {k}: found {int(numbers[k])}, expected a number below the {len(points)} points")
    return _core.from_arrays(points, corners, numpy.asarray(offsets, dtype=numpy.uint32), wires)
