"""Closed chains against their oracle: joints, corners, straight and circular pieces, wherever the seam is."""

from collections import Counter
from random import Random

import mpmath
import pytest
from gmpy2 import mpq

from exactspline import Nurbs, analyse, read
from tests.geometry.test_shared_curves import FILES
from tests.support.answers import places
from tests.support.chains import EQUAL, as_curve, closed_chain, curvature_at, cut_and_rotated, expected_pieces, meeting
from tests.support.space_curves import TURNED


def check_chain(chain, curve):
    """Everything that the oracle knows of a closed chain is what the analysis says."""
    found, breaks, count = analyse(curve), curve.breakpoints, len(chain)
    assert found.closed
    assert len(found.joints) == count == len(breaks) - 1
    meetings = [meeting(chain[i - 1], chain[i]) for i in range(count)]
    for joint, expected, piece, before in zip(found.joints, meetings, chain, [chain[-1], *chain], strict=False):
        assert joint.order == expected.order
        assert (joint.angle is None) == (expected.order > 0)
        assert (joint.kind == "corner") == (expected.order == 0)
        assert (joint.kind == "jump of the curvature") == (expected.order == 1)
        if joint.angle is not None:
            with mpmath.workdps(50):
                difference = joint.angle.degrees(45) - expected.degrees
                assert min(abs(difference), abs(abs(difference) - 360)) < EQUAL
        if joint.curvatures is not None:
            with mpmath.workdps(50):
                sides = -curvature_at(before.reversed), curvature_at(piece)
                assert all(
                    abs(x.significant(45) - true) < EQUAL for x, true in zip(joint.curvatures, sides, strict=True)
                )
    orders = [m.order for m in meetings]
    straight = [piece.kind == "line" for piece in chain]
    circular = [piece.kind in ("line", "arc") for piece in chain]
    assert as_sets(found.straight_pieces) == expected_pieces(breaks, straight, [order >= 1 for order in orders])
    assert as_sets(found.constant_pieces) == expected_pieces(breaks, circular, [order >= 2 for order in orders])
    assert not found.standing_pieces
    assert not found.singular_points
    for piece in (*found.straight_pieces, *found.constant_pieces):
        assert all(breaks[0] <= a < b <= breaks[-1] for a, b in piece.parts)


def as_sets(pieces):
    return [piece.parts for piece in pieces]


def kinds(curve):
    """How many features of each kind a curve has: whatever its knots and its seam."""
    named = [Counter(f.kind for f in found) for found in places(curve).values()]
    return *named, Counter(joint.order for joint in analyse(curve).joints if joint.order < 3)


def check_seed(seed):
    random = Random(seed)
    chain = closed_chain(random)
    curve = as_curve(random, chain)
    check_chain(chain, curve)
    turned = cut_and_rotated(random, chain)
    other = as_curve(random, turned)
    check_chain(turned, other)
    assert kinds(curve) == kinds(other)
    return turned


@pytest.mark.parametrize("block", range(6))
def test_closed_chains_in_the_plane(block):
    for seed in range(10 * block, 10 * block + 10):
        check_seed(seed)


def test_the_chains_have_joints_of_every_order_and_pieces_across_the_seam():
    orders, across = Counter(), 0
    for seed in range(100):
        random = Random(seed)
        curve = as_curve(random, cut_and_rotated(random, closed_chain(random)))
        orders += Counter(joint.order for joint in analyse(curve).joints)
        across += sum(piece.across_seam for piece in (*analyse(curve).straight_pieces, *analyse(curve).constant_pieces))
    assert min(orders[order] for order in range(4)) >= 5
    assert across >= 20


def tilted(point):
    """A plane point in a plane of space, three times as large."""
    return tuple(row[0] * point[0] + row[1] * point[1] for row in TURNED)


@pytest.mark.parametrize("seed", range(20))
def test_closed_chains_in_a_plane_of_space(seed):
    random = Random(seed)
    turned = cut_and_rotated(random, closed_chain(random))
    plane, space = as_curve(Random(seed), turned), as_curve(Random(seed), turned, tilted)
    a, b = analyse(plane), analyse(space)
    for flat, joint in zip(a.joints, b.joints, strict=True):
        assert (flat.parameter, flat.order) == (joint.parameter, joint.order)
        if flat.angle is not None:
            assert flat.angle.cosine == joint.angle.cosine
    assert a.straight_pieces == b.straight_pieces
    lines = all(piece.kind == "line" for piece in turned)
    assert [p.parts for p, _ in b.planar_pieces] == ([] if lines else [(plane.domain,)])
    assert b.torsion_zeros.points == ()


def test_a_circle_with_one_corner_is_one_piece_round_the_seam():
    """A line there and back with a smooth seam: it turns round at its two ends."""
    found = analyse(Nurbs(1, [0, 0, 1, 2, 3, 3], [(1, 0), (3, 0), (0, 0), (1, 0)]))
    assert [str(piece) for piece in found.straight_pieces] == ["[1, 2]", "[2, 3] ∪ [0, 1]"]
    assert [joint.angle.degrees(5) for joint in found.corners] == [180, 180]


def test_planar_pieces_go_on_across_the_seam():
    points = [(1, 0, 0), (2, 0, 0), (2, 1, 0), (2, 1, 3), (0, 0, 1), (0, 1, 0), (1, 0, 0)]
    start = Nurbs(1, [0, 0, 1, 2, 3, 4, 5, 6, 6], points)
    pieces = [(str(piece), str(plane)) for piece, plane in analyse(start).planar_pieces]
    assert ("[5, 6] ∪ [0, 2]", "z = 0") in pieces
    for piece, plane in analyse(start).planar_pieces:
        for a, b in piece.parts:
            for t in (a, (a + b) / 2, b):
                side = "left" if t == b else "right"
                assert sum(n * x for n, x in zip(plane.normal, start(t, side), strict=True)) == plane.offset


@pytest.mark.parametrize("file", FILES, ids=lambda f: f.stem)
def test_nothing_that_is_told_of_a_real_curve_is_outside_its_domain(file):
    curve = read(file).curve
    if curve.dimension > 3:
        return
    (a, b), found = curve.domain, analyse(curve)
    pieces = [
        *found.straight_pieces,
        *found.constant_pieces,
        *found.standing_pieces,
        *[piece for piece, _ in found.planar_pieces],
    ]
    assert all(a <= low < high <= b for piece in pieces for low, high in piece.parts)
    bad = {joint.parameter for joint in found.joints if joint.kind != "continuous curvature"}
    for piece in (*found.straight_pieces, *found.constant_pieces):
        assert not any(low < t < high for low, high in piece.parts for t in bad) or curve.dimension == 3
        assert not piece.across_seam or (curve.closed and a not in bad)
    for piece in found.straight_pieces:
        for low, high in piece.parts:
            points = [curve(low + (high - low) * mpq(k, 7), "left" if k == 7 else "right") for k in range(8)]
            rows = [[y - x for x, y in zip(points[0], p, strict=True)] for p in points[1:]]
            assert all(u[i] * v[j] == u[j] * v[i] for u in rows for v in rows for i in range(len(u)) for j in range(i))
