"""Forward modelling, figure 8 of the paper: a ring with a cable across it, in its plane and out of it.

The cable is shortened step by step, each equilibrium starting from the last. The ring in its plane
stays an equilibrium; below some length it is no longer stable, and a push sends it out of its plane.
"""

import matplotlib.pyplot as plt
import numpy as np

import tencer

count, length = 80, 100.0  # cm
t = np.linspace(0, 2 * np.pi, count, endpoint=False)
circle = length / (2 * np.pi) * np.stack([np.cos(t), np.sin(t), 0 * t], axis=1)
section = tencer.Section.circle(youngs_modulus=4e6, radius=0.1)  # N/cm^2, cm
rod = tencer.Rod(section, np.full(count, length / count), closed=True)


def ring(part):
    """The structure with a cable from one side to the other, `part` as long as the diameter."""
    cable = tencer.Cable((0, 0.0), (0, length / 2), stiffness=1, rest_length=part * length / np.pi)
    return tencer.Structure([rod], [cable])


def follow(parts, push):
    """From the circle on, every pose the start of the next; `push` out of the plane before each."""
    bump = push * np.stack([0 * t, 0 * t, np.cos(2 * t)], axis=1)
    position, found = circle, []
    for part in parts:
        structure = ring(part)
        rest = structure.solve(structure.pose([position + bump]), inextensible=True)
        if not rest.usable:
            print(f"cable at {part:.2f} of the diameter: {rest.reason}")
            break
        position = rest.positions[0]
        eigenvalue = structure.stability(rest, inextensible=True).smallest_eigenvalue
        found.append((part, position, rest.tensions[0], eigenvalue))
    return found


parts = np.linspace(0.95, 0.2, 16)
pushed = follow(parts, push=0.2)
for part, position, tension, eigenvalue in pushed:
    height = np.ptp(position[:, 2])
    print(f"{part:.2f}: pulls {tension:.3f} N, {height:5.2f} cm high, eigenvalue {eigenvalue:.0f}")

figure = plt.figure(figsize=(9, 4))
view = figure.add_subplot(121, projection="3d")
for part, position, _, _ in pushed[::3]:
    view.plot(*np.vstack([position, position[:1]]).T, label=f"{part:.2f}")
view.set_aspect("equal")
view.legend(title="cable / diameter", fontsize=7, loc="upper left", bbox_to_anchor=(-0.2, 1))
graph = figure.add_subplot(122)
graph.plot([part for part, *_ in pushed], [tension for _, _, tension, _ in pushed], "o-")
graph.set(xlabel="cable / diameter", ylabel="tension, N")
graph.grid(alpha=0.3)
figure.tight_layout()
figure.savefig("ring.png")
