"""A rule and an objective of your own: where on an arch a string is tied, so that its top is low and
its ends are level, by scipy, by Ipopt and in plain numpy; derivatives come back through the pose by one
adjoint solve each.

The rule is a function of the pose that no scene has a key for: the arch may lean by so much and no
more. The same derivative is a custom rule of JAX or PyTorch: value(p) forwards, pull_back backwards.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import minimize

import tencer

count, length = 60, 100.0  # cm
x = np.linspace(0, length, count)
straight = np.stack([x, 8 * np.sin(np.pi * x / length), 0 * x], axis=1)
section = tencer.Section.circle(youngs_modulus=4e6, radius=0.2)  # N/cm^2, cm
rod = tencer.Rod(section, np.full(count - 1, length / (count - 1)))
strings = [
    tencer.Cable((0, 0.0), (0, length), stiffness=40, rest_length=80),
    tencer.Cable((0, 20.0), (0, 75.0), stiffness=40, rest_length=48),
]
arch = tencer.Structure([rod], strings, pins=[(0, 0, "xyz")], planar=True)
pose = tencer.PoseMap(
    arch,
    arch.pose([straight]),
    [("rest_length", 0), ("rest_length", 1), ("s_a", 1), ("s_b", 1)],
)


def residuals(positions):
    """How far the top is from 18 cm, and the ends from level, (2,); the derivatives, (2, count, 3)."""
    y = positions[0][:, 1]
    top = np.argmax(y)
    derivatives = np.zeros((2, count, 3))
    derivatives[0, top, 1] = 1
    derivatives[1, [0, -1], 1] = -1, 1
    return np.array([y[top] - 18, y[-1] - y[0]]), derivatives


def value(p):
    """The sum of their squares, and its derivative by what the strings are."""
    if not pose.move(p):  # no equilibrium: the line search comes back
        return 1e6, np.zeros(len(p))
    r, derivatives = residuals(pose.positions)
    return r @ r, pose.pull_back([2 * np.tensordot(r, derivatives, 1)])


before, start = pose.positions[0], pose.values
found = minimize(
    value,
    pose.values,
    jac=True,
    method="L-BFGS-B",
    bounds=[(60, 95), (30, 60), (5, 45), (55, 95)],
    callback=lambda p: pose.move(p) and pose.commit(),
    options={"maxiter": 40},
)
after = pose.positions[0]
print(found.message, f"after {found.nfev} equilibria: {found.fun:.2g} cm^2")
print(f"top {after[:, 1].max():.2f} cm, ends level to {abs(after[-1, 1] - after[0, 1]):.3f} cm")

# The same with tencer's own optimizers, which take gradients as they are.
own = tencer.minimise(
    lambda p: value(p)[0],
    found.x,
    gradient=lambda p: value(p)[1],
    lower=[60, 30, 5, 55],
    upper=[95, 60, 45, 95],
    method="ipopt",
    max_iterations=20,
)
print(own)

# And in plain numpy: Gauss-Newton steps of at most 2 cm, a row of the Jacobian from each adjoint solve.
pose.move(start) and pose.commit()
for step in range(20):
    r, derivatives = residuals(pose.positions)
    if abs(r).max() < 1e-3:
        break
    jacobian = [pose.pull_back([derivative]) for derivative in derivatives]
    change = np.linalg.lstsq(jacobian, -r, rcond=None)[0]
    assert pose.move(pose.values + change * min(1, 2 / abs(change).max())), pose.outcome
    pose.commit()
print(f"plain numpy: {r @ r:.2g} cm^2 after {step} steps")
assert r @ r < 1e-4

figure, axes = plt.subplots(figsize=(7, 4))
axes.plot(*before[:, :2].T, "--", label="before")
axes.plot(*after[:, :2].T, linewidth=3, label="after")
for ends in ([0, length], found.x[2:]):  # the strings
    axes.plot(*(np.interp(ends, x, after[:, axis]) for axis in (0, 1)), color="0.3", linewidth=0.8)
axes.axhline(18, color="0.7")
axes.set_aspect("equal")
axes.legend()
figure.savefig("custom_objective.png")
