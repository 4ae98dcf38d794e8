#!/usr/bin/env python3
"""Makes the pictures of the README and of the decisions with the command, and lays white paper under them, so that they look
the same on white and on black pages.

    docs/pictures.py --hsr build/release/bin/hsr --part build/release/examples/part_model            writes docs/*.svg
    docs/pictures.py --hsr ... --part ... --check      fails if a picture is not what the command makes today, or if the README
                                                       shows another command for it

The page is cut to the drawing (--page fit), which the commands in the README leave out; that of a sheet is not. Standard library only.
"""

import argparse
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Picture -> the command that makes it, as the README shows it if it shows it.
PICTURES = {
    "part_filled.svg": "hsr draw part.obj -o part_filled.svg --fill --merge coplanar",
    "part.svg": "hsr draw part.obj -o part.svg --hidden dashed",
    "part_sheet.svg": 'hsr sheet part.obj -o part_sheet.svg --section y=0 --title "title=Gear on a flange" --title material=C45',
    "part_section.svg": "hsr draw part.obj -o part_section.svg --section y=0",
    "sheet_gear_box.svg": 'hsr sheet gear_box.obj -o sheet_gear_box.svg --section z=50 --section x=50 --hidden none '
                          '--title "title=Gear box"',
    "sheet_house.svg": "hsr sheet house.obj -o sheet_house.svg --unit m --page A2 --section z=1.2 --section x=0.9 --hidden none "
                       "--title title=House",
    "pierced.svg": "hsr draw examples/pierced.obj -o pierced.svg --fill --hidden dashed",
    "woven.svg": "hsr order examples/woven.obj -o woven.svg --direction 1,-2,3",
    "woven_naive.svg": "hsr order examples/woven.obj -o woven_naive.svg --direction 1,-2,3 --method naive",
}
# Of a model that is made with Open CASCADE: written where that is there, and not compared, as its last digits are its own.
OF_STEP = {"sheet_assembly.svg": "hsr sheet assembly.step -o sheet_assembly.svg --section y=12 --title title=Assembly"}
IN_SHEETS = ["sheet_gear_box.svg", "sheet_house.svg"]
IN_README = ["part.svg", "part_sheet.svg", "part_section.svg", "pierced.svg", "woven.svg"]


def on_white(svg):
    width, height = map(float, re.search(r'viewBox="0 0 ([0-9.]+) ([0-9.]+)"', svg).groups())
    paper = f'<rect width="{width:g}" height="{height:g}" fill="#fff"/>\n'
    head, desc, rest = svg.partition("</desc>\n")
    return head + desc + paper + rest


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--hsr", required=True, type=pathlib.Path, help="the command")
    parser.add_argument("--part", required=True, type=pathlib.Path, help="the program that writes part.obj")
    parser.add_argument("--step-shapes", type=pathlib.Path, help="the program that writes assembly.step, where hsr reads STEP")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where a picture differs")
    a = parser.parse_args()
    readme, problems = (ROOT / "README.md").read_text(), []
    problems += [f"README.md does not show: {PICTURES[name]}" for name in IN_README if PICTURES[name] not in readme]
    sheets = (ROOT / "docs" / "sheets.md").read_text()
    shown = [PICTURES[name] for name in IN_SHEETS] + list(OF_STEP.values())
    problems += [f"docs/sheets.md does not show: {command}" for command in shown if command not in sheets]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([str(a.part.resolve()), f"{folder}/part.obj"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([sys.executable, str(ROOT / "docs" / "sheet_models.py"), folder], check=True)
        pictures = dict(PICTURES)
        if a.step_shapes and not a.check:
            subprocess.run([str(a.step_shapes.resolve()), folder], check=True)
            pictures |= OF_STEP
        for name, command in pictures.items():
            words = shlex.split(command)[1:]
            words = [str(ROOT / w) if w.startswith("examples/") else w for w in words]
            page = [] if words[0] == "sheet" else ["--page", "fit"]
            subprocess.run([str(a.hsr.resolve())] + words + page + ["-q"], cwd=folder, check=True)
            made = on_white((pathlib.Path(folder) / name).read_text())
            file = ROOT / "docs" / name
            if not a.check:
                file.write_text(made)
            elif not file.exists() or file.read_text() != made:
                problems.append(f"docs/{name} is not what the command makes today: run docs/pictures.py")
    for problem in problems:
        print(problem)
    print(f"{len(pictures)} pictures, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
