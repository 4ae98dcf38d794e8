#!/usr/bin/env python3
"""Draws the rooms of the code and which of them include which, from the #include lines.

    docs/rooms.py             writes docs/rooms.svg
    docs/rooms.py --check     fails if docs/rooms.svg is not of today's code, or if rooms include one another in a circle

A room is a directory below hsr/, or geometry, or study; headers directly in hsr/ belong to all. Rooms stand in the picture
above those that they include; an arrow is left out where a longer way leads to the same room. Standard library only.
"""

import argparse
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs" / "rooms.svg"

# What the picture says of each room.
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
    "coordinates": "results as numbers",
    "sheet": "views on one page",
    "tiles": "one scene in parts",
    "io": "files in, files out",
    "step": "surfaces of STEP and IGES",
    "three_mf": "3MF",
    "study": "methods compared",
    "cli": "the command",
}


def room_of(path):
    parts = path.split("/")
    if parts[0] == "hsr":
        return parts[1] if len(parts) > 2 else None
    return parts[0]


def included_rooms():
    """Room -> rooms that it includes."""
    direct = {room: set() for room in WORDS}
    for top in ("geometry", "hsr", "study"):
        for file in sorted((ROOT / top).rglob("*")):
            room = room_of(str(file.relative_to(ROOT)))
            if file.suffix not in (".h", ".cpp") or room is None:
                continue
            if room not in WORDS:
                raise ValueError(f"{room}: a room that docs/rooms.py has no words for")
            for included in re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.M):
                other = room_of(included)
                if other in WORDS and other != room:
                    direct[room].add(other)
    return direct


def levels(direct):
    """How many rooms are at most below each."""
    level, on_the_way = {}, []

    def of(room):
        if room in on_the_way:
            raise ValueError("rooms in a circle: " + " -> ".join(on_the_way[on_the_way.index(room):] + [room]))
        if room not in level:
            on_the_way.append(room)
            level[room] = 1 + max((of(other) for other in sorted(direct[room])), default=-1)
            on_the_way.pop()
        return level[room]

    for room in direct:
        of(room)
    return level


def without_shortcuts(direct):
    """Without the rooms that another included one leads to. @pre no circles"""
    below = {}

    def reach(room):
        if room not in below:
            below[room] = set(direct[room]).union(*(reach(other) for other in direct[room]))
        return below[room]

    return {room: {b for b in others if not any(b in reach(c) for c in others)} for room, others in direct.items()}


def svg(graph, level):
    rows = collections.defaultdict(list)
    for room in WORDS:
        rows[level[room]].append(room)
    width, height, gap_x, gap_y, margin = 210, 52, 40, 44, 24
    full = max(len(row) for row in rows.values()) * (width + gap_x) - gap_x + 2 * margin + 2 * gap_x
    place = {}
    for k in sorted(rows, reverse=True):
        # Each room as near as may be under the middle of those that include it.
        def wish(room):
            above = [place[a][0] for a in place if room in graph[a]]
            return sum(above) / len(above) if above else full / 2

        row = sorted(rows[k], key=wish)
        start = (full - len(row) * (width + gap_x) + gap_x) / 2 + width / 2
        for i, room in enumerate(row):
            place[room] = (start + i * (width + gap_x), margin + (len(rows) - 1 - k) * (height + gap_y) + height / 2)
    total = 2 * margin + len(rows) * (height + gap_y) - gap_y
    size = f'width="{full:.0f}" height="{total:.0f}"'
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 {full:.0f} {total:.0f}" font-family="sans-serif"'
        ' text-anchor="middle">',
        "<title>The rooms of hsr and which include which</title>",
        '<defs><marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" markerHeight="8" orient="auto">'
        '<path d="M0 0 10 5 0 10z" fill="#456"/></marker></defs>',
        f'<rect {size} rx="10" fill="#fff"/>',
    ]
    for a in WORDS:
        for b in WORDS:
            if b not in graph[a]:
                continue
            (xa, ya), (xb, yb) = place[a], place[b]
            ya, yb = ya + height / 2, yb - height / 2
            xb += max(-width / 3, min(width / 3, (xa - xb) / 6))  # arrows from several rooms end side by side
            between = [r for r in place if level[a] > level[r] > level[b]]
            if between and all(abs(place[r][0] - xa) > width / 2 for r in between):  # straight down between them
                bend = f"{xa:.0f} {yb - gap_y:.0f} {xa:.0f} {yb - gap_y / 2:.0f}"
            elif between and abs(xb - xa) < width:  # around the rooms between the two
                side = xa + (1 if xb > xa or xa == xb > full / 2 else -1) * (width / 2 + 1.5 * gap_x)
                bend = f"{side:.0f} {ya + gap_y:.0f} {side:.0f} {yb - gap_y:.0f}"
            else:
                bend = f"{xa:.0f} {(ya + yb) / 2:.0f} {xb:.0f} {(ya + yb) / 2:.0f}"
            out.append(f'<path d="M{xa:.0f} {ya:.0f}C{bend} {xb:.0f} {yb:.0f}" fill="none" stroke="#456" stroke-width="1.5"'
                       ' marker-end="url(#head)"/>')
    for room, (x, y) in place.items():
        out.append(
            f'<rect x="{x - width / 2:.0f}" y="{y - height / 2:.0f}" width="{width}" height="{height}" rx="6" fill="#eef3f8"'
            ' stroke="#456"/>'
            f'<text x="{x:.0f}" y="{y - 4:.0f}" font-size="17" font-weight="bold" fill="#123">{room}</text>'
            f'<text x="{x:.0f}" y="{y + 15:.0f}" font-size="13" fill="#345">{WORDS[room]}</text>'
        )
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail where the picture is not of today's code")
    is_check = parser.parse_args().check
    try:
        direct = included_rooms()
        level = levels(direct)  # first: it finds circles
        drawn = svg(without_shortcuts(direct), level)
    except ValueError as error:
        print(error)
        return 1
    if not is_check:
        PICTURE.write_text(drawn, encoding="utf-8")
    elif not PICTURE.exists() or PICTURE.read_text(encoding="utf-8") != drawn:
        print("docs/rooms.svg is not of today's code: run docs/rooms.py")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
