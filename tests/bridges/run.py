#!/usr/bin/env python3
"""Runs the tests of one bridge inside of its program. Usage: run.py three_js|freecad|blender HSR DIRECTORY

Exit status 77: the program is not there; one line says what to install. DIRECTORY is where the package three is put, once.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
BRIDGES = HERE.parents[1] / "bridges"
PAGE = HERE.parents[1] / "docs" / "bridges.md"


def skip(why):
    print(f"skipped: {why}")
    sys.exit(77)


def program(names, package):
    for name in names:
        found = shutil.which(name)
        if found:
            return found
    skip(f"{names[0]} is not on PATH: apt-get install --no-install-recommends {package}")


def three_js(directory):
    node = program(["node"], "nodejs")
    there = pathlib.Path(directory) / "three_js"
    there.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json", "in_node.mjs"):
        shutil.copy(HERE / "three_js" / name, there)
    wanted = json.loads((there / "package.json").read_text(encoding="utf-8"))["dependencies"]["three"]
    has = there / "node_modules" / "three" / "package.json"
    if not has.exists() or json.loads(has.read_text(encoding="utf-8"))["version"] != wanted:
        npm = program(["npm"], "npm")
        try:
            got = subprocess.run([npm, "ci", "--no-audit", "--no-fund"], cwd=there, capture_output=True, timeout=120, check=False)
        except subprocess.TimeoutExpired:
            skip("the npm registry does not answer, which has the package three")
        if got.returncode != 0:
            skip(f"the package three cannot be had from npm: npm ci in {there} says why")
    bridge = shutil.copy(BRIDGES / "three_js" / "hsr_scene.mjs", there)
    return [node, str(there / "in_node.mjs")], bridge


def freecad(directory):
    command = program(["freecadcmd", "FreeCADCmd"], "freecad-python3")
    return [command, str(HERE / "freecad" / "in_freecad.py")], BRIDGES / "freecad"


def blender(directory):
    command = program(["blender"], "blender")
    script = str(HERE / "blender" / "in_blender.py")
    return [command, "--background", "--factory-startup", "--python-exit-code", "1", "--python", script], BRIDGES / "blender"


name, hsr, directory = sys.argv[1:]
arguments, bridge = {"three_js": three_js, "freecad": freecad, "blender": blender}[name](directory)
with tempfile.TemporaryDirectory() as home:  # nobody's settings are read or written
    environment = dict(os.environ, HSR=hsr, BRIDGE=str(bridge), PAGE=str(PAGE), HOME=home, PYTHONDONTWRITEBYTECODE="1")
    # The Python inside of a program looks for its modules beside the first python3 on PATH, which may be another one.
    environment["PATH"] = os.pathsep.join([str(pathlib.Path(arguments[0]).parent), os.environ["PATH"]])
    ran = subprocess.run(arguments, env=environment, stdin=subprocess.DEVNULL, check=False)
sys.exit(1 if ran.returncode else 0)
