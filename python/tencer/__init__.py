"""Hold bent elastic rods in a chosen 3D shape with as few cables as possible.

>>> import numpy as np, tencer
>>> t = np.linspace(0, 2 * np.pi, 40, endpoint=False)
>>> ring = np.stack([30 * np.cos(t), 20 * np.sin(t), 0 * t], axis=1)
>>> design = tencer.design(ring, closed=True, max_error=5, effort=1)
>>> design.complete, len(design.tensions) == len(design.cables)
(True, True)

Lengths and forces are in the scene's units, cm and N if nothing else is said. What is asked for has
the names of the scene file (docs/scene.md); docs/python.md is the guide.
"""

from . import _core
from ._core import (
    Actuation,
    Cable,
    Curve,
    Design,
    Equilibrium,
    Error,
    Minimum,
    Network,
    Pose,
    PoseMap,
    Problem,
    Progress,
    Rod,
    Scene,
    Section,
    Simulation,
    Stability,
    Structure,
    System,
    families,
    minimise,
    optimizers,
    read_curves,
    read_design,
)
from .front_door import curves_of_family, design, feasible, prepare, scene, trade_off
from .results import Check, Feasibility
from .structures import hessian

__all__ = [
    "Actuation",
    "Cable",
    "Check",
    "Curve",
    "Design",
    "Equilibrium",
    "Error",
    "Feasibility",
    "Minimum",
    "Network",
    "Pose",
    "PoseMap",
    "Problem",
    "Progress",
    "Rod",
    "Scene",
    "Section",
    "Simulation",
    "Stability",
    "Structure",
    "System",
    "curves_of_family",
    "design",
    "families",
    "feasible",
    "hessian",
    "minimise",
    "optimizers",
    "prepare",
    "read_curves",
    "read_design",
    "scene",
    "trade_off",
]
__version__ = _core.__version__
