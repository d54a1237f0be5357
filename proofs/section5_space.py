"""§5 of the paper (Chen, Riesenfeld and Cohen 2007) on space curves: curvature and torsion, the ruled surfaces on the
Frenet directions, the focal curve and the focal surface.

Each naive form equals its reduction, and each object is compared with its definition. In two places the paper is wrong:
the parameter of the rectifying developable is λ = ζ/‖γ′‖, not ‖γ′‖ζ, and the focal curve is rational.
"""

from fractions import Fraction

import pytest
from gmpy2 import mpq
from theorem import establish, verdict_for_all

from exactspline.interchange.examples import example, example_names
from exactspline.language import Vector, dot
from exactspline.language.arguments import Curve
from exactspline.language.rational import Rational
from exactspline.papers import find
from exactspline.readings.taylor import Series, series_curve

SPACE = [name for name in example_names() if example(name).dimension == 3]
TWISTED = [name for name in SPACE if not find("D1_D2_D3")(example(name)).is_zero]


def helix(pitch, terms=6):
    """The helix (cos t, sin t, pitch·t) around t = 0 as exact Taylor series."""
    cosine, sine, factorial = [], [], 1
    for i in range(terms):
        factorial *= max(i, 1)
        value = Fraction((-1) ** (i // 2), factorial)
        cosine.append(mpq(value if i % 2 == 0 else 0))
        sine.append(mpq(value if i % 2 else 0))
    line = [mpq(0), mpq(pitch), *[mpq(0)] * (terms - 2)]
    one = Series([mpq(1), *[mpq(0)] * (terms - 1)])
    return Curve(Vector(Series(cosine), Series(sine), Series(line)), one)


@pytest.mark.parametrize("pitch", ["1", "-2", "3/7"])
def test_a_helix_has_constant_curvature_and_torsion(pitch):
    """κ = 1/(1 + c²) and τ = c/(1 + c²), positive for a right-handed helix; the focal curve is the helix of the
    centres.
    """
    c, h = mpq(pitch), helix(pitch)
    assert find("torsion")(h).value == find("torsion_reduced")(h).value == c / (1 + c * c)
    assert find("space_curvature_squared")(h).value == 1 / (1 + c * c) ** 2
    centre = tuple(x.value for x in find("focal_curve")(h))
    assert centre == (-c * c, 0, 0)


def test_curvature_and_torsion():
    """κN and κ⁻¹N are rational; equations (17) and (18) agree with each other and with the Frenet equations."""
    assert set(verdict_for_all("C5.1a")) == {"PROVED"}
    assert verdict_for_all("C5.2a") == ["PROVED"]
    assert set(verdict_for_all("C5.2b")) == {"PROVED"}
    assert verdict_for_all("E17") == ["PROVED"]


def test_the_zero_set_of_torsion():
    """The zero set of the torsion is that of [D1 D2 D3], except at points with γ′ × γ″ = 0."""
    assert verdict_for_all("C5.2c", "degree") == ["PROVED", "PROVED"]
    assert verdict_for_all("C5.2c", "where γ′×γ″ has no zero") == ["PROVED"]
    assert verdict_for_all("C5.2c", "identical") == ["REFUTED"]


@pytest.mark.parametrize("claim", ["C5.3a", "C5.3b", "C5.3c"])
def test_ruled_surfaces_of_the_frenet_directions(claim):
    """The naive and the reduced form are the same surface, with the degrees stated."""
    assert set(verdict_for_all(claim)) == {"PROVED"}


def test_relations_between_the_ruling_parameters():
    """The relations ζ = w λ, w³ λ and w⁵ λ are computed, not assumed."""
    found = [
        str(row.factor)
        for claim in ("C5.3a", "C5.3b", "C5.3c")
        for row in establish(claim, "one surface")
        if not row.curve
    ]
    assert found == ["ζ = w λ", "ζ = w³ λ", "ζ = w⁵ λ"]


def test_the_rectifying_developable():
    """The two forms are the same surface, which is developable and has γ as a geodesic; in the relation between the
    parameters the speed is printed as a factor instead of a divisor.
    """
    assert verdict_for_all("C5.4a", "one surface") == ["PROVED"]
    assert verdict_for_all("C5.4a", "geodesic") == verdict_for_all("C5.4a", "developable is developable") == ["PROVED"]
    assert verdict_for_all("C5.4a", "λ = ‖γ′‖ ζ") == ["REFUTED"]
    assert verdict_for_all("C5.4a", "λ = ζ/‖γ′‖") == ["PROVED"] * 2
    assert set(verdict_for_all("C5.4b")) == {"PROVED"}


def test_the_focal_curve_is_rational():
    """By its definition, contact of third order, the focal curve is equation (19) with the derivative by arc length. Ψ
    is right. The statement "non-rational" is wrong, and equation (7), which is cited, is about curves in the plane.
    """
    assert set(verdict_for_all("E19")) == {"PROVED"}
    refuted = [row.key for row in establish("C5.5a") if not row.curve and row.verdict != "PROVED"]
    assert refuted == ["C55a-signed_curvature"]
    assert verdict_for_all("C5.5b", "non-rational") == ["REFUTED"]
    assert verdict_for_all("C5.5b", "is rational") == ["PROVED"]
    assert verdict_for_all("C5.5b", "derivative by the parameter") == ["REFUTED"]
    assert verdict_for_all("C5.5b", "with the derivative by arc length has") == ["PROVED"]
    assert set(verdict_for_all("C5.5c")) == {"PROVED"}


def solve(rows, right):
    """Three linear equations by elimination, over the rationals."""
    m = [[*row, b] for row, b in zip(rows, right, strict=True)]
    for i in range(3):
        pivot = next(j for j in range(i, 3) if m[j][i])
        m[i], m[pivot] = m[pivot], m[i]
        m[i] = [x / m[i][i] for x in m[i]]
        for j in range(3):
            if j != i:
                m[j] = [x - m[j][i] * y for x, y in zip(m[j], m[i], strict=True)]
    return tuple(row[3] for row in m)


@pytest.mark.parametrize("name", TWISTED)
def test_focal_points_are_centres_of_third_order_contact(name):
    """Focal points satisfy their definition, checked by exact Taylor coefficients and elimination, without the formula
    of the focal curve.
    """
    curve = example(name)
    a, b = curve.domain
    reduced, naive = find("focal_curve_reduced")(curve), find("focal_curve")(curve)
    for t in (a + (b - a) * mpq(k, 11) for k in (2, 5, 9)):
        c = series_curve(curve, t, 4)
        x, y, z = (component.coefficients for component in c.gamma)
        # ‖γ(h) − m‖² constant to h³: the coefficients of h, h², h³ vanish
        rows = [[x[k], y[k], z[k]] for k in (1, 2, 3)]
        squared = dot(c.gamma - constant_point(c), c.gamma - constant_point(c))
        if find("D1_D2_D3")(curve)(t) == 0:
            continue
        offset = solve(rows, [squared.coefficients[k] / 2 for k in (1, 2, 3)])
        centre = tuple(p + q for p, q in zip(curve(t), offset, strict=True))
        for form in (reduced, naive):
            assert (form(t) if isinstance(form, Rational) else tuple(s(t) for s in form)) == centre


def constant_point(c):
    """The point itself as a constant series."""
    return Vector(*[component.constant(component.value) for component in c.gamma])


def test_the_focal_surface():
    """The two forms are the same developable surface, the envelope of the normal planes: its rulings lie in the normal
    planes.
    """
    assert verdict_for_all("C5.6a", "one surface") == ["PROVED"]
    assert verdict_for_all("C5.6a", "developable") == ["PROVED"]
    for name in TWISTED:
        surface = find("focal_surface_reduced")(example(name))
        d1 = find("D1")(example(name))
        assert dot(surface.generator, d1).is_zero


def test_degrees_the_paper_does_not_give():
    """The focal surface has degree 31d, and 15d − 6 in the reduced form."""
    assert [str(row.computed) for row in establish("C5.6a", "degree") if not row.curve] == ["31d", "15d − 6"]
