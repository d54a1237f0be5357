"""Bisectors at irrational parameters: lines over irrational cusps by exact control points, and the decision whether
polynomials vanish at two irrational numbers, of any degrees.
"""

import json
from itertools import pairwise, product
from random import Random

import mpmath
import pytest
from flint import fmpq_poly, fmpz_poly
from gmpy2 import mpq

from exactspline import BSpline, write, zeros
from exactspline.display.answer_forms import bisector_answer
from exactspline.errors import ReachError
from exactspline.geometry.bisectors import lines
from exactspline.geometry.bisectors.system import vanish_together
from exactspline.geometry.bisectors.two_curves import curve_bisector
from exactspline.polynomials.elimination import resultant
from exactspline.polynomials.over_root import OverRoot, by_powers
from exactspline.polynomials.two_parameters import S, T, least_value, rows_of
from exactspline.roots.of_polynomials import as_splines, roots_in
from tests.support.bisector_oracle import bezier, curve_of, point_and_tangent, spans
from tests.support.command import invoke
from tests.support.vectors import cross, dot

U = BSpline.identity(0, 1)
ZERO, ONE = mpq(0), mpq(1)


#: γ′ = (2t² − 1)(1, t, t²): a cusp at r = 1/√2, where γ = (−2r/3, −1/8, −r/15).
CUSP = curve_of(U**3 * mpq(2, 3) - U, U**4 * mpq(1, 2) - U**2 * mpq(1, 2), U**5 * mpq(2, 5) - U**3 * mpq(1, 3))
FOOT = [(ZERO, mpq(-2, 3)), (mpq(-1, 8), ZERO), (ZERO, mpq(-1, 15))]
#: A cusp at r in the origin.
CUSP_IN_ORIGIN = curve_of((2 * U * U - 1) ** 2, (2 * U * U - 1) ** 2 * U, (2 * U * U - 1) ** 3)
OTHERS = {
    "a parabola": bezier((0, 0, 1), (1, 2, 0), (2, 1, 1)),
    "a conic with negative weights": bezier((0, 0, 1), (1, 2, 0), (2, 1, 1), weights=[-1, -2, -3]),
    "a line": bezier((1, 0, 0), (1, 1, 2)),
}


class Number:
    """a + b r with r² = 1/2, exactly."""

    def __init__(self, a, b=ZERO):
        self.a, self.b = mpq(a), mpq(b)

    def __add__(self, other):
        return Number(self.a + other.a, self.b + other.b)

    def __sub__(self, other):
        return Number(self.a - other.a, self.b - other.b)

    def __mul__(self, other):
        return Number(self.a * other.a + self.b * other.b / 2, self.a * other.b + self.b * other.a)

    def __bool__(self):
        return bool(self.a or self.b)


def total(numbers):
    found = Number(0)
    for x in numbers:
        found = found + x
    return found


def product_of(one, other):
    return total(x * y for x, y in zip(one, other, strict=True))


def numbers(part, t):
    return [Number(*[f(t) for f in coordinate]) for coordinate in part]


def component(found):
    (line,) = [x for x in found.lines if x.over_root is not None]
    return line


@pytest.mark.parametrize("swap", [False, True])
@pytest.mark.parametrize("name", OTHERS)
def test_lines_over_an_irrational_cusp_lie_in_both_planes_exactly(name, swap):
    """In the field of r: as far from both feet, and perpendicular to the tangent of the second curve."""
    other = OTHERS[name]
    found = curve_bisector(other, CUSP) if swap else curve_bisector(CUSP, other)
    assert found.undecided == ()
    line = component(found)
    lines = line.over_root
    assert (lines.of, line.fixed.minimal_polynomial()) == (0 if swap else 1, [-1, 0, 2])
    (span, (low, high)), foot = spans(other)[0], [Number(*x) for x in FOOT]
    for k in range(7):
        t = low + (high - low) * mpq(k, 6)
        q, tangent = ([Number(x) for x in v] for v in point_and_tangent(other, span, t))
        *top, w = numbers(lines.directrix, t)
        generator = numbers(lines.generator, t)
        assert w
        assert any(generator)
        chord = [y - x for x, y in zip(foot, q, strict=True)]
        # heights times w, so that nothing is divided
        assert not product_of(tangent, top) - product_of(tangent, q) * w
        assert not product_of(tangent, generator)
        double = Number(2)
        assert not product_of(chord, top) * double - (product_of(q, q) - product_of(foot, foot)) * w
        assert not product_of(chord, generator)
        balls, again = lines.line(t), line.line(*((t, line.fixed) if swap else (line.fixed, t)))
        assert all(x.overlaps(y) for x, y in zip(cross(balls.direction, again.direction), [0] * 3, strict=True))


def test_lines_over_a_cusp_at_infinity():
    """Tangents of (t, t² + 2, 0) go through the origin for t = √2, those of (t, t² + 1, 0) for t = 1."""
    for height, polynomial in ((2, [-2, 0, 1]), (1, [-1, 1])):
        other = bezier((0, height, 0), (1, height, 0), (2, height + 4, 0), domain=(0, 2))
        (pole,) = component(curve_bisector(CUSP_IN_ORIGIN, other)).over_root.poles
        assert pole == zeros(as_splines([fmpz_poly(polynomial)], ZERO, mpq(2))[0])[0]


def test_poles_out_of_reach_are_named_and_the_rest_is_there(monkeypatch):
    """Before: `ReachError` for the whole output; and a pole that could not be decided was said to be none."""

    def refuse(*_):
        raise ReachError("the resultant")

    other = bezier((0, 2, 0), (1, 2, 0), (2, 6, 0), domain=(0, 2))
    whole = curve_bisector(CUSP_IN_ORIGIN, other)
    for name, instead in (("resultant", refuse), ("vanish_together", lambda *_: None)):
        with monkeypatch.context() as patch:
            patch.setattr(lines, name, instead)
            found = curve_bisector(CUSP_IN_ORIGIN, other)
            assert component(found).over_root.poles is None
            assert found.undecided == ("the poles of the lines over (√2/2) of one curve",)
            data = bisector_answer(found, 20)
        assert not data["complete"]
        (line,) = [x for x in data["lines"] if x["over_root"]]
        assert line["over_root"]["poles"] is None
        assert len(found.pairs) == len(whole.pairs)


def test_a_line_through_an_irrational_cusp_has_no_lines_there():
    """Its normal planes and the middle planes are parallel; only in the cusp itself there is a plane."""
    found = curve_bisector(CUSP_IN_ORIGIN, bezier((-1, -1, 0), (2, 2, 0)))
    assert not [line for line in found.lines if line.over_root is not None]
    assert [(str(x.solutions), x.t) for x in found.pairs if x.s == zeros(2 * U * U - 1)[0]] == [("plane", mpq(1, 3))]


def test_lines_over_a_root_as_data(tmp_path):
    """A point of the surface from the control points of the file."""
    files = [tmp_path / "cusp.json", tmp_path / "other.json"]
    for file, curve in zip(files, (CUSP, OTHERS["a parabola"]), strict=True):
        write(curve, file)
    done = invoke("bisector", *map(str, files), "--digits", "20", "--json")
    assert done.exit_code == 0
    (line,) = json.loads(done.stdout)["rows"][0]["lines"]
    data, (t, a, b) = line["over_root"], (mpq(1, 3), mpq(line["fixed"]["low"]), mpq(line["fixed"]["high"]))
    assert (data["parameter"], line["pieces"]) == ("t", [])
    rows = data["directrix"]["homogeneous_control_points"]
    while len(rows) > 1:
        rows = [
            [[(1 - t) * mpq(x) + t * mpq(y) for x, y in zip(*pair, strict=True)] for pair in zip(*two, strict=True)]
            for two in pairwise(rows)
        ]
    *point, w = [x + y * (a + b) / 2 for x, y in rows[0]]
    foot = [x + y * (a + b) / 2 for x, y in FOOT]
    q, tangent = point_and_tangent(OTHERS["a parabola"], 2, t)
    point = [x / w for x in point]
    away = [[x - y for x, y in zip(point, end, strict=True)] for end in (foot, q)]
    assert abs(dot(away[1], tangent)) < mpq(1, 10**15)
    assert abs(dot(away[0], away[0]) - dot(away[1], away[1])) < mpq(1, 10**15)
    shown = invoke("bisector", *map(str, files), env={"COLUMNS": "200"}).stdout
    assert "s = √2/2" in shown


# ---- polynomials over a root


def test_divisors_over_a_root():
    """Products of linear factors in Q(∛2): the common ones are found, and exact division undoes multiplication."""
    random, modulus = Random(1), fmpq_poly([-2, 0, 0, 1])

    def factor():
        return OverRoot([fmpq_poly([random.randint(-2, 2) for _ in range(3)]), fmpq_poly([1])], modulus)

    for _ in range(20):
        one, other, shared = factor(), factor(), factor()
        found = (one * shared * shared).gcd(other * shared)
        expected = shared * one if one.coefficients == other.coefficients else shared
        assert found.coefficients == expected.coefficients or shared.coefficients == other.coefficients
        assert ((one * other) // other).coefficients == one.coefficients
        assert not divmod(one * other, other)[1]
        assert not one - one
        assert one.gcd(one - one).coefficients == one.coefficients
    half = OverRoot([fmpq_poly([1, 0, 12]) / 2, fmpq_poly([0, 3])], modulus)
    assert by_powers([half, half * 2]) == [
        [fmpz_poly(x) for x in ([1], [0, 6], [12])],
        [fmpz_poly(x) for x in ([2], [0, 12], [24])],
    ]


# ---- whether polynomials vanish at two irrational numbers


def test_polynomials_at_two_irrational_numbers_of_high_degrees():
    """r of degree 11 and 1 − r: the product of the degrees is 121."""
    random = Random(2)
    minimal = fmpz_poly([-1, *[random.randint(0, 99) for _ in range(10)], 7])
    (r,) = roots_in(minimal, ZERO, ONE)
    (q,) = roots_in(minimal(fmpz_poly([1, -1])), ZERO, ONE)
    assert len(r.minimal_polynomial()) == len(q.minimal_polynomial()) == 12
    multiple = sum((random.randint(-9, 9) * S**i * T**j for i, j in product(range(4), repeat=2)), 0 * S)
    zero = multiple * (S + T - 1) + (S * T + 3) * minimal_in_s(minimal)
    assert vanish_together([zero], r, q) is True
    assert vanish_together([zero, zero + 1], r, q) is False
    # nearer to zero than any digits that are tried first
    assert vanish_together([10**300 * zero + 1], r, q) is False
    assert vanish_together([zero * 10**300 + (S - T)], r, q) is False
    near = 10**200 * (S + T - 1) ** 2 * multiple + zero
    assert vanish_together([near], r, q) is True


def minimal_in_s(p):
    return sum((int(x) * S**k for k, x in enumerate(p.coeffs())), 0 * S)


def all_roots(p):
    parts = [[int(x) for x in f.coeffs()][::-1] for f, _ in p.factor_squarefree()[1]]
    return [root for part in parts for root in mpmath.polyroots(part, maxsteps=500, extraprec=500)]


def test_values_that_are_not_zero_are_not_smaller_than_the_least_value():
    """At all pairs of real and complex roots; (10ᵏ s − 1)ⁿ comes near to zero where s is near to 10⁻ᵏ."""
    random = Random(3)
    tight = [
        ((10 * S - 1) ** 5 + T * (10 * S - 1) ** 6, fmpz_poly([-1, 10, 0, 0, 1]), fmpz_poly([-3, 0, 1])),
        ((S - T) ** 4, fmpz_poly([-2, 0, 1000]), fmpz_poly([-2001, 0, 1000000])),
    ]
    for _ in range(20):
        first, second = ([random.randint(-9, 9) for _ in range(random.randint(2, 5))] + [1] for _ in range(2))
        p = sum((random.randint(-9, 9) * S**i * T**j for i, j in product(range(3), repeat=2)), 0 * S)
        tight.append((p + S, fmpz_poly(first), fmpz_poly(second)))
    nearest = mpmath.inf
    with mpmath.workdps(120):
        for p, first, second in tight:
            least = least_value(p, first, second)
            for s, t in product(all_roots(first), all_roots(second)):
                size = abs(sum(int(x) * s ** int(i) * t ** int(j) for (i, j), x in p.terms()))
                if size > mpmath.mpf(10) ** -90:
                    assert size >= mpmath.mpf(2) ** -least
                    nearest = min(nearest, size)
    assert nearest < 1e-8


def test_resultants_by_values_are_those_of_flint():
    random = Random(4)
    for m, n in product(range(1, 4), repeat=2):
        f, g = (
            sum((random.randint(-9, 9) * S**i * T**j for i in range(3) for j in range(k)), S * T**k) for k in (m, n)
        )
        expected = f.resultant(g, 1)
        found = resultant(rows_of(f), rows_of(g))
        assert minimal_in_s(found) == expected
    assert resultant([fmpz_poly([0, 1])], rows_of(T * T + S)) == fmpz_poly([0, 0, 1])
