#!/usr/bin/env python3
"""Makes docs/tiles.png: what hsr join has drawn of a job in perspective with --fov, and the sides of the tiles over it.

    docs/tiles_picture.py JOB DRAWING.svg docs/tiles.png

The target of the view is in the middle of the page, and the field of view fills its height but for the margin of 10 mm. Needs
rsvg-convert, and ImageMagick's convert to make the file small.
"""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

WIDTH = 1400  # pixels
MARGIN = 10  # mm


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def place(view, p):
    """Of a point of space, in the frame of a perspective, from its target."""
    r, u, eye = view["right"], view["frame_up"], view["viewpoint"]
    normal = [r[1] * u[2] - r[2] * u[1], r[2] * u[0] - r[0] * u[2], r[0] * u[1] - r[1] * u[0]]
    sight = minus(p, eye)
    ahead = dot(minus(view["target"], eye), normal) / dot(sight, normal)
    on = minus([e + ahead * s for e, s in zip(eye, sight)], view["target"])
    return dot(on, r), dot(on, u)


def halves(polygon, c, d):
    """The parts of a convex polygon to the left and to the right of c -> d."""
    side = [(d[0] - c[0]) * (p[1] - c[1]) - (d[1] - c[1]) * (p[0] - c[0]) for p in polygon]
    left, right = [], []
    for i, (p, a) in enumerate(zip(polygon, side)):
        j = (i + 1) % len(polygon)
        q, b = polygon[j], side[j]
        if a >= 0:
            left.append(p)
        if a <= 0:
            right.append(p)
        if a * b < 0:
            on = tuple(x + a / (a - b) * (y - x) for x, y in zip(p, q))
            left.append(on)
            right.append(on)
    return left, right


def tiles(job, view):
    """Of each tile its number and the polygon that it is in the frame."""
    reach = 1e3 * math.dist(view["target"], view["viewpoint"])
    open_ = [(0, [(-reach, -reach), (reach, -reach), (reach, reach), (-reach, reach)])]
    while open_:
        at, polygon = open_.pop()
        if at < 0:
            yield ~at, polygon
            continue
        c, d = (place(view, p) for p in job["sides"][at])
        left, right = halves(polygon, c, d)
        low, high = job["splits"][at]
        # Which half is which: to the left of c -> d is the one of lower x where the side runs upward, of higher y where it runs to the right.
        lower_first = abs(d[1] - c[1]) > abs(d[0] - c[0])
        is_forward = d[1] > c[1] if lower_first else d[0] < c[0]
        first, second = (left, right) if is_forward else (right, left)
        if lower_first:
            low, high = high, low
        open_ += [(low, first), (high, second)]


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    job = json.loads(pathlib.Path(sys.argv[1], "job.json").read_text())
    svg = pathlib.Path(sys.argv[2]).read_text()
    view = job["view"]
    width, height = map(float, re.search(r'viewBox="0 0 ([0-9.]+) ([0-9.]+)"', svg).groups())
    scale = (height - 2 * MARGIN) / (2 * math.dist(view["target"], view["viewpoint"]) * math.tan(math.radians(view["fov"]) / 2))
    over = []
    for number, polygon in tiles(job, view):
        page = [(width / 2 + scale * x, height / 2 - scale * y) for x, y in polygon]
        over.append('<path d="M' + " ".join(f"{x:.2f} {y:.2f}" for x, y in page) + 'Z" fill="none" stroke="#d03020" stroke-width="0.4"/>')
        low, high = ([f(p[k] for p in page) for k in (0, 1)] for f in (min, max))
        middle = [(max(a, MARGIN) + min(b, end - MARGIN)) / 2 for a, b, end in zip(low, high, (width, height))]
        if all(a < m < b for a, m, b in zip(low, middle, high)):
            over.append(f'<text x="{middle[0]:.1f}" y="{middle[1]:.1f}" font-family="sans-serif" font-size="7" fill="#d03020">{number + 1}</text>')
    with tempfile.TemporaryDirectory() as folder:
        both, large = pathlib.Path(folder, "both.svg"), pathlib.Path(folder, "large.png")
        both.write_text(svg.replace("</svg>", "<g>" + "".join(over) + "</g></svg>"))
        subprocess.run(["rsvg-convert", "--unlimited", "-w", str(WIDTH), "-b", "white", both, "-o", large], check=True)
        subprocess.run(["convert", large, "-colors", "24", "-strip", "png8:" + sys.argv[3]], check=True)


if __name__ == "__main__":
    main()
