"""`hsr.draw` writes what the command writes, byte by byte, for the same request. HSR_COMMAND is the command."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import hsr
import scenes

COMMAND = os.environ.get("HSR_COMMAND", "hsr")
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
WOVEN, PIERCED = str(EXAMPLES / "woven.obj"), str(EXAMPLES / "pierced.obj")

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
    ({"sort": "pen", "fill": True, "id_prefix": "a-"}, ["--sort", "pen", "--fill", "--id-prefix", "a-"]),
    ({"tolerance": 0.01, "threads": 1}, ["--tolerance", "0.01", "--threads", "1"]),
)


class SameBytes(unittest.TestCase):
    def compare(self, model, endings, named, options, directory):
        """One call writes all endings, as one run of the command does."""
        ours = [os.path.join(directory, f"ours.{ending}") for ending in endings]
        theirs = [os.path.join(directory, f"theirs.{ending}") for ending in endings]
        hsr.draw(model, ours, **named)
        outputs = [part for path in theirs for part in ("-o", path)]
        subprocess.run([COMMAND, "draw", model, *outputs, "-q", *options], check=True)
        for mine, other in zip(ours, theirs):
            self.assertEqual(pathlib.Path(mine).read_bytes(), pathlib.Path(other).read_bytes(), f"{other} {options}")

    def test_every_request(self):
        with tempfile.TemporaryDirectory() as directory:
            noisy = os.path.join(directory, "soup.obj")
            scenes.write_obj(noisy, scenes.confetti(11, 12))
            for named, options in REQUESTS:
                for model, endings in ((WOVEN, ["svg"]), (noisy, ["json"]), (PIERCED, ["svg", "png", "json"])):
                    with self.subTest(model=os.path.basename(model), options=options):
                        small = {"size": (90, 60), **named} if "png" in endings else named
                        options_of_small = ["--size", "90x60", *options] if small is not named and "size" not in named else options
                        self.compare(model, endings, small, options_of_small, directory)

    def test_arrays_draw_as_the_file_with_the_same_numbers(self):
        with tempfile.TemporaryDirectory() as directory:
            path = os.path.join(directory, "cube.obj")
            scenes.write_obj(path, scenes.CUBE)
            from_file, from_arrays = hsr.draw(path, fill=True).svg(), hsr.draw(scenes.CUBE, fill=True).svg()
            self.assertEqual(from_arrays, from_file.replace("<title>cube.obj</title>\n", ""))


class Drawings(unittest.TestCase):
    def test_only_the_outline(self):
        with tempfile.TemporaryDirectory() as directory:
            mine, other = os.path.join(directory, "mine.svg"), os.path.join(directory, "other.svg")
            hsr.draw(PIERCED, mine, outline_only=True)
            subprocess.run([COMMAND, "draw", PIERCED, "-o", other, "-q", "--outline-only"], check=True)
            self.assertEqual(pathlib.Path(mine).read_bytes(), pathlib.Path(other).read_bytes())
            with self.assertRaisesRegex(hsr.InputError, "json"):
                hsr.draw(PIERCED, os.path.join(directory, "a.json"), outline_only=True)

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
            ("x.pdf", {}, "x.pdf"),
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


class Command(unittest.TestCase):
    def test_python_m_hsr(self):
        environment = dict(os.environ, PATH=os.path.dirname(COMMAND) + os.pathsep + os.environ.get("PATH", ""))
        ran = subprocess.run([sys.executable, "-m", "hsr", "--version"], capture_output=True, text=True, env=environment, check=True)
        self.assertEqual(ran.stdout.strip(), "hsr " + hsr.__version__)


if __name__ == "__main__":
    unittest.main()
