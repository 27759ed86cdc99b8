"""How close with how many cables: all numbers in one run, as a plot."""

import matplotlib.pyplot as plt

import tencer

designs = tencer.trade_off(family="trefoil-hypotrochoid", vertices=40, time=1)
counts = [len(design.cables) for design in designs]
errors = [design.max_percent for design in designs]

figure, axes = plt.subplots(figsize=(6, 4))
axes.semilogy(counts, errors, "o-")
axes.set(xlabel="cables", ylabel="largest distance from the target, % of its size")
axes.grid(alpha=0.3)
for design, count, error in zip(designs, counts, errors):
    print(f"{count} cables: {error:.3g} %{'' if design.stands else ', does not stand'}")
figure.savefig("trade_off.png")
