"""What Axes3D holds and shows: the one file that touches private attributes of matplotlib (tested with 3.6)."""

import numpy
from matplotlib.colors import to_rgba
from matplotlib.path import Path
from mpl_toolkits.mplot3d import art3d


def viewpoint(matrix):
    """The eye of a projection (4, 4) in data coordinates, (point, None), or of a parallel one (None, direction to the viewer).

    The eye is what the rows x, y and w of the matrix make nothing of; farther is a greater depth.
    """
    if numpy.allclose(matrix[3, :3], 0, atol=1e-12 * abs(matrix).max()):
        toward = numpy.cross(matrix[0, :3], matrix[1, :3])
        depth = matrix[2, :3] @ toward / matrix[3, 3]
        return None, -toward * numpy.sign(depth)
    return numpy.linalg.solve(matrix[[0, 1, 3], :3], -matrix[[0, 1, 3], 3]), None


def projected(matrix, points):
    """The image of points (n, 3) in the 2-D data coordinates of the Axes, (n, 2)."""
    homogeneous = points @ matrix[:, :3].T + matrix[:, 3]
    return homogeneous[:, :2] / homogeneous[:, 3:]


def is_ours(artist):
    """Whether it is of a kind that can be put in order."""
    kinds = (art3d.Poly3DCollection, art3d.Line3DCollection, art3d.Path3DCollection, art3d.Line3D, art3d.Patch3D, art3d.Text3D)
    return isinstance(artist, kinds) and artist.get_visible()


def polygons_of(artist):
    """Polygons of a Poly3DCollection or a patch: points, face colour, edge colour, line width, each."""
    if isinstance(artist, art3d.Patch3D):
        yield _outline(artist), artist.get_facecolor(), artist.get_edgecolor(), artist.get_linewidth()
    if not isinstance(artist, art3d.Poly3DCollection):
        return
    points = artist._vec[:3].T
    face, edge = artist._facecolor3d, artist._edgecolor3d
    if artist.get_array() is not None:
        artist.update_scalarmappable()
        face = artist._facecolors if artist._face_is_mapped else face
        edge = artist._edgecolors if artist._edge_is_mapped else edge
    widths = artist.get_linewidth()
    for k, corners in enumerate(artist._segslices):
        yield points[corners], _cycled(face, k), _cycled(edge, k), widths[k % len(widths)]


def _outline(patch):
    """The corners of a patch, (n, 3); curves as sixteen sides each."""
    points = numpy.array(patch._segment3d, dtype=float).reshape(-1, 3)
    codes = getattr(patch, "_code3d", None)
    if codes is None:
        return points
    corners, k = [], 0
    t = numpy.linspace(0, 1, 17)[1:, None]
    while k < len(points):
        code = codes[k]
        if code == Path.CURVE3:
            a, b, c = corners[-1], points[k], points[k + 1]
            corners += list((1 - t) ** 2 * a + 2 * t * (1 - t) * b + t**2 * c)
        elif code == Path.CURVE4:
            a, b, c, d = corners[-1], points[k], points[k + 1], points[k + 2]
            corners += list((1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t**2 * (1 - t) * c + t**3 * d)
        elif code in (Path.MOVETO, Path.LINETO):
            corners.append(points[k])
        k += {Path.CURVE3: 2, Path.CURVE4: 3}.get(code, 1)
    return numpy.array(corners)


def lines_of(artist):
    """Polylines: points (k, 3), colour, line width, dashes in points (offset, lengths or None), each."""
    if isinstance(artist, art3d.Line3D):
        if artist.get_linestyle() not in ("None", "", " "):
            yield _points_of(artist.get_data_3d()), to_rgba(artist.get_color(), artist.get_alpha()), artist.get_linewidth(), artist._dash_pattern
    elif isinstance(artist, art3d.Line3DCollection):
        if artist.get_array() is not None:
            artist.update_scalarmappable()
        colours, widths, dashes = artist._edgecolors, artist.get_linewidth(), artist._linestyles
        for k, line in enumerate(artist._segments3d):
            yield numpy.asarray(line, dtype=float).reshape(-1, 3), _cycled(colours, k), widths[k % len(widths)], dashes[k % len(dashes)]


def markers_of(artist):
    """Markers of a scatter or a plot: point (3,), path, size in square points, face colour, edge colour, line width, each."""
    if isinstance(artist, art3d.Line3D) and artist.get_marker() not in ("None", "", " ", None):
        marker, alpha = artist._marker, artist.get_alpha()
        path = marker.get_path().transformed(marker.get_transform())
        face = to_rgba(artist.get_markerfacecolor(), alpha) if marker.is_filled() else (0.0, 0.0, 0.0, 0.0)
        edge = to_rgba(artist.get_markeredgecolor(), alpha)
        for point in _every(_points_of(artist.get_data_3d()), artist.get_markevery()):
            yield point, path, artist.get_markersize() ** 2, face, edge, artist.get_markeredgewidth()
    if not isinstance(artist, art3d.Path3DCollection):
        return
    if artist.get_array() is not None:
        artist.update_scalarmappable()
    points = _points_of(artist._offsets3d)
    paths, sizes, widths = artist.get_paths(), artist._sizes3d, artist._linewidths3d
    for k, point in enumerate(points):
        edge = artist._facecolors if isinstance(artist._edgecolors, str) else artist._edgecolors
        size, width = sizes[k % len(sizes)], widths[k % len(widths)]
        yield point, paths[k % len(paths)], size, _cycled(artist._facecolors, k), _cycled(edge, k), width


def text_of(artist):
    """Where a text is (3,), or None."""
    return numpy.array(artist.get_position_3d(), dtype=float) if isinstance(artist, art3d.Text3D) else None


def draw_text(artist, renderer):
    """Draws a text that is not shown by itself."""
    artist._visible = True
    try:
        artist.draw(renderer)
    finally:
        artist._visible = False


def _points_of(coordinates):
    """(n, 3) of three arrays; what is masked is nan."""
    return numpy.array([numpy.ma.filled(numpy.ma.asarray(x, dtype=float), numpy.nan) for x in coordinates]).T


def _every(points, markevery):
    """The points that have markers; where they are chosen by their distance in the figure all have."""
    if isinstance(markevery, int):
        return points[::markevery]
    if isinstance(markevery, tuple) and all(isinstance(n, int) for n in markevery):
        return points[markevery[0] :: markevery[1]]
    if markevery is None or isinstance(markevery, (float, tuple)):
        return points
    return points[markevery]


def _cycled(colours, k):
    """The colour of the k-th thing; transparent where there is none."""
    return tuple(colours[k % len(colours)]) if len(colours) else (0.0, 0.0, 0.0, 0.0)
