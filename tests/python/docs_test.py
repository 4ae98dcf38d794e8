"""The documents hold: doctests, the blocks of docs/python.md, the examples, and the stubs."""

import contextlib
import doctest
import importlib.util
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import hsr

ROOT = pathlib.Path(__file__).resolve().parents[2]
HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None


class Documents(unittest.TestCase):
    def test_doctests(self):
        for module in (hsr, sys.modules["hsr._view"], sys.modules["hsr._scene"], sys.modules["hsr._viewport"]):
            result = doctest.testmod(module)
            self.assertGreater(result.attempted, 0)
            self.assertEqual(result.failed, 0)

    def test_every_function_says_what_it_is(self):
        for name in hsr.__all__:
            if not name[0].isupper() and callable(getattr(hsr, name)):
                self.assertGreater(len(getattr(hsr, name).__doc__ or ""), 100, name)

    @unittest.skipUnless(HAS_MATPLOTLIB, "matplotlib is not installed")
    def test_recipes(self):
        page = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", page, re.S)
        self.assertGreater(len(blocks), 3)
        names = {}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as directory, contextlib.redirect_stdout(io.StringIO()):
            os.chdir(directory)
            try:
                for block in blocks:
                    exec(block, names)
                self.assertEqual(sorted(os.listdir(".")), ["cube.dxf", "cube.pdf", "cube.png", "cube.svg", "half.svg", "holes.dxf", "lines.png", "painted.pdf", "plan.svg", "planes.png", "plot.svg",
                                                    "quarter.svg"])
            finally:
                os.chdir(before)

    def test_examples(self):
        examples = {path.name: path for path in (ROOT / "examples" / "python").glob("*.py")}
        with tempfile.TemporaryDirectory() as directory:
            for name, arguments, printed in (
                ("drawing.py", [str(ROOT / "examples" / "woven.obj"), directory], r"\d+ polylines on 297 x 210 mm\n"),
                ("arrays.py", [], r"edge \[0 1\]: hidden from 1/4 to 1/2 by faces \[1\]\nedge \[2 3\]: hidden from 1/2 to 3/4 .*\n"),
                ("plot.py", [os.path.join(directory, "plot.png")], ""),
            ):
                path = examples.pop(name)
                if name == "plot.py" and not HAS_MATPLOTLIB:
                    continue
                ran = subprocess.run([sys.executable, str(path), *arguments], capture_output=True, text=True, check=False)
                self.assertEqual(ran.returncode, 0, ran.stderr)
                self.assertRegex(ran.stdout, f"^{printed}$")
        self.assertEqual(examples, {})

    @unittest.skipUnless(importlib.util.find_spec("mypy") and HAS_MATPLOTLIB, "mypy or matplotlib is not installed")
    def test_stubs(self):
        with tempfile.TemporaryDirectory() as directory:
            configuration = pathlib.Path(directory) / "mypy.ini"
            configuration.write_text("[mypy]\nignore_missing_imports = True\n", encoding="utf-8")
            allowed = pathlib.Path(directory) / "allowed"
            # Modules of our own that nobody imports, and a method that matplotlib makes.
            names = [r"hsr\._.*", r"hsr\.__main__.*", r"hsr\.matplotlib\.OrderedArtist\.set"]
            allowed.write_text("\n".join(names) + "\n", encoding="utf-8")
            options = ["--mypy-config-file", str(configuration), "--allowlist", str(allowed), "--ignore-unused-allowlist"]
            ran = subprocess.run(
                [sys.executable, "-m", "mypy.stubtest", "hsr", *options], capture_output=True, text=True, cwd=directory, check=False
            )
            self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)


if __name__ == "__main__":
    unittest.main()
