"""What bridges/freecad draws, from inside of freecadcmd: run.py runs this with BRIDGE, the folder to test, HSR, the command,
and PAGE, the document."""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import unittest

import FreeCAD
import Part

sys.path.insert(0, os.environ["BRIDGE"])
import hsr_drawing

VECTOR = FreeCAD.Vector
BOX = "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"


def box_file(path, low, size):
    """The same as Part.makeBox, by hand."""
    corners = [[low[k] + (size[k] if j >> (2 - k) & 1 else 0) for k in range(3)] for j in range(8)]
    path.write_text("o Box\n" + "".join("v {} {} {}\n".format(*c) for c in corners) + BOX, encoding="utf-8")


def ends(line):
    return [tuple(p) for part in line["visible_points"] + line["hidden_points"] for p in part]


def parts(lines):
    def both(intervals):
        return [sorted(map(tuple, interval)) for interval in intervals]

    return sorted((x["class"], both(x["visible_points"]), both(x["hidden_points"])) for x in lines)


class Bridge(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.at = pathlib.Path(self.directory.name)
        self.document = FreeCAD.newDocument()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)
        self.directory.cleanup()

    def add(self, shape, label="Shape"):
        o = self.document.addObject("Part::Feature", "Shape")
        o.Shape, o.Label = shape, label
        return o

    def drawn(self, view="iso", options=("--hidden", "dashed")):
        self.document.recompute()
        hsr_drawing.draw(self.document.Objects, self.at / "drawn.json", view, options)
        return json.loads((self.at / "drawn.json").read_text(encoding="utf-8"))

    def directly(self, file, *options):
        command = [os.environ["HSR"], "draw", str(file), "-q", "-o", str(self.at / "direct.json"), "--hidden", "dashed"]
        subprocess.run([*command, *options], check=True)
        return json.loads((self.at / "direct.json").read_text(encoding="utf-8"))

    def test_a_box_is_drawn_exactly_as_by_hand(self):
        self.add(Part.makeBox(10, 20, 30.1, VECTOR(1, 2, 3)))
        box_file(self.at / "box.obj", (1, 2, 3), (10, 20, 30.1))
        self.assertEqual(parts(self.drawn()["lines"]), parts(self.directly(self.at / "box.obj")["lines"]))

    def test_facets_and_the_seam_of_a_cylinder_do_not_show(self):
        self.add(Part.makeCylinder(5, 20))
        lines = self.drawn()["lines"]
        rims = [x for x in lines if {p[2] for p in ends(x)} in ({0}, {20})]
        rest = [x for x in lines if x not in rims]
        self.assertGreater(len(rims), 40)
        self.assertEqual([x["class"] for x in rest], ["outline", "outline"])

    def test_faces_bent_both_ways_show_nothing_but_their_outline(self):
        for shape in (Part.makeSphere(8), Part.makeTorus(20, 3), Part.makeTorus(5, 4), Part.makeSphere(0.01)):
            o = self.add(shape)
            self.assertEqual({x["class"] for x in self.drawn()["lines"]}, {"outline"})
            self.document.removeObject(o.Name)

    def test_facets_of_splines_do_not_show(self):
        points = [[VECTOR(x * 4, y * 4, 3 * math.sin(x) * math.cos(y * 1.3)) for y in range(8)] for x in range(8)]
        surface = Part.BSplineSurface()
        surface.interpolate(points)
        self.add(surface.toShape())
        self.assertEqual({x["class"] for x in self.drawn()["lines"]}, {"outline", "boundary"})

    def test_a_shallow_edge_of_a_chain_with_itself_is_drawn(self):
        wire = Part.Wire([Part.makeLine(VECTOR(-2, 0, 0), VECTOR(20, 0, 0)),
                          Part.Arc(VECTOR(20, 0, 0), VECTOR(25, 5, 0), VECTOR(20, 10, 0)).toShape(),
                          Part.makeLine(VECTOR(20, 10, 0), VECTOR(0, 10, 0)),
                          Part.Arc(VECTOR(0, 10, 0), VECTOR(-5.2, 4.8, 0), VECTOR(-2, 0, 0)).toShape()])
        self.add(Part.Face(wire).extrude(VECTOR(0, 0, 30)))
        lines = [x for x in self.drawn()["lines"] if x["class"] == "material" and {p[2] for p in ends(x)} == {0, 30}]
        upright = [{p[:2] for p in ends(x)} for x in lines]
        corner = [one for one in upright if len(one) == 1 and math.dist(*one, (-2, 0)) < 1e-9]
        self.assertEqual((len(corner), len(upright)), (1, 2))

    def test_a_fillet_goes_on_and_a_shallow_ridge_is_an_edge(self):
        box = Part.makeBox(30, 20, 10)
        upright = [e for e in box.Edges if e.Vertexes[0].Z != e.Vertexes[1].Z]
        self.add(box.makeFillet(4, upright))
        self.assertEqual({x["class"] for x in self.drawn()["lines"] if {p[2] for p in ends(x)} == {0, 10}}, {"outline"})
        self.document.removeObject(self.document.Objects[0].Name)
        roof = [VECTOR(*p) for p in ((0, 0, 0), (20, 0, 0), (20, 0, 5), (10, 0, 6), (0, 0, 5), (0, 0, 0))]
        self.add(Part.Face(Part.makePolygon(roof)).extrude(VECTOR(0, 40, 0)))
        ridge = [x for x in self.drawn()["lines"] if {(p[0], p[2]) for p in ends(x)} == {(10, 6)}]
        self.assertEqual([x["class"] for x in ridge], ["material"])

    def test_objects_are_where_the_document_has_them(self):
        part = self.document.addObject("App::Part", "Assembly")
        part.Placement.Base = VECTOR(100, 0, 0)
        inner = self.document.addObject("App::Part", "Inner")
        inner.Placement.Base = VECTOR(0, 10, 0)
        part.addObject(inner)
        box = self.add(Part.makeBox(1, 2, 4), "a box")
        box.Placement.Base = VECTOR(0, 0, 8)
        inner.addObject(box)
        hidden = self.add(Part.makeBox(500, 500, 500), "hidden")
        hidden.Visibility = False
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = self.document.addObject("Part::Box", "Base"), self.document.addObject("Part::Cylinder", "Tool")
        body = self.document.addObject("PartDesign::Body", "Body")
        solid = body.newObject("PartDesign::AdditiveBox", "Solid")
        solid.Length = 3
        rod = self.document.addObject("Part::Box", "Rod")  # one that another only measures is drawn
        rod.Placement.Base = VECTOR(0, 300, 0)
        solid.setExpression("Width", "Rod.Width / 2")
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject, link.Label = box, "another"
        link.Placement.Base = VECTOR(-50, 0, 0)
        found = self.drawn()
        self.assertEqual(sorted(found["objects"]), ["Body", "Cut", "Rod", "a box", "another"])
        name = {k: [p for x in found["lines"] if x.get("object") == i for p in ends(x)] for i, k in enumerate(found["objects"])}
        self.assertEqual((min(name["a box"]), max(name["a box"])), ((100, 10, 8), (101, 12, 12)))
        self.assertEqual((min(name["another"]), max(name["another"])), ((-50, 0, 0), (-49, 2, 4)))
        # One that stands in a part, chosen alone.
        hsr_drawing.draw([box], self.at / "one.json")
        corners = [p for x in json.loads((self.at / "one.json").read_text())["lines"] for p in ends(x)]
        self.assertEqual((min(corners), max(corners)), ((100, 10, 8), (101, 12, 12)))

    def test_cameras(self):
        self.add(Part.makeBox(10, 20, 30))
        box_file(self.at / "box.obj", (0, 0, 0), (10, 20, 30))
        turned = "viewportMapping ADJUST_CAMERA\n position 40 10 15\n orientation 0.57735026 0.57735026 0.57735026 2.0943952\n"
        seen = self.drawn("#Inventor V2.1 ascii\n\nPerspectiveCamera {\n " + turned + " focalDistance 35\n heightAngle 0.78539819\n}")
        self.assertEqual(seen["view"]["eye"], [40, 10, 15, 1])
        direct = self.directly(self.at / "box.obj", "--eye=40,10,15", "--target=5,10,15", "--up=0,0,1")
        self.assertEqual(len(seen["lines"]), len(direct["lines"]))
        for a, b in zip(seen["view"]["frame"]["up"] + seen["view"]["target"], [0, 0, 1, 5, 10, 15]):
            self.assertAlmostEqual(a, b, 5)
        seen = self.drawn("#Inventor V2.1 ascii\n\nOrthographicCamera {\n " + turned + " height 80\n}\n")
        for a, b in zip(seen["view"]["eye"], [1, 0, 0, 0]):
            self.assertAlmostEqual(a, b, 6)
        options = hsr_drawing.view_options("PerspectiveCamera {" + turned + "focalDistance 35\nheightAngle 0.78539819\n}")
        self.assertTrue(any(re.match(r"--fov=45\.0000", o) for o in options), options)

    def test_millimetres(self):
        self.add(Part.makeBox(40, 20, 30))
        outputs = [self.at / "x.svg", self.at / "x.dxf"]
        hsr_drawing.draw(self.document.Objects, outputs, "front", ["--scale", "1:1", "--page", "fit"])
        size = re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', (self.at / "x.svg").read_text(encoding="utf-8"))
        self.assertEqual([float(x) - 20 for x in size.groups()], [40, 30])  # less the margins
        self.assertIn("AC1009", (self.at / "x.dxf").read_text(encoding="utf-8"))

    def test_colours(self):
        view = types.SimpleNamespace(ShapeColor=(1.0, 0.0, 0.5, 0.0), DiffuseColor=[(1.0, 0.0, 0.5, 0.0)], Transparency=25)
        self.assertEqual(hsr_drawing.colours_of(view, 3), [(1.0, 0.0, 0.5, 0.75)] * 3)
        view.DiffuseColor = [(1.0, 0, 0, 0), (0, 1.0, 0, 0)]
        self.assertEqual(hsr_drawing.colours_of(view, 2), [(1.0, 0, 0, 0.75), (0, 1.0, 0, 0.75)])
        look = types.SimpleNamespace(ShapeAppearance=[types.SimpleNamespace(DiffuseColor=(0, 0, 1.0, 0))])
        self.assertEqual(hsr_drawing.colours_of(look, 2), [(0, 0, 1.0, 1)] * 2)
        view = types.SimpleNamespace(ShapeColor=(1.0, 0.0, 0.0, 0.0))
        hsr_drawing.write_model([("Red", Part.makeBox(1, 1, 1), view)], str(self.at / "red.obj"))
        command = [os.environ["HSR"], "info", str(self.at / "red.obj")]
        self.assertRegex(subprocess.run(command, capture_output=True, text=True, check=True).stdout, r"colours\s+1: #ff0000")

    def test_the_script_of_the_document_draws(self):
        self.add(Part.makeCylinder(5, 20))
        self.document.recompute()
        self.document.saveAs(str(self.at / "part.FCStd"))
        (script,) = re.findall(r"```python\n(.*?)```", pathlib.Path(os.environ["PAGE"]).read_text(encoding="utf-8"), re.S)
        before = os.getcwd()
        os.chdir(self.at)
        try:
            exec(script, {})
        finally:
            os.chdir(before)
        self.assertTrue((self.at / "part.svg").exists() and (self.at / "part.dxf").exists())

    def test_what_goes_wrong_is_said_in_one_line(self):
        with self.assertRaisesRegex(RuntimeError, "^hsr: found no visible shape, [^\n]*$"):
            self.drawn()
        self.add(Part.makeBox(1, 1, 1))
        with self.assertRaisesRegex(RuntimeError, r"^hsr: [^\n]*x\.xyz[^\n]*$"):
            hsr_drawing.draw(self.document.Objects, self.at / "x.xyz")
        command, os.environ["HSR"] = os.environ["HSR"], "/nowhere/hsr"
        try:
            with self.assertRaisesRegex(RuntimeError, "^hsr: /nowhere/hsr cannot be run: [^\n]*$"):
                self.drawn()
        finally:
            os.environ["HSR"] = command


ran = unittest.TextTestRunner(stream=sys.stderr).run(unittest.defaultTestLoader.loadTestsFromTestCase(Bridge))
sys.stderr.flush()
os._exit(0 if ran.wasSuccessful() and ran.testsRun > 0 else 1)
