"""`hsr.sheet` writes what `hsr sheet` writes, byte by byte, for the same request. HSR_COMMAND is the command."""

import inspect
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import hsr

COMMAND = os.environ.get("HSR_COMMAND", "hsr")
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
PIERCED = str(EXAMPLES / "pierced.obj")
FORMATS = ("pdf", "svg", "eps", "dxf", "tex", "hpgl", "plt", "png", "json")

REQUESTS = (
    ({}, []),
    ({"page": "ANSI-B", "hidden": "none"}, ["--page", "ANSI-B", "--hidden", "none"]),
    ({"page": "A2", "angle": "third", "scale": "1:2", "unit": "cm"}, ["--page", "A2", "--angle", "third", "--scale", "1:2", "--unit", "cm"]),
    ({"views": ["front", "iso"], "scale": 0.5, "dimensions": False}, ["--views", "front,iso", "--scale", "0.5:1", "--dimensions", "none"]),
    ({"section": "z=1", "centre_lines": False}, ["--section", "z=1", "--centre-lines", "off"]),
    ({"section": ["x=0.5", "1,1,0@0,0,0"], "page": "A1"}, ["--section", "x=0.5", "--section", "1,1,0@0,0,0", "--page", "A1"]),
    ({"detail": "front:0,0,0:1:20:1"}, ["--detail", "front:0,0,0:1:20:1"]),
    ({"title": {"title": "Block", "owner": "Müller"}}, ["--title", "title=Block", "--title", "owner=Müller"]),
    ({"up_axis": "y", "edges": "outline,sharp", "crease": 20}, ["--up-axis", "y", "--edges", "outline,sharp", "--crease", "20"]),
    ({"pen": "visible=0.35", "fit_arcs": 0.02, "dxf": "2000"}, ["--pen", "visible=0.35", "--fit-arcs", "0.02", "--dxf", "2000"]),
    ({"coplanar": "last", "tolerance": 0.01, "threads": 1}, ["--coplanar", "last", "--tolerance", "0.01", "--threads", "1"]),
    ({"method": "roberts", "stages": "all=never"}, ["--method", "roberts", "--stages", "all=never"]),
)


class Sheets(unittest.TestCase):
    def test_every_request(self):
        for named, options in REQUESTS:
            with self.subTest(options=options), tempfile.TemporaryDirectory() as directory:
                theirs = [os.path.join(directory, f"theirs.{ending}") for ending in FORMATS]
                outputs = [part for path in theirs for part in ("-o", path)]
                size = ["--size", "210x148"]
                subprocess.run([COMMAND, "sheet", PIERCED, *outputs, "-q", *options, *size], check=True)
                ours = [os.path.join(directory, f"ours.{ending}") for ending in FORMATS]
                page = hsr.sheet(PIERCED, ours, size=(210, 148), **named)
                for ending, ours_path, theirs_path in zip(FORMATS, ours, theirs):
                    expected = pathlib.Path(theirs_path).read_bytes()
                    self.assertEqual(pathlib.Path(ours_path).read_bytes(), expected, ending)
                    self.assertEqual(page.written(ending), expected, ending)

    def test_title_block_of_a_file(self):
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory, "fields.json")
            path.write_text('{"title": "Block", "number": "7"}')
            from_file = hsr.sheet(PIERCED, title_block=path)
            self.assertEqual(from_file.svg(), hsr.sheet(PIERCED, title={"title": "Block", "number": "7"}).svg())

    def test_places(self):
        places = json.loads(hsr.sheet(PIERCED, section="z=1").written("json"))
        self.assertEqual([view["name"] for view in places["views"]], ["front", "top", "side", "A-A", "iso"])
        self.assertEqual(len(places["dimensions"]), 3)

    def test_notes_and_errors(self):
        self.assertIn("section A-A: the plane cuts no closed body", hsr.sheet(PIERCED, section="z=1e6").notes)
        for named, text in (
            ({"page": "A9"}, 'page: found "A9", expected A0 ... A4'),
            ({"views": "back"}, 'views: found "back", expected some of front'),
            ({"scale": 1000}, "scale: the views have no room on A3 at 1000:1"),
            ({"title": "Block"}, "title: found 'Block', expected a dict"),
            ({"title": {"colour": "red"}}, 'title: found the field "colour"'),
            ({"section": "w=1"}, 'section: found "w=1"'),
            ({"angle": "second"}, "angle: found"),
        ):
            with self.subTest(named=named), self.assertRaises(hsr.InputError) as caught:
                hsr.sheet(PIERCED, **named)
            self.assertIn(text, str(caught.exception))
            self.assertNotIn("--", str(caught.exception))

    def test_progress(self):
        shares = []
        hsr.sheet(PIERCED, progress=shares.append)
        self.assertTrue(all(0 <= share <= 1 for share in shares))

    def test_every_option_has_an_argument(self):
        """An option that sheet() does not have is one of those that belong to the command alone, or to the scene."""
        shown = subprocess.run([COMMAND, "sheet", "--help"], capture_output=True, text=True, check=True).stdout
        options = {name.replace("-", "_") for name in re.findall(r"^  (?:-\w,)?--([a-z][a-z-]+)", shown, re.M)}
        self.assertGreater(len(options), 25)
        elsewhere = {"help", "output", "report", "quiet", "from", "only", "hide", "ghost", "chord", "marks"}
        self.assertEqual(options - set(inspect.signature(hsr.sheet).parameters) - elsewhere, set())


if __name__ == "__main__":
    unittest.main()
