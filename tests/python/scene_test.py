"""What can be a scene: every form of one scene gives the same lines; what is no scene is refused in one line."""

import fractions
import pathlib
import tempfile
import types
import unittest

import numpy

import hsr
import scenes

V = numpy.array(scenes.CUBE_POINTS, dtype=float)
F = numpy.array(scenes.CUBE_FACES)
Thing = types.SimpleNamespace


def lines_of(scene):
    lines = hsr.visible_lines(scene)
    return lines.edge.tolist(), lines.points.tolist(), lines.visible.tolist()


class Forms(unittest.TestCase):
    def setUp(self):
        self.expected = lines_of((V, F))
        self.assertEqual(sum(self.expected[2]), 9)

    def check(self, scene):
        self.assertEqual(lines_of(scene), self.expected)

    def test_lists(self):
        self.check(scenes.CUBE)

    def test_offsets(self):
        self.check((V, F.reshape(-1), numpy.arange(0, 25, 4)))

    def test_any_types_of_numbers(self):
        for of_points in ("f2", "f4", "f8", ">f8", "i1", "u2", "i8"):
            for of_faces in ("i1", "u2", "i4", "u4", "i8", "u8", ">i4"):
                self.check((V.astype(of_points), F.astype(of_faces)))

    def test_any_layout(self):
        self.check((numpy.asfortranarray(V), F[:, ::-1][:, ::-1]))

    def test_vertices_and_faces(self):
        self.check(Thing(vertices=V, faces=F))

    def test_padded_faces(self):
        padded = numpy.hstack([numpy.full((6, 1), 4), F])
        self.check(Thing(points=V, faces=padded.reshape(-1)))
        self.check(Thing(points=V, faces=padded))
        self.check(Thing(points=V, regular_faces=None, faces=F))

    def test_cells(self):
        self.check(Thing(points=V, cells=[Thing(type="vertex", data=[[0]]), Thing(type="quad", data=F)]))
        self.check(Thing(points=V, cells=[("polygon4", F[:3]), ("quad", F[3:])]))
        self.check(Thing(points=V, cells={"quad": F}))

    def test_file_and_scene(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "cube.obj"
            scenes.write_obj(path, scenes.CUBE)
            self.check(str(path))
            self.check(path)
            self.check(hsr.scene(path))
            self.assertEqual(hsr.scene(path).format, "OBJ")

    def test_polygons_of_several_sizes(self):
        faces = [[0, 1, 3, 2], [4, 6, 7], [4, 7, 5]]
        lines = hsr.visible_lines((V, faces), edges="all")
        self.assertEqual(lines.points.tolist(), hsr.visible_lines((V, sum(faces, []), [0, 4, 7, 10]), edges="all").points.tolist())
        padded = [4, 0, 1, 3, 2, 3, 4, 6, 7, 3, 4, 7, 5]
        self.assertEqual(lines.points.tolist(), hsr.visible_lines(Thing(points=V, faces=padded), edges="all").points.tolist())

    def test_list_of_scenes(self):
        both = hsr.scene([(V, F), Thing(vertices=V + [0, 0, 5], faces=F)])
        self.assertEqual(both.objects, ["0", "1"])
        self.assertEqual(len(both.points), 16)
        corners, offsets = both.faces
        self.assertEqual(corners[24:].tolist(), (F.reshape(-1) + 8).tolist())
        self.assertEqual(offsets.tolist(), list(range(0, 49, 4)))

    def test_objects(self):
        parts = [(V, F), Thing(vertices=V + [0, 5, 0], faces=F)]
        seen = hsr.visible_lines(parts, "front")
        self.assertTrue((seen.edge[seen.visible] < 8).all())
        through = hsr.scene(parts, ghost="0")
        lines = hsr.visible_lines(through, "front")
        self.assertEqual(set((lines.edge[lines.visible] < 8).all(axis=1)), {True, False})
        self.assertEqual(set(hsr.order(through, "front").face), set(hsr.order(hsr.scene(parts, hide=["0"]), "front").face))
        self.assertTrue((hsr.fragments(through, "front").face >= 6).all())
        self.assertTrue((hsr.visible_lines(hsr.scene(parts, only="1"), "front").edge >= 8).all())
        # A ghost stays one as a part of another scene.
        again = hsr.visible_lines([through, Thing(vertices=V + [0, 0, 5], faces=F)], "front")
        seen = again.edge[again.visible]
        self.assertTrue(((seen >= 8) & (seen < 16)).any())
        with self.assertRaisesRegex(hsr.InputError, 'ghost: found no object "2", expected one of "0", "1"'):
            hsr.scene(parts, ghost="2")
        with self.assertRaisesRegex(hsr.InputError, "hide: found 1, expected the name of an object"):
            hsr.scene(parts, hide=[1])

    def test_wires(self):
        scene = Thing(points=[[0, 0, 0], [0, 0, 2]], cells=[("line", [[0, 1]])])
        lines = hsr.visible_lines(scene, "front")
        self.assertEqual([hsr.edge_class_names[k] for k in lines.edge_class], ["wire"])

    def test_wires_of_objects(self):
        rod = Thing(points=[[0, 0, 5], [0, 0, 7]], cells=[("line", [[0, 1]])])
        parts = [(V, F), rod, Thing(points=[[0, 0, 8], [0, 0, 9]], cells=[("line", [[0, 1]])])]

        def wires(**selection):
            lines = hsr.visible_lines(hsr.scene(parts, **selection), "front")
            return {int(edge[0]) for edge, k in zip(lines.edge, lines.edge_class) if hsr.edge_class_names[k] == "wire"}

        self.assertEqual(wires(), {8, 10})
        self.assertEqual(wires(only="0"), set())
        self.assertEqual(wires(only="1"), {8})
        self.assertEqual(wires(hide=["2"]), {8})
        self.assertEqual(wires(ghost=["1", "2"]), {8, 10})
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory) / "x.svg"
            hsr.draw(hsr.scene(parts), str(path), view="front")
            self.assertIn('id="visible-wire-2" class="object" data-object="2"', path.read_text())

    def test_no_faces(self):
        for faces in ([], numpy.zeros((0, 3), dtype=int)):
            self.assertEqual(len(hsr.visible_lines((V, faces))), 0)
        self.assertEqual(len(hsr.visible_lines(([], []))), 0)


class Exactness(unittest.TestCase):
    def test_float32_widens_exactly(self):
        points = numpy.array([[0.1, 0, 0], [1, 0.1, 0], [0, 1, 0.1]], dtype=numpy.float32)
        lines = hsr.visible_lines((points, [[0, 1, 2]]), "top")
        exact = lines.exact_points(0)[0]
        self.assertEqual(exact[0], fractions.Fraction(float(points[0, 0])))
        self.assertNotEqual(exact[0], fractions.Fraction(0.1))

    def test_what_was_given_does_not_matter_later(self):
        points = V.copy()
        scene = hsr.scene((points, F))
        points[:] = 0
        self.assertEqual(scene.points.tolist(), V.tolist())


class Refused(unittest.TestCase):
    def refuse(self, scene, *words):
        with self.assertRaises(hsr.InputError) as caught:
            hsr.visible_lines(scene)
        text = str(caught.exception)
        for word in words:
            self.assertIn(word, text)
        self.assertNotIn("\n", text)
        self.assertIsInstance(caught.exception, ValueError)

    def test_not_finite(self):
        points = V.copy()
        points[5, 1] = numpy.nan
        self.refuse((points, F), "points, row 5", "y = nan")
        points[2, 2] = numpy.inf
        self.refuse((points.astype("f4"), F), "points, row 2", "z = inf")

    def test_numbers_that_are_no_doubles(self):
        self.refuse(([[2**53 + 1, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), "row 0", "9007199254740993")
        self.refuse((V.astype("longdouble"), F), "float128")
        self.refuse((V.astype(complex), F), "complex128")

    def test_shapes(self):
        self.refuse((V[:, :2], F), "(8, 2)", "(n, 3)")
        self.refuse((V, F.reshape(-1)), "(24,)", "offsets")
        self.refuse((V, F, [0, 24]), "(6, 4)")
        self.refuse((V, F.reshape(-1), [0, 23]), "offsets", "24")
        self.refuse((V, F.reshape(-1), [0, 8, 4, 24]), "offsets")

    def test_indices(self):
        self.refuse((V, [[0, 1, 8]]), "entry 2", "found 8", "below the 8 points")
        self.refuse((V, [[0, -1, 2]]), "entry 1", "found -1")
        self.refuse((V, [[0, 1.5, 2]]), "whole")
        self.refuse(Thing(points=V, faces=[3, 0, 1]), "entry 0", "3 corners")

    def test_what_is_no_scene(self):
        self.refuse(None, "NoneType")
        self.refuse((V,), "tuple of 1")
        self.refuse([], "empty list")
        self.refuse("no/such/file.obj", "no/such/file.obj")
        self.refuse(Thing(points=V, cells=[("tetra", [[0, 1, 2, 4]])]), "tetra", "surface")

    def test_views(self):
        for view, words in (
            ("inside", ("inside", "front")),
            (3, ("int", "View")),
        ):
            with self.assertRaises(hsr.InputError) as caught:
                hsr.visible_lines(scenes.CUBE, view)
            for word in words:
                self.assertIn(word, str(caught.exception))
        for make in (
            lambda: hsr.View.parallel((0, 0)),
            lambda: hsr.View.parallel((0, 0, float("nan"))),
            lambda: hsr.View.perspective(5),
            lambda: hsr.View.named("iso", up_axis="w"),
            lambda: hsr.visible_lines(scenes.CUBE, hsr.View.parallel((0, 0, 0))),
            lambda: hsr.visible_lines(scenes.CUBE, hsr.View.perspective((1, 1, 1), target=(1, 1, 1))),
            lambda: hsr.visible_lines(scenes.CUBE, hsr.View.named("camera:Left")),
        ):
            with self.assertRaises(hsr.InputError) as caught:
                make()
            self.assertNotIn("--", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
