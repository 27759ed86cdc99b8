# A design in Rhino: run it by RunPythonScript (Rhino 7 or 8), or put it into a Python component of
# Grasshopper, where `curves` and `names` are outputs. First: tencer export knot/design.json -o
# knot.obj. Lengths are taken in the unit of the document as they stand in the file.
import rhinoscriptsyntax as rs

points, name = [], ""
curves, names = [], []
for line in open(rs.OpenFileName("A design exported as OBJ", "OBJ (*.obj)|*.obj||")):
    word, _, rest = line.strip().partition(" ")
    if word == "o":
        name = rest
    elif word == "v":
        points.append([float(x) for x in rest.split()])
    elif word == "l":
        line_points = [points[int(i) - 1] for i in rest.split()]
        # Rods are smooth curves through their vertices, cables straight.
        if name.startswith("rod"):
            curve = rs.AddInterpCurve(line_points, knotstyle=4 if rest.split()[0] == rest.split()[-1] else 1)
        else:
            curve = rs.AddPolyline(line_points)
        rs.ObjectName(curve, name)
        layer = name.split("_")[0] + "s"
        if not rs.IsLayer(layer):
            rs.AddLayer(layer)
        rs.ObjectLayer(curve, layer)
        curves.append(curve)
        names.append(name)
