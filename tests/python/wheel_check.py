"""pyproject.toml builds a wheel, which serves a fresh environment: module, stubs and command, with nothing from any network.

One of the long tests: `ctest -C long -L long`. HSR_COMMAND is the command of this build, whose bytes the wheel's must write; CMAKE_ARGS
is handed to CMake.
"""

import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

import scenes

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ.get("HSR_COMMAND", "hsr")
PROGRAM = """
import pathlib, sys, hsr
assert pathlib.Path(hsr.__file__).is_relative_to(sys.prefix), hsr.__file__
hsr.draw("cube.obj", ["ours.svg", "ours.pdf"], hidden="dashed")
print(hsr.__version__, len(hsr.visible_lines("cube.obj").t))
"""


def run(*command, **options):
    ran = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **options)
    if ran.returncode != 0:
        raise AssertionError(f"{command}: status {ran.returncode}\n{ran.stdout[-4000:]}\n{ran.stderr[-4000:]}")
    return ran.stdout


MISSING = [name for name in ("pip", "setuptools", "wheel", "venv") if importlib.util.find_spec(name) is None]


@unittest.skipIf(MISSING, f"not installed: {MISSING}")
class Wheel(unittest.TestCase):
    def test_a_fresh_environment(self):
        version = re.search(r"project\(hsr VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        # Without this build's module on the path, and without the network.
        env = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        env["PIP_NO_INDEX"] = "1"
        with tempfile.TemporaryDirectory() as directory:
            work = pathlib.Path(directory)
            pip = [sys.executable, "-m", "pip"]
            run(*pip, "wheel", "--no-build-isolation", "--no-deps", "--no-cache-dir", "-w", work, ROOT, env=env)
            (wheel,) = work.glob("*.whl")
            tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
            self.assertRegex(wheel.name, rf"^hsr-{re.escape(version)}-{tag}-{tag}-linux_\w+\.whl$")
            with zipfile.ZipFile(wheel) as archive:
                names = archive.namelist()
                metadata = archive.read(f"hsr-{version}.dist-info/METADATA").decode()
            sources = [path.name for path in (ROOT / "python" / "hsr").iterdir() if path.suffix in (".py", ".pyi", ".typed")]
            packed = [name for name in names if name.startswith("hsr/") and not name.startswith("hsr/_core.cpython")]
            self.assertEqual(sorted(packed), sorted(f"hsr/{name}" for name in sources))
            self.assertIn(f"hsr-{version}.data/scripts/hsr", names)
            self.assertIn("Requires-Dist: numpy", metadata)

            run(sys.executable, "-m", "venv", "--system-site-packages", work / "venv", env=env)
            python = work / "venv" / "bin" / "python3"
            run(python, "-m", "pip", "install", "--no-deps", wheel, env=env)
            scenes.write_obj(work / "cube.obj", scenes.CUBE)
            self.assertEqual(run(python, "-c", PROGRAM, cwd=work, env=env), f"{version} 12\n")
            run(COMMAND, "draw", "cube.obj", "-q", "-o", "theirs.svg", "-o", "theirs.pdf", "--hidden", "dashed", cwd=work)
            for ending in ("svg", "pdf"):
                self.assertEqual((work / f"ours.{ending}").read_bytes(), (work / f"theirs.{ending}").read_bytes())
            for command in ([work / "venv" / "bin" / "hsr"], [python, "-m", "hsr"]):
                self.assertEqual(run(*command, "--version", cwd=work, env=env), f"hsr {version}\n")


if __name__ == "__main__":
    unittest.main()
