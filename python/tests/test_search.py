"""The stages of a search one by one."""

import numpy as np
import pytest

import tencer
from conftest import QUICK


@pytest.fixture(scope="module")
def problem(trefoil):
    return tencer.prepare(trefoil, **QUICK)


def test_candidates_join_vertices_of_the_target(problem, trefoil):
    candidates = problem.candidates
    edges = np.linalg.norm(np.roll(trefoil.points, -1, axis=0) - trefoil.points, axis=1)
    places = np.concatenate([[0], np.cumsum(edges)[:-1]])
    ends = [
        trefoil.points[abs(places[:, None] - candidates[end]).argmin(axis=0)]
        for end in ("s_a", "s_b")
    ]
    assert len(candidates) > 100
    assert np.allclose(np.linalg.norm(ends[1] - ends[0], axis=1), candidates["length"])


def test_tensions_balance_the_rods_forces(problem):
    tensions = problem.balanced_tensions()
    assert tensions.shape == (len(problem.candidates),)
    assert (tensions >= 0).all() and 0 < (tensions > 0).sum() < 100


def test_fewer_cables_one_after_another(problem):
    dense = problem.balance()
    assert dense.valid and dense.max_percent < 1 and dense.fault == ""
    few = problem.eliminate(dense, max_error=8)
    assert len(few[0]) < len(dense) and all(network.valid for network in few)
    assert [len(network) for network in few] == sorted(len(network) for network in few)
    cables = few[0].cables
    assert (cables["tension"] > 0).all()
    assert few[0].positions[0].shape == (40, 3)
