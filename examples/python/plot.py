"""Two planes that cross, with matplotlib, in the right order: plot.py [FILE.png]."""

import sys

import matplotlib.pyplot as plt
import numpy

import hsr.matplotlib

ax = plt.figure().add_subplot(projection="3d")
x, y = numpy.meshgrid([-1, 1], [-1, 1])
ax.plot_surface(x, y, 0 * x, color="tab:blue")
ax.plot_surface(x, 0 * x, y, color="tab:orange")
hsr.matplotlib.fix(ax)
plt.savefig(sys.argv[1] if len(sys.argv) > 1 else "plot.png")
