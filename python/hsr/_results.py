"""Results: arrays, and what can be asked of them."""

from fractions import Fraction

import numpy

from . import _core
from ._arguments import arguments, paths
from ._numbers import count

CLASS_NAMES = _core.edge_class_names


class VisibleLines:
    """The visible and the hidden parts of edges, n of them, in the order of the edges and along each.

    edge (n, 2) int64: the points a < b that the edge runs between; -1, -1: where two faces pierce each other
    edge_class (n,) uint8: a number into `class_names`
    faces (m,), faces_offsets (n + 1,) int64: part i is at faces[faces_offsets[i]:faces_offsets[i + 1]], ascending
    t (n, 2) float64: where the part begins and ends along its edge, 0 at a and 1 at b
    visible (n,) bool; behind (n,) bool: hidden by what it touches
    points (n, 2, 3) float64: the ends in space, in the scene's units
    image (n, 2, 2) float64: the ends in the view, x to the right and y up, in the scene's units, from the point looked at
    line (n,) int64: the number of the edge, or part of an edge of one class, that it is of

    Numbers are correctly rounded, once; `exact` and `exact_points` have them as Fractions.
    """

    __slots__ = ("_data", "edge", "edge_class", "faces", "faces_offsets", "t", "visible", "behind", "points", "image", "line")
    class_names = CLASS_NAMES

    def __init__(self, data):
        self._data = data
        for name, array in data.arrays().items():
            setattr(self, name, array)

    def __len__(self):
        return len(self.visible)

    def __repr__(self):
        return f"<hsr.VisibleLines: {int(self.visible.sum())} visible parts, {int((~self.visible).sum())} hidden>"

    def occluders(self, i):
        """The faces that hide part i, (k,) int64, ascending; of a visible part none."""
        return self._data.occluders(_place(i, len(self)))

    def exact(self, i):
        """The parameters of part i, exactly: two Fractions."""
        return tuple(Fraction(self._data.exact_end(_place(i, len(self)), end)[3]) for end in (0, 1))

    def exact_points(self, i):
        """The ends of part i in space, exactly: two triples of Fractions."""
        ends = (self._data.exact_end(_place(i, len(self)), end)[:3] for end in (0, 1))
        return tuple(tuple(Fraction(x) for x in end) for end in ends)

    def polylines(self, visible=True, join=True):
        """The visible parts, or the hidden ones, in the image: a list of (k, 2) arrays.

        join: parts of one class are joined where the ends of exactly two of them coincide; a closed one ends where it begins.
        """
        chosen = numpy.flatnonzero(self.visible == bool(visible))
        if not join:
            return [self.image[i] for i in chosen]
        lines = []
        for edge_class in numpy.unique(self.edge_class[chosen]):
            lines += _joined(self.image[chosen[self.edge_class[chosen] == edge_class]])
        return lines

    def json(self, exact=False):
        """The lines as the command writes them, "hsr-lines/1"."""
        return self._data.json(bool(exact))


def _place(i, n):
    i = count("part", i)
    if not 0 <= i < n:
        raise IndexError(f"part {i}: expected a number from 0 to {n - 1}")
    return i


def _joined(segments):
    """Chains of segments (n, 2, 2); through points where exactly two ends are."""
    ends = {}
    for i, segment in enumerate(segments):
        for end in (0, 1):
            ends.setdefault(tuple(segment[end]), []).append((i, end))
    used = numpy.zeros(len(segments), dtype=bool)

    def follow(i, end):
        """The points from segment i on, which is left at its end `end`."""
        points = [segments[i][1 - end], segments[i][end]]
        used[i] = True
        while True:
            there = ends[tuple(points[-1])]
            ahead = [(k, e) for k, e in there if not used[k]]
            if len(there) != 2 or not ahead:
                return points
            i, end = ahead[0][0], 1 - ahead[0][1]
            used[i] = True
            points.append(segments[i][end])

    chains = []
    for begins_at_end in (True, False):  # first those that begin where a chain must, then the rings that are left
        for i, segment in enumerate(segments):
            for end in (0, 1):
                if not used[i] and (not begins_at_end or len(ends[tuple(segment[1 - end])]) != 2):
                    chains.append(numpy.array(follow(i, end)))
    return chains


class Fragments:
    """The visible parts of faces, n polygons with holes.

    face (n,) int64: whose part it is; area (n,) float64: in the image
    ring_offsets (n + 1,), offsets (r + 1,) int64: fragment i has the rings ring_offsets[i] to ring_offsets[i + 1] - 1, the outer one
    first, counter-clockwise as seen, then the holes, clockwise; ring k has the corners offsets[k] to offsets[k + 1] - 1
    points (p, 3), image (p, 2) float64: the corners in space and in the view, in the scene's units, correctly rounded
    """

    __slots__ = ("face", "area", "ring_offsets", "offsets", "points", "image")

    def __init__(self, arrays):
        for name, array in arrays.items():
            setattr(self, name, array)

    def __len__(self):
        return len(self.face)

    def __repr__(self):
        return f"<hsr.Fragments: {len(self)} of {len(numpy.unique(self.face))} faces>"

    def polygons(self):
        """Of each fragment its rings in the image, a list of (k, 2) arrays; shapely's Polygon(rings[0], rings[1:]) takes them."""
        rings = [self.image[a:b] for a, b in zip(self.offsets, self.offsets[1:])]
        return [rings[a:b] for a, b in zip(self.ring_offsets, self.ring_offsets[1:])]


class Section:
    """What a section cuts closed bodies to, n caps: polygons with holes in the plane, one for each object and plane.

    object (n,) int64: whose cap it is, in the order of the scene's objects; face (n,) int64: the lowest of its faces that are cut
    plane (n,) int64: of several planes, in which it lies
    ring_offsets (n + 1,), offsets (r + 1,), points (p, 3), image (p, 2): as those of `Fragments`, from any corner of each ring
    open_outlines: how many connected outlines of the cut do not close, and so bound nothing
    """

    __slots__ = ("object", "face", "plane", "ring_offsets", "offsets", "points", "image", "open_outlines", "_exact")

    def __init__(self, arrays):
        self._exact = arrays.pop("exact")
        for name, array in arrays.items():
            setattr(self, name, array)

    def __len__(self):
        return len(self.object)

    def __repr__(self):
        return f"<hsr.Section: {len(self)} caps, {len(self.offsets) - 1} rings>"

    def polygons(self):
        """Of each cap its rings in the image, a list of (k, 2) arrays."""
        return Fragments.polygons(self)

    def exact_points(self, ring):
        """The corners of a ring in space, exactly: triples of Fractions."""
        k = _place(ring, len(self.offsets) - 1)
        return [tuple(Fraction(x) for x in self._exact[3 * i : 3 * i + 3]) for i in range(self.offsets[k], self.offsets[k + 1])]


class Order:
    """Convex pieces of faces from far to near, n of them: whoever paints them in turn shows what is visible.

    face (n,) int64: whose piece it is
    offsets (n + 1,) int64: piece i has the corners offsets[i] to offsets[i + 1] - 1, counter-clockwise as seen
    points (p, 3), image (p, 2) float64: the corners in space and in the view, in the scene's units, correctly rounded
    original (p,) bool: the side from this corner to the next lies on an edge of the face; else it is a cut
    """

    __slots__ = ("_data", "face", "offsets", "points", "image", "original")

    def __init__(self, data):
        self._data = data
        arrays = data.arrays()
        for name in ("face", "offsets", "points", "image", "original"):
            setattr(self, name, arrays[name])

    def __len__(self):
        return len(self.face)

    def __repr__(self):
        return f"<hsr.Order: {len(self)} pieces of {len(numpy.unique(self.face))} faces>"

    def polygons(self):
        """The pieces in the image, far to near: a list of (k, 2) arrays."""
        return [self.image[a:b] for a, b in zip(self.offsets, self.offsets[1:])]

    def exact_points(self, i):
        """The corners of piece i in space, exactly: triples of Fractions."""
        return [tuple(Fraction(x) for x in corner) for corner in self._data.exact(_place(i, len(self)))]

    def draw(
        self,
        output=None,
        *,
        opacity=None,
        shade=None,
        edges=None,
        crease=None,
        page=None,
        scale=None,
        unit=None,
        margin=None,
        min_length=None,
        size=None,
        pen=None,
        pens=None,
        fit_arcs=None,
        id_prefix=None,
        exact=False,
        threads=None,
        progress=None,
    ):
        """Paints the pieces on a page, far to near, and writes it as the command `hsr order` does, byte by byte: a `Drawing`.

        output: a path, or a list of them, all written or none; the ending chooses svg, pdf, eps, tex (TikZ), png or json
        opacity: of every face, times its own [1]; shade: "slope" or "none"; edges: those drawn on the faces. All others mean what they
        do at `draw`. Raises InputError for what cannot be drawn or written.
        """
        named = arguments(
            None,
            threads=threads,
            progress=progress,
            outputs=None if output is None else paths(output),
            opacity=opacity,
            shade=shade,
            edges=edges,
            crease=crease,
            page=page,
            scale=scale,
            unit=unit,
            margin=margin,
            min_length=min_length,
            size=size,
            pen=pen,
            pens=pens,
            fit_arcs=fit_arcs,
            id_prefix=id_prefix,
            exact=exact,
        )
        return Drawing(self._data.draw(named))

    def json(self, exact=False):
        """The order as the command writes it, "hsr-order/1"."""
        return self._data.json(bool(exact))


class Tree:
    """A tree of planes that orders a scene for any view: built once, asked for each."""

    __slots__ = ("_data",)

    def __init__(self, data):
        self._data = data

    def __repr__(self):
        return f"<hsr.Tree: {self._data.pieces} pieces>"


class Drawing:
    """A drawing on a page. In a notebook it shows itself.

    width, height: of the page, mm; scale: millimetres to a unit of the view; fits: nothing is outside the page; notes: what the
    command says about the scene and the arguments, a line each
    """

    __slots__ = ("_data",)

    def __init__(self, data):
        self._data = data

    def __repr__(self):
        return f"<hsr.Drawing: {self.width:g} x {self.height:g} mm>"

    def _repr_svg_(self):
        return self.svg()

    def svg(self):
        """The text of the SVG file that the command writes."""
        return self._data.svg()

    def png(self, size=None):
        """The bytes of the PNG file that the command writes; size: (width, height) in pixels [the drawing's, or 150 to the inch]."""
        return self._data.png(None if size is None else f"{count('size', size[0])}x{count('size', size[1])}")

    def written(self, format):
        """What the command writes into a file of that format: svg, pdf, eps, tex, hpgl, png; dxf and json if an output was one."""
        return self._data.written(format)

    def polylines(self):
        """What a plotter draws: a list of (points, hidden, class), points (k, 2) in mm from the upper left corner, y down."""
        arrays = self._data.polylines()
        points, offsets = arrays["points"], arrays["offsets"]
        names = (CLASS_NAMES[k] for k in arrays["edge_class"])
        rows = zip(offsets, offsets[1:], arrays["hidden"], names)
        return [(points[a:b], bool(hidden), name) for a, b, hidden, name in rows]

    @property
    def width(self):
        return self._data.width

    @property
    def height(self):
        return self._data.height

    @property
    def scale(self):
        return self._data.scale

    @property
    def fits(self):
        return self._data.fits

    @property
    def notes(self):
        return self._data.notes


class Record:
    """Some named numbers. It is true if what it is about is right."""

    __slots__ = ("__dict__",)

    def __init__(self, fields):
        self.__dict__.update(fields)

    def __bool__(self):
        return bool(self.ok)

    def __repr__(self):
        fields = ", ".join(f"{name}={value!r}" for name, value in self.__dict__.items())
        return f"<hsr.{type(self).__name__}: {fields}>"


class Verdict(Record):
    """Whether a painting order is right; it is true if so.

    ok: bool; polygons, overlapping, wrong, piercing, covered_twice: counts of polygons and of pairs; order_exists: some order of
    these polygons is right; cycle: else polygons each of which must be painted before the next; cuts_that_suffice: so many cuts
    make one, or None; first: the first violations, dicts of earlier, later (numbers of polygons), fault (order, piercing, coplanar
    or covered_twice), image (x, y), of_earlier and of_later (x, y, z): a place where the later one is not the nearer
    """


class Check(Record):
    """Fragments compared with the nearest face at samples; it is true if they agree.

    ok: bool; samples, covered (with a face), wrong, overlapping (painted twice): counts; first_wrong: at most ten (column, row, face
    painted, face cast), -1 for none
    """
