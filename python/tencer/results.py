"""What results have beside what the library says of them: arrays by name, words and files."""

import html
import json
import os
import sys
import tempfile
import webbrowser

import numpy as np

from . import _core
from .keys import Keys


class Check(dict):
    """What a check found out, as design.json has it: sections, `passed` and what `fails`.

    `design` is the design as it comes to rest, with the cables of a repair; str() says all in words.
    """

    def __init__(self, design, text, report):
        super().__init__(json.loads(text))
        self.design = design
        self._report = report

    def __str__(self):
        return self._report


class Feasibility(dict):
    """Whether cables can hold a shape, as feasible.json has it: its `verdict`; str() is in words."""

    def __init__(self, text, report):
        super().__init__(json.loads(text))
        self._report = report

    def __str__(self):
        return self._report


def _check(
    design,
    *,
    length_error_mm=1.0,
    attachment_error_mm=2.0,
    max_deviation=None,
    draws=10000,
    repair=False,
):
    """Whether the design can be built and does then what it should, as `tencer check` tells.

    max_deviation: what errors may move, "2 mm" or "1 %" (of the target's diagonal). repair: ties what
    moves at no cost, and checks that.
    """
    deviation = None if max_deviation is None else str(max_deviation)
    return Check(
        *_core.check(design, length_error_mm, attachment_error_mm, deviation, draws, repair)
    )


def _simulate(design, *, start="pose", cables="inextensible", refine=1):
    """Where the design comes to rest from its "pose" or the "target", as a Simulation.

    cables: "inextensible" as they are built, or "springs". refine: edges into which each is divided.
    """
    for name, value, known in (
        ("start", start, ("pose", "target")),
        ("cables", cables, ("inextensible", "springs")),
    ):
        if value not in known:
            raise ValueError(f"{name}: expected one of {', '.join(known)}, found {value!r}")
    return _core.simulate(design, start == "target", cables == "springs", refine)


def _actuate(design, schedule):
    """What the design does while its cables change length slowly, as a tencer.Actuation.

    schedule: the path of a file as `tencer actuate` takes (docs/actuate.md), or its steps, a dict each:
        {2: "by -12 mm", "5-7": "to 80 %", "frames": 20}. Cables go by the numbers that they have on
        the sheet and on the page, from 1: row k of design.cables is cable k + 1.

    Ctrl-C ends it with the poses so far. Raises tencer.Error, which names the key or the file and line,
    and where the design does not rest in its pose.
    """
    if isinstance(schedule, (str, os.PathLike)):
        return _core.actuate(design, os.fspath(schedule), "")
    steps = [schedule] if isinstance(schedule, dict) else list(schedule)
    return _core.actuate(design, None, Keys({"step": steps}).text)


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
    """Writes what the ending says: the design (.json), its page (.html), or a file for other programs
    (.obj, .vtp, .gltf, .glb, .dxf, .csv), or a picture (.svg, .pdf, .png).
    """
    path = os.fspath(path)
    ending = os.path.splitext(path)[1].lower()
    if ending == ".json":
        content = design.to_json()
    elif ending == ".html":
        content = design.page()
    elif ending in (".svg", ".pdf", ".png"):
        return design.picture(path)
    else:
        content = design.export_bytes(path)
    _core.write_file(path, content)


def _need_program(what):
    if not hasattr(_core, "page"):
        raise RuntimeError(f"this build has no {what}: it was made without the program (TENCER_APPS)")


def _picture(design, path, *, views=(), caption="", numbers=True):
    """Draws the design into a file, .svg, .pdf or .png, as `tencer picture` does. views: of "oblique",
    "front", "side" and "top"; numbers: whether rods and cables have their names.
    """
    _need_program("pictures")
    views = [views] if isinstance(views, str) else list(views)
    content = _core.picture_bytes(design, os.fspath(path), views, caption, numbers)
    _core.write_file(os.fspath(path), content)


def _page(shown):
    """The page, view.html, as text."""
    _need_program("page")
    return _core.page(shown)


def _actuation_report(actuation):
    """What happened, in the words of `tencer actuate`: a line for each step, and for each jump."""
    _need_program("words for this")
    return _core.actuation_report(actuation)


def _export_actuation(actuation, folder):
    """Writes what `tencer actuate` does into the folder: page, poses.csv, an OBJ for each pose, pictures."""
    _need_program("files of this")
    _core.write_actuation(actuation, os.fspath(folder))


def _repr_html(shown):
    """The page in a notebook."""
    if not hasattr(_core, "page"):
        return None  # the notebook falls back on the text
    page = html.escape(_core.page(shown))
    return f'<iframe srcdoc="{page}" style="width: 100%; height: 900px; border: 0"></iframe>'


def _show(shown):
    """Shows the page: in the notebook, or in a browser; returns the file that a browser reads."""
    if "IPython" in sys.modules and sys.modules["IPython"].get_ipython() is not None:
        sys.modules["IPython"].display.display(shown)
        return None
    folder = tempfile.mkdtemp(prefix="tencer-")
    path = os.path.join(folder, shown.name + ".html")
    _core.write_file(path, _page(shown))
    webbrowser.open("file://" + path)
    return path


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
_core.Design.actuate = _actuate
_core.Design.check = _check
_core.Design.simulate = _simulate
_core.Design.export = _export
_core.Design.plot = _plot
_core.Design.page = _page
_core.Design.picture = _picture
_core.Design.show = _show
_core.Design._repr_html_ = _repr_html

_core.Actuation.report = _actuation_report
_core.Actuation.export = _export_actuation
_core.Actuation.page = _page
_core.Actuation.show = _show
_core.Actuation._repr_html_ = _repr_html
if hasattr(_core, "page"):
    _core.Actuation.__str__ = _actuation_report
