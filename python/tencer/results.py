"""What a Design has beside what the library says of it: arrays by name, and files."""

import os

import numpy as np

from . import _core


def _column(name, what):
    return property(lambda design: design.cables[name], doc=what)


def _marks(design):
    """Per rod what to mark on it: an array of (s, cable), by arc length s at rest from its start."""
    cables = design.cables
    marks = []
    for rod in range(len(design.poses)):
        ends = [
            (cables["s_" + end][number], number)
            for end in "ab"
            for number in np.flatnonzero(cables["rod_" + end] == rod)
        ]
        marks.append(np.array(sorted(ends), dtype=[("s", float), ("cable", int)]))
    return marks


def _export(design, path):
    """Writes what the ending says: .json the design, .obj the pose, .csv the record of stages."""
    path = os.fspath(path)
    writers = {".json": design.to_json, ".obj": design.pose_obj, ".csv": design.trace_csv}
    ending = os.path.splitext(path)[1]
    if ending not in writers:
        raise ValueError(f"{path}: expected an ending among {', '.join(writers)}, found '{ending}'")
    _core.write_file(path, writers[ending]())


def _plot(design, axes=None):
    """Draws rods and cables with matplotlib, into 3D axes if they are given; returns the axes."""
    if axes is None:
        import matplotlib.pyplot as plt

        axes = plt.figure(figsize=(6, 6)).add_subplot(projection="3d")
    for pose, closed in zip(design.poses, design.closed):
        line = np.vstack([pose, pose[:1]]) if closed else pose
        axes.plot(*line.T, linewidth=3)
    for ends in design.cable_points:
        axes.plot(*ends.T, color="0.3", linewidth=0.8)
    if len(design.anchors):
        axes.scatter(*design.anchors.T, marker="s", color="0.3")
    axes.set_aspect("equal")
    error = "" if design.max_percent is None else f", {design.max_percent:.2g} % from the target"
    axes.set(xlabel=design.length_unit, title=f"{design.name}: {len(design.cables)} cables{error}")
    return axes


_core.Design.tensions = _column("tension", "What each cable pulls with, (cables,), forces.")
_core.Design.lengths = _column("length", "Each cable's length as built, (cables,).")
_core.Design.marks = property(_marks)
_core.Design.export = _export
_core.Design.plot = _plot
