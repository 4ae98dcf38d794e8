"""Marks of a mesh; STEP and IGES, where the module is built with them."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import hsr
import scenes

CUBE = (numpy.array(scenes.CUBE_POINTS, dtype=float), numpy.array(scenes.CUBE_FACES))


def classes_of(lines):
    return {lines.class_names[c] for c in lines.edge_class}


class Marks(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory()
        self.addCleanup(self.directory.cleanup)

    def marks(self, **said):
        path = pathlib.Path(self.directory.name) / "marks.json"
        path.write_text(json.dumps({"format": "hsr-marks/1", **said}), encoding="utf-8")
        return path

    def test_one_surface_has_outlines_only(self):
        plain = hsr.visible_lines(CUBE)
        marked = hsr.visible_lines(hsr.scene(CUBE, marks=self.marks(surfaces=[0] * 6)))
        self.assertIn("sharp", classes_of(plain))
        self.assertEqual(classes_of(marked), {"outline"})

    def test_parts_of_a_list_keep_their_marks(self):
        part = hsr.scene(CUBE, marks=self.marks(surfaces=[0] * 6))
        far = (CUBE[0] + [9, 0, 0], CUBE[1])
        lines = hsr.visible_lines(hsr.scene([part, far]))
        sharp = lines.edge[lines.edge_class == lines.class_names.index("sharp")]
        self.assertGreater(len(sharp), 0)
        self.assertTrue((sharp >= 8).all())

    def test_wrong_marks_are_refused(self):
        with self.assertRaisesRegex(hsr.InputError, "surfaces: found 1 numbers"):
            hsr.scene(CUBE, marks=self.marks(surfaces=[0]))
        with self.assertRaisesRegex(hsr.InputError, "chord: found -1"):
            hsr.scene(CUBE, chord=-1)


class Step(unittest.TestCase):
    def test_a_finer_chord_has_more_faces(self):
        shapes = os.environ.get("HSR_STEP_SHAPES")
        if not shapes:
            self.skipTest("hsr is built without STEP")
        with tempfile.TemporaryDirectory() as directory:
            subprocess.run([shapes, directory], check=True)
            path = pathlib.Path(directory) / "cylinder.step"
            coarse, fine = hsr.scene(path, chord=0.5), hsr.scene(path)
            self.assertEqual(coarse.format, "STEP")
            self.assertGreater(len(fine.faces[1]), 2 * len(coarse.faces[1]))
            self.assertEqual(classes_of(hsr.visible_lines(fine)), {"outline", "sharp"})
            assembly = hsr.scene(pathlib.Path(directory) / "assembly.step")
            self.assertEqual(assembly.objects[:3], ["Plate", "Bolts/Bolt", "Bolts/Bolt [2]"])


if __name__ == "__main__":
    unittest.main()
