"""3-D plots of matplotlib in the right order, and line drawings in 2-D axes.

    ax.plot_surface(...); ax.bar3d(...); ax.plot(...)
    hsr.matplotlib.fix(ax)

Matplotlib sorts whole polygons, and whole artists, by one depth each: what crosses or overlaps in turn comes out wrong. `fix` cuts the
polygons where they must be cut, once, and paints the pieces from far to near in whatever view the plot is turned to.
"""

import numpy
from matplotlib.artist import Artist
from matplotlib.collections import LineCollection
from matplotlib.path import Path
from matplotlib.transforms import Affine2D

from . import _axes3d
from . import order as _order
from . import scene as _scene
from . import tree as _tree
from ._core import InputError
from ._results import VisibleLines
from ._view import View

__all__ = ["OrderedArtist", "draw", "fix"]

# Lines and markers get this width in space, of the box of all: nearer to a face than this they are seen on it.
_WIDTH = 1e-6


def fix(ax):
    """Replaces what is plotted in an Axes3D by one artist that paints it in the right order: an `OrderedArtist`.

    Surfaces, trisurf, bar3d, voxels, Poly3DCollection, patches, plot, wireframes, quiver, contours, stem, scatters and texts keep their
    colours, colour maps, alpha, edge colours and dashes as they are now; what is plotted later is not in it. The plot may be turned
    and zoomed. A marker or a text is behind what its point is behind. The old artists stay in the Axes and are not shown;
    `OrderedArtist.undo` shows them again.

    Raises InputError if nothing of these is in the Axes, or beyond a million pieces, or 64 a face.
    """
    if not hasattr(ax, "get_proj"):
        raise InputError(f"ax: found {type(ax).__name__}, expected an Axes3D")
    artists = [artist for artist in ax.get_children() if _axes3d.is_ours(artist)]
    ordered = OrderedArtist(artists)
    ax.add_artist(ordered)
    for artist in artists:
        artist.set_visible(False)
    return ordered


def draw(ax, lines, *, visible=True, hidden=True, **style):
    """Puts a line drawing, a `VisibleLines`, into 2-D axes, in units of the scene: a list of LineCollections.

    visible, hidden: which parts; hidden ones are thin and dashed. style: of LineCollection, such as colors and linewidths.
    """
    if not isinstance(lines, VisibleLines):
        raise InputError(f"lines: found {type(lines).__name__}, expected what hsr.visible_lines gives")
    added = []
    if hidden:
        dashed = {"colors": "0.5", "linewidths": 0.5, "linestyles": (0, (6, 4)), **style}
        added.append(LineCollection(lines.polylines(visible=False), **dashed))
    if visible:
        added.append(LineCollection(lines.polylines(), **{"colors": "black", "linewidths": 1, "capstyle": "round", **style}))
    for collection in added:
        ax.add_collection(collection)
    ax.set_aspect("equal")
    ax.autoscale_view()
    return added


class _Polygon:
    """A face, painted with its edges."""

    is_whole = False  # whether it is painted once, with the last of its pieces, or piece by piece

    def __init__(self, face, edge, width):
        self.face, self.edge, self.width = face, edge, width

    def paint(self, pen, corners, original, image):
        if self.face[3] > 0:
            # What meets in a side would leave a seam, through which shows what is behind: opaque pieces go under it.
            pen.polygon(image(corners), self.face, pen.seam if self.face[3] == 1 else 0)
        if self.edge[3] > 0 and self.width > 0 and original.any():
            ends = image(numpy.concatenate([corners, corners[:1]]))
            pen.sides([ends[k : k + 2] for k in numpy.flatnonzero(original)], self.edge, self.width)


class _Line:
    """A polyline, whose segments are painted each in its turn; dashes go on from one to the next."""

    def __init__(self, points, colour, width, dashes):
        self.points, self.colour, self.width = points, colour, width
        self.dash_offset, self.dashes = dashes

    def lengths_before(self, image):
        """Of each segment how long the line is before it, in pixels; what is not finite has no length."""
        steps = numpy.linalg.norm(numpy.diff(image(self.points), axis=0), axis=1)
        return numpy.concatenate([[0], numpy.cumsum(numpy.nan_to_num(steps, nan=0, posinf=0))])


class _Segment:
    """A part of a line, in the scene as strips of hardly any width: the one that faces the viewer more stands for it."""

    is_whole = False

    def __init__(self, line, number):
        self.line, self.number, self.ends = line, number, line.points[number : number + 2]

    def paint(self, pen, corners, original, image):
        along = self.ends[1] - self.ends[0]
        t = ((corners - self.ends[0]) @ along) / (along @ along)
        t = numpy.clip([t.min(), t.max()], 0, 1)
        piece = image(self.ends[0] + t[:, None] * along)
        if not self.line.dashes:
            pen.sides([piece], self.line.colour, self.line.width)
            return
        before = pen.lengths_before(self.line, image)[self.number] + numpy.linalg.norm(piece[0] - image(self.ends[:1])[0])
        pen.dashed(piece, self.line, before)


class _Text:
    """A text, in the scene as triangles of hardly any size at its point."""

    is_whole = True

    def __init__(self, artist):
        self.artist = artist

    def paint(self, pen, corners, original, image):
        _axes3d.draw_text(self.artist, pen.renderer)


class _Marker:
    """A marker of a scatter or a plot, in the scene as triangles of hardly any size."""

    is_whole = True

    def __init__(self, point, path, size, face, edge, width):
        self.point, self.path, self.size, self.face, self.edge, self.width = point, path, size, face, edge, width

    def paint(self, pen, corners, original, image):
        pen.marker(self.path, image(self.point[None])[0], self.size, self.face, self.edge, self.width)


class _Pen:
    """Paints in pixels."""

    def __init__(self, renderer, clip):
        self.renderer, self.clip = renderer, clip
        self._lengths = {}
        pixels = renderer.points_to_pixels(1)
        self.seam = 1 / pixels if pixels > 1 else 0.5  # points: a pixel, or what a viewer's pixel may be

    def lengths_before(self, line, image):
        if line not in self._lengths:
            self._lengths[line] = line.lengths_before(image)
        return self._lengths[line]

    def _path(self, path, transform, face, edge, points, capstyle="round", dashes=(0, None)):
        gc = self.renderer.new_gc()
        self.clip(gc)
        gc.set_dashes(*dashes)
        gc.set_foreground(edge, isRGBA=True)
        gc.set_linewidth(points)
        gc.set_joinstyle("round")
        gc.set_capstyle(capstyle)
        self.renderer.draw_path(gc, path, transform, face)
        gc.restore()

    def polygon(self, corners, face, points):
        path = Path(numpy.concatenate([corners, corners[:1]]), closed=True)
        self._path(path, Affine2D(), face, face if points else (0, 0, 0, 0), points)

    def sides(self, sides, colour, points):
        codes = [Path.MOVETO, Path.LINETO] * len(sides)
        self._path(Path(numpy.concatenate(sides), codes), Affine2D(), None, colour, points)

    def dashed(self, piece, line, pixels_before):
        offset = line.dash_offset + pixels_before / self.renderer.points_to_pixels(1)
        self._path(Path(piece), Affine2D(), None, line.colour, line.width, "butt", (offset, line.dashes))

    def marker(self, path, at, size, face, edge, points):
        scale = self.renderer.points_to_pixels(numpy.sqrt(size))
        self._path(path, Affine2D().scale(scale).translate(*at), face if face[3] > 0 else None, edge, points, "butt")


class OrderedArtist(Artist):
    """What is plotted in an Axes3D, painted from far to near: pieces of faces, lines and markers.

    The tree of planes is built when it is made, and asked once for each view.
    """

    def __init__(self, artists):
        super().__init__()
        self._replaced = artists
        self._things = []
        self._corners, self._of_thing = [], []
        self._normals = []
        for artist in artists:
            for corners, face, edge, width in _axes3d.polygons_of(artist):
                if len(corners) > 2 and numpy.isfinite(corners).all():
                    self._add(_Polygon(face, edge, width), [(corners, None)])
        self._add_lines_and_markers(artists)
        if not self._corners:
            raise InputError("ax: found nothing in it that has an order in depth")
        offsets = numpy.cumsum([0] + [len(corners) for corners in self._corners])
        self._scene = _scene((numpy.concatenate(self._corners), numpy.arange(offsets[-1]), offsets))
        self._tree = _tree(self._scene)
        self._order, self._matrix = None, None

    def undo(self):
        """Shows again what this artist has replaced, and takes itself out."""
        for artist in self._replaced:
            artist.set_visible(True)
        self.remove()

    def order(self, matrix):
        """The pieces from far to near in the view of a projection (4, 4): an `Order`; face k of it is the k-th of the scene."""
        if self._order is None or not numpy.array_equal(matrix, self._matrix):
            self._order, self._matrix = _order(self._tree, self._view(matrix), coplanar="last"), matrix.copy()
        return self._order

    def draw(self, renderer):
        if not self.get_visible():
            return
        matrix = self.axes.get_proj()
        order = self.order(matrix)
        transform = self.axes.transData

        def image(points):
            return transform.transform(_axes3d.projected(matrix, points))

        pen = _Pen(renderer, self._set_gc_clip)
        shown = self._shown(matrix)
        offsets = order.offsets
        last = dict(zip(order.face.tolist(), range(len(order))))
        for k, face in enumerate(order.face.tolist()):
            thing = self._things[self._of_thing[face]]
            if shown[face] and (not thing.is_whole or last[face] == k):
                part = slice(offsets[k], offsets[k + 1])
                thing.paint(pen, order.points[part], order.original[part], image)
        self.stale = False

    def _add(self, thing, faces):
        """A thing with its faces and, where it has several of which one is shown, their normals."""
        for corners, normal in faces:
            self._corners.append(numpy.asarray(corners, dtype=float))
            self._normals.append(normal)
            self._of_thing.append(len(self._things))
        self._things.append(thing)

    def _add_lines_and_markers(self, artists):
        lines = [_Line(*line) for a in artists for line in _axes3d.lines_of(a)]
        segments = [_Segment(line, k) for line in lines for k in range(len(line.points) - 1)]
        segments = [s for s in segments if numpy.isfinite(s.ends).all() and (s.ends[0] != s.ends[1]).any()]
        marks = [(m[0], _Marker(*m)) for a in artists for m in _axes3d.markers_of(a)]
        marks += [(_axes3d.text_of(a), _Text(a)) for a in artists if _axes3d.text_of(a) is not None]
        marks = [(point, mark) for point, mark in marks if numpy.isfinite(point).all()]
        points = numpy.concatenate(self._corners + [s.ends for s in segments] + [m[0][None] for m in marks] or [numpy.zeros((1, 3))])
        size = points.max(axis=0) - points.min(axis=0)
        size[size == 0] = size.max() or 1
        for segment in segments:
            self._add(segment, _strips(segment.ends, (segment.ends[1] - segment.ends[0]) / size, size))
        for point, mark in marks:
            self._add(mark, _triangles(point, size))

    def _view(self, matrix):
        eye, direction = _axes3d.viewpoint(matrix)
        if eye is None:
            return View.parallel(direction)
        points = self._scene.points
        return View.perspective(eye, target=(points.max(axis=0) + points.min(axis=0)) / 2)

    def _shown(self, matrix):
        """Of each face whether it stands for its thing: of several faces the one that is turned to the viewer most."""
        eye, direction = _axes3d.viewpoint(matrix)
        best = {}
        shown = numpy.ones(len(self._corners), dtype=bool)
        for k, normal in enumerate(self._normals):
            if normal is None:
                continue
            toward = direction if eye is None else eye - self._corners[k][0]
            facing = abs(normal @ toward)
            thing = self._of_thing[k]
            if thing in best and best[thing][0] >= facing:
                shown[k] = False
                continue
            if thing in best:
                shown[best[thing][1]] = False
            best[thing] = (facing, k)
        return shown


def _strips(ends, along, size):
    """Two strips along a segment, square to each other in the unit box, and the normals of their planes."""
    first = numpy.cross(along, numpy.eye(3)[numpy.argmin(abs(along))])
    second = numpy.cross(along, first)
    strips = []
    for across in (first, second):
        across = across / numpy.linalg.norm(across)
        offset = across * size * _WIDTH
        corners = [ends[0] - offset, ends[0] + offset, ends[1] + offset, ends[1] - offset]
        normal = numpy.cross(along, across) / numpy.linalg.norm(along) / size
        strips.append((corners, normal))
    return strips


def _triangles(point, size):
    """Three triangles around a point, square to the axes, and their normals."""
    triangles = []
    for axis in range(3):
        u, v = numpy.eye(3)[axis - 2] * size * _WIDTH, numpy.eye(3)[axis - 1] * size * _WIDTH
        triangles.append(([point - u - v, point + u - v, point + v], numpy.eye(3)[axis] / size))
    return triangles
