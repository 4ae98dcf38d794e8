"""`hsr.draw` writes what the command writes, byte by byte, for the same request. HSR_COMMAND is the command."""

import inspect
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import hsr
import scenes

COMMAND = os.environ.get("HSR_COMMAND", "hsr")
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
WOVEN, PIERCED = str(EXAMPLES / "woven.obj"), str(EXAMPLES / "pierced.obj")
# Models to draw besides, where there are any: the directory HSR_MODELS, or that of models beside the repository.
MODELS = pathlib.Path(os.environ.get("HSR_MODELS") or EXAMPLES.parent.parent / "shared" / "models")
SMALL = 8_000  # bytes

FORMATS = ("svg", "pdf", "eps", "dxf", "tex", "hpgl", "plt", "png", "json")
OF_ORDERS = ("svg", "pdf", "eps", "tex", "png", "json")

# Arguments here and options there.
REQUESTS = (
    ({}, []),
    ({"view": "front", "hidden": "dashed"}, ["--view", "front", "--hidden", "dashed"]),
    ({"fill": True, "hidden": "solid", "merge": "coplanar"}, ["--fill", "--hidden", "solid", "--merge", "coplanar"]),
    ({"edges": "all", "crease": 10, "exact": True}, ["--edges", "all", "--crease", "10", "--exact"]),
    ({"edges": ["outline", "sharp"], "crease": (30, 25)}, ["--edges", "outline,sharp", "--crease", "30,25"]),
    ({"view": hsr.View.parallel((1, -2, 3.5), up=(0, 1, 0))}, ["--direction", "1,-2,3.5", "--up", "0,1,0"]),
    ({"view": hsr.View.named("left", target=(1, 2, 3), up_axis="y")}, ["--view", "left", "--target", "1,2,3", "--up-axis", "y"]),
    ({"view": hsr.View.perspective((20, 15, 30)), "fill": True}, ["--eye", "20,15,30", "--fill"]),
    (
        {"view": hsr.View.perspective((20, 15, 30), target=(0.5, 0, 1e-3), fov=20, near=2.5), "hidden": "dashed"},
        ["--eye", "20,15,30", "--target", "0.5,0,1e-3", "--fov", "20", "--near", "2.5", "--hidden", "dashed"],
    ),
    ({"view": hsr.View.perspective((0.5, 0.25, 0.5))}, ["--eye", "0.5,0.25,0.5"]),
    ({"page": "A3", "scale": "1:2", "unit": "cm", "margin": 20}, ["--page", "A3", "--scale", "1:2", "--unit", "cm", "--margin", "20"]),
    ({"page": (120, 80.5), "scale": 0.5, "min_length": 3}, ["--page", "120x80.5mm", "--scale", "0.5:1", "--min-length", "3"]),
    ({"page": "fit", "size": (300, 200)}, ["--page", "fit", "--size", "300x200"]),
    ({"why": True, "method": "roberts"}, ["--why", "--method", "roberts"]),
    ({"fill": True, "method": "roberts", "coplanar": "last"}, ["--fill", "--method", "roberts", "--coplanar", "last"]),
    ({"hidden": "dashed", "pen": "visible=0.35,hidden-sharp=0.18:#555"}, ["--hidden", "dashed", "--pen", "visible=0.35,hidden-sharp=0.18:#555"]),
    ({"pen": {"visible": 0.7, "sharp": ":red"}, "scale": "standard"}, ["--pen", "visible=0.7", "--pen", "sharp=:red", "--scale", "standard"]),
    ({"fit_arcs": 0.05, "hidden": "dashed"}, ["--fit-arcs", "0.05", "--hidden", "dashed"]),
    ({"sort": "pen", "fill": True, "id_prefix": "a-"}, ["--sort", "pen", "--fill", "--id-prefix", "a-"]),
    ({"tolerance": 0.01, "threads": 1}, ["--tolerance", "0.01", "--threads", "1"]),
    ({"dxf": "2000", "hidden": "dashed", "unit": "in"}, ["--dxf", "2000", "--hidden", "dashed", "--unit", "in"]),
    ({"fill": True, "shade": "none", "merge": "colour"}, ["--fill", "--shade", "none", "--merge", "colour"]),
    ({"view": hsr.View.named(oblique=(45, 0.5))}, ["--oblique", "45,0.5"]),
    ({"view": hsr.View.named("top", oblique=(270, 1)), "min_length": 2}, ["--view", "top", "--oblique", "270,1", "--min-length", "2"]),
    ({"view": hsr.View.named().with_section(((0.1, 0.2, 0.3), (1, -2, 0.5))), "fill": True}, ["--section", "1,-2,0.5@0.1,0.2,0.3", "--fill"]),
    ({"view": hsr.View.parallel((1, -3, 0.5), oblique=(30.5, 0.75))}, ["--direction", "1,-3,0.5", "--oblique", "30.5,0.75"]),
    ({"stages": {"all": "never", "far-faces": "always"}}, ["--stages", "all=never,far-faces=always"]),
    ({"arithmetic": "rational", "fill": True}, ["--arithmetic", "rational", "--fill"]),
)

# The same of orders: what is asked of hsr.order, what of its page, and options.
ORDERS = (
    ({}, {}, []),
    ({"method": "bsp", "seed": 3}, {"opacity": 0.5}, ["--method", "bsp", "--seed", "3", "--opacity", "0.5"]),
    ({"method": "naive"}, {"shade": "none"}, ["--method", "naive", "--shade", "none"]),
    ({"method": "z-sort", "coplanar": "last"}, {"exact": True}, ["--method", "z-sort", "--coplanar", "last", "--exact"]),
    (
        {"cuts": "classic", "view": hsr.View.perspective((20, 15, 30), fov=30)},
        {"page": "A3", "pen": "visible=0.7", "id_prefix": "b-", "fit_arcs": 0.1},
        ["--cuts", "classic", "--eye", "20,15,30", "--fov", "30", "--page", "A3", "--pen", "visible=0.7", "--id-prefix", "b-", "--fit-arcs", "0.1"],
    ),
    (
        {"view": "front"},
        {"edges": "all", "crease": 10, "scale": "standard", "margin": 5, "unit": "cm"},
        ["--view", "front", "--edges", "all", "--crease", "10", "--scale", "standard", "--margin", "5", "--unit", "cm"],
    ),
)


def written_by(command, model, endings, options, directory):
    """What the command writes, by ending; its note where it refuses the request."""
    paths = [os.path.join(directory, f"theirs.{ending}") for ending in endings]
    outputs = [part for path in paths for part in ("-o", path)]
    ran = subprocess.run([COMMAND, command, model, *outputs, "-q", *options], capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        return ran.stderr
    return {ending: pathlib.Path(path).read_bytes() for ending, path in zip(endings, paths)}


class SameBytes(unittest.TestCase):
    def compare(self, command, draw, model, endings, options):
        """One call, `draw` of paths, writes all endings, as one run of the command does. `hsr.InputError` where that refuses."""
        with tempfile.TemporaryDirectory() as directory:
            ours = {ending: os.path.join(directory, f"ours.{ending}") for ending in endings}
            theirs = written_by(command, model, endings, options, directory)
            if isinstance(theirs, str):
                self.assertRaises(hsr.InputError, draw, list(ours.values()))
                return 0
            page = draw(list(ours.values()))
            for ending, path in ours.items():
                self.assertEqual(pathlib.Path(path).read_bytes(), theirs[ending], f"{model} {ending} {options}")
                self.assertEqual(page.written(ending), theirs[ending])
            return len(theirs)

    def compare_drawings(self, model, endings, named, options):
        named = {"size": (90, 60), **named} if "png" in endings else named
        options = ["--size", "90x60", *options] if "png" in endings and "--size" not in options else options
        return self.compare("draw", lambda paths: hsr.draw(model, paths, **named), model, endings, options)

    def compare_orders(self, model, endings, asked, named, options):
        order = hsr.order(model, **asked)
        draw = lambda paths: order.draw(paths, size=(90, 60), **named)  # noqa: E731
        return self.compare("order", draw, model, endings, ["--size", "90x60", *options])

    def test_every_request(self):
        with tempfile.TemporaryDirectory() as directory:
            noisy = os.path.join(directory, "soup.obj")
            scenes.write_obj(noisy, scenes.confetti(11, 12))
            for named, options in REQUESTS:
                for model, endings in ((WOVEN, ["svg", "dxf"]), (noisy, ["json"]), (PIERCED, FORMATS)):
                    with self.subTest(model=os.path.basename(model), options=options):
                        self.assertEqual(self.compare_drawings(model, endings, named, options), len(endings))

    def test_every_request_of_an_order(self):
        for asked, named, options in ORDERS:
            for model in (WOVEN, PIERCED):
                with self.subTest(model=os.path.basename(model), options=options):
                    endings = [ending for ending in OF_ORDERS if ending != "eps" or "--opacity" not in options]
                    self.assertEqual(self.compare_orders(model, endings, asked, named, options), len(endings))
        tree = hsr.tree(WOVEN, seed=3)
        draw = lambda paths: hsr.order(tree).draw(paths)  # noqa: E731
        self.assertEqual(self.compare("order", draw, WOVEN, ["pdf"], ["--method", "bsp", "--seed", "3"]), 1)

    def test_generated_scenes(self):
        made = {"cube": scenes.CUBE, "soup": scenes.soup(5), "grid": scenes.soup(6, 25, 3), "confetti": scenes.confetti(7, 60)}
        requests = (({"hidden": "dashed"}, ["--hidden", "dashed"]), ({"fill": True, "dxf": "2000"}, ["--fill", "--dxf", "2000"]))
        with tempfile.TemporaryDirectory() as directory:
            for name, scene in made.items():
                model = os.path.join(directory, f"{name}.obj")
                scenes.write_obj(model, scene)
                for named, options in requests:
                    with self.subTest(name=name, options=options):
                        self.assertEqual(self.compare_drawings(model, FORMATS, named, options), len(FORMATS))
                with self.subTest(name=name, order=True):
                    self.assertEqual(self.compare_orders(model, OF_ORDERS, {}, {}, []), len(OF_ORDERS))

    @unittest.skipUnless(MODELS.is_dir(), "no directory of models: HSR_MODELS names one")
    def test_small_models(self):
        compared = 0
        endings = {".obj", ".off", ".ply", ".stl", ".glb", ".gltf"}
        for path in sorted(path for path in MODELS.rglob("*") if path.suffix in endings and path.stat().st_size < SMALL):
            with self.subTest(path=str(path)):
                model = str(path)
                try:
                    hsr.scene(model)
                except hsr.InputError:
                    continue
                compared += self.compare_drawings(model, FORMATS, {"hidden": "dashed"}, ["--hidden", "dashed"]) > 0
                self.compare_orders(model, OF_ORDERS, {}, {}, [])
        self.assertGreater(compared, 0)

    def test_arrays_draw_as_the_file_with_the_same_numbers(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "cube.obj")
            scenes.write_obj(path, scenes.CUBE)
            from_file, from_arrays = hsr.draw(path, fill=True).svg(), hsr.draw(scenes.CUBE, fill=True).svg()
            self.assertEqual(from_arrays, from_file.replace("<title>cube.obj</title>\n", ""))


class Drawings(unittest.TestCase):
    def test_only_the_outline(self):
        with tempfile.TemporaryDirectory() as directory:
            endings = [ending for ending in FORMATS if ending != "json"]
            theirs = written_by("draw", PIERCED, endings, ["--outline-only"], directory)
            page = hsr.draw(PIERCED, [os.path.join(directory, f"ours.{ending}") for ending in endings], outline_only=True)
            for ending in endings:
                self.assertEqual(pathlib.Path(directory, f"ours.{ending}").read_bytes(), theirs[ending], ending)
                self.assertEqual(page.written(ending), theirs[ending], ending)
            with self.assertRaisesRegex(hsr.InputError, "json"):
                hsr.draw(PIERCED, os.path.join(directory, "a.json"), outline_only=True)

    def test_circles(self):
        disc = [[math.cos(k * math.pi / 48), math.sin(k * math.pi / 48), 0] for k in range(96)], [list(range(96))]
        drawing = hsr.draw(disc, view="top", scale="20:1", fit_arcs=0.05)
        self.assertEqual(drawing.svg().count("A20 20 0 0 "), 3)
        self.assertNotIn("A20", hsr.draw(disc, view="top", scale="20:1").svg())
        self.assertEqual(len(drawing.polylines()[0][0]), 97)
        with self.assertRaisesRegex(hsr.InputError, '^fit_arcs: found "0", expected millimetres, more than 0'):
            hsr.draw(disc, fit_arcs=0)

    def test_pens_of_a_file(self):
        with tempfile.TemporaryDirectory() as directory:
            pens = pathlib.Path(directory, "my.pens")
            pens.write_text("visible = 0.7\nsharp = 0.35:#888\n")
            self.assertEqual(hsr.draw(WOVEN, pens=pens).svg(), hsr.draw(WOVEN, pen=["visible=0.7", "sharp=0.35:#888"]).svg())
        with self.assertRaisesRegex(hsr.InputError, "expected visible, hidden, outline"):
            hsr.draw(WOVEN, pen="edges=1")

    def test_without_a_file(self):
        drawing = hsr.draw(WOVEN, hidden="dashed")
        self.assertTrue(drawing._repr_svg_().startswith("<?xml"))
        self.assertEqual(drawing._repr_svg_(), drawing.svg())
        self.assertEqual(drawing.written("svg"), drawing.svg().encode())
        self.assertTrue(drawing.written("pdf").startswith(b"%PDF"))
        for wanting in ("dxf", "json"):
            with self.assertRaisesRegex(hsr.InputError, f"{wanting}: the drawing was made without it, expected an output that ends in"):
                drawing.written(wanting)
        with self.assertRaisesRegex(hsr.InputError, "format: found the format gif, expected .svg"):
            drawing.written("gif")
        self.assertTrue(drawing.png((40, 30)).startswith(b"\x89PNG"))
        self.assertEqual((drawing.width, drawing.height), (297, 210))
        self.assertTrue(drawing.fits)
        for points, hidden, name in drawing.polylines():
            self.assertTrue((points >= 0).all() and (points[:, 0] <= 297).all() and (points[:, 1] <= 210).all())
            self.assertIn(name, hsr.edge_class_names)
        self.assertTrue(any(hidden for _, hidden, _ in drawing.polylines()))

    def test_notes(self):
        inside = hsr.draw(WOVEN, view=hsr.View.perspective((0.5, 0.25, 0.5)))
        self.assertTrue(any("inside the model's bounding box" in note for note in inside.notes), inside.notes)
        self.assertFalse(any("--" in note for note in inside.notes), inside.notes)

    def test_all_files_or_none(self):
        with tempfile.TemporaryDirectory() as directory:
            good, bad = os.path.join(directory, "a.svg"), os.path.join(directory, "missing", "b.svg")
            self.assertRaises(hsr.InputError, hsr.draw, WOVEN, [good, bad])
            self.assertEqual(os.listdir(directory), [])

    def test_refused(self):
        for output, named, text in (
            ("x.gif", {}, "x.gif"),
            ("x.csv", {}, "x.csv"),
            (None, {"dxf": "r14"}, 'dxf: found "r14", expected one of r12, 2000'),
            (None, {"shade": "dark"}, "shade: found"),
            (None, {"stages": "frame"}, "stages: found"),
            (None, {"arithmetic": "float"}, "arithmetic: found"),
            (None, {"view": hsr.View.named(oblique=(45, -1))}, "oblique: found"),
            (None, {"view": hsr.View.named("top").with_section("z=0"), "why": True}, "section: "),
            (None, {"view": hsr.View.named("top").with_section("z=0"), "outline_only": True}, "section: "),
            (None, {"view": hsr.View.named("top").with_section("u=0")}, "section: found"),
            ("x", {}, "x"),
            (None, {"hidden": "dotted"}, 'hidden: found "dotted", expected one of none, dashed, solid'),
            (None, {"page": "A9"}, "page: found"),
            (None, {"scale": "big"}, "scale: found"),
            (None, {"unit": "mile"}, "unit: found"),
            (None, {"margin": -1}, "margin: found"),
            (None, {"min_length": -1}, "min_length: found"),
            (None, {"size": "7"}, "size: found"),
            (None, {"fill": "yes"}, "fill: found"),
            (None, {"why": True, "method": "appel"}, "why: appel counts"),
        ):
            with self.assertRaises(hsr.InputError) as caught:
                hsr.draw(WOVEN, output, **named)
            self.assertIn(text, str(caught.exception))
            self.assertNotIn("--", str(caught.exception))


# Options that are no arguments, with the reason.
NOT_IN_PYTHON = {
    "--help": "help(hsr)",
    "--from": "a scene is a path or arrays: no standard input",
    "--output": "the second argument, output",
    "--check": "hsr.check",
    "--report": "of a run of the command: times and counts",
    "--section": "View.with_section",
    "--section-each": "a view for each",
    "--quiet": "nothing is said: Drawing.notes",
}


class Options(unittest.TestCase):
    """An option of the command is an argument of its function, of hsr.scene or of hsr.View, or it is listed above."""

    def check(self, command, *functions):
        text = subprocess.run([COMMAND, command, "--help"], capture_output=True, text=True, check=True).stdout
        options = set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.M))
        self.assertGreater(len(options), 20)
        views = (hsr.View.named, hsr.View.parallel, hsr.View.perspective, hsr.View.with_section)
        arguments = {name for function in (*functions, hsr.scene, *views) for name in inspect.signature(function).parameters}
        missing = {option for option in options - set(NOT_IN_PYTHON) if option[2:].replace("-", "_") not in arguments}
        self.assertEqual(missing, set())
        return options

    def test_draw(self):
        self.assertLessEqual(set(NOT_IN_PYTHON), self.check("draw", hsr.draw))

    def test_order(self):
        self.check("order", hsr.order, hsr.Order.draw)


class Command(unittest.TestCase):
    def test_python_m_hsr(self):
        environment = dict(os.environ, PATH=os.path.dirname(COMMAND) + os.pathsep + os.environ.get("PATH", ""))
        ran = subprocess.run([sys.executable, "-m", "hsr", "--version"], capture_output=True, text=True, env=environment, check=True)
        self.assertEqual(ran.stdout.strip(), "hsr " + hsr.__version__)


if __name__ == "__main__":
    unittest.main()
