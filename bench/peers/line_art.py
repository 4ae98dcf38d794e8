"""Blender's Line Art on a triangle mesh: run by bench/peers as `blender --background --python line_art.py -- SCENE STROKES`.

SCENE (doubles and 32-bit integers, native): the numbers of points and triangles; eye x, y, z, w; target; frame right, up; half of the picture
in units of the frame; crease in degrees; points; triangles. STROKES: seconds of the depsgraph by the clock and of the processor, the
number of strokes, for each the number of its points, then all points, in the scene's space.

Time is that of evaluating the dependency graph, which is where Line Art works, with the mesh already there.
"""

import math
import struct
import sys
import time

import bpy
import mathutils
import numpy


def read_scene(path):
    with open(path, "rb") as file:
        counts = numpy.fromfile(file, numpy.int64, 2)
        eye, target, right, up = numpy.split(numpy.fromfile(file, numpy.float64, 13), [4, 7, 10])
        half, crease = numpy.fromfile(file, numpy.float64, 2)
        points = numpy.fromfile(file, numpy.float64, 3 * counts[0]).reshape(-1, 3)
        triangles = numpy.fromfile(file, numpy.int32, 3 * counts[1])
    return eye, target, right, up, half, crease, points, triangles


def add_mesh(points, triangles):
    mesh = bpy.data.meshes.new("scene")
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set("co", points.astype(numpy.float32).ravel())
    mesh.loops.add(len(triangles))
    mesh.loops.foreach_set("vertex_index", triangles)
    mesh.polygons.add(len(triangles) // 3)
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, len(triangles), 3, dtype=numpy.int32))
    mesh.polygons.foreach_set("loop_total", numpy.full(len(triangles) // 3, 3, dtype=numpy.int32))
    mesh.update(calc_edges=True)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("scene", mesh))


def add_camera(eye, target, right, up, half, points):
    camera = bpy.data.cameras.new("camera")
    thing = bpy.data.objects.new("camera", camera)
    toward = numpy.cross(right, up)
    reach = float(numpy.linalg.norm(points - target, axis=1).max())
    if eye[3] == 0:
        camera.type = "ORTHO"
        camera.ortho_scale = 2 * half
        place = target + 3 * reach * toward
    else:
        place = eye[:3]
        camera.angle = 2 * math.atan(half / float(numpy.linalg.norm(eye[:3] - target)))
    camera.clip_start, camera.clip_end = 0.01 * reach, 10 * reach + float(numpy.linalg.norm(place - target))
    rows = [[right[k], up[k], toward[k], place[k]] for k in range(3)] + [[0, 0, 0, 1]]
    thing.matrix_world = mathutils.Matrix(rows)
    scene = bpy.context.scene
    scene.collection.objects.link(thing)
    scene.camera = thing
    scene.render.resolution_x = scene.render.resolution_y = 1024


def add_line_art(crease):
    pencil = bpy.data.grease_pencils.new("lines")
    layer = pencil.layers.new("lines")
    layer.frames.new(bpy.context.scene.frame_current)
    material = bpy.data.materials.new("ink")
    bpy.data.materials.create_gpencil_data(material)
    pencil.materials.append(material)
    thing = bpy.data.objects.new("lines", pencil)
    bpy.context.scene.collection.objects.link(thing)
    modifier = thing.grease_pencil_modifiers.new("lines", "GP_LINEART")
    modifier.source_type = "SCENE"
    modifier.target_layer, modifier.target_material = layer.info, material
    modifier.use_contour = modifier.use_crease = modifier.use_intersection = modifier.use_loose = True
    modifier.use_edge_mark = modifier.use_material = False
    modifier.use_crease_on_smooth = True
    modifier.crease_threshold = math.radians(180 - crease)
    modifier.chaining_image_threshold = 0
    modifier.smooth_tolerance = 0
    modifier.split_angle = 0
    modifier.stroke_depth_offset = 0  # points on the edges themselves
    return thing


def main():
    source, result = sys.argv[sys.argv.index("--") + 1 :]
    eye, target, right, up, half, crease, points, triangles = read_scene(source)
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    add_mesh(points, triangles)
    add_camera(eye, target, right, up, half, points)
    bpy.context.evaluated_depsgraph_get()  # what there is without lines
    pencil = add_line_art(crease)
    clock, processor = time.perf_counter(), time.process_time()
    graph = bpy.context.evaluated_depsgraph_get()
    clock, processor = time.perf_counter() - clock, time.process_time() - processor
    strokes = [s.points for layer in pencil.evaluated_get(graph).data.layers for frame in layer.frames for s in frame.strokes]
    with open(result, "wb") as file:
        file.write(struct.pack("=ddq", clock, processor, len(strokes)))
        numpy.array([len(s) for s in strokes], dtype=numpy.int64).tofile(file)
        for stroke in strokes:
            at = numpy.empty(3 * len(stroke), dtype=numpy.float32)
            stroke.foreach_get("co", at)
            at.astype(numpy.float64).tofile(file)


main()
