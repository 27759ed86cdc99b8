# Opens exported files with the programs they are for: read_exports.py [ASSIMP]. What is not
# installed is said and left out. The folder holds ring.* and the design ring/design.json.
import json
import subprocess
import sys

design = json.load(open("ring/design.json"))
vertices = len(design["rods"][0]["pose"])
cables = len(design["cables"])
names = ["rod A"] + [f"cable {i + 1}" for i in range(cables)]


def expect(holds, what):
    if not holds:
        sys.exit(f"{what} is not so")


def read_vtp():
    try:
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    except ImportError:
        return "SKIPPED ring.vtp: no VTK (python3-vtk9)"
    reader = vtkXMLPolyDataReader()
    reader.SetFileName("ring.vtp")
    reader.Update()
    data = reader.GetOutput()
    expect(data.GetNumberOfPoints() == vertices + 2 * cables, "the number of points")
    expect(data.GetNumberOfLines() == 1 + cables, "the number of lines")
    expect(data.GetCell(0).GetNumberOfPoints() == vertices + 1, "that the rod is closed")
    for i in range(3):
        expect(data.GetPoint(5)[i] == design["rods"][0]["pose"][5][i], "a vertex")
    for name in ["curvature", "bending_strain", "tension", "deviation"]:
        array = data.GetPointData().GetArray(name)
        expect(array is not None and array.GetNumberOfTuples() == data.GetNumberOfPoints(), name)
    tension = data.GetPointData().GetArray("tension")
    expect(tension.GetValue(vertices) == design["cables"][0]["tension"], "a cable's tension")
    strain = data.GetPointData().GetArray("bending_strain")
    largest = max(strain.GetValue(i) for i in range(vertices))
    told = design["rods"][0]["bending_strain"]["largest"]
    expect(abs(largest - told) < 1e-6 * told, f"that the largest strain {largest} is {told}")
    name = data.GetCellData().GetAbstractArray("name")
    expect([name.GetValue(i) for i in range(1 + cables)] == names, "the names")
    unit = data.GetFieldData().GetAbstractArray("length_unit")
    expect(unit.GetValue(0) == "cm", "the unit")
    return "ring.vtp: read by VTK"


def read_dxf():
    try:
        import ezdxf
    except ImportError:
        return "SKIPPED ring.dxf: no ezdxf (python3-ezdxf)"
    document = ezdxf.readfile("ring.dxf")
    audit = document.audit()
    expect(not audit.errors, f"that ezdxf finds no errors, but {audit.errors}")
    lines = list(document.modelspace())
    layers = [line.dxf.layer for line in lines]
    expect(layers == [name.upper().replace(" ", "_") for name in names], f"the layers {layers}")
    expect(lines[0].is_3d_polyline and lines[0].is_closed, "that the rod is a closed 3D polyline")
    expect(len(lines[0].vertices) == vertices, "the number of vertices")
    return "ring.dxf: read by ezdxf"


def read_by_assimp(path):
    if len(sys.argv) < 2:
        return f"SKIPPED {path}: no assimp (assimp-utils)"
    told = subprocess.run([sys.argv[1], "info", path], capture_output=True, text=True).stdout
    for name in names:
        name = name.replace(" ", "_") if path.endswith(".obj") else name
        expect(name in told, f"that assimp finds '{name}' in {path}: {told}")
    return f"{path}: read by assimp"


for result in [read_vtp(), read_dxf()] + [read_by_assimp("ring." + e) for e in ["obj", "gltf", "glb"]]:
    print(result)
