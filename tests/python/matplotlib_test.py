"""`hsr.matplotlib.fix`: the classic plots that matplotlib paints wrong, against the nearest face at each sample, found in doubles by
the dumbest way; samples beside a border of colours are passed over."""

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
from mpl_toolkits.mplot3d.art3d import Line3DCollection  # noqa: E402

COLOURS = numpy.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [0, 1, 1], [1, 0, 1], [0.5, 0, 0], [0, 0.5, 0]])


def planes_and_a_cylinder(ax):
    u = numpy.linspace(-1, 1, 2)
    x, y = numpy.meshgrid(u, u)
    ax.plot_surface(x, y, 0 * x, color=COLOURS[0], shade=False)
    ax.plot_surface(x, 0 * x, y, color=COLOURS[1], shade=False)
    t, z = numpy.meshgrid(numpy.linspace(0, 2 * numpy.pi, 13), u)
    ax.plot_surface(0.4 * numpy.cos(t), 0.4 * numpy.sin(t), z, color=COLOURS[2], shade=False)


def crossing_surfaces(ax):
    x, y = numpy.meshgrid(numpy.linspace(-2, 2, 7), numpy.linspace(-2, 2, 7))
    x, y = x.ravel(), y.ravel()
    ax.plot_trisurf(x, y, numpy.sin(x * y), color=COLOURS[0], shade=False)
    ax.plot_trisurf(x, y, 0.3 * x - 0.2 * y, color=COLOURS[1], shade=False)


def bars(ax):
    x, y = (a.ravel() for a in numpy.meshgrid(range(3), range(3)))
    ax.bar3d(x, y, 0 * x, 1, 1, 1 + x * y, color=COLOURS[numpy.arange(9) % 8], shade=False)
    ax.bar3d([0.5], [0.5], [0.5], [1.5], [1.75], [3.25], color=[COLOURS[7]], shade=False)


def voxels_and_trisurf(ax):
    filled = numpy.indices((3, 3, 3)).sum(axis=0) % 2 == 0
    ax.voxels(filled, facecolors=COLOURS[4], shade=False)
    ax.plot_trisurf([0, 3, 3, 0], [0, 0, 3, 3], [0.5, 2.5, 0.5, 2.75], color=COLOURS[5], shade=False)


def triangles_of(ax):
    """Corners and colours of all triangles; quads, which are planar here, are two."""
    corners, colours = [], []
    for artist in ax.get_children():
        if _axes3d.is_ours(artist):
            for points, face, _, _ in _axes3d.polygons_of(artist):
                for k in range(1, len(points) - 1):
                    corners.append(points[[0, k, k + 1]])
                    colours.append(face[:3])
    return numpy.array(corners), numpy.array(colours)


STEP, SIDE = 3, 300  # pixels from sample to sample, and of the picture


def certain_colours(ax, corners, colours):
    """The colour of the nearest triangle at samples, by rows from below, and whether it is that of all eight samples around."""
    matrix = ax.get_proj()
    flat = corners.reshape(-1, 3)
    image = ax.transData.transform(_axes3d.projected(matrix, flat)).reshape(-1, 3, 2)
    homogeneous = numpy.column_stack([flat, numpy.ones(len(flat))]) @ matrix.T
    depth = (homogeneous[:, 2] / homogeneous[:, 3]).reshape(-1, 3)
    places = numpy.arange(SIDE // STEP) * STEP + 0.5
    best = numpy.full((len(places), len(places)), numpy.inf)
    seen = numpy.full((len(places), len(places), 3), -1.0)
    for (a, b, c), z, colour in zip(image, depth, colours):
        area = numpy.cross(b - a, c - a)
        if abs(area) < 1e-6:
            continue
        low, high = (numpy.searchsorted(places, limit([a, b, c], axis=0)) for limit in (numpy.min, numpy.max))
        box = slice(low[1], high[1]), slice(low[0], high[0])
        x, y = numpy.meshgrid(places[box[1]], places[box[0]])
        weights = [((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area for p, q in ((b, c), (c, a), (a, b))]
        inside = (weights[0] >= 0) & (weights[1] >= 0) & (weights[2] >= 0)
        here = numpy.where(inside, sum(w * at for w, at in zip(weights, z)), numpy.inf)
        seen[box][here < best[box]] = colour
        best[box] = numpy.minimum(best[box], here)
    certain = numpy.isfinite(best)
    for row, column in ((r, c) for r in (-1, 0, 1) for c in (-1, 0, 1)):
        certain &= (numpy.roll(seen, (row, column), (0, 1)) == seen).all(axis=2)
    return seen, certain


def picture(plot, view, fixed):
    """What is shown, by rows from below, and the Axes with its triangles."""
    view = dict(view)
    figure = plt.figure(figsize=(3, 3), dpi=SIDE // 3)
    ax = figure.add_subplot(projection="3d", proj_type=view.pop("proj_type", "persp"))
    plot(ax)
    ax.set_axis_off()
    triangles = triangles_of(ax)
    if fixed:
        hsr.matplotlib.fix(ax)
    ax.view_init(**view)
    figure.canvas.draw()
    shown = numpy.asarray(figure.canvas.buffer_rgba())[::-1, :, :3] / 255
    plt.close(figure)
    return shown, ax, triangles


def wrong_samples(shown, expected, certain):
    """How many certain samples show another colour. Where polygons meet, antialiasing may leave a seam a pixel wide: one of the
    pixels around has the colour."""
    wrong = certain.copy()
    for row, column in ((r, c) for r in (-1, 0, 1) for c in (-1, 0, 1)):
        nearby = numpy.roll(shown, (row, column), (0, 1))[::STEP, ::STEP]
        wrong &= abs(nearby - expected).max(axis=2) > 0.02
    return wrong.sum()


class Fix(unittest.TestCase):
    def test_classic_failures(self):
        for plot in (planes_and_a_cylinder, crossing_surfaces, bars, voxels_and_trisurf):
            wrong_before = 0
            for view in ({"elev": 30, "azim": -60}, {"elev": -15, "azim": 100, "proj_type": "ortho"}, {"elev": 60, "azim": 10}):
                with self.subTest(plot=plot.__name__, view=view):
                    shown, ax, triangles = picture(plot, view, True)
                    expected, certain = certain_colours(ax, *triangles)
                    self.assertGreater(certain.sum(), 500)
                    self.assertEqual(wrong_samples(shown, expected, certain), 0)
                    wrong_before = max(wrong_before, wrong_samples(picture(plot, view, False)[0], expected, certain))
            self.assertGreater(wrong_before, 10, plot.__name__)  # else the test would show nothing


class Lines(unittest.TestCase):
    """Seen from the front, a wall with lines and points before, through and behind it."""

    def pixels(self, add, alpha=1):
        figure = plt.figure(figsize=(2, 2), dpi=100)
        ax = figure.add_subplot(projection="3d", proj_type="ortho")
        x, z = numpy.meshgrid([-1, 1], [-1, 1])
        ax.plot_surface(x, 0 * x, z, color=(1, 0, 0, alpha), shade=False)
        add(ax)
        ax.set_axis_off()
        ax.view_init(elev=0, azim=-90)
        hsr.matplotlib.fix(ax)
        figure.canvas.draw()
        shown = numpy.asarray(figure.canvas.buffer_rgba())[:, :, :3] / 255
        matrix = ax.get_proj()

        def at(*point):
            column, row = ax.transData.transform(_axes3d.projected(matrix, numpy.array([point], dtype=float)))[0]
            return shown[200 - 1 - int(row), int(column)].round(2).tolist()

        plt.close(figure)
        return at

    def test_a_line_through_a_wall(self):
        at = self.pixels(lambda ax: ax.plot([-0.9, 0.9], [-1, 1], [0.5, 0.5], color="blue", lw=4))
        self.assertEqual(at(-0.5, 0, 0.5), [0, 0, 1])
        self.assertEqual(at(0.5, 0, 0.5), [1, 0, 0])

    def test_a_line_on_a_wall_and_one_behind_it(self):
        at = self.pixels(lambda ax: (ax.plot([-0.9, 0.7], [0, 0], [-0.3, 0.1], color="blue", lw=4), ax.plot([-0.9, 0.7], [0.01, 0.01], [0.5, 0.5])))
        self.assertEqual(at(-0.1, 0, -0.1), [0, 0, 1])
        self.assertEqual(at(-0.1, 0, 0.5), [1, 0, 0])

    def test_points(self):
        at = self.pixels(lambda ax: ax.scatter([-0.5, 0, 0.5], [-0.5, 0, 0.5], [0, 0, 0], color="blue", s=80))
        self.assertEqual([at(x, 0, 0) for x in (-0.5, 0, 0.5)], [[0, 0, 1], [0, 0, 1], [1, 0, 0]])

    def test_a_marker_in_pieces_is_painted_once(self):
        def add(ax):
            y, z = numpy.meshgrid([-1, 1], [-1, 1])
            ax.plot_surface(0 * y, y, z, color="red", shade=False)  # seen edge-on, and cuts the marker
            ax.scatter([0], [-0.01], [0], color="blue", s=900, alpha=0.5, linewidths=0, depthshade=False)

        for found, expected in zip(self.pixels(add)(0.06, 0, 0), [0.5, 0, 0.5]):
            self.assertAlmostEqual(found, expected, delta=0.02)

    def test_behind_a_transparent_wall(self):
        at = self.pixels(lambda ax: ax.plot([-0.9, 0.9], [0.5, 0.5], [0.5, 0.5], color="blue", lw=4), alpha=0.5)
        for found, expected in zip(at(0.2, 0, 0.5), [0.5, 0, 0.5]):
            self.assertAlmostEqual(found, expected, delta=0.02)


class Kept(unittest.TestCase):
    def dark(self, plot, fixed):
        figure = plt.figure(figsize=(3, 3), dpi=150)
        ax = figure.add_subplot(projection="3d")
        plot(ax)
        ax.set_axis_off()
        if fixed:
            hsr.matplotlib.fix(ax)
        figure.canvas.draw()
        shown = numpy.asarray(figure.canvas.buffer_rgba())[:, :, 1] < 128
        plt.close(figure)
        return shown

    def wider(self, shape):
        return numpy.max([numpy.roll(shape, (row, column), (0, 1)) for row in (-1, 0, 1) for column in (-1, 0, 1)], axis=0)

    def test_what_nothing_hides_looks_as_before(self):
        t = numpy.linspace(0, 4 * numpy.pi, 61)
        x, y, z = numpy.cos(t), numpy.sin(t), t
        lines = numpy.stack([numpy.column_stack([x[:30], y[:30], z[:30] + k]) for k in (0, 20)])

        def collection(ax):
            ax.add_collection3d(Line3DCollection(lines, colors="black", linewidths=3, linestyles="dashdot"))
            ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(0, 27))

        for name, plot in (
            ("solid", lambda ax: ax.plot(x, y, z, "k-", lw=3)),
            ("dashed", lambda ax: ax.plot(x, y, z, "k--", lw=3)),
            ("dotted", lambda ax: ax.plot(x, y, z, "k:", lw=3)),
            ("dashes of a collection", collection),
            ("markers", lambda ax: ax.plot(x, y, z, "ko", ms=5)),
            ("some markers", lambda ax: ax.plot(x, y, z, "k-s", ms=7, markevery=6)),
            ("unfilled markers", lambda ax: ax.plot(x, y, z, "kx", ms=9, mew=2)),
            ("scatter", lambda ax: ax.scatter(x, y, z, color="black", s=40, depthshade=False)),
            ("text", lambda ax: (ax.scatter(x, y, z, color="black", s=4, depthshade=False), ax.text(0, 0, 6, "some text", "x", size=14))),
            ("edges", lambda ax: ax.bar3d(0, 0, 0, 1, 1, 1, color="white", edgecolor="black", linewidth=3, shade=False)),
        ):
            with self.subTest(name):
                before, after = self.dark(plot, False), self.dark(plot, True)
                self.assertGreater(before.sum(), 200)
                # Markers may be a pixel beside where they were, which Agg puts on whole pixels.
                wrong = (before & ~self.wider(after)).sum() + (after & ~self.wider(before)).sum()
                self.assertLess(wrong, 0.01 * before.sum())

    def test_undo(self):
        ax = plt.figure().add_subplot(projection="3d")
        bars(ax)
        before = [(artist, artist.get_visible()) for artist in ax.get_children()]
        fixed = hsr.matplotlib.fix(ax)
        self.assertTrue(hsr.verify(fixed.order(ax.get_proj())))
        fixed.undo()
        self.assertEqual([(artist, artist.get_visible()) for artist in ax.get_children()], before)
        plt.close("all")

    def test_colour_maps_and_edges(self):
        ax = plt.figure().add_subplot(projection="3d")
        x, y = numpy.meshgrid([0, 1, 2], [0, 1])
        surface = ax.plot_surface(x, y, x + y, cmap="viridis", edgecolor="white", linewidth=2)
        found = list(_axes3d.polygons_of(surface))
        self.assertEqual(len(found), 2)
        for (_, face, edge, width), value in zip(found, surface.get_array()):
            self.assertEqual(tuple(face), surface.to_rgba(value))
            self.assertEqual((tuple(edge), width), ((1, 1, 1, 1), 2))
        plt.close("all")

    def test_refused(self):
        figure = plt.figure()
        self.assertRaisesRegex(hsr.InputError, "expected an Axes3D", hsr.matplotlib.fix, figure.add_subplot())
        self.assertRaisesRegex(hsr.InputError, "found nothing", hsr.matplotlib.fix, figure.add_subplot(projection="3d"))
        plt.close("all")


class Draw(unittest.TestCase):
    def test_lines_in_2d(self):
        ax = plt.figure().add_subplot()
        lines = hsr.visible_lines(([[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0]], [[0, 1, 2, 3]]), "top")
        hidden, visible = hsr.matplotlib.draw(ax, lines)
        self.assertEqual((len(hidden.get_segments()), len(visible.get_segments())), (0, 1))
        self.assertLess(ax.get_xlim()[0], -1.9)
        self.assertRaises(hsr.InputError, hsr.matplotlib.draw, ax, "x.obj")
        plt.close("all")


if __name__ == "__main__":
    unittest.main()
