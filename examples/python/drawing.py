"""Draws a model with hidden lines dashed, as SVG and PNG: drawing.py MODEL [DIRECTORY]."""

import sys

import hsr

model, directory = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else "."
drawing = hsr.draw(model, [f"{directory}/drawing.svg", f"{directory}/drawing.png"], hidden="dashed")
print(f"{len(drawing.polylines())} polylines on {drawing.width:g} x {drawing.height:g} mm")
