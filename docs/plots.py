#!/usr/bin/env python3
"""Twenty plots that mplot3d paints wrong, each before and after hsr.matplotlib.fix: the pictures of docs/plots.md.

    PYTHONPATH=build/release/python docs/plots.py                    writes docs/plots/*.png
    PYTHONPATH=build/release/python docs/plots.py NAME ... -o DIR    some of them, to look at: larger, in another directory

tests/python/plots_test.py compares the pixels of each with what is nearest there.
"""

import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.patches import Circle, Rectangle  # noqa: E402
from mpl_toolkits.mplot3d import art3d  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # noqa: E402

import hsr.matplotlib  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parent.parent
RED, BLUE, GREEN, YELLOW, GREY = "tab:red", "tab:blue", "tab:green", "gold", "0.75"


def grid(n, low=-1.0, high=1.0):
    return np.meshgrid(np.linspace(low, high, n), np.linspace(low, high, n))


def sphere(radius=1.0, centre=(0, 0, 0), n=12):
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 2 * n + 1), np.linspace(0, np.pi, n + 1))
    shape = (np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v))
    return [radius * x + c for x, c in zip(shape, centre)]


def cylinder(radius, low, high, n=24):
    t, z = np.meshgrid(np.linspace(0, 2 * np.pi, n + 1), np.linspace(low, high, 2))
    return radius * np.cos(t), radius * np.sin(t), z


def box_faces(low, high):
    (a, b, c), (d, e, f) = low, high
    corners = np.array([[x, y, z] for x in (a, d) for y in (b, e) for z in (c, f)], dtype=float)
    return [corners[k] for k in ([0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3])]


def crossing_planes(ax):
    x, y = grid(2)
    ax.plot_surface(x, y, 0 * x, color=RED)
    ax.plot_surface(x, 0 * x, y, color=BLUE)
    ax.plot_surface(0 * x, x, y, color=GREEN)


def planes_and_a_cylinder(ax):
    x, y = grid(2)
    ax.plot_surface(x, y, 0.4 * x, color=RED)
    ax.plot_surface(x, 0 * x, y, color=BLUE)
    ax.plot_surface(*cylinder(0.5, -0.9, 0.9), color=YELLOW)


def two_surfaces(ax):
    x, y = grid(11, -2, 2)
    ax.plot_surface(x, y, np.sin(1.5 * x) + np.cos(1.5 * y), rstride=1, cstride=1, color=BLUE)
    ax.plot_surface(x, y, 0.4 * x - 0.3 * y, rstride=1, cstride=1, color=RED)


def trisurf_and_plane(ax):
    x, y = (a.ravel() for a in grid(9, -2, 2))
    ax.plot_trisurf(x, y, x * y / 2, color=GREEN)
    ax.plot_trisurf([-2, 2, 2, -2], [-2, -2, 2, 2], [0.9, -0.7, 0.4, 0.1], color=RED)


def moebius_strip(ax):
    u, w = (a.ravel() for a in np.meshgrid(np.linspace(0, 2 * np.pi, 33), np.linspace(-0.6, 0.6, 5)))
    r = 1 + w * np.cos(u / 2)
    triangles = matplotlib.tri.Triangulation(u, w).triangles
    ax.plot_trisurf(r * np.cos(u), r * np.sin(u), w * np.sin(u / 2), triangles=triangles, color=BLUE)
    ax.plot_surface(*cylinder(0.35, -0.6, 0.6), color=RED)


def line_through_a_plane(ax):
    x, y = grid(2)
    ax.plot_surface(x, y, 0.3 * x, color=RED)
    ax.plot([-0.6, 0.6], [-0.7, 0.7], [-0.9, 0.9], color="black", lw=4)
    ax.plot([-0.9, 0.9], [0.8, -0.8], [0.9, -0.9], color="blue", lw=4, ls="--")


def helix_around_a_cylinder(ax):
    t = np.linspace(0, 6 * np.pi, 121)
    ax.plot_surface(*cylinder(0.6, -1, 1), color=GREEN)
    ax.plot(np.cos(t), np.sin(t), t / (3 * np.pi) - 1, color="black", lw=4)


def bars(ax):
    x, y = (a.ravel() for a in np.meshgrid(range(3), range(3)))
    ax.bar3d(x, y, 0 * x, 0.7, 0.7, 1 + (x * 2 + y) % 4, color=[f"C{k}" for k in range(9)])
    ax.bar3d([-0.5], [0.9], [0.8], [3.7], [0.5], [0.5], color=GREY)


def sphere_in_a_box(ax):
    ax.add_collection3d(Poly3DCollection(box_faces((-0.8, -0.8, -0.8), (0.8, 0.8, 0.8)), facecolor=GREY, edgecolor="black", linewidths=2))
    ax.plot_surface(*sphere(1.05, n=14), rstride=1, cstride=1, color=RED)


def two_spheres(ax):
    ax.plot_surface(*sphere(1, (-0.45, 0, 0)), rstride=1, cstride=1, color=BLUE)
    ax.plot_surface(*sphere(0.9, (0.45, 0.4, 0.2)), rstride=1, cstride=1, color=YELLOW)


def quiver_behind_a_surface(ax):
    x, y = grid(9)
    ax.plot_surface(x, y, 0.5 * x * x - 0.5 * y * y, rstride=1, cstride=1, color=RED)
    u, v = (a.ravel() for a in grid(4, -0.75, 0.75))
    ax.quiver(u, v, 0 * u - 0.9, 0 * u, 0 * u, 0 * u + 1.4, color="black", lw=3)


def scatter_behind_a_surface(ax):
    x, y = grid(7)
    ax.plot_surface(x, y, 0.4 * x + 0.2 * y, rstride=1, cstride=1, color=BLUE)
    u, v = (a.ravel() for a in grid(4, -0.8, 0.8))
    ax.scatter(u, v, 0.4 * u + 0.2 * v - 0.5, color="red", s=60, depthshade=False)
    ax.plot(u, v, 0.4 * u + 0.2 * v + 0.5, "o", color="black", ms=6)


def voxels_and_a_plane(ax):
    filled = np.indices((3, 3, 3)).sum(axis=0) % 2 == 0
    ax.voxels(filled, facecolors=BLUE)
    ax.plot_trisurf([-0.3, 3.3, 3.3, -0.3], [-0.3, -0.3, 3.3, 3.3], [0.4, 2.6, 1.9, 0.7], color=YELLOW)


def crossing_triangles(ax):
    corners = np.array([[[-1, -1, -0.4], [1, -0.8, 0.3], [0, 1, 0.1]], [[-1, 0, 0.9], [1, 0.1, 0.8], [0.1, 0.2, -1]]])
    third = np.array([[0.1, -1, 0.7], [-0.2, 1, 0.6], [0.2, 0, -1]])
    ax.add_collection3d(Poly3DCollection([*corners, third], facecolors=[RED, BLUE, YELLOW], edgecolor="black", linewidths=2))
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))


def woven_bars(ax):
    # Each rests on the next, all the way round: no order of whole bars is right.
    for k in range(4):
        c, s = [(1, 0), (0, 1), (-1, 0), (0, -1)][k]
        a = np.array([[-0.9, 0.4, 0], [0.9, 0.4, 0.4], [0.9, 0.7, 0.4], [-0.9, 0.7, 0]])
        turned = np.column_stack([c * a[:, 0] - s * a[:, 1], s * a[:, 0] + c * a[:, 1], a[:, 2]])
        ax.add_collection3d(Poly3DCollection([turned], facecolor=(RED, BLUE, GREEN, YELLOW)[k], edgecolor="black", linewidths=2))
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))


def contours_on_walls(ax):
    x, y = grid(17, -2, 2)
    z = np.exp(-((x - 0.4) ** 2) - y**2) - np.exp(-((x + 1) ** 2) - (y - 0.8) ** 2)
    ax.plot_surface(x, y, z, rstride=1, cstride=1, color=BLUE)
    ax.contour(x, y, z, zdir="z", offset=0.35, levels=[-0.5, -0.2, 0.2, 0.7], colors="black", linewidths=3, linestyles="solid")
    ax.contour(x, y, z, zdir="y", offset=2.3, levels=6, colors="red", linewidths=3, linestyles="solid")


def wireframe_before_a_surface(ax):
    x, y = grid(9)
    ax.plot_surface(x, 0 * x + 0.5, y, color=GREEN)
    ax.plot_wireframe(*sphere(0.8, (0, 0.2, 0), n=4), color="black", lw=2.5)


def transparent_planes(ax):
    x, y = grid(2)
    ax.plot_surface(x, y, 0.5 * y, color=RED, alpha=0.5)
    ax.plot_surface(x, 0 * x, y, color=BLUE, alpha=0.5)
    ax.plot_surface(0.3 * y, x, y, color=YELLOW, alpha=0.5)


def patches_and_stems(ax):
    for z, colour in ((0, GREY), (0.5, YELLOW)):
        circle = Circle((0, 0), 1, color=colour)
        ax.add_patch(circle)
        art3d.pathpatch_2d_to_3d(circle, z=z)
    wall = Rectangle((-1, -0.2), 2, 1.2, color=RED)
    ax.add_patch(wall)
    art3d.patch_2d_to_3d(wall, z=0.1, zdir="y")
    t = np.linspace(0, 2 * np.pi, 10)[:-1]
    ax.stem(0.7 * np.cos(t), 0.7 * np.sin(t), 0 * t + 1, linefmt="k-", markerfmt="ko", basefmt=" ")
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-0.2, 1))


def texts_behind_a_surface(ax):
    x, y = grid(2)
    ax.plot_surface(x, 0 * x, y, color=YELLOW)
    ax.set(xlim=(-1, 1), ylim=(-1, 1), zlim=(-1, 1))
    ax.text(-0.2, -0.8, 0.2, "before", None, size=13, ha="center")
    ax.text(0.2, 0.8, -0.3, "behind", None, size=13, ha="center")
    ax.text(0.6, 0.9, 1.25, "above", None, size=13, ha="center")


# Name -> where it is seen from; a function of that name plots it.
PLOTS = {
    "crossing_planes": {},
    "planes_and_a_cylinder": {},
    "two_surfaces": {"elev": 45, "azim": -50},
    "trisurf_and_plane": {},
    "moebius_strip": {"elev": 35},
    "line_through_a_plane": {"elev": 20},
    "helix_around_a_cylinder": {"elev": 20},
    "bars": {"elev": 35, "azim": -50},
    "sphere_in_a_box": {},
    "two_spheres": {"elev": 20, "azim": -70},
    "quiver_behind_a_surface": {"elev": 25},
    "scatter_behind_a_surface": {"elev": 25},
    "voxels_and_a_plane": {"elev": 35, "azim": 120},
    "crossing_triangles": {"elev": 25, "azim": -70},
    "woven_bars": {"elev": 50, "azim": -60},
    "contours_on_walls": {"elev": 30, "azim": -60},
    "wireframe_before_a_surface": {"elev": 15, "azim": -75},
    "transparent_planes": {"elev": 20, "azim": -55},
    "patches_and_stems": {"elev": 25, "azim": -60},
    "texts_behind_a_surface": {"elev": 15, "azim": -70},
}


def plot(name, ax):
    globals()[name](ax)
    ax.set_axis_off()
    ax.view_init(**PLOTS[name])


def picture(name, path, inches, dpi):
    """Before and after, side by side."""
    figure = plt.figure(figsize=(2 * inches, inches), dpi=dpi)
    for k in (1, 2):
        ax = figure.add_axes([(k - 1) / 2, 0, 0.5, 1], projection="3d")
        plot(name, ax)
        if k == 2:
            hsr.matplotlib.fix(ax)
    figure.savefig(path, metadata={"Software": None})
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="some of the plots [all]")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="a directory for larger pictures [docs/plots]")
    a = parser.parse_args()
    for name in a.names or PLOTS:
        if a.output:
            picture(name, a.output / f"{name}.png", 6, 100)
        else:
            picture(name, ROOT / "docs" / "plots" / f"{name}.png", 3, 100)
    return 0


if __name__ == "__main__":
    sys.exit(main())
