#!/usr/bin/env python3
"""cost.py FOLDER: what the sweep in FOLDER says that an error costs, as a table and as cost.svg there.

A design that is not complete counts as more cables than any other.
"""

import csv
import re
import sys
import tomllib
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np


def bending(curve):
    """Of a closed OBJ: the integral of curvature squared, times length, of which a circle has 1."""
    points = np.array(re.findall(r"^v (\S+) (\S+) (\S+)", curve.read_text(), re.M), dtype=float)
    edges = np.roll(points, -1, axis=0) - points
    lengths = np.linalg.norm(edges, axis=1)
    before = np.roll(edges, 1, axis=0)
    cosines = (edges * before).sum(axis=1) / (lengths * np.roll(lengths, 1))
    turns = np.arccos(np.clip(cosines, -1, 1))
    share = (lengths + np.roll(lengths, 1)) / 2
    return (turns**2 / share).sum() * lengths.sum() / (2 * np.pi) ** 2


def read_runs(folder):
    """An array, a row a run; springs are those that made the knot."""
    rows = []
    with open(folder / "study" / "study.csv", newline="") as table:
        for row in csv.DictReader(table):
            scene = folder / "knots" / (row["scene"] + ".toml")
            asked = tomllib.loads(scene.read_text())["design"]["max_error"]
            seed = int(row["scene"].rsplit("-", 1)[1])
            cables = float(row["cables"]) if row["status"] == "complete" else np.inf
            bend = bending(scene.with_suffix(".obj"))
            rows.append((asked, 4 + 2 * (seed % 5), bend, cables, float(row["seconds"] or "nan")))
    names = ("asked", "springs", "bending", "cables", "seconds")
    return np.array(rows, dtype=[(name, float) for name in names])


def quantile(numbers, part):
    """The least number that so many do not exceed."""
    return np.quantile(numbers, part, method="inverted_cdf")


def shown(number):
    return "none" if np.isinf(number) else f"{number:g}"


def told(runs):
    """The tables, in Markdown."""
    kinds = np.unique(runs["springs"])
    heads = ["within", "knots", "complete", "1 in 10", "half", "9 in 10"]
    heads += [f"of {kind:g} springs" for kind in kinds]
    lines = ["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|"]
    for asked in np.unique(runs["asked"]):
        of = runs[runs["asked"] == asked]
        cells = [f"{asked:g} %", str(len(of)), f"{100 * np.isfinite(of['cables']).mean():.0f} %"]
        cells += [shown(quantile(of["cables"], part)) for part in (0.1, 0.5, 0.9)]
        for kind in kinds:
            cables = of["cables"][of["springs"] == kind]
            cells.append(shown(quantile(cables, 0.5)) if len(cables) else "")
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def draw(runs, path):
    figure, (by_error, by_bend) = plt.subplots(1, 2, figsize=(9, 4), sharey=True, layout="constrained")
    errors = np.unique(runs["asked"])
    colours = dict(zip(errors, ("#0060ad", "#d95319", "#4f9d2f", "#7e2f8e")))
    jitter = np.random.default_rng(1).uniform(-0.28, 0.28, (2, len(runs)))
    place = np.searchsorted(errors, runs["asked"])
    for number, asked in enumerate(errors):
        of = runs["asked"] == asked
        dots = {"color": colours[asked], "s": 5, "alpha": 0.45, "linewidths": 0}
        by_error.scatter(place[of] + jitter[0, of], runs["cables"][of] + jitter[1, of], **dots)
        by_bend.scatter(runs["bending"][of], runs["cables"][of] + jitter[1, of], **dots)
    for part, dashes, name in ((0.9, "--", "9 in 10 need no more"), (0.5, "-", "half"), (0.1, ":", "1 in 10")):
        line = [quantile(runs["cables"][runs["asked"] == asked], part) for asked in errors]
        by_error.plot(line, dashes, color="#222222", label=name)
    by_error.set_xticks(range(len(errors)), [f"{asked:g} %" for asked in errors])
    by_error.set(xlabel="max error asked for, of the size", ylabel="cables")
    by_error.legend(frameon=False)
    for asked in errors:  # the middle of each fifth of the knots
        of = np.sort(runs[runs["asked"] == asked], order="bending")
        fifths = [fifth for fifth in np.array_split(of, 5) if len(fifth)]
        by_bend.plot(
            [np.median(fifth["bending"]) for fifth in fifths],
            [quantile(fifth["cables"], 0.5) for fifth in fifths],
            "o-",
            color=colours[asked],
            markersize=4,
            label=f"half, within {asked:g} %",
        )
    by_bend.set(xlabel="bending energy of the target, that of a circle being 1")
    by_bend.legend(frameon=False)
    for axes in (by_error, by_bend):
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(color="#e4e4e4")
        axes.set_axisbelow(True)
    figure.savefig(path)


def main():
    folder = Path(sys.argv[1])
    runs = read_runs(folder)
    print(told(runs))
    draw(runs, folder / "cost.svg")


if __name__ == "__main__":
    main()
