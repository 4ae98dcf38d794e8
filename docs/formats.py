#!/usr/bin/env python3
"""Makes docs/formats.png: one drawing in every format, each as a program that is not hsr shows it.

    docs/formats.py --hsr build/release/bin/hsr --part build/release/examples/part_model

Needs rsvg-convert, pdftoppm, gs, ezdxf with matplotlib, pdflatex with the picture package, hp2xx, and ImageMagick (convert, montage);
a format whose program is missing is left out, and said.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH = 400  # pixels of each

# Label, file that hsr writes, program that shows it, and its command; each writes shown.png or shown-*.png of at least WIDTH pixels.
FORMATS = [
    ("SVG, by librsvg", "part.svg", "rsvg-convert", "rsvg-convert -w 640 -b white part.svg -o shown.png"),
    ("PDF, by poppler", "part.pdf", "pdftoppm", "pdftoppm -png -singlefile -scale-to-x 640 -scale-to-y -1 part.pdf shown"),
    ("EPS, by ghostscript", "part.eps", "gs",
     "gs -q -dNOPAUSE -dBATCH -dEPSCrop -sDEVICE=png16m -r110 -dGraphicsAlphaBits=4 -sOutputFile=shown.png part.eps"),
    ("TikZ, by pdflatex", "part.tex", "pdflatex",
     "pdflatex -interaction=batchmode -jobname=tikz part.tex && pdftoppm -png -singlefile -scale-to-x 640 -scale-to-y -1 tikz.pdf shown"),
    ("DXF, by ezdxf", "part.dxf", "ezdxf", "ezdxf draw -o shown.png --dpi 150 part.dxf"),
    ("HPGL, by hp2xx", "part.hpgl", "hp2xx", "hp2xx -q -t -m png -d 110 -f shown.png part.hpgl"),
    ("PNG, by hsr", "part.png", "convert", "convert part.png -resize 640x shown.png"),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--hsr", required=True, type=pathlib.Path, help="the command")
    parser.add_argument("--part", required=True, type=pathlib.Path, help="the program that writes part.obj")
    a = parser.parse_args()
    missing = [p for p in ("convert", "montage") if shutil.which(p) is None]
    if missing:
        sys.exit(f"found no {' and no '.join(missing)}, expected ImageMagick")
    with tempfile.TemporaryDirectory() as folder:
        def run(command):
            subprocess.run(command, shell=True, check=True, cwd=folder, stdout=subprocess.DEVNULL)

        run(f"{a.part.resolve()} part.obj")
        cells = []
        for label, file, program, command in FORMATS:
            if shutil.which(program) is None:
                print(f"left out, as {program} is missing: {label}")
                continue
            run(f"{a.hsr.resolve()} draw part.obj -q --hidden dashed --page fit -o {file}")
            run(command)
            cell = f"{len(cells)}.png"
            run(f"convert shown.png -background white -flatten -trim +repage -resize {WIDTH}x{WIDTH} {cell}")
            cells.append(f"-label '{label}' {cell}")
        run(f"montage -font DejaVu-Sans -pointsize 18 {' '.join(cells)} -tile 4x -geometry +16+12 -background white "
            "-colorspace Gray -colors 16 -depth 4 -strip png8:formats.png")
        shutil.copy(pathlib.Path(folder) / "formats.png", ROOT / "docs" / "formats.png")
    print(f"docs/formats.png: {len(cells)} of {len(FORMATS)} formats")
    return 0


if __name__ == "__main__":
    sys.exit(main())
