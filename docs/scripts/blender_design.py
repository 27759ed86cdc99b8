# A design in Blender: curves with thickness, named as in tencer's reports.
#
#   tencer export knot/design.json -o knot.obj
#   blender --background --python blender_design.py -- knot.obj knot.blend
#
# Or open it in Blender's Scripting workspace, where it takes the file named below.
import os
import sys

import bpy

FILE = "knot.obj"
ROD_RADIUS = 0.004  # of the size of the whole
METRES = {"mm": 0.001, "cm": 0.01, "m": 1.0}


def read_objects(path):
    """Names, points and whether closed, in metres, of the lines in an exported OBJ file."""
    lines = open(path).read().splitlines()
    unit = METRES[lines[0].split()[-1]]
    points, name = [], ""
    for line in lines[1:]:
        word, _, rest = line.partition(" ")
        if word == "o":
            name = rest
        elif word == "v":
            points.append([unit * float(x) for x in rest.split()])
        elif word == "l":
            indices = [int(i) - 1 for i in rest.split()]
            closed = indices[0] == indices[-1]
            yield name, [points[i] for i in (indices[:-1] if closed else indices)], closed


def add_curve(name, points, closed, radius, colour):
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = radius
    spline = curve.splines.new("POLY")
    spline.points.add(len(points) - 1)
    for place, point in zip(spline.points, points):
        place.co = (*point, 1)
    spline.use_cyclic_u = closed
    material = bpy.data.materials.get(colour) or bpy.data.materials.new(colour)
    material.diffuse_color = {"rod": (0.05, 0.2, 0.55, 1), "cable": (0.7, 0.06, 0.01, 1)}[colour]
    curve.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, curve))


given = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else [FILE]
parts = list(read_objects(given[0]))
places = [point for _, points, _ in parts for point in points]
size = max(max(axis) - min(axis) for axis in zip(*places))
for name, points, closed in parts:
    is_rod = name.startswith("rod")
    radius = ROD_RADIUS * size * (1 if is_rod else 0.4)
    add_curve(name, points, closed, radius, "rod" if is_rod else "cable")
if len(given) > 1:
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(given[1]))
