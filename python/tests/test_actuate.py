"""Cables pulled and let go: the words and files are the program's, the poses are arrays."""

import os
import subprocess

import numpy as np
import pytest

import tencer

PULL = [{1: "by -4 %", "frames": 4}, {"all": "to 100 %", "frames": 2}]


@pytest.fixture(scope="module")
def actuation(design):
    return design.actuate(PULL)


def test_poses_are_arrays(design, actuation):
    count = len(actuation)
    cables = len(design.cables)
    assert actuation.finished and not actuation.jumps and count == 7
    assert actuation.lengths.shape == actuation.tensions.shape == (count, cables)
    assert actuation.steps.tolist() == [0] * 5 + [1] * 2
    assert np.allclose(actuation.parts, [0, 0.25, 0.5, 0.75, 1, 0.5, 1])
    assert (actuation.strands_apart > 0).all()
    assert len(actuation.poses) == count and actuation.poses[0][0].shape == (40, 3)
    with pytest.raises(ValueError, match="read-only"):
        actuation.poses[0][0][0, 0] = 1


def test_a_view_keeps_its_actuation(design):
    pose = design.actuate({1: "by -1 %", "frames": 1}).poses[-1][0]
    assert np.isfinite(pose).all()


def test_lengths_go_as_asked_and_come_back(design, actuation):
    assert np.isclose(actuation.lengths[4, 0], 0.96 * design.lengths[0])
    size = np.ptp(design.poses[0])
    assert abs(actuation.poses[4][0] - design.poses[0]).max() > 1e-3 * size
    assert abs(actuation.poses[-1][0] - design.poses[0]).max() < 1e-4 * size


def test_energy_is_the_work_of_the_cables(actuation):
    """dE = - tension dl, by the trapezoidal rule."""
    tension = (actuation.tensions[1:] + actuation.tensions[:-1]) / 2
    work = -(tension * np.diff(actuation.lengths, axis=0)).sum(axis=1)
    assert np.allclose(np.diff(actuation.energies), work, rtol=0.05)


def test_a_pose_is_a_design(actuation, tmp_path):
    pulled = actuation.design(4)
    assert np.array_equal(pulled.poses[0], actuation.poses[4][0])
    assert np.array_equal(pulled.tensions, actuation.tensions[4]) and pulled.max_percent is None
    assert np.array_equal(actuation.design(-1).lengths, actuation.lengths[-1])
    pulled.export(tmp_path / "pulled.obj")
    with pytest.raises(IndexError, match="there are 7, found 7"):
        actuation.design(7)


@pytest.mark.parametrize(
    "schedule, words",
    [
        ([], "has no step"),
        ({99: "by -4 %"}, r"step\[0\]\.99: the design has no such cable"),
        ({1: "shorter"}, r"step\[0\]\.1: expected \"by -12 mm\""),
        ({1: "to -5 mm"}, "it must stay above zero"),
        ({"cable": "by -4 %"}, r"step\[0\]\.cable: is no cable"),
        ("none.toml", "none.toml"),
    ],
)
def test_what_cannot_be_followed_is_refused(design, schedule, words):
    with pytest.raises(tencer.Error, match=words):
        design.actuate(schedule)


@pytest.mark.skipif("TENCER_PROGRAM" not in os.environ, reason="TENCER_PROGRAM names the program")
def test_it_is_what_the_program_does(design, tmp_path):
    """Of one design file, with one schedule file: the same words and bytes."""
    design.export(tmp_path / "design.json")
    schedule = tmp_path / "pull.toml"
    schedule.write_text('[[step]]\n1 = "by -4 %"\nframes = 4\n[[step]]\nall = "to 100 %"\nframes = 2\n')
    told = subprocess.run(
        [os.environ["TENCER_PROGRAM"], "actuate", "design.json", schedule, "-o", "theirs"],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    again = tencer.read_design(tmp_path / "design.json")
    ours = again.actuate(schedule)
    assert ours.report() == str(ours) == told
    ours.export(tmp_path / "ours")
    names = sorted(path.name for path in (tmp_path / "theirs").iterdir())
    assert names == sorted(path.name for path in (tmp_path / "ours").iterdir())
    for name in names:
        assert (tmp_path / "ours" / name).read_bytes() == (tmp_path / "theirs" / name).read_bytes()
    assert np.array_equal(again.actuate(PULL).tensions, ours.tensions)
    assert ours._repr_html_().startswith("<iframe srcdoc=")
