"""Five sources beside the paper: where they are wrong another computation says so too: sympy, on curves with random
coefficients, from the words of the source and without a formula of the library.
"""

import random
import re
from pathlib import Path

import pytest
import sympy
from sympy import Matrix, Rational, diff, sqrt, symbols

from exactspline import Verdict, paper
from exactspline.verification.claims import claims_of
from tests.support.vectors import turn

SOURCES = (
    "primer_on_bezier_curves",
    "petrunin_zamora_barrera",
    "eberly_geometric_tools",
    "levien_parallel_curves",
    "demers_hodographs",
)
t = symbols("t", real=True)
DIGITS = 40


@pytest.mark.parametrize("name", SOURCES)
def test_the_page_of_the_sources_names_every_error(name):
    page = " ".join((Path(__file__).parents[2] / "docs" / "sources.md").read_text(encoding="utf-8").split())
    assert paper(name).errors
    for title in (paper(name).title, *paper(name).errors.values()):
        assert title in page


def test_a_convention_is_no_error_and_an_offset_is_one_at_any_distance():
    """Passed before: a convention of signs as an error of its source; "(1 − dκ) c′" that was proved for d = 1 alone."""
    signs = [claim for claim in claims_of(paper("levien_parallel_curves")) if claim.error == "cusp-sign"]
    assert "printed" not in {claim.status for claim in signs}
    speeds = [claim for claim in claims_of(paper("demers_hodographs")) if "sigma(1 - eps kappa)" in claim.words]
    assert "plane with delta" in {claim.curve for claim in speeds}


def test_there_are_enough_claims_and_no_statement_twice():
    claims = [claim for name in SOURCES for claim in claims_of(name)]
    assert len(claims) >= 120
    for name in SOURCES:
        assert sum(claim.kind != "degree" for claim in claims_of(name)) >= 10
    said = [
        (
            c.paper,
            c.kind,
            c.curve,
            c.of,
            c.named,
            *[getattr(c, x, "") for x in ("factor", "claimed", "measure", "under", "order", "parameter")],
        )
        for c in claims
    ]
    assert len(said) == len(set(said))
    assert len({claim.id for claim in claims}) > 80


@pytest.mark.parametrize("name", SOURCES)
def test_what_is_printed_is_quoted_with_its_place_and_the_text_is_named(name):
    """Passed before: a line of code, which states nothing of what it computes, was told as printed."""
    for claim in claims_of(name):
        if claim.status == "printed":
            assert claim.words
            assert claim.place
            assert not re.search(r"=.*;$|^(const|return) ", claim.words), f"{claim.key} quotes a line of code"
    readme = (Path(str(paper(name).folder)) / "README.md").read_text(encoding="utf-8")
    assert "**The text read.**" in readme
    assert re.search(r"commit\s[0-9a-f]{7}", readme)


@pytest.mark.parametrize("name", SOURCES)
def test_every_error_is_refuted_and_corrected(name):
    claims = claims_of(name)
    for error in paper(name).errors:
        own = [claim for claim in claims if claim.error == error]
        assert any(c.expected == Verdict.REFUTED for c in own)
        assert any(c.status == "meant" and c.expected != Verdict.REFUTED for c in own)
        assert error.replace("-", "_") in CHECKS


def number(rng):
    return Rational(rng.randint(-9, 9) or 5, rng.randint(1, 5))


def curve(rng, dimension, degree):
    return Matrix([sum(number(rng) * t**k for k in range(degree + 1)) for _ in range(dimension)])


def bezier(points):
    n = len(points) - 1
    return Matrix(
        [sum(sympy.binomial(n, k) * (1 - t) ** (n - k) * t**k * p[i] for k, p in enumerate(points)) for i in (0, 1)]
    )


def value(expression, at):
    """The value of a scalar or of a vector at a parameter, to some digits."""
    if isinstance(expression, sympy.MatrixBase):
        return expression.applyfunc(lambda x: value(x, at))
    return sympy.sympify(expression).evalf(DIGITS, subs={t: at})


def length(vector):
    return sqrt(sum(x**2 for x in vector))


def is_small(x):
    return abs(x) < sympy.Float(10) ** (10 - DIGITS)


def meaningful_derivatives(rng):
    cubic = curve(rng, 2, 3)
    return diff(cubic, t, 3).is_zero_matrix, not diff(cubic, t, 3).is_zero_matrix and diff(cubic, t, 4).is_zero_matrix


def aligned_sign(rng):
    x2, y2, x3, y3, x4 = (number(rng) for _ in range(5))
    y4 = 0
    c = bezier([(0, 0), (x2, y2), (x3, y3), (x4, y4)])
    true = sympy.Poly(turn(c.diff(t), c.diff(t, 2)) / 18, t).coeff_monomial(t**2)
    printed = 3 * x3 * y2 + 2 * x4 * y2 + 3 * x2 * y3 - x4 * y3
    a, b, d, e = x3 * y2, x4 * y2, x2 * y3, x4 * y3
    return true == printed, true == -3 * a + 2 * b + 3 * d - e


def scaling(rng):
    height = abs(number(rng)) + 2
    return height * height == 1, height / height == 1


def length_of_the_tangent(rng):
    b = curve(rng, 2, 3).diff(t)
    at_two = [length(b.subs(t, x)) for x in (0, Rational(1, 3))]
    by_components = [sqrt(b[0] ** 2 + b[1] ** 2).subs(t, x) for x in (0, Rational(1, 3))]
    return at_two[0] == at_two[1], at_two == by_components


def frenet_normal(rng):
    c, x = curve(rng, 3, 3), number(rng)
    d, dd = value(c.diff(t), x), value(c.diff(t, 2), x)
    a = d / length(d)
    b = (a + dd) / length(a + dd)
    r = b.cross(a) / length(b.cross(a))
    normal = r.cross(a) / length(r.cross(a))
    change = value((c.diff(t) / length(c.diff(t))).diff(t), x)
    frenet = change / length(change)
    return tuple(is_small(length(normal - k * frenet)) for k in (1, -1))


def osculating_sphere(rng):
    c, x = curve(rng, 3, 3), number(rng)
    a, b, e = (c.diff(t, k) for k in (1, 2, 3))
    binormal, speed = a.cross(b), length(a)
    kappa = length(binormal) / speed**3
    k, change = value(kappa, x), value(kappa.diff(t) / speed, x)
    tau = value(binormal.dot(e), x) / value(binormal.dot(binormal), x)
    unit, normal = value(binormal, x), value(binormal.cross(a), x)
    held = []
    for sign in (1, -1):
        centre = value(c, x) + normal / length(normal) / k + sign * unit / length(unit) * change / (k**2 * tau)
        way = c - centre
        held.append(all(is_small(value(way.dot(way).diff(t, n), x)) for n in (1, 2, 3)))
    return tuple(held)


def handedness(rng):
    x, y = symbols("x y")
    f = sum(number(rng) * x**i * y**j for i in range(3) for j in range(3))
    gradient = Matrix([f.diff(v).subs({x: number(rng), y: number(rng)}) for v in (x, y)])
    tangent = Matrix([-gradient[1], gradient[0]])
    return turn(tangent, gradient) > 0, turn(gradient, tangent) > 0


def clockwise_normal(rng):
    c, x = curve(rng, 2, 3), number(rng)
    d = c.diff(t)
    kappa = turn(d, c.diff(t, 2)) / length(d) ** 3
    normal = Matrix([d[1], -d[0]]) / length(d)
    change = (d / length(d)).diff(t) / length(d)
    return tuple(is_small(length(value(change - k * kappa * normal, x))) for k in (1, -1))


def cusp_sign(rng):
    c, x = curve(rng, 2, 3), number(rng)
    d, dd = c.diff(t), c.diff(t, 2)
    printed = value(turn(dd, d) / length(d) ** 3, x)
    left = Matrix([-d[1], d[0]]) / length(d)
    return tuple(is_small(length(value((c + left * k / printed).diff(t), x))) for k in (1, -1))


def polynomial_offset(rng):
    u, v = (sum(number(rng) * t**k for k in range(3)) for _ in range(2))
    hodograph = Matrix([u**2 - v**2, 2 * u * v])
    step = Matrix([-hodograph[1], hodograph[0]]) / (u**2 + v**2)
    below = [sympy.fraction(sympy.cancel(x))[1] for x in step]
    return all(not b.has(t) for b in below), all(sympy.rem(sympy.expand(u**2 + v**2), b, t) == 0 for b in below)


def mobius_control_points(rng):
    x, y, w = (sum(number(rng) * t**k for k in range(4)) for _ in range(3))
    degrees = [sympy.degree(sympy.expand(f), t) for f in (x * w, -y * w, x**2 + y**2)]
    return max(degrees) + 1 == 15, max(degrees) + 1 == 7


CHECKS = {
    check.__name__: check
    for check in (
        *(meaningful_derivatives, aligned_sign, scaling, length_of_the_tangent, frenet_normal, osculating_sphere),
        *(handedness, clockwise_normal, cusp_sign, polynomial_offset, mobius_control_points),
    )
}


@pytest.mark.parametrize("name", CHECKS)
def test_errata_by_another_computation(name):
    """What is printed fails on a random instance, and what must be said instead holds on it."""
    rng = random.Random(f"sources {name}")
    for _ in range(2):
        assert CHECKS[name](rng) == (False, True)
