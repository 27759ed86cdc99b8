"""The front door: a design, how it is watched and stopped, and what comes back."""

import json
import os
import signal
import threading
import time

import numpy as np
import pytest

import tencer
from conftest import QUICK


def test_a_design_has_arrays(design, trefoil):
    assert design.complete and design.stands and design.status == "complete"
    assert design.max_percent <= 5
    count = len(design.cables)
    assert design.tensions.shape == design.lengths.shape == (count,)
    assert (design.tensions > 0).all()
    assert np.array_equal(design.targets[0], trefoil.points)
    assert design.poses[0].shape == (40, 3) and design.closed == [True]
    assert sum(len(marks) for marks in design.marks) == 2 * count
    spans = design.cable_points[:, 1] - design.cable_points[:, 0]
    assert np.allclose(np.linalg.norm(spans, axis=1), design.lengths, rtol=1e-6)


def test_poses_are_views(design):
    assert np.shares_memory(design.poses[0], design.poses[0])
    with pytest.raises(ValueError, match="read-only"):
        design.poses[0][0, 0] = 1


def test_a_view_keeps_its_design():
    pose = tencer.design(family="circle", vertices=20, time=0.01).poses[0]
    assert np.isfinite(pose).all()


def test_words(design):
    assert "complete" in design.brief_report()
    assert "cables" in str(design)
    assert design.trace[0].keys() >= {"stage", "seconds", "cables", "max_percent"}
    first = design.trace[0]["snapshots"][-1]
    assert first["cable_points"].shape == (len(first["tensions"]), 2, 3)
    assert len(first["tensions"]) > len(design.cables)
    assert np.abs(first["rods"][0]).max() < 2 * np.abs(design.poses[0]).max()


def test_how_few_cables_could_do(design):
    needed = design.at_least
    assert needed == json.loads(design.to_json())["at_least"]
    assert 0 <= needed["cables"] <= len(design.cables)


def test_files(design, tmp_path):
    design.export(tmp_path / "knot.json")
    again = tencer.read_design(tmp_path / "knot.json")
    assert np.array_equal(again.poses[0], design.poses[0])
    assert json.loads(design.to_json())["schema"] == "tencer-design/2"
    (tmp_path / "pose.obj").write_text(design.pose_obj())
    assert np.array_equal(tencer.read_curves(tmp_path / "pose.obj")[0].points, design.poses[0])
    assert design.trace_csv().startswith("stage,")
    for ending, start in {"glb": b"glTF", "vtp": b"<", "dxf": b"", "obj": b"", "csv": b""}.items():
        design.export(tmp_path / f"knot.{ending}")
        content = (tmp_path / f"knot.{ending}").read_bytes()
        assert len(content) > 500 and content.startswith(start)
    with pytest.raises(ValueError, match="expected an ending among"):
        design.export(tmp_path / "knot.xyz")


def test_progress_is_told_in_the_calling_thread(trefoil):
    told = []
    tencer.design(
        trefoil,
        **QUICK,
        progress=lambda at: told.append((threading.get_ident(), at.stage, at.cables)),
    )
    assert told and {thread for thread, _, _ in told} == {threading.get_ident()}
    assert all(cables >= 0 for _, _, cables in told)


def test_progress_that_says_so_ends_the_search(trefoil):
    design = tencer.design(trefoil, max_error=2, effort=3, progress=lambda at: True)
    assert design.status == "interrupted" and not design.complete


def test_what_progress_raises_comes_out(trefoil):
    def fail(at):
        raise RuntimeError("enough of " + at.stage)

    with pytest.raises(RuntimeError, match="enough of"):
        tencer.design(trefoil, max_error=2, progress=fail)


def test_what_is_to_be_known_is_said(trefoil, caplog):
    caplog.set_level("INFO", logger="tencer")
    with pytest.warns(UserWarning, match="strain"):
        tencer.design(trefoil, **QUICK, section={"radius": 1.0}, time=0.1)
    assert "3-fold rotation" in caplog.text


def test_the_interpreter_is_free_meanwhile(trefoil):
    """Another thread counts while the search runs."""
    counted = 0
    over = threading.Event()

    def count():
        nonlocal counted
        while not over.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    try:
        tencer.design(trefoil, **QUICK, threads=1)
    finally:
        over.set()
        thread.join()
    assert counted > 20


def test_ctrl_c_gives_the_best_so_far(trefoil):
    """Sent once the search tells how far it is, so that there is something to give."""

    def interrupt(at):
        if not sent:
            sent.append(at)
            os.kill(os.getpid(), signal.SIGINT)

    sent = []
    design = tencer.design(trefoil, max_error=0.01, effort=3, progress=interrupt)
    assert sent and design.status == "interrupted"
    assert np.isfinite(design.poses[0]).all()


def test_ctrl_c_reaches_a_search_that_tells_nobody(trefoil):
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    try:
        design = tencer.design(trefoil, max_error=0.01, effort=3)
    finally:
        timer.join()
    assert design.status == "interrupted"


def test_a_trade_off(trefoil):
    designs = tencer.trade_off(trefoil, **QUICK, time=0.5)
    counts = [len(design.cables) for design in designs]
    errors = [design.max_percent for design in designs]
    assert counts == sorted(counts) and errors == sorted(errors, reverse=True)


def test_going_on_from_a_design(design, trefoil):
    count = len(design.cables)
    fewer = tencer.design(trefoil, **QUICK, edit={"from": design, "remove": 1})
    assert len(fewer.cables) <= count - 1


def test_scenes_are_complete(trefoil):
    scene = tencer.scene(trefoil)
    with pytest.raises(TypeError, match="a Scene is complete"):
        tencer.design(scene, max_error=1)


def test_a_check_tells_what_holds(design):
    check = design.check(draws=100)
    assert set(check) >= {"stands", "forgives", "holds"} and isinstance(check["fails"], list)
    assert "stands: " in str(check)
    assert len(check.design.cables) == len(design.cables)
    with pytest.raises(ValueError, match="max_deviation: expected"):
        design.check(max_deviation="far")


def test_it_comes_to_rest_where_it_should(design):
    rest = design.simulate()
    assert rest.stays and rest.moved_percent < 1e-3 and "converged" in rest.reason
    finer = design.simulate(start="target", refine=2)
    assert len(finer.design.poses[0]) == 2 * len(design.poses[0])
    with pytest.raises(ValueError, match="cables: expected one of inextensible, springs"):
        design.simulate(cables="ropes")


def test_its_structure_rests_in_its_pose(design):
    structure = design.structure
    assert len(structure.cables) == len(design.cables)
    rest = structure.solve(structure.pose(design.poses), inextensible=True)
    size = np.ptp(design.poses[0])
    assert rest.usable and abs(rest.positions[0] - design.poses[0]).max() < 1e-4 * size
    assert np.allclose(rest.tensions, design.tensions, rtol=1e-3)


def test_whether_it_can_be_held(trefoil):
    found = tencer.feasible(trefoil)
    assert found["verdict"] == "can" and str(found)


with_page = pytest.mark.skipif(
    not hasattr(tencer._core, "page"), reason="the module was built without the program"
)


@with_page
def test_pictures(design, tmp_path):
    for ending, start in {"svg": b"<?xml", "pdf": b"%PDF", "png": b"\x89PNG"}.items():
        design.export(tmp_path / f"knot.{ending}")
        assert (tmp_path / f"knot.{ending}").read_bytes().startswith(start)
    design.picture(tmp_path / "views.svg", views=["front", "top"], caption="A knot")
    assert (tmp_path / "views.svg").read_bytes() != (tmp_path / "knot.svg").read_bytes()
    with pytest.raises(ValueError, match="use front, side, top"):
        design.picture(tmp_path / "none.svg", views="frnt")
    with pytest.raises(ValueError, match="let the name end with"):
        design.picture(tmp_path / "none.jpg")
    assert not (tmp_path / "none.svg").exists()


@with_page
def test_the_page_in_the_notebook(design, tmp_path):
    design.export(tmp_path / "knot.html")
    page = (tmp_path / "knot.html").read_text()
    assert page.lstrip().lower().startswith("<!doctype html>") and "</html>" in page
    assert design._repr_html_().startswith("<iframe srcdoc=")


@with_page
def test_show_opens_the_page(design, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    path = design.show()
    assert opened == ["file://" + path] and os.path.getsize(path) > 10_000
