"""What is proved of a surface is so at every point, and what is not proved is named: families where a form vanishes at
corners, on borders, at knots, on lines, with even multiplicity, at irrational points, at every dial.

Each docstring says which false statement passed before.
"""

import signal
from collections import Counter
from contextlib import contextmanager
from fractions import Fraction
from random import Random
from time import process_time

import pytest
from gmpy2 import mpq

from exactspline import ExactSplineError, NurbsSurface, analyse, example, write
from exactspline.bivariate import singular_points
from exactspline.bivariate.common_zeros import Found, zeros_of
from exactspline.bivariate.signs import sign_on_patch
from exactspline.bivariate.zero_curve import ZeroCurve
from exactspline.display.answer_forms import surface_inspection_data
from exactspline.display.surface_data import map_sheet, surface_sheet
from exactspline.errors import FormulaError
from exactspline.polynomials.patch_forms import PatchForm
from exactspline.polynomials.two_parameters import S, T, as_form
from tests.campaigns.surfaces import is_good, run
from tests.support.command import invoke
from tests.support.dials import factors, over_dials
from tests.support.squares import graph, parameters
from tests.support.surface_oracle import gaussian_curvature


@contextmanager
def seconds(n):
    """An error if it takes longer."""

    def stop(*_):
        raise TimeoutError(f"longer than {n} s")

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(n)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def is_complete(found, factor):
    """Whether all is decided; of surfaces 10³⁰⁰ times as high as wide, or as low, whether all but umbilics is."""
    if mpq(1, 10**9) < abs(factor) < 10**9:
        return found.complete
    return all(one.open_boxes == one.umbilics.undecided for one in found.patches)


# ---- signs


def test_a_form_that_vanishes_at_all_corners_has_the_sign_of_its_inside():
    """Passed before: "negative except at single zeros" of a form that is positive inside."""
    net = [[0, 1, 0], [1, 1, 1], [0, 1, 0]]
    for factor, sign in ((1, "positive except at single zeros"), (-1, "negative except at single zeros")):
        found = sign_on_patch(PatchForm.of_net([[factor * x for x in row] for row in net]))
        assert (found.sign, len(found.zeros)) == (sign, 4)
        assert (found.positive is None) == (factor < 0)
        assert (found.negative is None) == (factor > 0)


@pytest.mark.parametrize(
    "p",
    [
        S * (1 - S) + T * (1 - T),
        S * (1 - S) * T * (1 - T) + S * (1 - S) + T * (1 - T),
        (2 * S - 1) ** 2 + (3 * T - 1) ** 2,
        (2 * S**2 - 1) ** 2 + (3 * T - 1) ** 2,
        (S**2 + T**2 - 1) ** 2,
        (3 * S - 1) ** 2,
        (2 * S**2 - 1) ** 2 * (T + 1),
    ],
)
def test_signs_are_those_of_values(p):
    """A sign is never the opposite of a value; passed before: the first two were negative."""
    for factor in (1, -1):
        form = as_form(p * factor)
        found = sign_on_patch(form)
        assert found.sign not in (
            "both signs",
            "positive except at single zeros" if factor < 0 else "negative except at single zeros",
        )
        for place, sign in ((found.positive, 1), (found.negative, -1)):
            assert place is None or form.value(*place) * sign > 0
        assert (found.positive or found.negative) is not None


@over_dials
def test_a_surface_that_is_flat_at_its_corners_alone(number):
    """z = a(x) + a(y) + (x − x²)²(y − y²)²/16 with a″ = x − x²: K > 0 but at the corners.

    Passed before: "hyperbolic except at parabolic points, K ≤ 0", complete.
    """

    def height(u, v):
        a = [t * t * t * mpq(1, 6) - t * t * t * t * mpq(1, 12) for t in (u, v)]
        bump = [(t - t * t) * (t - t * t) for t in (u, v)]
        return (a[0] + a[1] + bump[0] * bump[1] * mpq(1, 16)) * factor

    (factor,) = factors(number, Random(1), 1)
    found = analyse(graph(height))
    assert (found.kinds, is_complete(found, factor)) == (("elliptic except at parabolic points",), True)
    assert {place.exact for place in found.parabolic_points} == {(0, 0), (0, 1), (1, 0), (1, 1)}


@over_dials
@pytest.mark.parametrize(
    ("height", "kind", "lines"),
    [
        (lambda u, v: u * u * u * u + v * v, "elliptic", [0]),
        (
            lambda u, v: (u * 2 - 1) * (u * 2 - 1) * (u * 2 - 1) * (u * 2 - 1) + v * v,
            "elliptic except at parabolic points",
            [mpq(1, 2)],
        ),
        (lambda u, v: u * u * u * u * u * u - u * u * u * u * mpq(5, 4) + v * v, "elliptic and hyperbolic", [0, None]),
        (lambda u, v: (u * 3 - 1) * (u * 3 - 1) * (u * 3 - 1) + v * v, "elliptic and hyperbolic", [mpq(1, 3)]),
    ],
)
def test_lines_of_zeros_on_borders_and_inside(height, kind, lines, number):
    """K vanishes on a border, on a line inside, with even multiplicity, at an irrational value.

    Passed before: the line inside was a "parabolic curve", with a knot there a "parabolic line".
    """
    (factor,) = factors(number, Random(1), 1)
    found = analyse(graph(lambda u, v: height(u, v) * factor))
    assert (found.kinds, is_complete(found, factor), found.parabolic_curves) == ((kind,), True, ())
    assert [getattr(line.value, "exact", line.value) for line in found.parabolic_lines] == lines
    for line in found.parabolic_lines:
        if isinstance(line.value, type(mpq(0))) and 0 < line.value < 1:
            cut = analyse(found.surface.insert_knot("u", line.value))
            assert [(one.along, one.value, one.interval) for one in cut.parabolic_lines][-1] == (
                line.along,
                line.value,
                line.interval,
            )


def test_a_map_that_is_folded_between_patches():
    """det ≥ 0 on one patch, zero at its corners alone, and det < 0 on the other one.

    Passed before: "det has zeros", and one point with det < 0 and det = 0.
    """
    u, v = parameters()
    # x_u y_v − x_v y_u = (u − u²) + (v − v²)
    x = u * u * mpq(1, 2) - u * u * u * mpq(1, 3) + u * (v - v * v)
    first = NurbsSurface.from_splines([x, v])
    assert analyse(first).kind == "det has zeros"
    assert analyse(first).positive is not None
    assert analyse(first).negative is None
    rows = [list(row) for row in first.elevate_degree(3 - first.degree[0], 0).control_points]
    folded = [[(x - mpq(k, 3), y) for x, y in rows[-1]] for k in range(4)]
    n = first.degree[1]
    knots = [[0] * 4 + [1] * 4 + [2] * 4, [0] * (n + 1) + [1] * (n + 1)]
    found = analyse(NurbsSurface((3, n), *knots, rows + folded))
    assert found.kind == "folded: det has both signs"
    assert found.positive not in [place.exact for place in found.zeros]
    assert found.negative not in [place.exact for place in found.zeros]
    assert "det = 0 as seen from patch 0, 0" in map_sheet(found).text()


# ---- zeros that were hidden, and those that did not end


P = [(34, 29), (2464, 241), (-990, 1143), (963, 631)]
Q = [(218, 97), (891, 2007), (586, -1156), (608, 908)]


def _bernstein(points, t, k):
    weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3)
    return sum(w * point[k] for w, point in zip(weights, points, strict=True))


def test_refinement_comes_to_an_end():
    """The common points of two cubics.

    Passed before: isolation and refinement ran for ever, the box stopped shrinking at 0.0136 × 0.051.
    """
    with seconds(30):
        found = zeros_of([as_form(_bernstein(P, S, k) - _bernstein(Q, T, k)) for k in (0, 1)])
        for zero in found.zeros:
            assert max(b - a for a, b in zero.refine(300)) <= mpq(1, 2**300)
    assert found.undecided == []
    assert len(found.zeros) == _crossings()
    assert all(not one.is_at(other) for one in found.zeros for other in found.zeros if one is not other)


def _crossings(steps=2000):
    """How often two polygons cross that are near the curves."""
    chains = [[tuple(float(_bernstein(own, k / steps, j)) for j in (0, 1)) for k in range(steps + 1)] for own in (P, Q)]

    def side(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0

    cells = {}
    for i, (a, b) in enumerate(zip(chains[0], chains[0][1:], strict=False)):
        for key in {(int(x // 20), int(y // 20)) for x, y in (a, b)}:
            cells.setdefault(key, []).append(i)
    count = set()
    for j, (c, d) in enumerate(zip(chains[1], chains[1][1:], strict=False)):
        x, y = int(c[0] // 20), int(c[1] // 20)
        for key in ((x + h, y + k) for h in (-1, 0, 1) for k in (-1, 0, 1)):
            for i in cells.get(key, ()):
                a, b = chains[0][i : i + 2]
                if side(a, b, c) != side(a, b, d) and side(c, d, a) != side(c, d, b):
                    count.add((i, j))
    return len(count)


TACNODE_AND_CIRCLE = ((T * 4 - 1) ** 2 - (S * 4 - 1) ** 4) * ((8 * S - 6) ** 2 + (8 * T - 6) ** 2 - 1)


def test_a_tacnode_beside_a_circle():
    """Two parabolas 4t − 1 = ±(4s − 1)² and a circle. Passed before: the tacnode was undecided."""
    curve = ZeroCurve(as_form(TACNODE_AND_CIRCLE))
    assert curve.complete
    assert sorted(part.shape for part in curve.parts) == ["branches that cross", "closed loop"]
    (crossed,) = (part for part in curve.parts if part.shape == "branches that cross")
    on_parabolas = [(s, (1 + sign * (4 * s - 1) ** 2) / 4) for s in (mpq(1, 8), mpq(2, 5)) for sign in (1, -1)]
    for place in on_parabolas:
        boxes = (*crossed.cells, *(arc.box for arc in crossed.arcs))
        assert any(all(low <= x <= high for x, (low, high) in zip(place, box, strict=True)) for box in boxes)


def test_what_is_certain_is_shown_beside_a_box_that_is_open(monkeypatch):
    """Where elimination is out of reach, a tacnode is undecided. Passed before: one box hid the circle."""
    monkeypatch.setattr(singular_points, "zeros_of", lambda *_, **__: Found([], []))
    curve = ZeroCurve(as_form(TACNODE_AND_CIRCLE))
    assert not curve.complete
    assert [part.shape for part in curve.parts if part.shape != "arc into an undecided box"] == ["closed loop"]
    # four branches lead into the box
    assert sum(part.shape == "arc into an undecided box" for part in curve.parts) == 4
    for a, b in (side for box in curve.undecided for side in box):
        assert a < mpq(1, 4) + mpq(1, 100)
        assert b > mpq(1, 4) - mpq(1, 100)


@pytest.mark.parametrize(
    ("p", "shapes"),
    [
        ((61 * T - 29) * (S + 1), ["arc from border to border"]),
        ((61 * S - 29) * (67 * T - 31), ["branches that cross"]),
        ((64 * S - 29) * (128 * S - 29), ["arc from border to border", "arc from border to border"]),
        ((122 * T - 29) * (S**2 + 1), ["arc from border to border"]),
    ],
)
def test_zeros_along_a_line_of_the_subdivision(p, shapes):
    """Passed before: the line 61 y = 29, on which the square was cut first, was three single points, complete."""
    curve = ZeroCurve(as_form(p))
    assert curve.complete
    assert [part.shape for part in curve.parts] == shapes


def singular_curvature():
    """z with f_uu f_vv − f_uv² = v′ (4 u′³v′ + 64 v′⁴ + 192 u′⁵ + …) for u′ = 4u − 1, v′ = 4v − 1."""
    return graph(
        lambda u, v: (
            _integrated(u, lambda t: (t * 4 - 1) * (t * 4 - 1) * (t * 4 - 1))
            + _integrated(v, lambda t: (t * 4 - 1) * (t * 4 - 1))
            + (u * 4 - 1) * (u * 4 - 1) * (v * 4 - 1) * (v * 4 - 1) * (v * 4 - 1)
        )
    )


def test_all_branches_of_a_degenerate_parabolic_curve():
    """By Newton's polygon, v′ ~ −48 u′² and 16 v′³ ~ −u′³, and the line v′ = 0; K changes its sign across each.

    Passed before: the point was undecided.
    """
    surface = singular_curvature()
    found = analyse(surface)
    assert found.complete
    (line,) = found.parabolic_lines
    assert (line.along.value, line.value) == ("u", mpq(1, 4))
    crossed, *others = sorted(found.parabolic_curves, key=lambda curve: curve.shape != "branches that cross")
    assert [curve.shape for curve in (crossed, *others)] == ["branches that cross", "arc from border to border"]
    # the signs of K on a square around the point, by formulas that are not the library's
    r, n = Fraction(1, 1 << 9), 60
    side = [(r * (2 * k - n) / n, -r) for k in range(n)] + [(r, r * (2 * k - n) / n) for k in range(n)]
    signs = [
        gaussian_curvature(surface, Fraction(1, 4) + x, Fraction(1, 4) + y) > 0
        for x, y in (*side, *((-x, -y) for x, y in side))
    ]
    assert sum(a != b for a, b in zip(signs, signs[1:] + signs[:1], strict=True)) == 4 + 2


def test_incomplete_answers_say_so(monkeypatch):
    """Every open box is in the table and in JSON. Passed before: only the first one was, and no word "incomplete"."""
    monkeypatch.setattr(singular_points, "zeros_of", lambda *_, **__: Found([], []))
    found = analyse(singular_curvature())
    data = surface_inspection_data(found, 5)
    boxes = [box for patch in data["patches"] for box in patch["undecided"]]
    assert len(boxes) == sum(len(one.open_boxes) for one in found.patches)
    table = surface_sheet(found, 5).text()
    assert found.complete == (not boxes) == ("incomplete" not in table) == ("undecided" not in table)
    assert not found.complete
    assert found.parabolic_curves


def _integrated(t, second):
    """Twice the integral of a polynomial up to degree 3 in one parameter: by its values, exactly."""
    # coefficients of second by finite differences at 0, 1, 2, 3
    values = [second(mpq(k)) for k in range(4)]
    rows = [values]
    while len(rows[-1]) > 1:
        rows.append([b - a for a, b in zip(rows[-1], rows[-1][1:], strict=False)])
    n0, n1, n2, n3 = (row[0] for row in rows)
    c = [n0, n1 - n2 / 2 + n3 / 3, n2 / 2 - n3 / 2, n3 / 6]
    total, power = None, t * t
    for k, x in enumerate(c):
        term = power * (x / ((k + 1) * (k + 2)))
        total = term if total is None else total + term
        power = power * t
    return total


# ---- remarks about borders


def test_an_umbilic_at_the_border_of_a_plane_has_all_its_sides():
    """z = 0 for u ≤ 1, then a sheet with one umbilic on the knot line.

    Passed before: "seen from some patches only" beside a plane all of whose points are umbilics.
    """
    # z = x² (y − 1/3): flat along x = 0 where y = 1/3
    heights = [[0, 0, 0], [0, 0, 0], [mpq(-1, 3), mpq(1, 6), mpq(2, 3)]]
    left = [[(mpq(i, 2) - 1, mpq(j, 2), 0) for j in range(3)] for i in range(3)]
    right = [[(mpq(i, 2), mpq(j, 2), heights[i][j]) for j in range(3)] for i in range(3)]
    surface = NurbsSurface((2, 2), [0, 0, 0, 1, 1, 1, 2, 2, 2], [0, 0, 0, 1, 1, 1], left + right)
    found = analyse(surface)
    assert found.kinds[0] == "planar"
    assert [one.place.exact for one in found.umbilics] == [(1, mpq(1, 3))]
    assert [one.one_sided for one in found.umbilics] == [False]
    assert [one.one_sided for one in analyse(surface.insert_knot("v", mpq(1, 3))).umbilics] == [False]


@pytest.mark.parametrize(
    ("seam", "middle", "one_sided"),
    [((-1, 0, 1), ((2, 2, 1), (3, -2, 1)), [False, False]), ((-1, 1, 1), ((0, -1, 1), (2, -4, 1)), [False, True])],
)
def test_one_sided_does_not_depend_on_knots(seam, middle, one_sided):
    """An umbilic on the seam of a closed surface, on one side of it only.

    Passed before: the second one was one-sided with a knot elsewhere and not without.
    """
    # a closed strip over a loop, its two ends bent differently
    net = [[(x, y, z) for z in (0, 1, 2)] for x, y in ((0, 0), (2, 1), (3, -2), (0, 0))]
    net[1][1], net[2][1] = middle
    net[0][1] = net[3][1] = seam
    surface = NurbsSurface((3, 2), [0] * 4 + [1] * 4, [0] * 3 + [1] * 3, net)
    plain = analyse(surface)
    assert plain.closed
    assert sorted(one.one_sided for one in plain.umbilics) == one_sided
    for along, at in (("u", mpq(1, 2)), ("u", mpq(1, 3)), ("v", mpq(1, 2)), ("v", mpq(2, 7))):
        cut = analyse(surface.insert_knot(along, at))
        assert sorted(one.one_sided for one in cut.umbilics) == one_sided
        assert sorted(one.order for one in cut.joints if one.at_seam) == sorted(
            one.order for one in plain.joints if one.at_seam
        )


def test_a_singular_point_on_a_seam_is_one():
    """A closed tube pinched at one point of its seam. Passed before: the point was listed at both ends."""
    net = [[(x, y, z) for z in (0, 1)] for x, y in ((0, 0), (0, 0), (2, 2), (2, -2), (0, 0), (0, 0))]
    for row in (1, 4):
        net[row][1] = (1, (1 if row == 1 else -1), 1)
    surface = NurbsSurface((5, 1), [0] * 6 + [1] * 6, [0, 0, 1, 1], net)
    found = analyse(surface)
    assert found.closed
    spots = [place.exact for place in found.singular_points]
    assert spots == [(0, 0)]
    cut = analyse(surface.insert_knot("u", mpq(1, 2)))
    assert [place.exact for place in cut.singular_points] == spots


# ---- many surfaces


def test_a_sample_of_the_campaign():
    """``python -m tests.campaigns.surfaces 1000`` has all of it. Passed before: K ≤ 0 proved where K > 0."""
    table = run(12, start=0)
    assert sum(own["surfaces"] for own in table.values()) == 12
    assert {name: (own["different"], own["slow"]) for name, own in table.items()} == dict.fromkeys(table, (0, 0))
    assert not any(own["incomplete"] for own in table.values())
    assert not is_good("net", Counter(surfaces=999, incomplete=1))
    assert is_good("net", Counter(surfaces=1000, incomplete=1))
    assert not is_good("corners", Counter(surfaces=1000, incomplete=1))


def test_a_sample_of_knots_that_are_inserted():
    """``python -m tests.campaigns.surfaces 1000 0 knots`` has all. Nothing compared what knots must not change."""
    table = run(2, start=18, knots=True)
    assert {name: (own["different"], own["incomplete"]) for name, own in table.items()} == dict.fromkeys(table, (0, 0))


# ---- the commands


def test_options_that_surfaces_do_not_have_are_refused():
    """Passed before: options for curves were ignored without a word."""
    result = invoke("inspect", "torus", "--stability")
    assert isinstance(result.exception, ExactSplineError)
    assert "--stability" in str(result.exception)


def test_a_kind_that_is_undecided_has_a_remark(tmp_path):
    """Passed before: "undecided" and an empty remark."""
    from dataclasses import replace

    found = analyse(example("bicubic"))
    (patch,) = found.patches
    vars(found)["patches"] = (replace(patch, kind=type(patch.kind)("undecided")),)
    sheet = surface_sheet(found, 5)
    assert all(row[-1] for row in sheet.rows if row[0] == "undecided")
    assert "incomplete" in sheet.title
    path = tmp_path / "surface.json"
    write(found.surface, path)
    assert invoke("inspect", str(path)).exit_code == 0


def test_degrees_on_patches_name_what_is_missing():
    """Passed before: one formula of too many terms was the end of all of them; none of a kind was an empty table."""
    begun = process_time()
    names = ["parabolic", "stationary_curvature"]
    result = invoke("formula", "degrees", "--paper", "surfaces", "--patch", "2,2", *names)
    assert result.exit_code == 0
    assert process_time() - begun < 15  # 2.4 s are measured: the product is refused before it is multiplied out
    assert "551775" in result.stdout
    assert "32 × 32" in result.stdout
    result = invoke("formula", "degrees", "--paper", "surfaces", "--patch", "2,2", "ridges_of_forms")
    assert isinstance(result.exception, FormulaError)
    assert "ridges_of_forms (forms)" in str(result.exception)
