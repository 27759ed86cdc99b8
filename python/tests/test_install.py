"""The package as others install it: a wheel, built and installed without a network."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[2]


@pytest.mark.skipif("TENCER_BUILD" not in os.environ, reason="TENCER_BUILD names what is built")
def test_a_wheel_is_built_and_installed(tmp_path):
    def run(*command, **variables):
        done = subprocess.run(
            [sys.executable, *command],
            cwd=tmp_path,
            env={**os.environ, **variables},
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    alone = ["--no-index", "--no-deps", "--quiet", "--disable-pip-version-check"]
    run("-m", "pip", "wheel", "--no-build-isolation", *alone, "--wheel-dir", "dist", str(SOURCE))
    (wheel,) = (tmp_path / "dist").glob("tencer-*.whl")
    site = tmp_path / "site"
    run("-m", "pip", "install", *alone, "--target", str(site), str(wheel))
    found = run(
        "-c",
        "import tencer; print(tencer.__file__, tencer.curves_of_family('circle', vertices=9))",
        PYTHONPATH=str(site),
    )
    assert found.startswith(str(site)) and "9 vertices, closed" in found
    assert (site / "tencer" / "py.typed").exists()
    assert not list(SOURCE.glob("python/*.egg-info"))
