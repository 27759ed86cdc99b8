"""Curves in, cables out."""

import os
from collections.abc import Callable
from typing import Any

from . import _core, results
from .keys import Keys, as_curve

# A path, a Scene, a Curve, an array (n, 3), a list of these, or None.
Curves = Any
Told = Callable[[_core.Progress], object] | None


def scene(curves: Curves = None, *, resolution: float = 1.0, **keys: Any) -> _core.Scene:
    """The scene of curves with any key of a scene file.

    curves: the path of a scene, curve or design file; a Curve, an array (n, 3) or a list of these; a
        Scene, which comes back as it is; or nothing, when `rod` or `family` says the curves.
    resolution: vertices of every rod, times what the curves have.
    keys: of docs/scene.md, all by their names: those of the top level, of [design] and of [[rod]]
        (which hold for every rod); `rod` is a list of dicts, one a rod; `build` and `edit` are dicts.
        Arrays stand for lists, `curve` may be an array and `edit["from"]` a Design. In place of what a
        file says.

    Raises tencer.Error, which names the key or the file and line.

    >>> import tencer
    >>> print(tencer.scene(family="circle", section={"radius": 0.1}, vertices=60))
    1 closed rod, 157 cm, circle r 1 mm, glass fibre, 9.4 g; fits in 50 x 50 x 0 cm
    """
    if isinstance(curves, _core.Scene):
        if keys or resolution != 1.0:
            raise TypeError("a Scene is complete: give its keys to tencer.scene instead")
        return curves
    file = None
    if isinstance(curves, (str, os.PathLike)):
        file = os.fspath(curves)
    elif curves is not None:
        if "rod" in keys:
            raise TypeError("rod: give the curves, or rod, whose dicts have a curve each")
        keys["rod"] = [{"curve": curve} for curve in _curves(curves)]
    said = Keys(keys)
    return _core.scene(file, said.text, said.curves, said.designs, "design", float(resolution))


def design(
    curves: Curves = None, *, progress: Told = None, resolution: float = 1.0, **keys: Any
) -> _core.Design:
    """Cables that hold the curves: the fewest within max_error, or the closest with so many `cables`.

    curves, resolution, keys: as tencer.scene has them.
    progress: called with a tencer.Progress now and then, in the calling thread; one that returns
        something true ends the search with the best design so far, and so does Ctrl-C.

    Raises tencer.Error for bad input. A design that is not all that was asked for is not complete,
    and design.shortfalls says why.
    """
    return _core.design(scene(curves, resolution=resolution, **keys), progress)


def trade_off(
    curves: Curves = None, *, progress: Told = None, resolution: float = 1.0, **keys: Any
) -> list[_core.Design]:
    """How close with how many cables: a design for each number, the fewest first.

    Arguments are those of tencer.design.
    """
    return _core.trade_off(scene(curves, resolution=resolution, **keys), progress)


def feasible(
    curves: Curves = None, *, resolution: float = 1.0, **keys: Any
) -> results.Feasibility:
    """Whether the cables that are allowed can hold the shape at all, known before a search.

    Arguments are those of tencer.scene; what comes back is a tencer.Feasibility, whose "verdict" is
    "can", "unclear" or "cannot".
    """
    return results.Feasibility(*_core.feasible(scene(curves, resolution=resolution, **keys)))


def prepare(curves: Curves = None, *, resolution: float = 1.0, **keys: Any) -> _core.Problem:
    """The tencer.Problem of a scene, for those who run the search's stages one by one.

    Arguments are those of tencer.scene.
    """
    return _core.prepare(scene(curves, resolution=resolution, **keys))


def curves_of_family(
    name: str, vertices: int | None = None, **parameters: float
) -> list[_core.Curve]:
    """The curves of a built-in family, see tencer.families().

    >>> import tencer
    >>> tencer.curves_of_family("circle", vertices=50, radius=10)
    [<Curve: 50 vertices, closed, 62.7905 long>]
    """
    return scene(family=name, vertices=vertices, parameters=parameters or None).curves


def _curves(given):
    """Whatever holds curves as a list of them."""
    if isinstance(given, _core.Curve) or getattr(given, "ndim", 0) == 2 or _is_points(given):
        given = [given]
    return [as_curve(one, f"curves[{i}]") for i, one in enumerate(given)]


def _is_points(given):
    """Whether a plain list is of points [x, y, z] rather than of curves."""
    try:
        return len(given) > 0 and all(isinstance(number, (int, float)) for number in given[0])
    except TypeError:
        return False
