#!/usr/bin/env python3
"""Makes the pictures of the README and of the decisions with the command, and lays white paper under them, so that they look
the same on white and on black pages.

    docs/pictures.py --hsr build/release/bin/hsr --part build/release/examples/part_model            writes docs/*.svg
    docs/pictures.py --hsr ... --part ... --check      fails if a picture is not what the command makes today, or if the README
                                                       shows another command for it

The page is cut to the drawing (--page fit), which the commands in the README leave out. Standard library only.
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
    "part_section.svg": "hsr draw part.obj -o part_section.svg --section y=0",
    "pierced.svg": "hsr draw examples/pierced.obj -o pierced.svg --fill --hidden dashed",
    "woven.svg": "hsr order examples/woven.obj -o woven.svg --direction 1,-2,3",
    "woven_naive.svg": "hsr order examples/woven.obj -o woven_naive.svg --direction 1,-2,3 --method naive",
}
IN_README = ["part.svg", "part_section.svg", "pierced.svg", "woven.svg"]


def on_white(svg):
    width, height = map(float, re.search(r'viewBox="0 0 ([0-9.]+) ([0-9.]+)"', svg).groups())
    paper = f'<rect width="{width:g}" height="{height:g}" fill="#fff"/>\n'
    head, desc, rest = svg.partition("</desc>\n")
    return head + desc + paper + rest


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--hsr", required=True, type=pathlib.Path, help="the command")
    parser.add_argument("--part", required=True, type=pathlib.Path, help="the program that writes part.obj")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where a picture differs")
    a = parser.parse_args()
    readme, problems = (ROOT / "README.md").read_text(), []
    problems += [f"README.md does not show: {PICTURES[name]}" for name in IN_README if PICTURES[name] not in readme]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([str(a.part.resolve()), f"{folder}/part.obj"], check=True, stdout=subprocess.DEVNULL)
        for name, command in PICTURES.items():
            words = shlex.split(command)[1:]
            words = [str(ROOT / w) if w.startswith("examples/") else w for w in words]
            subprocess.run([str(a.hsr.resolve())] + words + ["--page", "fit", "-q"], cwd=folder, check=True)
            made = on_white((pathlib.Path(folder) / name).read_text())
            file = ROOT / "docs" / name
            if not a.check:
                file.write_text(made)
            elif not file.exists() or file.read_text() != made:
                problems.append(f"docs/{name} is not what the command makes today: run docs/pictures.py")
    for problem in problems:
        print(problem)
    print(f"{len(PICTURES)} pictures, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
