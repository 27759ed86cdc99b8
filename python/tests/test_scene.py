"""Targets and the keys of scenes: the reader of scene files is the one that judges them."""

import numpy as np
import pytest

import tencer
from conftest import trefoil_points


def test_a_curve_is_a_view_of_its_points():
    points = trefoil_points()
    curve = tencer.Curve(points, closed=True)
    assert curve.closed and len(curve) == 40
    assert np.array_equal(curve.points, points)
    assert not curve.points.flags.owndata and not curve.points.flags.writeable
    assert np.shares_memory(curve.points, curve.points)


def test_points_that_come_back_close_the_curve():
    points = trefoil_points()
    curve = tencer.Curve(np.vstack([points, points[:1]]))
    assert curve.closed and len(curve) == 40


def test_arrays_of_other_kinds_are_taken():
    points = trefoil_points()
    assert np.array_equal(tencer.Curve(points.astype(np.float32)).points, points.astype(np.float32))
    assert np.array_equal(tencer.Curve(np.asfortranarray(points)).points, points)
    assert np.array_equal(tencer.Curve(points.tolist()).points, points)


@pytest.mark.parametrize(
    "points, words",
    [
        (np.zeros((4, 2)), r"points: expected an array of shape \(n, 3\), found one of \(4, 2\)"),
        ([[0, 0, 0], [1, np.nan, 0]], r"points\[1\]: nan is not a finite number"),
        ([[0, 0, 0]], "a curve needs at least 2 points, found 1"),
        ([[0, 0, 0], [2, 0, 0], [1, 0, 0]], "turns straight back at points"),
    ],
)
def test_bad_points_are_refused(points, words):
    with pytest.raises(ValueError, match=words):
        tencer.Curve(points)


def test_families():
    assert tencer.families()["circle"] == {"radius": 25}
    rings = tencer.curves_of_family("borromean-ellipses", vertices=50)
    assert len(rings) == 3 and all(len(ring) == 50 and ring.closed for ring in rings)


def test_files(tmp_path, trefoil):
    path = tmp_path / "knot.csv"
    path.write_text("x,y,z\n" + "\n".join(",".join(map(repr, p)) for p in trefoil.points.tolist()))
    (curve,) = tencer.read_curves(path)
    assert np.array_equal(curve.points, trefoil.points)
    with pytest.raises(tencer.Error, match="none.obj") as bad:
        tencer.read_curves(tmp_path / "none.obj")
    assert str(bad.value) == f"{bad.value.where}: {bad.value.message}"


def test_keys_of_every_level(trefoil):
    scene = tencer.scene(
        trefoil,
        name="knot",
        length_unit="mm",
        anchors=np.array([[40, 0, 0], [-40, 0, 0]]),
        section={"radius": 0.5},
        material="ash",
        max_error=0.5,
        build={"length_error": 0.1},
    )
    assert (scene.name, scene.length_unit) == ("knot", "mm")
    assert "circle r 0.5 mm, ash" in str(scene)


def test_rods_of_their_own(trefoil):
    scene = tencer.scene(
        rod=[
            {"curve": trefoil, "section": {"radius": 0.2}},
            {"family": "circle", "parameters": {"radius": 40}, "vertices": 30},
        ],
        section={"radius": 0.1},
    )
    knot, ring = scene.curves
    assert np.array_equal(knot.points, trefoil.points) and len(ring) == 30
    assert "2 closed rods" in str(scene)


def test_a_curve_at_rest_beside_the_target():
    t = np.linspace(0, np.pi, 30)
    arch = np.stack([10 * np.cos(t), 10 * np.sin(t), 0 * t], axis=1)
    tencer.scene(arch, section={"EA": 1e5, "EI": 300, "GJ": 200}, rest={"curve": arch})
    with pytest.raises(tencer.Error, match=r"rod\[0\].rest: the curve at rest is"):
        tencer.scene(arch, section={"EA": 1e5, "EI": 300, "GJ": 200}, rest={"curve": 2 * arch})


@pytest.mark.parametrize(
    "keys, words",
    [
        ({"max_error": -1}, "design.max_error: expected a positive number, found -1"),
        ({"max_error": float("nan")}, "design.max_error: expected a finite number"),
        ({"max_eror": 1}, "unknown key max_eror; did you mean max_error?"),
        ({"method": "magic"}, "design.method: expected one of force-balance, dense-springs"),
        ({"build": {"length_eror": 1}}, "unknown key build.length_eror; did you mean length_error?"),
        ({"section": {"radius": 0}}, r"rod\[0\].section.radius: expected a positive number, found 0"),
        ({"anchors": [[0, 0]]}, r"anchors\[0\]: expected a point \[x, y, z\]"),
        ({"threads": 1.5}, "design.threads: expected a whole number"),
    ],
)
def test_wrong_keys_are_named_as_in_files(trefoil, keys, words):
    with pytest.raises(tencer.Error, match=words) as bad:
        tencer.scene(trefoil, **keys)
    assert bad.value.where == ""


def test_keys_in_place_of_a_files(tmp_path, trefoil):
    path = tmp_path / "scene.toml"
    path.write_text(
        '[[rod]]\nfamily = "circle"\nsection = {radius = 0.2}\n[design]\ncables = 4\nmax_error = 3\n'
    )
    assert "circle r 2 mm" in str(tencer.scene(path))
    assert "circle r 1 mm" in str(tencer.scene(path, section={"radius": 0.1}))
    path.write_text(path.read_text().replace("cables = 4", "cables = 0"))
    with pytest.raises(tencer.Error, match="scene.toml:5: design.cables: expected") as bad:
        tencer.scene(path, time=1)
    assert bad.value.where == f"{path}:5"
    tencer.scene(path, cables=3)  # takes the place of what is wrong


def test_what_is_no_value_of_a_scene(trefoil):
    with pytest.raises(TypeError, match="max_error: a scene has no value of type object"):
        tencer.scene(trefoil, max_error=object())
    with pytest.raises(TypeError, match="rod: give the curves, or rod"):
        tencer.scene(trefoil, rod=[{"family": "circle"}])
