"""The same design from C++, the command line and Python, byte by byte; also from arrays. All but the
seconds that were measured."""

import os
import re
import subprocess

import numpy as np
import pytest

import tencer
from conftest import QUICK, trefoil_points

PROGRAM = os.environ.get("TENCER_PROGRAM")
FRONT_DOOR = os.environ.get("TENCER_FRONT_DOOR")


def but_seconds(text):
    return re.sub(r'"seconds": [0-9.e+-]+', '"seconds": 0', text)


@pytest.mark.skipif(not PROGRAM, reason="TENCER_PROGRAM and TENCER_FRONT_DOOR name the programs")
def test_same_bytes(tmp_path):
    curve = tmp_path / "design.csv"
    points = trefoil_points(24)
    points = np.vstack([points, points[:1]])
    curve.write_text("\n".join(",".join(map(repr, point)) for point in points.tolist()))

    subprocess.run([FRONT_DOOR, curve, tmp_path / "cpp.json"], check=True)
    options = "--max-error 5 --effort 1 --length-error 0 --attachment-error 0".split()
    command = [PROGRAM, "design", curve, "-o", tmp_path / "cli", *options]
    subprocess.run(command, check=True, capture_output=True)
    made = {
        "C++": (tmp_path / "cpp.json").read_text(),
        "command line": (tmp_path / "cli" / "design.json").read_text(),
        "file": tencer.design(curve, **QUICK).to_json(),
        "array": tencer.design(points, **QUICK, threads=1).to_json(),
    }
    assert "seconds" in made["C++"]
    for how, text in made.items():
        assert but_seconds(text) == but_seconds(made["C++"]), how
