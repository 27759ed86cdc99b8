"""What numpy and scipy make of the library's matrices."""

from typing import Any

from . import _core


def hessian(system: _core.System, pose: _core.Pose) -> Any:
    """The Hessian of the energy in the free unknowns of a System, a sparse matrix of scipy's."""
    from scipy.sparse import csc_matrix, tril

    lower = csc_matrix(_core.System.lower_hessian(system, pose), shape=(len(system), len(system)))
    return lower + tril(lower, -1).T
