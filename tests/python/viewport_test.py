"""`hsr.project_to_viewport`: the projection by its formula, what is visible by the lines of the same view."""

import unittest

import numpy

import hsr
import scenes

PYRAMID = ([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0], [2, 2, 8]], [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])


def projected(points, origin, up, look_at, focus=None):
    """The viewport's coordinates: z toward the viewer from the origin, y the part of up across it; by a focus, 1 / (1 - z / focus)
    times as large."""
    origin, up, look_at = (numpy.asarray(a, dtype=float) for a in (origin, up, look_at))
    z = (origin - look_at) / numpy.linalg.norm(origin - look_at)
    x = numpy.cross(up, z) / numpy.linalg.norm(numpy.cross(up, z))
    from_origin = numpy.asarray(points, dtype=float) - origin
    image = from_origin @ numpy.array([x, numpy.cross(z, x)]).T
    return image if focus is None else image / (1 - from_origin @ z / focus)[:, None]


def sides(lines):
    """The straight pieces of polylines, each from the lesser end, rounded to what can be compared."""
    found = set()
    for points in lines:
        for a, b in zip(points, points[1:]):
            found.add(tuple(sorted((tuple(a.round(4) + 0.0), tuple(b.round(4) + 0.0)))))
    return found


def length(lines):
    return sum(numpy.linalg.norm(numpy.diff(points, axis=0), axis=1).sum() for points in lines)


class Projection(unittest.TestCase):
    def test_a_box_from_the_front_is_four_lines(self):
        visible, hidden = hsr.project_to_viewport(scenes.CUBE, (0.5, -7, 0.5))
        self.assertEqual(sides(visible), sides([numpy.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5], [-0.5, -0.5]])]))
        self.assertEqual((len(visible), hidden), (1, []))

    def test_coordinates(self):
        cube = numpy.array(scenes.CUBE_POINTS)
        edges = [(a, b) for a in range(8) for b in range(a) if abs(cube[a] - cube[b]).sum() == 1]
        for origin, up, look_at, focus, behind in (
            ((10, -10, 10), (0, 0, 1), None, None, 3),
            ((3, -1, 2), (0, 0, 1), (0.25, 0.5, 0), None, 3),
            ((3, -1, 2), (0, 1, 0), (0.25, 0.5, 0), 1.5, 3),
            ((0.5, -4, 2), (0.25, 0, -1), None, 20, 5),
        ):
            with self.subTest(origin=origin, focus=focus):
                visible, hidden = hsr.project_to_viewport(scenes.CUBE, origin, up, look_at, focus)
                image = projected(scenes.CUBE_POINTS, origin, up, look_at or (0.5, 0.5, 0.5), focus)
                # No edge is hidden in part.
                whole = sides([image[[a, b]] for a, b in edges])
                self.assertEqual(sides(visible) | sides(hidden), whole)
                self.assertEqual(sides(visible) & sides(hidden), set())
                self.assertEqual(len(sides(hidden)), behind)

    def test_argument_order_is_that_of_build123d(self):
        by_place = hsr.project_to_viewport(PYRAMID, (9, -9, 9), (0, 1, 0), (0, 0, 1), 30)
        by_name = hsr.project_to_viewport(PYRAMID, viewport_origin=(9, -9, 9), viewport_up=(0, 1, 0), look_at=(0, 0, 1), focus=30)
        for some, others in zip(by_place, by_name):
            self.assertEqual([a.tolist() for a in some], [a.tolist() for a in others])

    def test_it_looks_at_the_centre_of_mass(self):
        def same(scene, look_at):
            found = hsr.project_to_viewport(scene, (9, -5, 7))
            expected = hsr.project_to_viewport(scene, (9, -5, 7), look_at=look_at)
            self.assertEqual([[a.tolist() for a in lines] for lines in found], [[a.tolist() for a in lines] for lines in expected])

        same(PYRAMID, (2, 2, 2))  # a quarter of its height
        triangles = numpy.array(PYRAMID[0], dtype=float)[[[3, 2, 1], [3, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]]
        same((triangles.reshape(-1, 3), numpy.arange(18).reshape(-1, 3)), (2, 2, 2))  # as in STL, no point is shared
        same((PYRAMID[0], PYRAMID[1][:1]), (2, 2, 0))  # a surface
        same(([[0, 0, 0], [3, 0, 0], [0, 3, 0]], [[0, 1, 2]]), (1, 1, 0))

    def test_what_is_visible(self):
        for scene in (scenes.FLOOR_AND_ROOF, scenes.confetti(4, 40)):
            visible, hidden = hsr.project_to_viewport(scene, (50, -500, 300), look_at=(0, 0, 0))
            lines = hsr.visible_lines(scene, hsr.View.parallel((50, -500, 300), target=(50, -500, 300), up=(0, 0, 1)))
            self.assertAlmostEqual(length(visible), length(lines.polylines()), delta=1e-4 * length(visible))
            self.assertAlmostEqual(length(hidden), length(lines.polylines(visible=False)), delta=1e-4 * length(visible))
            self.assertGreater(length(hidden), 0)

    def test_edges_that_are_asked_for(self):
        smooth = ([[0, 0, 0], [2, 0, 0], [2, 2, 0.01], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])
        without, with_it = (sides(hsr.project_to_viewport(smooth, (1, 1, 5), (0, 1, 0), edges=e)[0]) for e in (None, "all"))
        self.assertEqual((len(without), len(with_it)), (4, 5))

    def test_any_size(self):
        for factor in (2.0**-60, 2.0**60):
            points = numpy.array(PYRAMID[0]) * factor
            visible, _ = hsr.project_to_viewport((points, PYRAMID[1]), numpy.array([9.0, -9, 9]) * factor, look_at=(0, 0, 0))
            expected, _ = hsr.project_to_viewport(PYRAMID, (9, -9, 9), look_at=(0, 0, 0))
            numpy.testing.assert_allclose(length(visible), length(expected) * factor, rtol=1e-5)

    def test_nothing(self):
        self.assertEqual(hsr.project_to_viewport(([], []), (1, 1, 1)), ([], []))

    def test_refused(self):
        for arguments, text in (
            (((0.5, 0.5, 0.5),), "viewport_origin: found the point looked at itself"),
            (((1, 2),), "viewport_origin: found an array"),
            (((5, 5, float("nan")),), "viewport_origin, row 0: found z = nan"),
            (((0.5, 0.5, 9),), "viewport_up: found"),
            (((9, 9, 9), (0, 0, 0)), "viewport_up: found"),
            (((9, 9, 9), (0, 0, 1), None, -1), "focus: found -1"),
        ):
            with self.assertRaises(hsr.InputError) as caught:
                hsr.project_to_viewport(scenes.CUBE, *arguments)
            self.assertIn(text, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
