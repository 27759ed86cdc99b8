"""What calling from Python costs: times of calls, and a design's beside the program's.

overhead.py TENCER, the program; needs the module on PYTHONPATH.
"""

import resource
import subprocess
import sys
import tempfile
import timeit
from pathlib import Path

import numpy as np

import tencer


def microseconds(call, number=2000):
    return min(timeit.repeat(call, number=number, repeat=5)) / number * 1e6


def structure():
    rod = tencer.Rod(tencer.Section(EA=1e6, EI1=1, EI2=1, GJ=1), np.full(20, 0.05))
    string = tencer.Cable((0, 0.0), (0, 1.0), stiffness=100, rest_length=0.7)
    return tencer.Structure([rod], [string])


x = np.linspace(0, 1, 21)
bow = structure()
rest = bow.solve(bow.pose([np.stack([x, 0.4 * x * (1 - x), 0 * x], axis=1)]))
system = tencer.System(bow)
pose = rest.pose
large = tencer.curves_of_family("circle", vertices=20000)[0]
points = np.random.default_rng(1).random((20000, 3))

print(f"energy of 21 vertices                 {microseconds(lambda: system.energy(pose)):8.1f} us")
print(f"a view of 20 000 points               {microseconds(lambda: large.points):8.1f} us")
print(f"20 000 points checked, into a curve   {microseconds(lambda: tencer.Curve(points), 20):8.1f} us")
print(f"a solve of 21 vertices from its rest  {microseconds(lambda: bow.solve(pose), 200):8.1f} us")
tracked = tencer.PoseMap(bow, pose, [("rest_length", 0)])
print(f"the same without a thread of its own  {microseconds(lambda: tracked.move([0.7]), 200):8.1f} us")

with tempfile.TemporaryDirectory() as folder:
    curve = Path(folder, "knot.csv")
    (knot,) = tencer.curves_of_family("trefoil-2-3", vertices=60)
    np.savetxt(curve, np.vstack([knot.points, knot.points[:1]]), delimiter=",", fmt="%.17g")

    def seconds(who, call):
        before = resource.getrusage(who).ru_utime
        call()
        return resource.getrusage(who).ru_utime - before

    options = ["--max-error", "2", "--effort", "1", "-o", f"{folder}/out"]
    command = [sys.argv[1], "design", str(curve), *options]
    program = seconds(
        resource.RUSAGE_CHILDREN, lambda: subprocess.run(command, capture_output=True, check=True)
    )
    module = seconds(resource.RUSAGE_SELF, lambda: tencer.design(curve, max_error=2, effort=1))
print(f"a design: {module:.2f} s of processor time, {program:.2f} s by the program: "
      f"ratio {module / program:.3f}")
