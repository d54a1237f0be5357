"""How two surfaces meet along common borders: what is shown, and a sample of the campaign."""

import json

import pytest

from exactspline import NurbsSurface, ask, example, write
from exactspline.errors import ShapeError
from exactspline.geometry.surfaces import joints
from tests.campaigns.common_borders import FAMILIES, differs
from tests.support.command import run
from tests.support.dials import ALWAYS

UNIT = [0, 0, 1, 1]
FLAT = NurbsSurface((1, 1), UNIT, UNIT, [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
#: Runs along the border of the other one the other way, and lies in its plane at the middle alone.
TWISTED = NurbsSurface((1, 1), UNIT, UNIT, [[(1, 1, 0), (1, 0, 0)], [(2, 1, 1), (2, 0, -1)]])


def shown(*surfaces):
    """What is reported, as text."""
    return [str(found) for found in ask(surfaces, "common_borders")]


def test_a_crease_has_one_tangent_plane_at_a_point():
    arc, point = ask((FLAT, TWISTED), "common_borders")
    assert str(arc) == "<crease: first from 0, first to 1, second from 1, second to 0>"
    assert arc.facts == {"first border": "u = 1", "second border": "u = 0", "order": 0}
    assert str(point) == "<one tangent plane: first 1/2, second 1/2>"


def test_the_angle_of_a_crease_where_it_is_constant():
    upright = NurbsSurface((1, 1), UNIT, UNIT, [[(1, 0, 0), (1, 1, 0)], [(1, 0, 1), (1, 1, 1)]])
    (arc,) = ask((FLAT, upright), "common_borders")
    assert arc.values["angle"] == 90
    assert arc.what == "crease"


def test_a_part_of_a_border_is_common():
    """Of a patch twice as wide, the half beside the other one; the other half is none."""
    wide = NurbsSurface((1, 1), UNIT, [0, 0, 2, 2], [[(1, -1, 0), (1, 1, 0)], [(3, -1, 0), (3, 1, 0)]])
    assert shown(FLAT, wide) == ["<continuous curvature: first from 0, first to 1, second from 1, second to 2>"]


def test_the_same_side_is_a_fold():
    back = NurbsSurface((1, 1), UNIT, UNIT, [[(1, 0, 0), (1, 1, 0)], [("1/2", 0, 0), ("1/2", 1, 0)]])
    assert shown(FLAT, back)[0] == "<fold: first from 0, first to 1, second from 0, second to 1>"


def test_knots_and_weights_do_not_matter():
    """A torus cut in two has two common borders over four segments, each one arc."""
    first, second = example("torus").split("v", 1)
    arcs = ask((first, second.insert_knot("u", "1/3").elevate_degree(1, 1)), "common_borders")
    assert [arc.facts["order"] for arc in arcs] == [2, 2]
    assert all([float(x) for x in arc.values.values()] == [0, 4, 0, 4] for arc in arcs)


def test_other_parameters_are_said_to_be_such():
    """The same border, its parameter a quotient of linear functions of the other one."""
    points = [[(1, 0, 0), (1, 1, 0)], [(2, 0, 0), (2, 1, 0)]]
    weighted = NurbsSurface((1, 1), UNIT, UNIT, points, [[1, 2], [1, 2]])
    (arc,) = ask((FLAT, weighted), "common_borders")
    assert (arc.what, arc.facts["order"]) == ("common arc", "unknown")


def test_points_have_no_arcs():
    """Both poles of two halves of a sphere, and points without a tangent plane at the ends of the cut."""
    found = ask(example("sphere").split("u", 1), "common_borders")
    assert [x.what for x in found] == ["continuous curvature", "no tangent plane", "no tangent plane"] * 2


def test_surfaces_with_nothing_in_common_and_maps_of_the_plane():
    assert ask((FLAT, example("torus")), "common_borders") == ()
    with pytest.raises(ShapeError):
        ask((FLAT, example("planar_map")), "common_borders")


def test_by_the_command(tmp_path):
    names = [str(tmp_path / name) for name in ("first.json", "second.json")]
    for surface, name in zip((FLAT, TWISTED), names, strict=True):
        write(surface, name)
    found = json.loads(run("between", *names, "--json").stdout)["rows"][0]
    assert found["question"] == "common_borders"
    assert [row["what"] for row in found["answer"]] == ["crease", "one tangent plane"]
    for options in (["--plot", "x.svg"], ["--ask", "distance"], ["--epsilon", "1"]):
        assert run("between", *names, *options).returncode == 2
    assert run("between", names[0], "circle").returncode == 2


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("dial", ALWAYS)
def test_against_fractions(family, dial):
    assert not differs(family, dial, 1)


@pytest.mark.parametrize(("proof", "family", "seed"), [("_keeps_positive", "folded", 0), ("_fit", "bent", 6)])
def test_the_oracle_finds_what_is_wrong(monkeypatch, proof, family, seed):
    """A fold is taken for a smooth joint, and other parameters for the same."""
    monkeypatch.setattr(joints, proof, lambda *given: True)
    assert differs(family, "small integers", seed)
