"""Draws shapes of FreeCAD with hidden lines removed, by the command hsr.

As a macro: copy this file into the macro folder (Macro > Macros shows it) and run it: what is selected, or all that is visible,
is drawn as the active view shows it, into a file whose ending chooses SVG, PDF, DXF, ...

Without a window: `draw` from a script of freecadcmd (docs/bridges.md has one).

hsr is looked for on PATH, or it is what the environment's HSR names. Lengths are mm, z is up.
"""

import math
import os
import re
import shutil
import subprocess
import tempfile

import FreeCAD
import Part

OPTIONS = ["--hidden", "dashed"]  # of the macro: options of `hsr draw`

# Radians between neighbouring facets, where FreeCAD's own meshes have 0.5: small holes are round, too.
ANGULAR_DEFLECTION = 0.2
# Degrees: hsr draws as sharp what deviates from flat by more. Facets of one face come to 25 at the poles of a sphere, and beyond 40
# on a surface of splines with tight waves, so hsr's own 30 would show some of them. Edges of the shape that are shallower than this
# are drawn all the same: their faces get different materials.
CREASE = 60
# Degrees: faces that meet within this go on in one another, as a fillet does, and no edge is drawn there.
TANGENT = 1


def draw(objects, output, view="iso", options=(), deflection=None):
    """Draws objects of a document, or all: `draw(document.Objects, "part.svg", "front", ["--hidden", "dashed"])`.

    objects: those in groups and parts come with these, wherever they are placed; invisible ones, and those that others are made
    of, are left out, unless nothing else is given
    output: a path, or a list of them; the ending chooses svg, pdf, eps, dxf, tex, hpgl, png or json
    view: front, back, left, right, top, bottom or iso; or the camera of a view, `view.getCamera()`
    options: more options of `hsr draw`
    deflection: how far facets may be from the surface, mm [a 2000th of the diagonal]

    An edge between two faces is drawn unless they go on in one another; what cuts a face into facets, or a closed one open, is
    not. Returns what hsr says. Raises RuntimeError, one line, where hsr refuses, there is nothing to draw or no hsr.
    """
    shapes = list(placed_shapes(objects))
    if not shapes:
        raise RuntimeError("hsr: found no visible shape, expected one or more")
    outputs = [output] if isinstance(output, (str, os.PathLike)) else list(output)
    with tempfile.TemporaryDirectory() as directory:
        model = os.path.join(directory, "freecad.obj")
        write_model(shapes, model, deflection)
        crease = [] if any(str(o).startswith("--crease") for o in options) else [f"--crease={CREASE}"]
        arguments = ["draw", model, *view_options(view), *crease, *options]
        for name in outputs:
            arguments += ["-o", os.fspath(name)]
        return run(arguments)


def run(arguments):
    """What the command hsr says. Raises RuntimeError, its one line, where it refuses."""
    command = os.environ.get("HSR") or shutil.which("hsr")
    if command is None:
        raise RuntimeError("hsr: the command is not on PATH: put it there, or its name into the environment as HSR")
    try:
        ran = subprocess.run([command, *arguments], capture_output=True, text=True, check=False)
    except OSError as error:
        raise RuntimeError(f"hsr: {command} cannot be run: {error.strerror}") from None
    said = ran.stderr.strip()
    if ran.returncode != 0:
        raise RuntimeError(said.splitlines()[-1] if said else f"hsr: ended with status {ran.returncode}")
    return said


def placed_shapes(objects):
    """Label, shape where it is in the document, and view provider of each visible object."""
    objects = list(objects)
    inside = {child.Name for o in objects if is_container(o) for child in o.Group}  # they come with it
    for o in drawn_themselves(objects):
        if o.Name not in inside:
            yield from shapes_below(o, parent_placement(o))


def shapes_below(o, placement):
    if not o.Visibility or o.TypeId == "App::Origin" or re.fullmatch(r"PartDesign::(Plane|Line|Point|CoordinateSystem)", o.TypeId):
        return
    if is_container(o):
        placement = placement.multiply(o.Placement) if hasattr(o, "Placement") else placement
        for child in drawn_themselves(o.Group):
            yield from shapes_below(child, placement)
        return
    shape = Part.getShape(o)
    if shape is None or shape.isNull() or not (shape.Faces or shape.Edges):
        return
    shape = shape.copy()
    shape.Placement = placement.multiply(shape.Placement)
    yield o.Label, shape, getattr(o, "ViewObject", None)


def is_container(o):
    """A group or a part; a body is one shape, that of its tip."""
    return hasattr(o, "Group") and not o.isDerivedFrom("Part::Feature")


def drawn_themselves(objects):
    """Those that no other of them is made of. With a window it makes these invisible, and what is visible is meant to be seen."""
    used = set()
    for o in () if FreeCAD.GuiUp else objects:
        for name in ("Base", "Tool", "Shapes", "Source", "Sections", "Spine", "Links"):
            value = getattr(o, name, None)  # an object, one with names of its edges, or a list of such
            for part in value if isinstance(value, (list, tuple)) else [value]:
                used.add(getattr(part[0] if isinstance(part, tuple) else part, "Name", None))
    for o in objects:
        body = o.getParentGeoFeatureGroup()
        if o.Name not in used and not (body in objects and body.isDerivedFrom("Part::Feature")):
            yield o


def parent_placement(o):
    if not hasattr(o, "getGlobalPlacement") or not hasattr(o, "Placement"):
        return FreeCAD.Placement()
    return o.getGlobalPlacement().multiply(o.Placement.inverse())


def write_model(shapes, path, deflection=None):
    """An OBJ file, and its materials beside it: points in doubles, an object for each shape, a material for faces that go on in one
    another."""
    if deflection is None:
        box = FreeCAD.BoundBox()
        for _, shape, _ in shapes:
            box.add(shape.BoundBox)
        deflection = max(box.DiagonalLength / 2000, 1e-7)
    library = os.path.splitext(path)[0] + ".mtl"
    names, points = set(), 1
    with open(path, "w", encoding="utf-8") as obj, open(library, "w", encoding="utf-8") as mtl:
        obj.write(f"mtllib {os.path.basename(library)}\n")
        for number, (label, shape, view) in enumerate(shapes):
            obj.write(f"o {unused(' '.join(label.split()) or 'shape', names)}\n")
            mesh(shape, deflection)
            colours, parts, known = colours_of(view, len(shape.Faces)), smooth_parts(shape), set()
            for face, colour, part in zip(shape.Faces, colours, parts):
                material = "shape{}-{}".format(number, "-".join([str(part), *(f"{c:.4f}" for c in colour or ())]))
                if colour and material not in known:
                    mtl.write("newmtl {}\nKd {:.6f} {:.6f} {:.6f}\nd {:.6f}\n".format(material, *colour))
                known.add(material)
                obj.write(f"usemtl {material}\n")
                corners, triangles = face.tessellate(deflection)
                points = write_cells(obj, corners, "f", triangles, points)
            if not shape.Faces:
                for edge in shape.Edges:
                    line = edge.discretize(Deflection=deflection)
                    points = write_cells(obj, line, "l", [(i, i + 1) for i in range(len(line) - 1)], points)


def unused(name, names):
    free, k = name, 2
    while free in names:
        free, k = f"{name} [{k}]", k + 1
    names.add(free)
    return free


def write_cells(obj, points, word, cells, first):
    for p in points:
        obj.write(f"v {p.x!r} {p.y!r} {p.z!r}\n")
    for cell in cells:
        obj.write(word + "".join(f" {first + i}" for i in cell) + "\n")
    return first + len(points)


def mesh(shape, deflection):
    """Makes the facets that face.tessellate then gives; alone it would allow 28 degrees between them."""
    if not shape.Faces:
        return
    import MeshPart

    MeshPart.meshFromShape(Shape=shape, LinearDeflection=deflection, AngularDeflection=ANGULAR_DEFLECTION, Relative=False)


def smooth_parts(shape):
    """A number for each face: the same for those that go on in one another, and different ones across shallow edges.

    hsr draws between faces of different materials. A chain of faces that go on in one another may end at a shallow edge with
    itself; one smooth edge of it is then drawn, too.
    """
    faces = shape.Faces
    smooth, shallow = [], [set() for _ in faces]
    for (i, j), edge in shared_edges(faces):
        bends = bends_along(edge, faces[i], faces[j])
        if bends and max(bends) <= TANGENT:
            smooth.append((i, j))
        elif not bends or min(bends) <= CREASE:
            shallow[i].add(j)
            shallow[j].add(i)
    part = list(range(len(faces)))
    members = [{i} for i in part]
    for i, j in smooth:
        a, b = part[i], part[j]
        if a != b and not any(shallow[k] & members[b] for k in members[a]):
            for k in members[b]:
                part[k] = a
            members[a] |= members[b]
    return part


def shared_edges(faces):
    """((i, j), edge) for each edge of two faces; seams, which one face has twice, are none."""
    known = {}
    for j, face in enumerate(faces):
        for edge in face.Edges:
            same = known.setdefault(edge.hashCode(), [])
            for i, other in same:
                if i != j and edge.isSame(other):
                    yield (i, j), edge
            same.append((j, edge))


def bends_along(edge, a, b):
    """Degrees by which two faces deviate from flat at three points of their edge; nothing where OCCT does not know."""
    bends = []
    try:
        for share in (0.1, 0.5, 0.9):
            p = edge.valueAt(edge.FirstParameter + share * (edge.LastParameter - edge.FirstParameter))
            normals = [face.normalAt(*face.Surface.parameter(p)) for face in (a, b)]
            bends.append(math.degrees(normals[0].getAngle(normals[1])))
    except Exception:  # of many kinds: an edge without a curve, a point where a surface has no normal
        return []
    return bends


def colours_of(view, faces):
    """Red, green, blue and opacity, 0 to 1, of each face; None without a window."""
    if view is None:
        return [None] * faces
    opacity = 1 - getattr(view, "Transparency", 0) / 100
    looks = getattr(view, "ShapeAppearance", None)  # FreeCAD 1.0
    given = [look.DiffuseColor for look in looks] if looks else list(getattr(view, "DiffuseColor", None) or ())
    if len(given) != faces:
        one = getattr(view, "ShapeColor", None) or (given[0] if given else None)
        given = [one] * faces
    return [None if colour is None else (*colour[:3], opacity) for colour in given]


def view_options(view):
    """The options of hsr for a view by name, or for the text of a camera of Coin."""
    if "Camera" not in view:
        return ["--view", view]

    def numbers(field):
        found = re.search(rf"\b{field}\s+([-+.\deE \t]+)", view)
        if found is None:
            raise RuntimeError(f"hsr: found a camera without {field}, expected one of FreeCAD's")
        return [float(x) for x in found.group(1).split()]

    *axis, angle = numbers("orientation")
    turn = FreeCAD.Rotation(FreeCAD.Vector(*axis), math.degrees(angle))
    back, up = turn.multVec(FreeCAD.Vector(0, 0, 1)), turn.multVec(FreeCAD.Vector(0, 1, 0))
    options = [f"--up={text(up)}"]
    if "OrthographicCamera" in view:
        return [f"--direction={text(back)}", *options]
    eye = FreeCAD.Vector(*numbers("position"))
    target = eye - back * numbers("focalDistance")[0]
    return [f"--eye={text(eye)}", f"--target={text(target)}", f"--fov={math.degrees(numbers('heightAngle')[0])!r}", *options]


def text(v):
    return f"{v.x!r},{v.y!r},{v.z!r}"


def macro():
    """What is selected, or all that is visible, as the active view shows it; asks for the file."""
    import FreeCADGui
    from PySide import QtGui

    window = FreeCADGui.getMainWindow()
    try:
        if FreeCAD.ActiveDocument is None:
            raise RuntimeError("hsr: found no document, expected an open one")
        endings = "Drawings (*.svg *.pdf *.dxf *.eps *.tex *.hpgl *.png *.json)"
        output = QtGui.QFileDialog.getSaveFileName(window, "Drawing", "drawing.svg", endings)[0]
        if output:
            chosen = FreeCADGui.Selection.getSelection() or FreeCAD.ActiveDocument.Objects
            camera = FreeCADGui.ActiveDocument.ActiveView.getCamera()
            FreeCAD.Console.PrintMessage(draw(chosen, output, camera, OPTIONS) + "\n")
    except RuntimeError as error:
        FreeCAD.Console.PrintError(f"{error}\n")
        QtGui.QMessageBox.critical(window, "hsr", str(error))


if __name__ == "__main__" and FreeCAD.GuiUp:
    macro()
