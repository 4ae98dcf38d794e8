"""Projections as CAD programs ask for them: a viewport with an origin, an up and a point looked at."""

import numpy

from . import _core
from ._arguments import arguments
from ._numbers import doubles, finite
from ._results import Drawing
from ._scene import scene
from ._view import View


def project_to_viewport(
    shape_mesh,
    viewport_origin,
    viewport_up=(0, 0, 1),
    look_at=None,
    focus=None,
    *,
    edges=None,
    crease=None,
    tolerance=None,
    coplanar=None,
    threads=None,
    progress=None,
):
    """Projects a shape onto a viewport: (visible, hidden), two lists of polylines, (k, 2) arrays, as `project_to_viewport` of
    build123d does with its edges.

    shape_mesh: any scene, such as (V, F); viewport_origin: where the viewport is, (x, y, z); viewport_up: the direction of its y axis
    look_at: the point that it looks at [the centre of mass: of the body if the faces close one, else of the surface]
    focus: perspective from the point this far behind the viewport, in whose plane lengths are true [parallel]. What is less than a
    thousandth of that in front of the eye, or behind it, is not there
    edges, crease, tolerance, coplanar, threads, progress: see the module

    Coordinates are those of the viewport, x to the right and y up from its origin, in units of the scene, rounded once to a power of
    ten below a millionth of the drawing. No line is drawn twice: what coincides with a visible line is not among the hidden ones. Parts
    of one class are joined; a closed polyline ends where it begins. What is visible is decided exactly, for the eye or the direction
    in doubles. Raises InputError.

    >>> cube = ([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
    ...         [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    >>> visible, hidden = project_to_viewport(cube, (0.5, -5, 0.5))
    >>> visible[0].tolist(), hidden
    ([[-0.5, 0.5], [-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]], [])
    """
    shape = scene(shape_mesh)
    origin = doubles("viewport_origin", [viewport_origin])[0]
    at = centre_of_mass(*_merged(shape)) if look_at is None else doubles("look_at", [look_at])[0]
    toward = origin - at
    if not toward.any():
        raise _core.InputError("viewport_origin: found the point looked at itself, expected another")
    up = doubles("viewport_up", [viewport_up])[0]
    if focus:
        if not finite("focus", focus) > 0:
            raise _core.InputError(f"focus: found {focus}, expected a length above 0")
        eye = origin + finite("focus", focus) * (toward / numpy.linalg.norm(toward))
        view = View.perspective(eye, target=origin, up=up)
    else:
        view = View.parallel(toward, target=origin, up=up)
    named = arguments(
        view,
        threads=threads,
        progress=progress,
        edges=edges,
        crease=crease,
        tolerance=tolerance,
        coplanar=coplanar,
        hidden="solid",
        in_frame_units=True,
    )
    try:
        lines = Drawing(_core.draw(shape._data, named)).polylines()
    except _core.InputError as refused:
        raise _core.InputError(("viewport_" if str(refused).startswith("up:") else "") + str(refused)) from None
    return [points for points, hidden, _ in lines if not hidden], [points for points, hidden, _ in lines if hidden]


def _merged(shape):
    """The points, each once, and the triangles that the faces are as fans, by their numbers."""
    points, number = numpy.unique(shape.points, axis=0, return_inverse=True)
    corners, offsets = (numpy.asarray(a, dtype=numpy.int64) for a in shape.faces)
    counts = numpy.diff(offsets)
    fans = numpy.maximum(counts - 2, 0)
    of_face, first_of_face = numpy.repeat(numpy.arange(len(fans)), fans), numpy.cumsum(fans) - fans
    second = offsets[of_face] + 1 + numpy.arange(len(of_face)) - first_of_face[of_face]
    triangles = corners[numpy.stack([offsets[of_face], second, second + 1], axis=1)]
    return points, number.reshape(-1)[triangles]


def centre_of_mass(points, triangles):
    """Of the body that the triangles bound, if each side has one of the other way round; else of the surface; else of the points."""
    if len(points) == 0:
        return numpy.zeros(3)
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    if len(triangles) == 0:
        return middle
    a, b, c = (points[triangles[:, k]] - middle for k in range(3))
    sides = numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    codes = sides[:, 0] * len(points) + sides[:, 1]
    opposite = sides[:, 1] * len(points) + sides[:, 0]
    volumes = numpy.einsum("ij,ij->i", a, numpy.cross(b, c))
    if numpy.array_equal(numpy.sort(codes), numpy.sort(opposite)) and volumes.sum() != 0:
        return middle + ((a + b + c) * volumes[:, None]).sum(axis=0) / (4 * volumes.sum())
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
    return middle + ((a + b + c) * areas[:, None]).sum(axis=0) / (3 * areas.sum()) if areas.sum() > 0 else middle
