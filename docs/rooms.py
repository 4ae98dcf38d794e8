#!/usr/bin/env python3
"""The rooms of the code and which of them include which, read from the #include lines.

    docs/rooms.py                 writes docs/rooms.svg
    docs/rooms.py --check         fails if a room includes one that it may not, or if docs/rooms.svg is not of today's code

A room is a directory below hsr/, or geometry, or study; headers directly in hsr/ belong to all. Rooms stand in the picture
above those that they include; an arrow is left out where a longer way leads to the same room. Standard library only.
"""

import argparse
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What each room may include, besides geometry, the headers directly in hsr/, and itself: docs/architecture.md says why.
MAY_INCLUDE = {
    "geometry": "",
    "view": "",
    "symbols": "view",
    "scene": "view symbols",
    "visibility_map": "scene view symbols",
    "lines": "visibility_map scene view symbols",
    "surfaces": "lines visibility_map scene view symbols",
    "painter": "visibility_map scene view symbols",
    "raster": "painter surfaces lines visibility_map scene view symbols",
    "drawing": "painter surfaces lines visibility_map scene view symbols",
    "check": "raster painter surfaces lines visibility_map scene view symbols",
    "io": "drawing raster painter surfaces lines view symbols",
    "study": "check io drawing raster painter surfaces lines scene view symbols",
    "cli": "study check io drawing raster painter surfaces lines scene view symbols",
}
# Includes that the table does not allow, and that wait for what both sides share to move down.
EXCEPTIONS = {
    ("hsr/painter/painters_order.cpp", "hsr/lines/visible_lines.h"),  # the plane of a cut
    ("hsr/painter/sort/depth_sort.cpp", "hsr/surfaces/fragments.h"),  # the exact point of a symbol
}
WORDS = {
    "geometry": "numbers, predicates, meshes",
    "view": "where one looks from",
    "symbols": "constructed points by name",
    "scene": "a mesh as one view sees it",
    "visibility_map": "predicates on the symbols",
    "lines": "visible parts of edges",
    "surfaces": "visible parts of faces",
    "painter": "orders from far to near",
    "raster": "methods of image space",
    "drawing": "results on a page",
    "check": "results against results",
    "io": "files in, files out",
    "study": "methods compared",
    "cli": "the command",
}


def room_of(path):
    parts = path.split("/")
    if parts[0] == "hsr":
        return parts[1] if len(parts) > 2 else "shared"
    return parts[0]


def includes():
    """All (file, included file) of the library, the study and the command, by paths from the root."""
    for top in ("geometry", "hsr", "study"):
        for file in sorted((ROOT / top).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            for included in re.findall(r'^#include "([^"]+)"', file.read_text(), re.M):
                if included.split("/")[0] in ("geometry", "hsr", "study"):
                    yield str(file.relative_to(ROOT)), included


def check(pairs):
    problems = []
    for file, included in pairs:
        a, b = room_of(file), room_of(included)
        if a == b or b in ("geometry", "shared") or (file, included) in EXCEPTIONS:
            continue
        if a == "shared":
            problems.append(f"{file}: a header that all share includes {included}")
        elif a not in MAY_INCLUDE:
            problems.append(f"{file}: the room {a} is not in the table of docs/rooms.py")
        elif b not in MAY_INCLUDE[a].split():
            problems.append(f"{file}: {a} may not include {b} ({included})")
    for file, included in sorted(EXCEPTIONS - set(pairs)):
        problems.append(f"docs/rooms.py: the exception {file} -> {included} is needed no longer")
    return problems


def arrows(pairs):
    """Room -> rooms that it includes; a room that another included one leads to is left out."""
    direct = collections.defaultdict(set)
    for file, included in pairs:
        a, b = room_of(file), room_of(included)
        if a != b and "shared" not in (a, b) and (file, included) not in EXCEPTIONS:
            direct[a].add(b)

    def reach(room):
        found = set()
        for other in direct[room]:
            found |= {other} | reach(other)
        return found

    for room in MAY_INCLUDE:
        direct[room]  # also those that include none
    return {room: {b for b in others if not any(b in reach(c) for c in others)} for room, others in direct.items()}


def levels(graph):
    level = {}

    def of(room):
        if room not in level:
            level[room] = 1 + max((of(other) for other in graph[room]), default=-1)
        return level[room]

    for room in graph:
        of(room)
    return level


def svg(graph):
    level = levels(graph)
    rows = [[] for _ in range(1 + max(level.values()))]
    for room in MAY_INCLUDE:
        rows[level[room]].append(room)
    width, height, gap_x, gap_y, margin = 210, 52, 40, 44, 24
    full = max(len(row) for row in rows) * (width + gap_x) - gap_x + 2 * margin + 2 * gap_x
    place = {}
    # Each room stands as near as may be under the middle of those that include it.
    for k in range(len(rows) - 1, -1, -1):
        def wish(room):
            above = [place[a][0] for a in place if room in graph[a]]
            return sum(above) / len(above) if above else full / 2
        row = sorted(rows[k], key=wish)
        start = (full - len(row) * (width + gap_x) + gap_x) / 2 + width / 2
        for i, room in enumerate(row):
            place[room] = (start + i * (width + gap_x), margin + (len(rows) - 1 - k) * (height + gap_y) + height / 2)
    total = 2 * margin + len(rows) * (height + gap_y) - gap_y
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{full:.0f}" height="{total:.0f}" viewBox="0 0 {full:.0f} {total:.0f}"'
        ' font-family="sans-serif" text-anchor="middle">',
        "<title>The rooms of hsr and which include which</title>",
        '<defs><marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" orient="auto">'
        '<path d="M0 0 10 5 0 10z" fill="#456"/></marker></defs>',
        f'<rect width="{full:.0f}" height="{total:.0f}" rx="10" fill="#fff"/>',
    ]
    for a in MAY_INCLUDE:
        for b in MAY_INCLUDE:
            if b not in graph[a]:
                continue
            (xa, ya), (xb, yb) = place[a], place[b]
            ya, yb = ya + height / 2, yb - height / 2
            xb += max(-width / 3, min(width / 3, (xa - xb) / 6))  # arrows from several rooms end side by side
            skips = level[a] - level[b] > 1
            middle = (ya + yb) / 2
            side = xa + (1 if xa > full / 2 else -1) * (width / 2 + 1.5 * gap_x)
            if skips and abs(xb - xa) < width:  # around the rooms between the two
                path = f"M{xa:.0f} {ya:.0f}C{side:.0f} {ya + gap_y:.0f} {side:.0f} {yb - gap_y:.0f} {xb:.0f} {yb:.0f}"
            else:
                path = f"M{xa:.0f} {ya:.0f}C{xa:.0f} {middle:.0f} {xb:.0f} {middle:.0f} {xb:.0f} {yb:.0f}"
            out.append(f'<path d="{path}" fill="none" stroke="#456" stroke-width="1.5" marker-end="url(#head)"/>')
    for room, (x, y) in place.items():
        out.append(
            f'<rect x="{x - width / 2:.0f}" y="{y - height / 2:.0f}" width="{width}" height="{height}" rx="6" fill="#eef3f8"'
            ' stroke="#456"/>'
            f'<text x="{x:.0f}" y="{y - 4:.0f}" font-size="17" font-weight="bold" fill="#123">{room}</text>'
            f'<text x="{x:.0f}" y="{y + 15:.0f}" font-size="13" fill="#345">{WORDS[room]}</text>'
        )
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the code breaks the rules")
    is_check = parser.parse_args().check
    pairs = list(includes())
    picture = ROOT / "docs" / "rooms.svg"
    problems = check(pairs)
    if not problems:  # then the rooms include one another one way, and can be drawn
        drawn = svg(arrows(pairs))
        if not is_check:
            picture.write_text(drawn)
        elif not picture.exists() or picture.read_text() != drawn:
            problems.append("docs/rooms.svg is not of today's code: run docs/rooms.py")
    for problem in problems:
        print(problem)
    print(f"{len(pairs)} includes between {len(MAY_INCLUDE)} rooms, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
