#!/usr/bin/env python3
"""Writes the models of the sheets in docs/sheets.md: a gear box in millimetres and a house in metres, each of closed bodies.

    docs/sheet_models.py FOLDER        writes FOLDER/gear_box.obj and FOLDER/house.obj

Standard library only.
"""

import math
import pathlib
import sys


class Model:
    """Closed bodies as the objects of an OBJ file."""

    def __init__(self):
        self.lines, self.points = [], 0

    def object(self, name, material):
        self.lines += [f"o {name}", f"usemtl {material}"]

    def prism(self, outline, holes, low, high, axis):
        """An outline counter-clockwise as seen against the axis, with holes clockwise, from `low` to `high` along it."""
        def place(p, t):
            u, v = p
            return {"x": (t, u, v), "y": (v, t, u), "z": (u, v, t)}[axis]

        rings, first = [outline] + holes, self.points + 1
        indices, count = [], 0
        for ring in rings:
            indices.append([first + count + k for k in range(len(ring))])
            count += len(ring)
        for t in (low, high):
            for ring in rings:
                # To a millionth: no last digit of a sine makes another drawing.
                self.lines += ["v " + " ".join(repr(round(c, 6) + 0.0) for c in place(p, t)) for p in ring]
        self.points += 2 * count
        top = self.face_with_holes(rings, indices)
        self.lines.append("f " + " ".join(str(i + count) for i in top))
        self.lines.append("f " + " ".join(str(i) for i in reversed(top)))
        for ring in indices:
            for a, b in zip(ring, ring[1:] + ring[:1]):
                self.lines.append(f"f {a} {b} {b + count} {a + count}")

    @staticmethod
    def face_with_holes(rings, indices):
        """One polygon that runs to each hole and back, from the nearest corner that no bridge crosses."""
        face, corners = list(indices[0]), list(rings[0])
        # From the right: a bridge to the right meets no hole that is still to come.
        order = sorted(range(1, len(rings)), key=lambda k: -max(p[0] for p in rings[k]))
        for k in order:
            start = max(range(len(rings[k])), key=lambda i: rings[k][i][0])
            p = rings[k][start]
            best = min((i for i, q in enumerate(corners) if q[0] > p[0] and Model.sees(p, q, corners)),
                       key=lambda i: math.dist(corners[i], p))
            hole, at = indices[k][start:] + indices[k][:start], rings[k][start:] + rings[k][:start]
            face = face[:best + 1] + hole + [hole[0]] + face[best:]
            corners = corners[:best + 1] + at + [at[0]] + corners[best:]
        return face

    @staticmethod
    def sees(p, q, ring):
        def turn(a, b, c):
            return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

        for a, b in zip(ring, ring[1:] + ring[:1]):
            if q in (a, b):
                continue
            if turn(p, q, a) * turn(p, q, b) <= 0 and turn(a, b, p) * turn(a, b, q) <= 0:
                return False
        return True

    def box(self, low, high):
        self.prism(rectangle(low[0], low[1], high[0], high[1]), [], low[2], high[2], "z")

    def text(self):
        return "\n".join(self.lines) + "\n"


def rectangle(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def circle(x, y, radius, corners=48):
    return [(x + radius * math.cos(2 * math.pi * k / corners), y + radius * math.sin(2 * math.pi * k / corners))
            for k in range(corners)]


def hole(ring):
    return ring[::-1]


def gear(x, y, teeth, module, turned):
    """A spur gear with straight flanks."""
    pitch, ring = teeth * module / 2, []
    for k in range(teeth):
        for share, radius in ((-0.30, -1.25), (-0.16, 1.0), (0.16, 1.0), (0.30, -1.25)):
            t = 2 * math.pi * (k + share + turned) / teeth
            ring.append((x + (pitch + radius * module) * math.cos(t), y + (pitch + radius * module) * math.sin(t)))
    return ring


def gear_box():
    """Two shafts in bearings in a housing with a lid. Along y; the plane of a section is that of the shafts, z = 50."""
    m = Model()
    height, first, second = 50.0, 50.0, 116.0  # of the shafts, and where they are across
    m.object("housing", "cast iron")
    feet = [circle(x, y, 4.5, 24) for x in (-6.0, 176.0) for y in (14.0, 66.0)]
    m.prism(rectangle(-14, 0, 184, 80), [hole(c) for c in feet], -12.0, 0.0, "z")
    bores = [(height, first, 20.0), (height, second, 24.0)]
    for low, high in ((0.0, 16.0), (64.0, 80.0)):  # the front and the back wall
        m.prism(rectangle(0, 0, 104, 170), [hole(circle(z, x, r)) for z, x, r in bores], low, high, "y")
    for left, right in ((0.0, 8.0), (162.0, 170.0)):
        m.box((left, 16, 0), (right, 64, 104))
    m.object("lid", "cast iron")
    m.box((0, 0, 104), (170, 80, 112))
    for k, (z, x, outer) in enumerate(bores):
        inner = 10.0 if k == 0 else 14.0
        m.object(f"shaft {k + 1}", "steel")
        ends = (-30.0, 80.0) if k == 0 else (0.0, 116.0)
        m.prism(circle(z, x, inner), [], ends[0], ends[1], "y")
        for n, (low, high) in enumerate(((0.0, 16.0), (64.0, 80.0))):
            m.object(f"bearing {2 * k + n + 1}", "steel")
            m.prism(circle(z, x, outer), [hole(circle(z, x, inner))], low, high, "y")
        m.object(f"gear {k + 1}", "steel")
        wheel = gear(z, x, 16, 3, 0.25) if k == 0 else gear(z, x, 28, 3, 0.25)
        m.prism(wheel, [hole(circle(z, x, inner))], 26.0, 54.0, "y")
    return m


def house():
    """Separate walls, slabs and columns that touch, a stair and a roof."""
    m = Model()
    width, depth, wall, storey = 9.0, 7.0, 0.36, 2.75
    window, door = (0.9, 2.2), (0.0, 2.1)

    def openings(places, sill_and_head):
        return [hole(rectangle(a, sill_and_head[0], b, sill_and_head[1])) for a, b in places]

    def walls(base, name, with_door):
        def at(ring):
            return [(u, v + base) for u, v in ring]

        front = openings([(1.0, 2.4), (6.6, 8.0)], window)
        outline = rectangle(0, 0, width, storey)
        if with_door:  # down to the floor: a notch
            outline = [(0, 0), (4.0, 0), (4.0, door[1]), (5.1, door[1]), (5.1, 0), (width, 0), (width, storey), (0, storey)]
        else:
            front += openings([(3.8, 5.2)], window)
        # Across x, up z: along -y. The axis of a prism along y has z first, so walls along x are turned.
        for name_of, ring, holes, low, high in (("south", outline, front, 0.0, wall),
                                                ("north", rectangle(0, 0, width, storey),
                                                 openings([(1.2, 3.2), (5.8, 7.8)], window), depth - wall, depth)):
            m.object(f"{name} wall {name_of}", "masonry")
            turned = [(v, u) for u, v in at(ring)][::-1]
            m.prism(turned, [[(v, u) for u, v in at(h)][::-1] for h in holes], low, high, "y")
        for name_of, low, high in (("west", 0.0, wall), ("east", width - wall, width)):
            m.object(f"{name} wall {name_of}", "masonry")
            m.prism(at(rectangle(wall, 0, depth - wall, storey)),
                    [at(h) for h in openings([(2.4, 4.4)], window)], low, high, "x")

    m.object("foundation", "concrete")
    m.box((-0.2, -0.2, -0.5), (width + 0.2, depth + 0.2, 0))
    walls(0.0, "ground floor", True)
    m.object("inner wall", "masonry")
    m.box((5.4, wall, 0), (5.64, depth - wall, storey))
    m.object("stair", "concrete")
    for k in range(15):
        rise = storey / 15
        m.box((wall, 2.0 + 0.27 * k, rise * k), (wall + 1.0, 2.0 + 0.27 * (k + 1), rise * (k + 1)))
    m.object("slab", "concrete")
    well = hole(rectangle(wall, 2.0, wall + 1.0, 6.05))
    m.prism(rectangle(0, 0, width, depth), [well], storey, storey + 0.25, "z")
    walls(storey + 0.25, "upper floor", False)
    eaves, ridge = 2 * storey + 0.25, 2 * storey + 0.25 + 3.0
    m.object("roof", "tiles")
    slope = (ridge - eaves) / (depth / 2)
    over, thick = 0.5, 0.3
    outline = [(-over, eaves - over * slope), (depth / 2, ridge), (depth + over, eaves - over * slope),
               (depth + over, eaves - over * slope + thick), (depth / 2, ridge + thick), (-over, eaves - over * slope + thick)]
    m.prism(outline, [], -over, width + over, "x")
    for name_of, low, high in (("west", 0.0, wall), ("east", width - wall, width)):
        m.object(f"gable {name_of}", "masonry")
        m.prism([(0, eaves), (depth, eaves), (depth / 2, ridge)], [], low, high, "x")
    for k, x in enumerate((2.9, 6.2)):
        m.object(f"porch column {k + 1}", "timber")
        m.prism(circle(x, -1.6, 0.12, 16), [], 0.0, 2.4, "z")
    m.object("porch floor", "concrete")
    m.box((2.5, -2.0, -0.15), (6.6, -0.2, 0))
    m.object("porch roof", "timber")
    m.box((2.5, -2.0, 2.4), (6.6, 0, 2.55))
    return m


def main():
    folder = pathlib.Path(sys.argv[1])
    (folder / "gear_box.obj").write_text(gear_box().text())
    (folder / "house.obj").write_text(house().text())


if __name__ == "__main__":
    main()
