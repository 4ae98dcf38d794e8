"""Draws what the camera of a Blender scene sees with hidden lines removed, by the command hsr.

As an add-on: Edit > Preferences > Add-ons > Install takes this file; then File > Export > hsr drawing.
Without a window: blender --background scene.blend --python hsr_drawing.py -- drawing.svg --hidden dashed
"""

import math
import os
import shlex
import shutil
import subprocess
import sys
import tempfile

import bpy
import numpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

bl_info = {
    "name": "hsr drawing",
    "description": "Vector drawings with hidden lines removed: SVG, PDF, DXF and others",
    "version": (1, 0, 0),
    "blender": (3, 0, 0),
    "location": "File > Export > hsr drawing",
    "category": "Import-Export",
}

LONGER_SIDE, MARGIN = 297, 10  # of the page of a perspective, mm


def draw(output, options=(), scene=None, command=None):
    """Draws the scene through its camera: `draw("drawing.svg", ["--hidden", "dashed"])`.

    output: a path, or a list of them; the ending chooses svg, pdf, eps, dxf, tex, hpgl, png or json
    options: more options of `hsr draw`; command: hsr [what the environment's HSR names, or hsr on PATH]

    Meshes, curves, surfaces, text and metaballs with their modifiers, and instances, as the viewport has them, less what is not
    rendered; loose edges are wires. Each object keeps its name, each face the base colour of its material. A perspective gets a
    page of the proportions of the render; a shifted lens the least one around it whose middle is the camera's axis. An
    orthographic camera gives its direction: all of the scene is drawn, whatever its frame.

    Returns what hsr says. Raises RuntimeError, one line, where hsr refuses, or there is no camera, nothing to draw, or no hsr.
    """
    scene = scene or bpy.context.scene
    depsgraph = bpy.context.evaluated_depsgraph_get()
    outputs = [output] if isinstance(output, (str, os.PathLike)) else list(output)
    with tempfile.TemporaryDirectory() as directory:
        model = os.path.join(directory, "blender.obj")
        box = write_model(depsgraph, model)
        arguments = ["draw", model, *view_options(scene, depsgraph, box), *unit_options(scene, options)]
        if not any(o.startswith(("--page", "--margin")) for o in options):
            arguments += page_options(scene, depsgraph)
        arguments += options
        for name in outputs:
            arguments += ["-o", os.fspath(name)]
        return run(arguments, command)


def run(arguments, command=None):
    """What the command hsr says. Raises RuntimeError, its one line, where it refuses."""
    command = command or os.environ.get("HSR") or shutil.which("hsr")
    if command is None:
        raise RuntimeError("hsr: the command is not on PATH: put it there, or name it in the add-on's preferences")
    try:
        ran = subprocess.run([command, *arguments], capture_output=True, text=True, check=False)
    except OSError as error:
        raise RuntimeError(f"hsr: {command} cannot be run: {error.strerror}") from None
    said = ran.stderr.strip()
    if ran.returncode != 0:
        raise RuntimeError(said.splitlines()[-1] if said else f"hsr: ended with status {ran.returncode}")
    return said


def write_model(depsgraph, path):
    """An OBJ file, and its materials beside it. Returns the corners of the box of all points."""
    library = os.path.splitext(path)[0] + ".mtl"
    names, materials, first = set(), {}, 1
    low, high = numpy.full(3, numpy.inf), numpy.full(3, -numpy.inf)
    with open(path, "w", encoding="utf-8") as obj:
        obj.write(f"mtllib {os.path.basename(library)}\n")
        for instance in depsgraph.object_instances:
            thing = instance.object
            if not instance.show_self or thing.hide_render or (instance.parent and instance.parent.hide_render):
                continue
            if thing.type not in {"MESH", "CURVE", "SURFACE", "FONT", "META"}:
                continue
            mesh = thing.to_mesh()
            if mesh is not None and len(mesh.vertices) > 0:
                points = placed_points(mesh, instance.matrix_world)
                low, high = numpy.minimum(low, points.min(axis=0)), numpy.maximum(high, points.max(axis=0))
                obj.write(f"o {unused(' '.join(thing.name.split()), names)}\n")
                write_mesh(obj, thing, mesh, points, first, materials)
                first += len(points)
            thing.to_mesh_clear()
    if first == 1:
        raise RuntimeError("hsr: found nothing that is rendered, expected an object with faces or edges")
    with open(library, "w", encoding="utf-8") as mtl:
        for name, colour in materials.values():
            mtl.write("newmtl {}\nKd {:.6f} {:.6f} {:.6f}\nd {:.6f}\n".format(name, *colour))
    return low, high


def placed_points(mesh, matrix):
    """The vertices in the world, in doubles: Blender's own products are rounded to floats."""
    points = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
    mesh.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3).astype(float)
    m = numpy.array(matrix, dtype=float)
    # Column by column: a product of matrices may add in another order for other sizes.
    return points[:, :1] * m[:3, 0] + points[:, 1:2] * m[:3, 1] + points[:, 2:] * m[:3, 2] + m[:3, 3]


def write_mesh(obj, thing, mesh, points, first, materials):
    obj.writelines("v {!r} {!r} {!r}\n".format(*p) for p in points.tolist())
    slots = [slot.material for slot in thing.material_slots]
    current = None
    for polygon in mesh.polygons:
        material = slots[polygon.material_index] if polygon.material_index < len(slots) else None
        if material is None:
            name = "none"
        else:
            name, _ = materials.setdefault(material.name, (f"material{len(materials)}", colour_of(material)))
        if name != current:
            obj.write(f"usemtl {name}\n")
            current = name
        obj.write("f" + "".join(f" {first + v}" for v in polygon.vertices) + "\n")
    in_faces = {key for polygon in mesh.polygons for key in polygon.edge_keys}
    for edge in mesh.edges:
        if edge.key not in in_faces:
            obj.write("l {} {}\n".format(*(first + v for v in edge.vertices)))


def unused(name, names):
    free, k = name, 2
    while free in names:
        free, k = f"{name} [{k}]", k + 1
    names.add(free)
    return free


def colour_of(material):
    """Red, green, blue in sRGB, and opacity: the base colour of its first shader that has one, else that of the viewport."""
    colour, opacity = material.diffuse_color, material.diffuse_color[3]
    for node in material.node_tree.nodes if material.use_nodes and material.node_tree else ():
        given = node.inputs.get("Base Color") or (node.inputs.get("Color") if node.type.startswith(("BSDF", "EMISSION")) else None)
        if given is not None and not given.is_linked:
            colour, opacity = given.default_value, 1.0
            if "Alpha" in node.inputs and not node.inputs["Alpha"].is_linked:
                opacity = node.inputs["Alpha"].default_value
            break
    return [*(stored(x) for x in colour[:3]), min(max(opacity, 0.0), 1.0)]


def stored(light):
    """A channel as sRGB has it; Blender computes with light."""
    light = min(max(light, 0.0), 1.0)
    return 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055


def camera_of(scene, depsgraph):
    if scene.camera is None:
        raise RuntimeError("hsr: found a scene without a camera, expected one")
    camera = scene.camera.evaluated_get(depsgraph)
    if camera.type != "CAMERA" or camera.data.type not in {"PERSP", "ORTHO"}:
        raise RuntimeError(f'hsr: found the camera "{camera.name}", expected a perspective or an orthographic one')
    return camera


def lens(scene, depsgraph):
    """Tangents of half the angles of the least frame around what is rendered whose middle is the camera's axis: across, up."""
    r = scene.render
    m = camera_of(scene, depsgraph).calc_matrix_camera(
        depsgraph, x=r.resolution_x, y=r.resolution_y, scale_x=r.pixel_aspect_x, scale_y=r.pixel_aspect_y
    )
    return (1 + abs(m[0][2])) / m[0][0], (1 + abs(m[1][2])) / m[1][1]


def view_options(scene, depsgraph, box):
    camera = camera_of(scene, depsgraph)
    m = numpy.array(camera.matrix_world, dtype=float)
    up, back, eye = m[:3, 1], m[:3, 2], m[:3, 3]
    if camera.data.type == "ORTHO":
        return [f"--direction={text(back)}", f"--up={text(up)}"]
    back = back / numpy.linalg.norm(back)
    ahead = float(numpy.dot(eye - (box[0] + box[1]) / 2, back))  # the target is as far as the middle of the scene
    target = eye - back * (ahead if ahead > 0 else 1.0)
    fov = math.degrees(2 * math.atan(min(lens(scene, depsgraph))))
    near = camera.data.clip_start
    return [f"--eye={text(eye)}", f"--target={text(target)}", f"--up={text(up)}", f"--fov={fov!r}", f"--near={near!r}"]


def page_options(scene, depsgraph):
    if camera_of(scene, depsgraph).data.type == "ORTHO":
        return []
    across, up = lens(scene, depsgraph)
    scale = (LONGER_SIDE - 2 * MARGIN) / max(across, up)
    return ["--page", f"{across * scale + 2 * MARGIN:.3f}x{up * scale + 2 * MARGIN:.3f}mm", "--margin", str(MARGIN)]


def unit_options(scene, options):
    """hsr knows metres, centimetres and millimetres; what the unit is counts only where a scale is asked for."""
    if any(o.startswith("--unit") for o in options):
        return []
    lengths, metres = {1.0: "m", 0.01: "cm", 0.001: "mm"}, scene.unit_settings.scale_length
    return [f"--unit={unit}" for length, unit in lengths.items() if math.isclose(metres, length, rel_tol=1e-6)]


def text(v):
    return ",".join(repr(float(x)) for x in v)


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    command: StringProperty(name="hsr", description="The command, where it is not on PATH", subtype="FILE_PATH")

    def draw(self, context):
        self.layout.prop(self, "command")


class ExportDrawing(bpy.types.Operator, ExportHelper):
    """A vector drawing of what the camera sees; the ending of the name chooses SVG, PDF, DXF, ..."""

    bl_idname = "export_scene.hsr_drawing"
    bl_label = "Export hsr drawing"
    filename_ext = ".svg"
    check_extension = None  # any ending
    filter_glob: StringProperty(default="*.svg;*.pdf;*.eps;*.dxf;*.tex;*.hpgl;*.png;*.json", options={"HIDDEN"})
    hidden: EnumProperty(name="Hidden lines", items=[(x, x.capitalize(), "") for x in ("none", "dashed", "solid")])
    fill: BoolProperty(name="Fill", description="Fill the visible parts of faces in the colours of their materials")
    options: StringProperty(name="Options", description='More options of "hsr draw", such as --pen visible=0.35')

    def execute(self, context):
        addon = context.preferences.addons.get(__name__)
        try:
            options = ["--hidden", self.hidden, *(["--fill"] if self.fill else []), *shlex.split(self.options)]
            said = draw(self.filepath, options, context.scene, addon.preferences.command if addon else None)
        except (RuntimeError, ValueError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, said.splitlines()[-1] if said else self.filepath)
        return {"FINISHED"}


def menu(self, context):
    self.layout.operator(ExportDrawing.bl_idname, text="hsr drawing (.svg, .pdf, .dxf, ...)")


def register():
    bpy.utils.register_class(Preferences)
    bpy.utils.register_class(ExportDrawing)
    bpy.types.TOPBAR_MT_file_export.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu)
    bpy.utils.unregister_class(ExportDrawing)
    bpy.utils.unregister_class(Preferences)


def main(arguments):
    """What stands behind `--`: the drawing, or several, and options."""
    first = next((k for k, word in enumerate(arguments) if word.startswith("-")), len(arguments))
    try:
        if first == 0:
            raise RuntimeError("hsr: found no name of a drawing behind --, expected one, such as drawing.svg")
        print(draw(arguments[:first], arguments[first:]))
    except RuntimeError as error:
        print(error, file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    if "--" in sys.argv:
        main(sys.argv[sys.argv.index("--") + 1 :])
    else:
        register()
