"""§6 of the paper (Chen, Riesenfeld and Cohen 2007): bisectors, in the sense of equal critical distances.

The reductions hold: (27), made polynomial in both curves, gives the bisector of two rational space curves degree 4d − 1
in either parameter. The direct approach for a point and a curve is right, too. Four things are wrong: (24) gives γ′ of
a rational curve the degree d − 1, and the naive counts based on this are too low; (27) as printed is polynomial in one
curve only; (34) as printed lacks a factor w; and the degree 4d − 2 of Farouki and Johnstone is not a typo but the true
degree.
"""

from itertools import product

import pytest
from gmpy2 import mpq
from theorem import establish, verdict_for_all

from exactspline.geometry.bisectors.point_and_curve import point_bisector
from exactspline.geometry.bisectors.trimmed import trimmed_bisector
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.interchange.examples import example, example_names
from exactspline.papers import find
from exactspline.verification.evaluation import point_beside

SPACE = [name for name in example_names() if example(name).dimension == 3]
TWISTED = [name for name in SPACE if not find("D1_D2_D3")(example(name)).is_zero]


def square(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b, strict=True))


def test_polynomial_curves():
    """D has degree 2d − 1; the numerators and the bisector have degree 3d − 1."""
    assert verdict_for_all("C6.1a") == ["PROVED", "PROVED", "PROVED"]


def test_naive_counts_of_rational_curves():
    """Neither policy of Table 1 gives the naive counts of the paper; all these counts come out with the degree of γ′
    that equation (24) implies.
    """
    assert verdict_for_all("C6.1b", "γ′ is d − 1, either polynomial or rational: rational") == ["REFUTED"]
    assert set(verdict_for_all("C6.1b", "of (24): the paper adds as Table 1 does")) == {"PROVED"}
    assert set(verdict_for_all("C6.1b", "by Table 1")) == {"PROVED"}
    for what in (
        "determinant D, rational curves",
        "Di, rows not brought to one denominator, rational",
        "Di, each row first brought to one denominator, rational",
    ):
        assert verdict_for_all("C6.1b", what)[0] == "REFUTED"


def test_the_polynomial_formulation():
    """Equation (27) gives the same surface, of degree 4d − 1 in s; the degree in s̄ is the same only if (27) is made
    polynomial in the second curve, too.
    """
    assert set(verdict_for_all("C6.1c")) == {"PROVED"}
    assert verdict_for_all("C6.1e", "same degree in s̄ as in s, rational") == ["REFUTED"]
    assert set(verdict_for_all("C6.1e", "polynomial in both curves")) == {"PROVED"}


def test_the_footnote():
    """4d − 2 is the degree in lowest terms of the planar bisector, and of the bisector of two space curves in either
    parameter.
    """
    assert verdict_for_all("C6.1d", "is a typo") == ["REFUTED"]
    assert verdict_for_all("C6.1d", "planar point/curve bisector of a rational curve has") == ["PROVED"]
    assert verdict_for_all("C6.1d", "two rational space curves") == ["PROVED"]


def test_a_point_and_a_curve():
    """The counts of the explicit directrix follow Table 1 with each row brought to a common denominator. The direct
    form is the same surface; equation (34) as printed is another surface.
    """
    assert set(verdict_for_all("C6.2a")) == {"PROVED"}
    printed = [row.key for row in establish("C6.2b") if not row.curve and row.verdict != "PROVED"]
    assert printed == ["C62b-point_bisector_printed-point_bisector"]
    assert set(verdict_for_all("C6.2c")) == {"PROVED"}
    assert set(verdict_for_all("C6.2d")) == {"PROVED"}
    assert set(verdict_for_all("C6.2e")) == {"PROVED"}


def test_the_planar_bisector_is_an_iso_curve():
    """The planar bisector is an iso-curve in a plane perpendicular to the moved axis, but not in a tilted plane."""
    assert verdict_for_all("C6.2f") == ["PROVED", "PROVED", "REFUTED"]


def test_misprints():
    """Equation (34) lacks a factor w in its last height; (35) is (24), not (29), without the second row."""
    assert verdict_for_all("C6.2g", "as printed") == ["REFUTED"]
    assert verdict_for_all("C6.2g", "w²‖Q‖²) is equivalent") == ["PROVED"]
    assert verdict_for_all("C6.2h", "(29)") == ["REFUTED"]
    assert verdict_for_all("C6.2h", "(24)") == ["PROVED"]


def test_definitions():
    """A point of the bisector lies in the normal planes at its foot points and is equidistant from them: this is
    proved, and checked on points.
    """
    assert set(verdict_for_all("E22")) == {"PROVED"}
    assert set(verdict_for_all("E30")) == {"PROVED"}


def test_captions_of_figures_4_and_5():
    assert [row.verdict for row in establish("Fig. 4") + establish("Fig. 5")] == ["VERIFIED"] * 4


@pytest.mark.parametrize(("one", "other"), [pair for pair in product(TWISTED, TWISTED) if pair[0] < pair[1]])
def test_points_of_the_bisector_of_two_curves(one, other):
    first, second = example(one), example(other)
    found = curve_bisector(first, second)
    patch = found.patches[-1]
    s, t = (a + (b - a) * mpq(3, 7) for a, b in patch.sides)
    b = patch.value(s, t)
    assert square(b, first(s)) == square(b, second(t))


@pytest.mark.parametrize("name", TWISTED)
def test_points_of_the_bisector_of_a_point_and_a_curve(name):
    curve = example(name)
    point = point_beside(curve)
    for piece in point_bisector(curve, point).pieces:
        a, b = piece.interval
        s = a + (b - a) * mpq(2, 5)
        for height in (-1, 0, mpq(7, 2)):
            x = piece.surface.at(height)(s)
            assert x["xyz".index(piece.moved)] == height
            assert square(x, curve(s)) == square(x, point)


def test_the_planar_bisector_of_an_ellipse_trimmed():
    """For a point inside the ellipse, trimming leaves two arcs of the four segments of the untrimmed bisector."""
    found = trimmed_bisector(example("ellipse"), (1, "1/3"))
    assert [piece.kind for piece in found.pieces] == ["arc", "arc"]
