"""What bridges/blender draws, from inside of Blender: run.py runs this with BRIDGE, the folder to test, and HSR, the command."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import bpy
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector

sys.path.insert(0, os.environ["BRIDGE"])
import hsr_drawing

CUBE = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def by_hand(boxes):
    """An OBJ file of boxes: name, middle, half of the size."""
    lines, first = [], 1
    for name, middle, half in boxes:
        lines.append(f"o {name}")
        lines += ["v {} {} {}".format(*(m + h * c for m, h, c in zip(middle, half, corner))) for corner in CUBE]
        lines += ["f {} {} {} {}".format(*(first + i for i in face)) for face in FACES]
        first += 8
    return "\n".join(lines) + "\n"


def parts(json_file):
    """Class, object, and the exact visible and hidden parts of each line, whichever way round it is stored."""
    found = json.loads(json_file.read_text(encoding="utf-8"))
    names = found.get("objects", [])

    def ends(intervals):
        return sorted(sorted(map(tuple, interval)) for interval in intervals)

    return sorted(
        (x["class"], names[x["object"]] if "object" in x else "", ends(x["visible_points"]), ends(x["hidden_points"]))
        for x in found["lines"]
    )


class Bridge(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.directory = tempfile.TemporaryDirectory()
        self.at = pathlib.Path(self.directory.name)
        self.scene = bpy.context.scene
        self.camera = bpy.data.objects.new("Eye", bpy.data.cameras.new("Eye"))
        self.scene.collection.objects.link(self.camera)
        self.scene.camera = self.camera
        self.look((6, -9, 5), (0.5, 0, 0.5))

    def tearDown(self):
        self.directory.cleanup()

    def look(self, eye, target):
        self.camera.location = eye
        self.camera.rotation_euler = (Vector(eye) - Vector(target)).to_track_quat("Z", "Y").to_euler()

    def mesh(self, name, points=CUBE, edges=(), faces=FACES):
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(points, edges, faces)
        o = bpy.data.objects.new(name, mesh)
        self.scene.collection.objects.link(o)
        return o

    def drawn(self, *options):
        bpy.context.view_layer.update()
        hsr_drawing.draw(self.at / "drawn.json", ["--exact", "--hidden", "dashed", *options])
        return parts(self.at / "drawn.json")

    def directly(self, boxes, *view):
        (self.at / "direct.obj").write_text(by_hand(boxes), encoding="utf-8")
        command = [os.environ["HSR"], "draw", str(self.at / "direct.obj"), "-q", "--exact", "--hidden", "dashed", *view]
        subprocess.run([*command, "-o", str(self.at / "direct.json")], check=True)
        return parts(self.at / "direct.json")

    def scene_of_boxes(self):
        """Scaled, parented, with a modifier, as instances of a collection and on points; and what must not be there."""
        parent = bpy.data.objects.new("Parent", None)
        self.scene.collection.objects.link(parent)
        parent.location = (0.5, 0, -1)
        slab = self.mesh("Slab")
        slab.parent, slab.scale = parent, (4, 2, 0.25)
        row = self.mesh("Row")
        row.location, row.scale = (-2, -1, 0.25), (0.5, 0.5, 0.75)
        array = row.modifiers.new("Array", "ARRAY")
        array.use_relative_offset, array.use_constant_offset, array.count = False, True, 2
        array.constant_offset_displace = (4, 0, 0)
        apart = bpy.data.collections.new("Apart")
        inner = self.mesh("Inner")
        self.scene.collection.objects.unlink(inner)
        apart.objects.link(inner)
        inner.scale = (0.25, 0.25, 0.5)
        for x in (1, 3):
            holder = bpy.data.objects.new("Holder", None)
            holder.instance_type, holder.instance_collection = "COLLECTION", apart
            holder.location = (x, 1, 0)
            self.scene.collection.objects.link(holder)
        hidden = self.mesh("Hidden")
        hidden.hide_render, hidden.scale = True, (20, 20, 20)
        self.mesh("Away").hide_viewport = True
        return [
            ("Slab", (0.5, 0, -1), (4, 2, 0.25)),
            ("Row", (-2, -1, 0.25), (0.5, 0.5, 0.75)),
            ("Row", (0, -1, 0.25), (0.5, 0.5, 0.75)),
            ("Inner", (1, 1, 0), (0.25, 0.25, 0.5)),
            ("Inner [2]", (3, 1, 0), (0.25, 0.25, 0.5)),
        ]

    def test_a_perspective_shows_exactly_the_lines_of_the_same_scene_by_hand(self):
        boxes = self.scene_of_boxes()
        drawn = self.drawn()
        self.assertEqual(drawn, self.directly(boxes, "--eye=6,-9,5", "--target=0.5,0,0.5", "--near=0.1"))
        self.assertEqual({name for _, name, _, _ in drawn}, {"Slab", "Row", "Inner", "Inner [2]"})
        hsr_drawing.draw(self.at / "view.json")
        view = json.loads((self.at / "view.json").read_text(encoding="utf-8"))["view"]
        distance = (Vector(view["target"]) - Vector(view["eye"][:3])).length  # near is in distances of the target
        self.assertAlmostEqual(view["near"] * distance, self.camera.data.clip_start, 5)

    def test_an_orthographic_camera_shows_exactly_the_lines_of_the_same_scene_by_hand(self):
        boxes = self.scene_of_boxes()
        self.camera.data.type = "ORTHO"
        drawn = self.drawn()
        back = [self.camera.matrix_world[k][2] for k in range(3)]
        self.assertLess((Vector(back) - Vector((5.5, -9, 4.5)).normalized()).length, 1e-6)
        self.assertEqual(drawn, self.directly(boxes, "--direction=" + ",".join(map(repr, back))))

    def test_on_the_page_a_point_is_where_the_camera_puts_it(self):
        self.mesh("Cube")
        self.look((12, -18, 10), (0.5, 0, 0.5))
        cases = [
            ({}, {}),
            ({"sensor_fit": "VERTICAL"}, {}),
            ({"sensor_fit": "HORIZONTAL"}, {"resolution_x": 400}),
            ({}, {"resolution_x": 400}),
            ({"shift_x": 0.06, "shift_y": -0.04}, {}),
            ({"sensor_fit": "VERTICAL", "shift_y": 0.05}, {"resolution_x": 700}),
            ({}, {"pixel_aspect_x": 2}),
        ]
        for lens, render in cases:
            with self.subTest(lens=lens, render=render):
                data = self.camera.data
                data.sensor_fit, data.shift_x, data.shift_y = "AUTO", 0, 0
                self.scene.render.resolution_x, self.scene.render.resolution_y, self.scene.render.pixel_aspect_x = 1600, 900, 1
                for of, settings in ((data, lens), (self.scene.render, render)):
                    for name, value in settings.items():
                        setattr(of, name, value)
                self.points_are_in_place()

    def points_are_in_place(self):
        bpy.context.view_layer.update()
        hsr_drawing.draw(self.at / "page.svg", ["--hidden", "solid"])
        svg = (self.at / "page.svg").read_text(encoding="utf-8")
        width, height = map(float, re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg).groups())
        numbers = [float(x) for d in re.findall(r' d="M([^"]*)"', svg) for x in re.findall(r"[\d.]+", d)]
        points = list(zip(numbers[::2], numbers[1::2]))
        frame = self.camera.data.view_frame(scene=self.scene)
        low = [min(c[k] for c in frame) / -frame[0].z for k in range(2)]
        high = [max(c[k] for c in frame) / -frame[0].z for k in range(2)]
        half = [max(abs(low[k]), abs(high[k])) for k in range(2)]
        self.assertAlmostEqual(half[0] / half[1], (width - 20) / (height - 20), 3)
        for corner in CUBE:
            share = world_to_camera_view(self.scene, self.camera, Vector(corner))
            x, y = ((low[k] + (high[k] - low[k]) * share[k]) / half[k] for k in range(2))
            x, y = width / 2 + x * (width / 2 - 10), height / 2 - y * (height / 2 - 10)
            self.assertTrue(10 < x < width - 10 and 10 < y < height - 10, "the cube is in the picture")
            self.assertLess(min(((px - x) ** 2 + (py - y) ** 2) ** 0.5 for px, py in points), 0.01)

    def test_a_turned_mesh_stays_closed(self):
        bpy.ops.mesh.primitive_uv_sphere_add(rotation=(0.3, 0.5, 0.7), scale=(1, 1.5, 0.8))
        self.assertEqual({x[0] for x in self.drawn()}, {"outline"})

    def test_curves_text_and_loose_edges(self):
        bpy.ops.object.text_add()
        bpy.context.object.data.extrude = 0.1
        self.assertTrue({"outline", "sharp"} <= {x[0] for x in self.drawn()})
        self.mesh("Loose", [(0, 0, 3), (2, 0, 3)], [(0, 1)], [])
        wires = [x[2:] for x in self.drawn() if x[0] == "wire"]
        self.assertEqual(wires, [([[("0", "0", "3"), ("2", "0", "3")]], [])])

    def test_colours_of_materials(self):
        cube = self.mesh("Cube")
        for name, colour in (("nodes", (1, 0, 0, 1)), ("viewport", (0.2158605, 0.2158605, 0.2158605, 1))):
            material = bpy.data.materials.new(name)
            material.use_nodes = name == "nodes"
            if material.use_nodes:
                material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = colour
            material.diffuse_color = colour
            cube.data.materials.append(material)
        cube.data.polygons[5].material_index = 1
        hsr_drawing.draw(self.at / "x.svg", ["--fill", "--shade", "none"])
        fills = set(re.findall(r'fill="(#[0-9a-f]{6})"', (self.at / "x.svg").read_text(encoding="utf-8")))
        self.assertEqual(fills, {"#ff0000", "#808080"})

    def test_units(self):
        self.mesh("Cube")
        self.camera.data.type = "ORTHO"
        self.look((0, -9, 0), (0, 0, 0))
        for length, size in ((1.0, 100), (0.01, 1)):
            self.scene.unit_settings.scale_length = length
            bpy.context.view_layer.update()
            hsr_drawing.draw(self.at / "x.svg", ["--scale", "1:20", "--page", "fit", "--margin", "0"])
            found = re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', (self.at / "x.svg").read_text(encoding="utf-8"))
            for side in found.groups():
                self.assertAlmostEqual(float(side), size, 2)

    def test_the_operator_of_the_menu(self):
        hsr_drawing.register()
        try:
            self.mesh("Cube")
            bpy.context.view_layer.update()
            path = self.at / "x.pdf"
            export = bpy.ops.export_scene.hsr_drawing
            self.assertEqual(export(filepath=str(path), hidden="dashed", options="--page A5"), {"FINISHED"})
            self.assertEqual(path.read_bytes()[:5], b"%PDF-")
            with self.assertRaisesRegex(RuntimeError, "hsr: .*x.xyz"):
                export(filepath=str(self.at / "x.xyz"))
        finally:
            hsr_drawing.unregister()

    def test_what_goes_wrong_is_said_in_one_line(self):
        def refused(pattern, **given):
            with self.assertRaisesRegex(RuntimeError, rf"\Ahsr: [^\n]*{pattern}[^\n]*\Z"):
                hsr_drawing.draw(self.at / "x.svg", **given)

        refused("found nothing that is rendered")
        self.mesh("Cube")
        bpy.context.view_layer.update()
        refused("cannot be run", command="/nowhere/hsr")
        refused("--hiden", options=["--hiden"])
        self.camera.data.type = "PANO"
        refused("expected a perspective")
        self.scene.camera = None
        refused("without a camera")

    def test_as_a_command(self):
        self.mesh("Cube")
        bpy.ops.wm.save_as_mainfile(filepath=str(self.at / "x.blend"))
        script = os.path.join(os.environ["BRIDGE"], "hsr_drawing.py")

        def ran(*arguments):
            command = [bpy.app.binary_path, "--background", "--factory-startup", str(self.at / "x.blend"), "--python", script, "--"]
            return subprocess.run([*command, *arguments], capture_output=True, text=True, check=False)

        done = ran(str(self.at / "x.svg"), str(self.at / "x.dxf"), "--hidden", "dashed")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.at / "x.svg").exists() and (self.at / "x.dxf").exists())
        wrong = ran(str(self.at / "x.xyz"))
        self.assertEqual(wrong.returncode, 2)
        self.assertRegex(wrong.stderr, "(?m)^hsr: .*x.xyz")


ran = unittest.TextTestRunner(stream=sys.stderr).run(unittest.defaultTestLoader.loadTestsFromTestCase(Bridge))
sys.stderr.flush()
os._exit(0 if ran.wasSuccessful() and ran.testsRun > 0 else 1)
