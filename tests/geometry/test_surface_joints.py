"""How patches meet, exactly: against surfaces whose joints are known by construction, however they are given.

Before, "C⁻¹ knot" was said of every knot of full multiplicity and nothing of any other one.
"""

import json

import pytest
from gmpy2 import mpq

from exactspline import NurbsSurface, analyse, example, write
from exactspline.splines.surface import Along
from tests.support.command import invoke

#: The dial: what coordinates are multiplied by and moved by.
DIAL = {
    "small integers": (mpq(1), mpq(0)),
    "thirds": (mpq(7, 3), mpq(-5, 3)),
    "ten decimals": (mpq(12345678901, 10**10), mpq(9876543211, 10**10)),
    "doubles": (mpq(0.1234567890123456789), mpq(2.718281828459045)),
    "huge": (mpq(1e300), mpq(0)),
    "tiny": (mpq(1e-300), mpq(1)),
}
KNOTS = [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2]


def dialled(surface, setting):
    factor, shift = DIAL[setting]
    rows = [[factor * (i == k) for k in range(3)] + [shift] for i in range(3)]
    return surface.transform(rows)


def sheets(first, second):
    """Two patches side by side, (u, v, z) for u from 0 to 2, by the cubic ordinates of z, plus v²; knots at 1."""
    rows = [(mpq(i, 3), z) for i, z in enumerate(first)] + [(1 + mpq(i, 3), z) for i, z in enumerate(second)]
    net = [[(x, y, mpq(z) + w) for y, w in ((0, 0), (mpq(1, 2), 0), (1, 1))] for x, z in rows]
    return NurbsSurface((3, 2), KNOTS, [0, 0, 0, 1, 1, 1], net)


#: z by u on both sides: (u − 1)² and so on.
KNOWN = {
    "torn": ([1, 1, 1, 0], [1, 0, 0, 0]),
    "crease": ([1, mpq(2, 3), mpq(1, 3), 0], [0, mpq(1, 3), mpq(2, 3), 1]),
    "jump of the curvature": ([1, mpq(1, 3), 0, 0], [0, 0, mpq(2, 3), 2]),
    "continuous curvature": ([1, mpq(1, 3), 0, 0], [0, 0, mpq(1, 3), 1]),
}


@pytest.mark.parametrize("setting", DIAL)
@pytest.mark.parametrize("kind", KNOWN)
def test_joints_that_are_known(kind, setting):
    """Passed before: a crease is no crease, and what is smooth is a "C⁻¹ knot" if its multiplicity is full."""
    surface = dialled(sheets(*KNOWN[kind]), setting)
    for one, across in ((surface, Along.U), (surface.transposed(), Along.V)):
        (joint,) = analyse(one).joints
        assert (joint.across, joint.value, joint.kind, joint.at_seam) == (across, 1, kind, False)


def test_the_parametrization_does_not_matter():
    """The right side three times as fast, and sheared along the knot line: G1 and G2 are of the surface.

    Passed before: nothing was said of either.
    """
    # z = u² + v² over [-1, 0] and over [0, 3], one parameter for each; and (u, v + u) instead of (u, v) on the right
    for stretch, shear, bend, kind in (
        (3, 0, 1, "continuous curvature"),
        (3, 2, 1, "continuous curvature"),
        (1, 2, 1, "continuous curvature"),
        (3, 2, 2, "jump of the curvature"),
    ):
        left = [[_bowl(i, j, 1, 0, 1) for j in range(3)] for i in range(3)]
        right = [[_bowl(i, j, stretch, shear, bend, behind=True) for j in range(3)] for i in range(3)]
        surface = NurbsSurface((2, 2), [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 0, 1, 1, 1], left + right)
        (joint,) = analyse(surface).joints
        assert joint.kind == kind


def _bowl(i, j, stretch, shear, bend, *, behind=False):
    """Bézier point i, j of (x, y, bend x² + y²): x is stretch u, before the knot u − 1, and y is v + shear u."""
    us = [1] * i + [0] * (2 - i)
    vs = [1] * j + [0] * (2 - j)
    xs = [stretch * u for u in us] if behind else [u - 1 for u in us]
    ys = [[v + (shear * u if behind else 0) for v in vs] for u in us]
    square_y = mpq(ys[0][0] * ys[1][1] + ys[0][1] * ys[1][0], 2)
    return mpq(sum(xs), 2), mpq(sum(ys[0]) + sum(ys[1]), 4), bend * mpq(xs[0] * xs[1]) + square_y


def squares(second):
    return NurbsSurface((1, 1), [0, 0, 1, 2, 2], [0, 0, 1, 1], [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)], second])


def test_two_squares_at_a_right_angle():
    """Passed before: a folded sheet of paper is "planar, K = H = 0" and nothing else."""
    bent = analyse(squares([(1, 0, 1), (1, 1, 1)]))
    (joint,) = bent.joints
    assert (joint.kind, joint.order, joint.angle.cosine) == ("crease", 0, 0)
    assert bent.kinds == ("planar",)
    (joint,) = analyse(squares([(2, 0, 0), (2, 1, 0)])).joints
    assert joint.order == 2
    # the second square lies on the first one
    (joint,) = analyse(squares([(mpq(1, 2), 0, 0), (mpq(1, 2), 1, 0)])).joints
    assert (joint.kind, joint.order) == ("fold", 0)
    # the second one is twisted: the angle is another one at each point
    (joint,) = analyse(squares([(2, 0, 0), (2, 1, 1)])).joints
    assert (joint.kind, joint.angle) == ("crease", None)
    # a side without tangent planes, behind and before
    thin = squares([(1, 5, 0), (1, 6, 0)])
    for one in (thin, NurbsSurface(thin.degree, *thin.knots, thin.control_points[::-1])):
        (joint,) = analyse(one).joints
        assert (joint.kind, joint.order) == ("no tangent plane", None)


@pytest.mark.parametrize("name", ["sphere", "torus", "cylinder", "ellipsoid", "cyclide"])
def test_closed_examples_are_smooth_at_knots_and_seams(name):
    """Rational arcs with double knots are of continuous curvature; passed before: nothing was said."""
    found = analyse(example(name))
    assert found.joints
    assert {joint.order for joint in found.joints} == {2}
    assert {joint.across for joint in found.joints if joint.at_seam} == set(found.closed)
    places = [(joint.across.direction, joint.value, joint.interval) for joint in found.joints]
    assert places == sorted(places)
    assert all(
        joint.value == found.surface.domain[joint.across.direction][0] for joint in found.joints if joint.at_seam
    )


def test_a_seam_may_be_a_crease():
    """A closed tube over a drop: one of its corners is at the seam; passed before: nothing was said of it."""
    drop = [(0, 0), (2, 2), (2, -2), (0, 0)]
    net = [[(x, y, z) for z in (0, 1)] for x, y in drop]
    tube = NurbsSurface((2, 1), [0, 0, 0, 1, 2, 2, 2], [0, 0, 1, 1], net)
    joints = analyse(tube).joints
    assert [(joint.at_seam, joint.value, joint.order) for joint in joints] == [(True, 0, 0), (False, 1, 2)]
    assert joints[0].angle.cosine == 0


def test_edges_of_different_kinds_are_reported_one_by_one():
    """A knot line that is a crease on one patch only: its two intervals; passed before: nothing was said of it."""
    flat, up = [(x, y, 0) for x in (0,) for y in range(3)], [(2, 0, 0), (2, 1, 0), (2, 2, 1)]
    net = [[(0, y, 0) for y in range(3)], [(1, y, 0) for y in range(3)], up]
    assert flat == net[0]
    found = analyse(NurbsSurface((1, 1), [0, 0, 1, 2, 2], [0, 0, 1, 2, 2], net))
    told = [(one.across, one.interval, one.order) for one in found.joints if one.across is Along.U]
    assert told == [(Along.U, (0, 1), 2), (Along.U, (1, 2), 0)]


def test_the_command_reports_them(tmp_path):
    """In the table and in JSON; passed before: "the sides fit together" of a right angle."""
    path = tmp_path / "bent.json"
    write(squares([(1, 0, 1), (1, 1, 1)]), path)
    result = invoke("inspect", str(path))
    assert result.exit_code == 0
    assert "crease" in result.stdout
    assert "turns by 90°" in result.stdout
    (row,) = json.loads(invoke("inspect", str(path), "--json").stdout)["rows"]
    (joint,) = row["joints"]
    angle = {name: told["exact"] for name, told in joint.pop("angle").items()}
    assert angle == {"cosine": "0", "sine": "1", "degrees": "90"}
    assert joint == {
        "across": "u",
        "value": "1",
        "interval": ["0", "1"],
        "at_seam": False,
        "kind": "crease",
        "geometric_continuity": 0,
    }


@pytest.mark.parametrize("axes", [(0, 1, 2), (1, 2, 0), (2, 0, 1)])
@pytest.mark.parametrize("factor", [1, mpq(5, 7)])
@pytest.mark.parametrize(("x", "cosine"), [(3, mpq(3, 5)), (-3, mpq(-3, 5)), (0, 0)])
def test_the_angle_of_a_crease_is_that_of_the_normals(x, cosine, factor, axes):
    """Normals of any lengths, edges along any axis; passed by mutants: no angle but a right one is the same everywhere,
    and what is a crease along one axis is none along another.
    """
    turned = [[int(axes[i] == k) for k in range(3)] + [0] for i in range(3)]
    # the second side grows along the edge: its normals have other lengths at each point, and one direction
    even, growing = [(1 + x * factor, v, 4 * factor) for v in (0, 1)], [(1 + x, 0, 4), (1 + 2 * x, 1, 8)]
    surfaces = [squares(second).transform(turned) for second in (even, growing)]
    surfaces += [NurbsSurface(one.degree, *one.knots, one.control_points[::-1]) for one in surfaces]
    for surface in surfaces:
        (joint,) = analyse(surface).joints
        assert joint.kind == "crease"
        assert joint.angle.cosine == cosine


def turning_back(second, *, behind):
    """The side before, or that behind, turns back half way along the edge: the normal there is (1 − 2v) times one
    vector.
    """
    net = [[(0, 0, 0), (2, 1, 0)], [(1, 0, 0), (1, 1, 0)], second]
    surface = NurbsSurface((1, 1), [0, 0, 1, 2, 2], [0, 0, 1, 1], net[::-1] if behind else net)
    (joint,) = analyse(surface).joints
    return joint.kind, joint.order, joint.angle


@pytest.mark.parametrize("behind", [False, True])
def test_a_side_that_turns_back_half_way(behind):
    """A fold on a part of the edge, and an angle that is not the same everywhere though its cosine squared is."""
    assert turning_back([(2, 0, 0), (2, 1, 0)], behind=behind) == ("fold", 0, None)
    assert turning_back([(4, 0, 4), (4, 1, 4)], behind=behind) == ("crease", 0, None)


@pytest.mark.parametrize("behind", [False, True])
def test_a_normal_may_vanish_in_the_middle_of_a_crease(behind):
    """One side is (1 − 2v)² times as wide: there is no normal at v = 1/2, and the same angle at all other points."""
    rows = [[(x, mpq(j, 2), 0) for j in range(3)] for x in (0, 1)]
    net = [*rows, [(1 + 3 * c, mpq(j, 2), 4 * c) for j, c in enumerate((1, -1, 1))]]
    surface = NurbsSurface((1, 2), [0, 0, 1, 2, 2], [0, 0, 0, 1, 1, 1], net[::-1] if behind else net)
    (joint,) = analyse(surface).joints
    assert (joint.kind, joint.angle.cosine) == ("crease", mpq(3, 5))


def test_neighbouring_edges_that_are_alike_are_one():
    """Three by three patches of a roof: one crease and smooth lines, each from end to end."""
    net = [[(x, y, z) for y in range(4)] for x, z in ((0, 0), (1, 0), (2, 1), (3, 2))]
    told = analyse(NurbsSurface((1, 1), [0, 0, 1, 2, 3, 3], [0, 0, 1, 2, 3, 3], net)).joints
    assert [(one.across, one.value, one.interval, one.order) for one in told] == [
        (Along.U, 1, (0, 3), 0),
        (Along.U, 2, (0, 3), 2),
        (Along.V, 1, (0, 3), 2),
        (Along.V, 2, (0, 3), 2),
    ]


@pytest.mark.parametrize("factor", [3, mpq(1, 7)])
@pytest.mark.parametrize("kind", KNOWN)
def test_weights_times_a_number_are_the_same_surface(kind, factor):
    """On one side only, where the knot has full multiplicity: nothing changes but the representation."""
    plain = sheets(*KNOWN[kind])
    weights = [[1] * 3] * 4 + [[factor] * 3] * 4
    surface = NurbsSurface((3, 2), KNOTS, [0, 0, 0, 1, 1, 1], plain.control_points, weights)
    (joint,) = analyse(surface).joints
    assert (joint.value, joint.kind) == (1, kind)
