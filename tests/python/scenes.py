"""Scenes that one can check by hand, and random ones."""

import random

CUBE_POINTS = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
CUBE_FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
CUBE = (CUBE_POINTS, CUBE_FACES)

# Seen from above the roof hides a part of the floor.
FLOOR_AND_ROOF = (
    [[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0], [1, -1, 1], [2, -1, 1], [2, 3, 1], [1, 3, 1]],
    [[0, 1, 2, 3], [4, 5, 6, 7]],
)


def soup(seed, triangles=40, size=8):
    """Random triangles with corners on a grid: many touch, pierce and coincide."""
    source = random.Random(seed)
    points = [[source.randint(0, size) for _ in range(3)] for _ in range(3 * triangles)]
    return points, [[3 * k, 3 * k + 1, 3 * k + 2] for k in range(triangles)]


def confetti(seed, triangles):
    """Many small random triangles."""
    source = random.Random(seed)
    points = []
    for _ in range(triangles):
        at = [source.randint(0, 400) for _ in range(3)]
        points += [[x + source.randint(0, 20) for x in at] for _ in range(3)]
    return points, [[3 * k, 3 * k + 1, 3 * k + 2] for k in range(triangles)]


def write_obj(path, scene):
    points, faces = scene
    with open(path, "w", encoding="utf-8") as file:
        for point in points:
            file.write("v " + " ".join(repr(x) for x in point) + "\n")
        for face in faces:
            file.write("f " + " ".join(str(v + 1) for v in face) + "\n")
