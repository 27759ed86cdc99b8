"""Every example runs and makes its picture; so does what tells a sweep's cost."""

import os
import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples" / "python"
COST = EXAMPLES.parent / "sweep" / "cost.py"


@pytest.mark.parametrize("example", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_example(example, tmp_path):
    done = subprocess.run(
        [sys.executable, example],
        cwd=tmp_path,
        env={**os.environ, "MPLBACKEND": "Agg"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    picture = tmp_path / f"{example.stem}.png"
    assert picture.read_bytes().startswith(b"\x89PNG") and picture.stat().st_size > 5000


def test_what_a_sweep_says_of_cost(tmp_path):
    """Of eight circles, four within each error; the design of knot 3 is not complete."""
    (tmp_path / "knots").mkdir()
    (tmp_path / "study").mkdir()
    table = ["scene,status,cables,seconds"]
    t = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    for seed in range(1, 9):
        knot = tmp_path / "knots" / f"knot-{seed:04}"
        points = np.stack([30 * np.cos(t), 30 * np.sin(t), 0 * t], axis=1)
        knot.with_suffix(".obj").write_text("".join("v {} {} {}\n".format(*p) for p in points))
        knot.with_suffix(".toml").write_text(f"[design]\nmax_error = {0.5 if seed < 5 else 2}\n")
        status = "tolerance-not-reached" if seed == 3 else "complete"
        table.append(f"knot-{seed:04},{status},{seed},0.5")
    (tmp_path / "study" / "study.csv").write_text("\n".join(table) + "\n")
    done = subprocess.run([sys.executable, COST, tmp_path], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    rows = [[cell.strip() for cell in line.split("|")] for line in done.stdout.splitlines()]
    assert rows[2][1:7] == ["0.5 %", "4", "75 %", "1", "2", "none"]
    assert rows[3][1:7] == ["2 %", "4", "100 %", "5", "6", "8"]
    assert (tmp_path / "cost.svg").read_text().count("<svg") == 1
    told = runpy.run_path(str(COST))
    assert abs(told["bending"](tmp_path / "knots" / "knot-0001.obj") - 1) < 1e-3
