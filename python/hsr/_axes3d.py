"""What Axes3D holds and shows: the one file that touches private attributes of matplotlib (tested with 3.6)."""

import numpy
from matplotlib.colors import to_rgba
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
    kinds = (art3d.Poly3DCollection, art3d.Line3DCollection, art3d.Path3DCollection, art3d.Line3D)
    return isinstance(artist, kinds) and artist.get_visible()


def polygons_of(artist):
    """Polygons of a Poly3DCollection: points, face colour, edge colour, line width, each."""
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


def segments_of(artist):
    """Segments of lines: both ends (2, 3), colour, line width, each."""
    if isinstance(artist, art3d.Line3D):
        points = numpy.array([numpy.ma.filled(numpy.ma.asarray(x, dtype=float), numpy.nan) for x in artist.get_data_3d()]).T
        colour = to_rgba(artist.get_color(), artist.get_alpha())
        if artist.get_linestyle() not in ("None", "", " "):
            for ends in zip(points, points[1:]):
                yield numpy.array(ends), colour, artist.get_linewidth()
    elif isinstance(artist, art3d.Line3DCollection):
        if artist.get_array() is not None:
            artist.update_scalarmappable()
        colours, widths = artist._edgecolors, artist.get_linewidth()
        for k, line in enumerate(artist._segments3d):
            line = numpy.asarray(line, dtype=float)
            for ends in zip(line, line[1:]):
                yield numpy.array(ends), _cycled(colours, k), widths[k % len(widths)]


def markers_of(artist):
    """Markers of a scatter: point (3,), path, size in square points, face colour, edge colour, line width, each."""
    if not isinstance(artist, art3d.Path3DCollection):
        return
    if artist.get_array() is not None:
        artist.update_scalarmappable()
    points = numpy.array([numpy.ma.filled(numpy.ma.asarray(x, dtype=float), numpy.nan) for x in artist._offsets3d]).T
    paths, sizes, widths = artist.get_paths(), artist._sizes3d, artist._linewidths3d
    for k, point in enumerate(points):
        edge = artist._facecolors if isinstance(artist._edgecolors, str) else artist._edgecolors
        size, width = sizes[k % len(sizes)], widths[k % len(widths)]
        yield point, paths[k % len(paths)], size, _cycled(artist._facecolors, k), _cycled(edge, k), width


def _cycled(colours, k):
    """The colour of the k-th thing; transparent where there is none."""
    return tuple(colours[k % len(colours)]) if len(colours) else (0.0, 0.0, 0.0, 0.0)
