"""The twenty plots of docs/plots.md: each pixel against what is nearest there, found in doubles by the dumbest way.

Faces are compared everywhere but near lines, markers and texts that are seen, or may be; these are looked for where they are
certainly seen. Antialiasing may show any colour between those of the nine pixels around, and where pieces meet a seam a pixel wide
is passed over: one of the nine has such a colour.
"""

import importlib.util
import pathlib
import unittest

import numpy

try:
    import matplotlib
except ImportError:
    raise unittest.SkipTest("matplotlib is not installed") from None

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import hsr  # noqa: E402
import hsr.matplotlib  # noqa: E402
from hsr import _axes3d  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "plots.py"
spec = importlib.util.spec_from_file_location("plots", SCRIPT)
plots = importlib.util.module_from_spec(spec)
spec.loader.exec_module(plots)

SIDE, DPI = 300, 100
PIXEL = DPI / 72  # in a point


class Expected:
    """What a picture of an Axes3D must show: rows from below."""

    def __init__(self, ax, artists):
        self.ax, self.matrix = ax, ax.get_proj()
        self.layers = []  # pixel, depth, rgba of every triangle at every pixel
        self.first = {}  # of each point where it comes first, which says how quads are cut (rule F8)
        for artist in artists:
            for points, face, edge, width in _axes3d.polygons_of(artist):
                self.add(points, face)
        self.compose()
        self.seen = {}  # colour -> where it is seen, or may be
        self.certain = []  # where it is certainly seen: row, column, colour
        for artist in artists:
            self.add_lines(artist)

    def image(self, points):
        points = numpy.asarray(points, dtype=float)
        homogeneous = numpy.column_stack([points, numpy.ones(len(points))]) @ self.matrix.T
        return self.ax.transData.transform(_axes3d.projected(self.matrix, points)), homogeneous[:, 2] / homogeneous[:, 3]

    def add(self, points, face):
        numbers = [self.first.setdefault(tuple(p), len(self.first)) for p in points.tolist()]
        apex = int(numpy.argmin(numbers)) if len(points) == 4 else 0
        xy, z = self.image(numpy.roll(points, -apex, axis=0))
        for k in range(1, len(points) - 1):
            self.add_triangle(xy[[0, k, k + 1]], z[[0, k, k + 1]], face)

    def add_triangle(self, corners, z, face):
        a, b, c = corners
        area = numpy.cross(b - a, c - a)
        if abs(area) < 1e-9 or face[3] == 0:
            return
        low, high = numpy.clip(numpy.floor([corners.min(axis=0), corners.max(axis=0) + 1]).astype(int), 0, SIDE)
        columns, rows = numpy.meshgrid(numpy.arange(low[0], high[0]), numpy.arange(low[1], high[1]))
        x, y = columns + 0.5, rows + 0.5
        weights = [((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area for p, q in ((b, c), (c, a), (a, b))]
        inside = (weights[0] >= 0) & (weights[1] >= 0) & (weights[2] >= 0)
        depth = sum(w * at for w, at in zip(weights, z))
        self.layers.append((rows[inside] * SIDE + columns[inside], depth[inside], numpy.broadcast_to(face, (inside.sum(), 4))))

    def compose(self):
        pixel, depth, colour = (numpy.concatenate(part) for part in zip(*self.layers))
        self.tolerance = 2e-3 * (depth.max() - depth.min())
        order = numpy.lexsort((-depth, pixel))
        pixel, depth, colour = pixel[order], depth[order], colour[order]
        shown = numpy.ones((SIDE * SIDE, 3))
        self.depth = numpy.full(SIDE * SIDE, numpy.inf)
        begins = numpy.flatnonzero(numpy.concatenate([[True], pixel[1:] != pixel[:-1]]))
        counts = numpy.diff(numpy.append(begins, len(pixel)))
        for layer in range(counts.max()):
            at = begins[counts > layer] + layer
            alpha = colour[at, 3:]
            shown[pixel[at]] = alpha * colour[at, :3] + (1 - alpha) * shown[pixel[at]]
            self.depth[pixel[at]] = numpy.where(alpha[:, 0] == 1, depth[at], self.depth[pixel[at]])
        self.shown, self.depth = shown.reshape(SIDE, SIDE, 3), self.depth.reshape(SIDE, SIDE)
        around = [numpy.roll(self.shown, (r, c), (0, 1)) for r in (-1, 0, 1) for c in (-1, 0, 1)]
        self.low, self.high = numpy.min(around, axis=0), numpy.max(around, axis=0)

    def add_lines(self, artist):
        for points, colour, width, (_, dashes) in _axes3d.lines_of(artist):
            for a, b in zip(points, points[1:]):
                ends, _ = self.image([a, b])
                steps = max(int(numpy.linalg.norm(ends[1] - ends[0]) / 2), 1)
                for t in (numpy.arange(steps) + 0.5) / steps:
                    self.look(a + t * (b - a), colour, width / 2, not dashes)
        for points, face, edge, width in _axes3d.polygons_of(artist):
            if edge[3] > 0 and width > 0 and tuple(edge[:3]) != tuple(face[:3]):
                for a, b in zip(points, numpy.roll(points, -1, axis=0)):
                    for t in numpy.linspace(0, 1, 150):
                        self.look(a + t * (b - a), edge, width / 2, False)
        for point, _, size, face, _, width in _axes3d.markers_of(artist):
            self.look(point, face, size**0.5 / 2 + width / 2, True)
        if _axes3d.text_of(artist) is not None:
            self.look(_axes3d.text_of(artist), (*to_rgb(artist.get_color()), 1), 32, False)

    def look(self, point, colour, radius, is_filled):
        """A disc of that radius in points: where it is seen."""
        (x, y), z = (part[0] for part in self.image([point]))
        reach = radius * PIXEL + 1.5
        rows, columns = numpy.mgrid[0:SIDE, 0:SIDE][:, max(int(y - reach), 0) : int(y + reach) + 2, max(int(x - reach), 0) : int(x + reach) + 2]
        disc = (rows + 0.5 - y) ** 2 + (columns + 0.5 - x) ** 2 <= reach**2
        rows, columns = rows[disc], columns[disc]
        if len(rows) == 0 or z > self.depth[rows, columns].max() + self.tolerance:
            return
        self.seen.setdefault(tuple(colour[:3]), numpy.zeros((SIDE, SIDE), dtype=bool))[rows, columns] = True
        if is_filled and z < self.depth[rows, columns].min() - self.tolerance:
            self.certain.append((int(y), int(x), tuple(colour[:3])))

    def wrong(self, shown):
        """How many pixels are wrong, and how many could be judged."""
        colours_seen = sum(mask.astype(int) for mask in self.seen.values()) if self.seen else numpy.zeros((SIDE, SIDE), dtype=int)
        bad = colours_seen == 0
        for row, column in ((r, c) for r in (-1, 0, 1) for c in (-1, 0, 1)):
            nearby = numpy.roll(shown, (row, column), (0, 1))
            bad &= ((nearby < self.low - 0.03) | (nearby > self.high + 0.03)).any(axis=2)
        alone = [(row, column, colour) for row, column, colour in self.certain if colours_seen[row, column] == 1]
        missing = sum(abs(shown[row, column] - colour).max() > 0.05 for row, column, colour in alone)
        return int(bad.sum()) + int(missing), int((colours_seen == 0).sum()) + len(alone)


def picture(name, fixed, **view):
    """What is shown, by rows from below, the Axes and what was plotted in it."""
    figure = plt.figure(figsize=(SIDE / DPI, SIDE / DPI), dpi=DPI)
    ax = figure.add_axes([0, 0, 1, 1], projection="3d", proj_type=view.pop("proj_type", "persp"))
    plots.plot(name, ax)
    if view:
        ax.view_init(**view)
    artists = [artist for artist in ax.get_children() if _axes3d.is_ours(artist)]
    if fixed:
        hsr.matplotlib.fix(ax)
    figure.canvas.draw()
    shown = numpy.asarray(figure.canvas.buffer_rgba())[::-1, :, :3] / 255
    plt.close(figure)
    return shown, ax, artists


class Plots(unittest.TestCase):
    def test_there_are_twenty(self):
        self.assertEqual(len(plots.PLOTS), 20)
        page = (SCRIPT.parent / "plots.md").read_text(encoding="utf-8")
        for name in plots.PLOTS:
            self.assertIn(f"plots/{name}.png", page)
            self.assertTrue((SCRIPT.parent / "plots" / f"{name}.png").exists(), name)

    def test_pixels(self):
        for name in plots.PLOTS:
            for view in ({}, {"elev": -15, "azim": 100, "proj_type": "ortho"}):
                with self.subTest(name=name, view=view):
                    shown, ax, artists = picture(name, True, **view)
                    expected = Expected(ax, artists)
                    wrong, judged = expected.wrong(shown)
                    self.assertEqual(wrong, 0)
                    self.assertGreater(judged, 0.8 * SIDE * SIDE)
                    if not view:  # else the plot would show nothing
                        self.assertGreater(expected.wrong(picture(name, False)[0])[0], 5)

    def test_texts(self):
        for azim, seen in ((-70, "before"), (110, "behind")):
            shown, ax, artists = picture("texts_behind_a_surface", True, elev=15, azim=azim)
            expected = Expected(ax, artists)
            for text in ax.texts:
                (x, y), _ = (part[0] for part in expected.image([text.get_position_3d()]))
                dark = shown[int(y) - 10 : int(y) + 10, int(x) - 15 : int(x) + 15].max(axis=2) < 0.3
                self.assertEqual(dark.any(), text.get_text() in (seen, "above"), text.get_text())


if __name__ == "__main__":
    unittest.main()
