"""Rods, energies and derivatives, equilibria, and functions of the pose: with numpy and scipy."""

import numpy as np
import pytest
from scipy.optimize import check_grad, minimize

import tencer

COUNT = 21


def bow(rest_length=0.7):
    """A rod 1 long with EI = 1, its ends drawn together by a string."""
    section = tencer.Section(EA=1e6, EI1=1, EI2=1, GJ=1)
    rod = tencer.Rod(section, np.full(COUNT - 1, 1 / (COUNT - 1)))
    string = tencer.Cable((0, 0.0), (0, 1.0), stiffness=100, rest_length=rest_length)
    return tencer.Structure([rod], [string])


def arc():
    x = np.linspace(0, 1, COUNT)
    return np.stack([x, 0.4 * x * (1 - x), 0 * x], axis=1)


@pytest.fixture
def rest():
    structure = bow()
    return structure.solve(structure.pose([arc()]))


def test_gradient_and_hessian_agree_with_differences():
    structure = bow()
    system = tencer.System(structure)
    at = structure.pose([arc()])
    gradient = system.gradient(at)
    hessian = tencer.hessian(system, at).toarray()
    assert gradient.shape == (len(system),) and np.allclose(hessian, hessian.T)
    h = 1e-6
    for i in range(0, len(system), 7):
        step = np.zeros(len(system))
        step[i] = h
        after, before = system.displaced(at, step), system.displaced(at, -step)
        slope = (system.energy(after) - system.energy(before)) / (2 * h)
        assert slope == pytest.approx(gradient[i], rel=1e-4, abs=1e-4 * abs(gradient).max())
        rates = (system.gradient(after) - system.gradient(before)) / (2 * h)
        assert np.allclose(rates, hessian[:, i], rtol=1e-4, atol=1e-5 * abs(hessian).max())


def test_unknowns_say_what_is_held():
    section = tencer.Section.circle(youngs_modulus=4e6, radius=0.1)
    rod = tencer.Rod(section, np.ones(4))
    held = tencer.Structure([rod], pins=[(0, 0, "xyz"), (0, 4, "y")], planar=True)
    (unknowns,) = tencer.System(held).unknowns
    assert (unknowns[0] == -1).all() and (unknowns[:, 2] == -1).all()
    assert unknowns[4, 1] == -1 and unknowns[4, 0] >= 0


def test_an_equilibrium(rest):
    assert rest.usable and rest.reason and rest.residual <= 1e-6
    structure = bow()
    assert structure.stability(rest).stable
    ends = rest.positions[0][[0, -1]]
    assert rest.tensions[0] == pytest.approx(100 * (np.linalg.norm(ends[1] - ends[0]) - 0.7))
    assert abs(tencer.System(structure).gradient(rest.pose)).max() < 1e-4


def test_a_warm_start_takes_fewer_steps(rest):
    structure = bow(rest_length=0.69)
    warm = structure.solve(rest.pose)
    cold = structure.solve(structure.pose([arc()]))
    assert warm.usable and warm.iterations < cold.iterations
    assert warm.energy == pytest.approx(cold.energy, rel=1e-9)


def test_inextensible_cables_keep_their_lengths():
    structure = bow()
    rest = structure.solve(structure.pose([arc()]), inextensible=True)
    ends = rest.positions[0][[0, -1]]
    assert np.linalg.norm(ends[1] - ends[0]) == pytest.approx(0.7, rel=1e-9)
    assert structure.stability(rest, inextensible=True).stable


def test_a_solve_that_fails_says_why():
    structure = bow()
    rest = structure.solve(structure.pose([arc()]), max_iterations=1)
    assert not rest.usable and rest.reason


@pytest.fixture
def pose():
    structure = bow()
    return tencer.PoseMap(
        structure, structure.pose([arc()]), [("rest_length", 0), ("stiffness", 0), ("s_b", 0)]
    )


def height(positions):
    """The bow's height above its string's middle, squared: no rigid motion changes it."""
    x = positions[0]
    sag = x[COUNT // 2] - (x[0] + x[-1]) / 2
    gradient = np.zeros_like(x)
    gradient[COUNT // 2] = 2 * sag
    gradient[0] = gradient[-1] = -sag
    return sag @ sag, [gradient]


def test_the_adjoint_gradient_agrees_with_differences_in_numpy(pose):
    p = pose.values - [0, 0, 0.12]  # between two vertices: at one, derivatives are one-sided
    assert pose.move(p)
    gradient = pose.pull_back(height(pose.positions)[1])
    (motion,) = pose.push_forward([1.0, 0, 0])
    assert (motion * height(pose.positions)[1][0]).sum() == pytest.approx(gradient[0], rel=1e-8)
    for i, h in enumerate([1e-5, 1e-2, 1e-5]):
        step = h * np.eye(3)[i]
        assert pose.move(p + step)
        after = height(pose.positions)[0]
        assert pose.move(p - step)
        assert (after - height(pose.positions)[0]) / (2 * h) == pytest.approx(gradient[i], rel=1e-5)


def test_it_sits_inside_scipy(pose):
    def value(p):
        assert pose.move(p), pose.outcome
        found, gradient = height(pose.positions)
        return (found - 0.03) ** 2, pose.pull_back([2 * (found - 0.03) * gradient[0]])

    start = pose.values - [0, 0, 0.12]  # between two vertices: at one, derivatives are one-sided
    assert check_grad(lambda p: value(p)[0], lambda p: value(p)[1], start, epsilon=1e-6) < 1e-5
    found = minimize(value, start, jac=True, bounds=[(0.5, 0.9), (90, 110), (0.8, 1)])
    pose.move(found.x)
    assert height(pose.positions)[0] == pytest.approx(0.03, rel=1e-3)


def test_a_lost_pose_is_told(pose):
    before = pose.positions[0]
    assert not pose.move([1e-3, 1e5, 0.01])
    assert pose.outcome and np.array_equal(pose.positions[0], before)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: tencer.Rod(tencer.Section(1, 1, 1, 1), np.zeros(5)), "rest_lengths"),
        (lambda: tencer.Rod(tencer.Section(1, 1, 1, 1), np.ones((5, 3))), r"shape \(n\)"),
        (lambda: tencer.Structure([], []), "rod"),
        (lambda: bow().pose([arc()[:5]]), "column|vert"),
        (lambda: tencer.PoseMap(bow(), bow().pose([arc()]), [("colour", 0)]), "found colour"),
    ],
)
def test_wrong_arguments_are_value_errors(call, words):
    with pytest.raises(ValueError, match=words):
        call()


@pytest.mark.parametrize("method", ["ipopt", "mma", "gauss-newton"])
def test_optimizers_take_functions(method):
    matrix = np.diag([1.0, 10.0])
    found = tencer.minimise(
        lambda p: 0.5 * (p - 1) @ matrix @ (p - 1),
        [0.0, 0.0],
        gradient=lambda p: matrix @ (p - 1),
        hessian=lambda p: matrix,
        upper=[0.5, 5.0],
        lower=[-5.0, -5.0],
        method=method,
    )
    assert found.usable and np.allclose(found.point, [0.5, 1], atol=1e-4)


def test_what_an_objective_raises_comes_out():
    def fail(p):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        tencer.minimise(fail, [0.0], gradient=lambda p: p)
    with pytest.raises(ValueError, match="method: .*gauss-newton"):
        tencer.minimise(fail, [0.0], gradient=lambda p: p, method="magic")


def test_ctrl_c_gives_the_best_point_so_far():
    asked = []

    def value(p):
        asked.append(p)
        if len(asked) == 4:
            raise KeyboardInterrupt
        return float(p @ p)

    found = tencer.minimise(value, [3.0, 4.0], gradient=lambda p: 2 * p, method="mma")
    assert found.reason == "stopped" and found.usable and found.value <= 25
