"""Results as arrays: what the shapes say, against what can be checked by hand, by Fractions and by the command's JSON."""

import json
import os
import signal
import threading
import time
import unittest
from fractions import Fraction

import numpy

import hsr
import scenes

VIEWS = (
    "iso",
    "top",
    hsr.View.parallel((1, -2, 3)),
    hsr.View.perspective((20, 15, 30)),
    hsr.View.perspective((4, 4, 4), target=(0, 1, 2), near=0.5),
)


class VisibleLines(unittest.TestCase):
    def test_shapes_and_types(self):
        for view in VIEWS:
            lines = hsr.visible_lines(scenes.soup(1), view, edges="all")
            n = len(lines)
            self.assertGreater(n, 100)
            for name, shape, kind in (
                ("edge", (n, 2), "int64"),
                ("edge_class", (n,), "uint8"),
                ("faces_offsets", (n + 1,), "int64"),
                ("t", (n, 2), "float64"),
                ("visible", (n,), "bool"),
                ("behind", (n,), "bool"),
                ("points", (n, 2, 3), "float64"),
                ("image", (n, 2, 2), "float64"),
                ("line", (n,), "int64"),
            ):
                array = getattr(lines, name)
                self.assertEqual((array.shape, array.dtype.name), (shape, kind), name)
            self.assertEqual(lines.faces.shape, (lines.faces_offsets[-1],))
            self.assertTrue((lines.t[:, 0] < lines.t[:, 1]).all())

    def test_roof_over_floor(self):
        lines = hsr.visible_lines(scenes.FLOOR_AND_ROOF, "top")
        hidden = numpy.flatnonzero(~lines.visible)
        self.assertEqual(lines.edge[hidden].tolist(), [[0, 1], [2, 3]])
        self.assertEqual(lines.t[hidden].tolist(), [[0.25, 0.5], [0.5, 0.75]])
        self.assertEqual(lines.points[hidden[0]].tolist(), [[1, 0, 0], [2, 0, 0]])
        for i in hidden:
            self.assertEqual(lines.occluders(i).tolist(), [1])
        self.assertEqual(lines.occluders(0).tolist(), [])
        self.assertEqual({lines.class_names[k] for k in lines.edge_class}, {"boundary"})
        self.assertEqual(lines.faces.tolist(), [0] * 8 + [1] * 4)

    def test_arrays_are_the_exact_numbers_rounded_once(self):
        for view in VIEWS:
            lines = hsr.visible_lines(scenes.soup(2), view)
            for i in range(0, len(lines), 7):
                self.assertEqual([float(t) for t in lines.exact(i)], lines.t[i].tolist())
                self.assertEqual([[float(x) for x in p] for p in lines.exact_points(i)], lines.points[i].tolist())
                a, b = lines.edge[i]
                if a < 0:
                    continue
                ends = [[Fraction(x) for x in scenes.soup(2)[0][v]] for v in (a, b)]
                for t, point in zip(lines.exact(i), lines.exact_points(i)):
                    self.assertEqual(tuple(p + t * (q - p) for p, q in zip(*ends)), point)

    def test_json_says_the_same(self):
        lines = hsr.visible_lines(scenes.soup(3), "iso")
        found = json.loads(lines.json())
        self.assertEqual(found["format"], "hsr-lines/1")
        exact = json.loads(lines.json(exact=True))
        self.assertNotEqual(found, exact)

    def test_occluders_hide(self):
        points, faces = scenes.soup(4)
        lines = hsr.visible_lines((points, faces), "top")
        for i in numpy.flatnonzero(~lines.visible & ~lines.behind)[::5]:
            middle = [(p + q) / 2 for p, q in zip(*lines.exact_points(i))]
            self.assertGreater(len(lines.occluders(i)), 0)
            one = [[float(x) for x in middle]]
            if [Fraction(x) for x in one[0]] == middle:  # a double, to be asked by itself
                self.assertTrue(hsr.hidden(one, (points, faces), "top")[0])

    def test_polylines(self):
        (ring,) = hsr.visible_lines(([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]]), "top").polylines()
        self.assertEqual(ring.shape, (5, 2))
        self.assertEqual(ring[0].tolist(), ring[-1].tolist())
        lines = hsr.visible_lines(scenes.soup(5), "iso")
        for visible in (True, False):
            parts = lines.polylines(visible, join=False)
            self.assertEqual(len(parts), (lines.visible == visible).sum())
            joined = lines.polylines(visible)
            self.assertLess(len(joined), len(parts))
            sides = [frozenset({tuple(p), tuple(q)}) for line in joined for p, q in zip(line, line[1:])]
            self.assertEqual(sorted(map(sorted, sides)), sorted(sorted(map(tuple, part)) for part in map(numpy.ndarray.tolist, parts)))

    def test_a_number_out_of_range(self):
        lines = hsr.visible_lines(scenes.CUBE)
        for ask in (lines.exact, lines.exact_points, lines.occluders):
            self.assertRaises(IndexError, ask, len(lines))
            self.assertRaises(IndexError, ask, -1)


class Surfaces(unittest.TestCase):
    def test_a_section_has_caps_of_exact_rings(self):
        cube = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
        faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
        two = [(cube, faces), (cube + [3, 0, 0], faces)]
        view = hsr.View.named("top").with_section(((0, 0, 1), (0, 1, 3)))
        cut = hsr.section(two, view)
        self.assertEqual(cut.object.tolist(), [0, 1])
        self.assertEqual(cut.open_outlines, 0)
        self.assertEqual(sorted(len(rings) for rings in cut.polygons()), [1, 1])
        for x, y, z in cut.exact_points(0):
            self.assertEqual(3 * (z - 1) + y, 0)
        drawn = hsr.draw(two, view=view)
        self.assertIn("visible hatching", drawn.svg())
        self.assertEqual(hsr.hidden([[0.5, 0.5, 0.2], [2, 0.5, 0.2]], two, view).tolist(), [True, False])
        with self.assertRaisesRegex(ValueError, "edge-on"):
            hsr.section(two, hsr.View.named("top").with_section("x=0.5"))
        with self.assertRaisesRegex(ValueError, "section"):
            hsr.View.named("top").with_section(3)

    def test_several_sections_and_a_depth(self):
        cube = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
        faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
        quarter = hsr.View.named("iso").with_section("x=0.5", ((0, 0.25, 0), (0, 1, 0)))
        cut = hsr.section((cube, faces), quarter)
        self.assertEqual(sorted(cut.plane.tolist()), [0, 1])
        self.assertEqual(eval(repr(hsr.View.named("top").with_section("z=1", "x=..2", depth=3)), {"View": hsr.View}),
                         hsr.View.named("top").with_section("z=1", "x=..2", depth=3))
        self.assertEqual(hsr.check((cube, faces), quarter, size=(60, 40)).wrong, 0)
        self.assertGreater(len(hsr.order((cube, faces), quarter)), 5)
        half = hsr.View.named("front").with_section("y=0.5", "x=0.5..")
        self.assertEqual(hsr.hidden([[0.25, 0.75, 0.5], [0.75, 0.25, 0.5]], (cube, faces), half).tolist(), [True, True])
        low = hsr.View.named("top").with_section("z=0.75", depth=0.5)
        self.assertEqual(len(hsr.visible_lines((cube, faces), low).t), 0)
        roof = (numpy.concatenate([cube, cube * [3, 3, 0.5] + [-1, -1, 1]]), faces + [[k + 8 for k in f] for f in faces])
        plan = hsr.View.named("top").with_section("z=0.5")
        self.assertIn("visible overhead", hsr.draw(roof, view=plan, overhead="dashed").svg())
        self.assertNotIn("visible overhead", hsr.draw(roof, view=plan).svg())
        with self.assertRaisesRegex(ValueError, "no plane"):
            hsr.View.named("top").with_section()
        with self.assertRaisesRegex(ValueError, "above 0"):
            hsr.draw(roof, view=hsr.View.named("top").with_section("z=0.5", depth=-1))

    def test_fragments_cover_the_image(self):
        seen = hsr.fragments(scenes.FLOOR_AND_ROOF, "top")
        self.assertEqual(seen.face.tolist(), [0, 0, 1])
        self.assertEqual(sorted(seen.area.tolist()), [2, 4, 4])
        for rings, area in zip(seen.polygons(), seen.area):
            x, y = rings[0].T
            self.assertEqual((x * numpy.roll(y, -1) - y * numpy.roll(x, -1)).sum() / 2, area)

    def test_holes(self):
        floor, roof = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[1, 1, 1], [2, 1, 1], [2, 2, 1], [1, 2, 1]]
        seen = hsr.fragments((floor + roof, [[0, 1, 2, 3], [4, 5, 6, 7]]), "top")
        self.assertEqual([len(rings) for rings in seen.polygons()], [2, 1])
        self.assertEqual(seen.ring_offsets.tolist(), [0, 2, 3])
        self.assertEqual(seen.area.tolist(), [15, 1])

    def test_methods_agree_and_the_caster_too(self):
        for view in VIEWS:
            scene = scenes.soup(6, triangles=20)
            by_lines, by_shadows = hsr.fragments(scene, view), hsr.fragments(scene, view, method="roberts")
            self.assertEqual(sorted(zip(by_lines.face, by_lines.area)), sorted(zip(by_shadows.face, by_shadows.area)))
            check = hsr.check(scene, view, size=(200, 100))
            self.assertTrue(check)
            self.assertEqual((check.samples, check.wrong, check.first_wrong), (20000, 0, []))

    def test_cast(self):
        image = hsr.cast(scenes.FLOOR_AND_ROOF, "top", size=(80, 80))
        self.assertEqual(image.shape, (80, 80))
        self.assertEqual((image == 1).sum(), 20 * 80)
        self.assertEqual((image == 0).sum(), 40 * 60)


class Coplanar(unittest.TestCase):
    def test_who_is_on_top(self):
        square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        scene = [(square, [[0, 1, 2, 3]]), (square, [[0, 1, 2, 3]])]
        self.assertEqual(hsr.fragments(scene, "top").face.tolist(), [0])
        self.assertEqual(hsr.fragments(scene, "top", coplanar="last").face.tolist(), [1])
        self.assertEqual(hsr.order(scene, "top").face.tolist(), [1, 0])
        self.assertEqual(hsr.order(scene, "top", coplanar="last").face.tolist(), [0, 1])


class Orders(unittest.TestCase):
    def test_both_methods_are_right(self):
        scene = scenes.soup(7, triangles=16)
        tree = hsr.tree(scene)
        for view in VIEWS:
            for order in (hsr.order(scene, view), hsr.order(scene, view, method="bsp"), hsr.order(tree, view)):
                self.assertTrue(hsr.verify(order))
                self.assertEqual(order.original.shape, (order.offsets[-1],))
                k = len(order) // 2
                exact = [[float(x) for x in corner] for corner in order.exact_points(k)]
                self.assertEqual(exact, order.points[order.offsets[k] : order.offsets[k + 1]].tolist())

    def test_a_wrong_order_has_a_witness(self):
        points, faces = scenes.FLOOR_AND_ROOF
        self.assertTrue(hsr.verify((points, faces), "top"))
        verdict = hsr.verify((points, faces[::-1]), "top")
        self.assertFalse(verdict)
        (violation,) = verdict.first
        self.assertEqual((violation["earlier"], violation["later"], violation["fault"]), (0, 1, "order"))
        self.assertEqual(violation["of_earlier"][2], 1)
        self.assertEqual(violation["of_later"][2], 0)

    def test_a_cycle(self):
        pierced = ([[-2, -1, 0], [2, -1, 0], [0, 3, 0], [-2, 1, -1], [2, 1, -1], [0, -2, 2]], [[0, 1, 2], [3, 4, 5]])
        verdict = hsr.verify(pierced, "top")
        self.assertFalse(verdict.order_exists)
        self.assertEqual(sorted(verdict.cycle), [0, 1])


class Hidden(unittest.TestCase):
    def test_points(self):
        points = numpy.array([[1.5, 1, 0], [0.5, 1, 0], [1.5, 1, 1], [1, 1, 0], [9, 9, 9]])
        expected = [True, False, False, True, False]
        self.assertEqual(hsr.hidden(points, scenes.FLOOR_AND_ROOF, "top").tolist(), expected)
        self.assertEqual(hsr.hidden(points.astype("f4"), scenes.FLOOR_AND_ROOF, "top").tolist(), expected)
        self.assertEqual(hsr.hidden([], scenes.FLOOR_AND_ROOF, "top").tolist(), [])
        with self.assertRaisesRegex(hsr.InputError, "points, row 1: found z = nan"):
            hsr.hidden([[0, 0, 0], [0, 0, float("nan")]], scenes.CUBE)


class LongWork(unittest.TestCase):
    """Some tenths of a second of it, so that the caller's thread looks after it."""

    scene = hsr.scene(scenes.confetti(8, 3000))

    def test_threads_change_nothing(self):
        results = [hsr.visible_lines(self.scene, threads=n) for n in (1, 2, None)]
        for lines in results[1:]:
            self.assertEqual(lines.t.tobytes(), results[0].t.tobytes())
        self.assertRaisesRegex(hsr.InputError, "threads: found 0", hsr.visible_lines, self.scene, threads=0)

    def test_progress_comes_on_this_thread_and_ends_at_1(self):
        told = []
        hsr.visible_lines(self.scene, progress=lambda done: told.append((done, threading.get_ident())))
        self.assertEqual(told[-1][0], 1)
        self.assertTrue(all(0 <= done <= 1 for done, _ in told))
        self.assertEqual({thread for _, thread in told}, {threading.get_ident()})

    def test_what_progress_raises_ends_the_work(self):
        class Enough(Exception):
            pass

        def stop(done):
            raise Enough

        self.assertRaises(Enough, hsr.visible_lines, self.scene, progress=stop)
        self.assertRaisesRegex(hsr.InputError, "progress: found 3", hsr.visible_lines, self.scene, progress=3)

    def test_other_threads_run_meanwhile(self):
        count = 0
        stop = threading.Event()

        def run():
            nonlocal count
            while not stop.is_set():
                count += 1
                time.sleep(0.001)

        thread = threading.Thread(target=run)
        thread.start()
        hsr.fragments(self.scene)
        stop.set()
        thread.join()
        self.assertGreater(count, 10)

    def test_ctrl_c_ends_the_work(self):
        large = hsr.scene(scenes.confetti(9, 20000))
        hsr.hidden([[0, 0, 0]], large)  # the mesh is made
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(100):
                hsr.visible_lines(large, hsr.View.parallel((1, 2, 3)), edges="all", method="roberts")
        timer.join()
        self.assertEqual(len(hsr.visible_lines(scenes.CUBE)), 12)  # and all goes on


class Errors(unittest.TestCase):
    def test_kinds(self):
        self.assertTrue(issubclass(hsr.InputError, ValueError))
        self.assertTrue(issubclass(hsr.PreconditionError, ValueError))
        self.assertTrue(issubclass(hsr.MemoryLimit, MemoryError))
        self.assertTrue(issubclass(hsr.InvariantError, RuntimeError))

    def test_words(self):
        for named, text in (
            ({"edges": "outline,nothing"}, 'edges: found "nothing", expected all'),
            ({"crease": 200}, "crease: found"),
            ({"crease": (10, 20)}, "crease: found"),
            ({"method": "zbuffer"}, 'method: found "zbuffer", expected one of auto, appel, roberts'),
            ({"coplanar": "middle"}, 'coplanar: found "middle"'),
            ({"tolerance": -1}, "tolerance: found"),
            ({"threads": "two"}, "threads: found"),
        ):
            with self.assertRaises(hsr.InputError) as caught:
                hsr.visible_lines(scenes.CUBE, **named)
            self.assertIn(text, str(caught.exception))
            self.assertNotIn("--", str(caught.exception))

    def test_out_of_memory(self):
        # In a process of its own, whose memory is limited.
        import subprocess
        import sys

        program = (
            "import resource, hsr, scenes\n"
            "scene = hsr.scene(scenes.confetti(9, 20000))\n"
            "hsr.hidden([[0, 0, 0]], scene)\n"
            "used = int(open('/proc/self/statm').read().split()[5]) * 4096\n"
            "resource.setrlimit(resource.RLIMIT_DATA, (used + (1 << 24), used + (1 << 24)))\n"
            "try:\n    hsr.visible_lines(scene, edges='all')\n"
            "except hsr.MemoryLimit as e:\n    print('refused:', e)\n"
        )
        # The scenes are modules beside this one.
        paths = [os.path.dirname(os.path.abspath(__file__)), os.environ.get("PYTHONPATH", "")]
        env = {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}
        ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env=env, check=False)
        self.assertRegex(ran.stdout, "^refused: out of memory, limit .* GB: the scene does not fit", ran.stderr)


if __name__ == "__main__":
    unittest.main()
