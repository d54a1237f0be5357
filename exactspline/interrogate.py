"""What a user calls: the derived objects of a curve, in whatever form, with the places where they do not exist named.

Parameters and coordinates are unitless exact numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flint import fmpz_poly
from gmpy2 import isqrt, mpq, mpz

from exactspline.constructions import CONSTRUCTIONS, MINIMAL, construction, joined, numerator
from exactspline.displayed import Displayed
from exactspline.errors import FormulaError, ShapeError
from exactspline.exact import ratio, rational, text
from exactspline.form import ONE, is_square_class, primitive, zero_on_segment
from exactspline.formulas import find
from exactspline.language import Curve, RuledSurface, Vector
from exactspline.measure import in_lowest_terms
from exactspline.quotients import Rational
from exactspline.spline import BSpline

Interval = tuple[mpq, mpq]


@dataclass(frozen=True)
class Piece:
    """A derived object over an interval of the curve's parameter: a spline, a vector of them, or a `Rational`."""

    interval: Interval
    value: Any


@dataclass(frozen=True)
class Derived(Displayed):
    """A derived object in pieces, and the intervals on which it does not exist, each with the reason."""

    name: str
    form: str
    pieces: tuple[Piece, ...]
    missing: tuple[tuple[Interval, str], ...]
    #: Whether it is a ruled surface: then the values are directrix and generator side by side.
    ruled: bool = False

    def __call__(self, t: Any) -> Any:
        """Value at a parameter, by the first piece that holds it; `ShapeError` where there is none."""
        t = rational(t)
        for piece in self.pieces:
            if piece.interval[0] <= t <= piece.interval[1]:
                return piece.value(t) if not isinstance(piece.value, Vector) else tuple(c(t) for c in piece.value)
        raise ShapeError(f"{self.name} does not exist at the parameter {text(t)}", remedy="; ".join(reason for _, reason in self.missing))


def part(curve: Any, a: mpq, b: mpq) -> Curve:
    """The curve over [a, b], as operands for formulas."""
    whole = curve.domain == (a, b)
    restricted = Curve(
        curve.p if whole else Vector(*[x.restrict(a, b) for x in curve.p]), curve.w if whole else curve.w.restrict(a, b), polynomial=curve.polynomial
    )
    restricted.domain = (a, b)  # type: ignore[attr-defined]
    return restricted


def intervals_where(breaks: Sequence[mpq], holds: Sequence[bool]) -> list[Interval]:
    """The maximal intervals made of segments on which something holds."""
    found: list[Interval] = []
    for a, b, here in zip(breaks, breaks[1:], holds, strict=False):
        if here:
            if found and found[-1][1] == a:
                found[-1] = (found[-1][0], b)
            else:
                found.append((a, b))
    return found


def plane(curve: Any) -> Any:
    """The curve itself, if it is one in the plane; `ShapeError` otherwise."""
    if curve.dimension != 2:
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="this needs a curve in the plane")
    return curve


def space(curve: Any) -> Any:
    """The curve itself, if it is one in space; `ShapeError` otherwise."""
    if curve.dimension != 3:
        raise ShapeError(f"a curve in R{curve.dimension}", remedy="this needs a curve in space")
    return curve


def derive(name: str, curve: Any, form: str = MINIMAL) -> Derived:
    """A construction or a formula on a curve.

    `name` is a construction (``evolute``, ``zero_curvature``, …) or any formula (``f2``, ``g0``, …; then `form` is ``minimal`` or ``naive``, the
    formula as it stands). Where an object does not exist (the evolute of a straight piece) the other pieces are returned and the missing ones
    named.

    >>> from exactspline.curves import example
    >>> derive("evolute", example("circle"))("1/2")
    (mpq(0,1), mpq(0,1))

    Raises `FormulaError` for an unknown name or form, `ShapeError` for a curve of the wrong dimension or where nothing is left.
    """
    if name in CONSTRUCTIONS:
        made = construction(name)
        needed, compute = made.curve, lambda c: made.on(c, form)
        formula = made.formula(form)
    else:
        formula = find(name)
        if form not in (MINIMAL, "naive"):
            raise FormulaError(f"{name} has no form {form!r}", remedy=f"a formula has the forms {MINIMAL} and naive (as it stands)")
        needed = formula.curve
        compute = (lambda c: joined(in_lowest_terms(formula(c)))) if form == MINIMAL else (lambda c: joined(formula(c)))
    if needed not in ("curve", {2: "plane", 3: "space"}.get(curve.dimension)):
        raise ShapeError(f"{name} of a curve in R{curve.dimension}", remedy=f"it is defined for a {needed} curve")
    found = formula(curve)
    ruled = isinstance(found, RuledSurface)
    exists, breaks = _exists(found), curve.breakpoints
    missing = tuple((interval, _why_missing(name)) for interval in intervals_where(breaks, [not here for here in exists]))
    pieces = tuple(Piece(interval, compute(part(curve, *interval))) for interval in intervals_where(breaks, exists))
    if not pieces:
        raise ShapeError(f"{curve.name or 'the curve'} has no {name}: {missing[0][1]} on its whole domain", remedy="choose another curve")
    return Derived(name, form, pieces, missing, ruled)


def evolute(curve: Any, form: str = MINIMAL) -> Derived:
    """The evolute of a plane curve, in lowest terms (`exactspline degrees --generic` tells the degree for all curves).

    >>> from exactspline.curves import example
    >>> evolute(example("ellipse_skew")).pieces[0].value.degree
    6

    Raises `ShapeError` for a curve that is not in the plane or is straight.
    """
    return derive("evolute", curve, form)


def focal_curve(curve: Any, form: str = MINIMAL) -> Derived:
    """The centres of the osculating spheres of a space curve, in lowest terms (`exactspline degrees --generic` tells the degree for all curves).

    >>> from exactspline.curves import example
    >>> focal_curve(example("twisted_cubic")).pieces[0].value.degree
    5

    Raises `ShapeError` for a curve that is not in space or is planar.
    """
    return derive("focal_curve", curve, form)


def torsion(curve: Any, form: str = MINIMAL) -> Derived:
    """The torsion of a space curve, in lowest terms (`exactspline degrees --generic` tells the degree for all curves).

    >>> from exactspline.curves import example
    >>> torsion(example("twisted_cubic")).pieces[0].value.degree
    4

    Raises `ShapeError` for a curve that is not in space or is straight.
    """
    return derive("torsion", curve, form)


def circle_centres(curve: Any, form: str = MINIMAL) -> Derived:
    """The centres of the osculating circles of a space curve, in lowest terms (`exactspline degrees --generic` tells the degree for all curves).

    >>> from exactspline.curves import example
    >>> circle_centres(example("twisted_cubic")).pieces[0].value.degree
    8

    Raises `ShapeError` for a curve that is not in space or is straight.
    """
    return derive("circle_centres", curve, form)


def _exists(value: Any) -> list[bool]:
    """Segment by segment whether a denominator, and the generator of a ruled surface, are not identically zero."""
    if isinstance(value, RuledSurface):
        ends = [_exists(part) for part in (value.directrix, value.generator)]
        generator = zip(*[c.polynomials for c in numerator(value.generator)], strict=True)
        return [all(here) and any(parts) for *here, parts in zip(*ends, generator, strict=True)]
    if isinstance(value, Rational):
        return [bool(c) for c in value.denominator.polynomials]
    return [True] * len((value[0] if isinstance(value, Vector) else value).mesh)


#: Why an object does not exist where its denominator vanishes identically, by the beginning of its name.
_MISSING = {
    "evolute": "the curve is straight (its curvature vanishes identically)",
    "focal_curve": "the curve is planar (its torsion vanishes identically)",
    "torsion": "the curve is straight (its curvature vanishes identically)",
    "circle_centres": "the curve is straight (its curvature vanishes identically)",
    "rectifying_developable": "the curve is straight (its curvature vanishes identically)",
    "focal_surface": "the curve is straight (its curvature vanishes identically)",
    "binormal_scroll": "the curve is straight (its curvature vanishes identically)",
    "normal_scroll": "the curve is straight (its curvature vanishes identically)",
    "tangent_developable": "the curve stands still (its velocity vanishes identically)",
}


def _why_missing(name: str) -> str:
    return next((why for start, why in _MISSING.items() if name.startswith(start)), "the denominator vanishes identically")


@dataclass(frozen=True)
class CurvaturePiece:
    """Curvature on one segment: ``√radicand · value``; `value` is None where the curvature is no such thing."""

    interval: Interval
    radicand: int
    value: Rational | BSpline | None
    reason: str = ""


def curvature(curve: Any) -> list[CurvaturePiece]:
    """Signed curvature (positive where the curve turns left), segment by segment, where it is rational up to a constant square root.

    It is exactly where ‖γ′‖² is a positive constant times a square: the curve is a Pythagorean hodograph there (claim C4.1d; Farouki and Sakkalis
    1990).

    >>> from exactspline.curves import example
    >>> [(piece.radicand, piece.value(piece.interval[0])) for piece in curvature(example("circle"))][:2]
    [(1, mpq(1,1)), (1, mpq(1,1))]

    Raises `ShapeError` for a curve that is not in the plane.
    """
    pieces = []
    for a, b in zip(curve.breakpoints, curve.breakpoints[1:], strict=False):
        pieces.append(_curvature_on(part(plane(curve), a, b), (a, b)))
    return pieces


def _curvature_on(c: Curve, interval: Interval) -> CurvaturePiece:
    turning = find("f2")(c)
    if turning.is_zero:
        return CurvaturePiece(interval, 1, turning.constant(0))
    squared = in_lowest_terms(find("curvature_squared")(c))
    roots = [_square_root(part) for part in (squared.numerator, squared.denominator)]
    if None in roots:
        return CurvaturePiece(interval, 0, None, "‖γ′‖² is no constant times a square: the curve is no Pythagorean hodograph here")
    (n, up), (m, down) = roots  # type: ignore[misc]
    if _vanishes(m):
        return CurvaturePiece(interval, 0, None, "γ′ has a zero here: the curvature has a pole, and its sign may jump")
    t = next(t for j in range(1, n.degree + turning.degree + 3) if n(t := _inner(interval, j)) and turning(t))
    root, radicand = _square_part(up / down)
    sign = 1 if n(t) * m(t) * turning(t) > 0 else -1
    return CurvaturePiece(interval, radicand, (n.scaled(sign * root)) / m)


def _inner(interval: Interval, j: int) -> mpq:
    a, b = interval
    return a + (b - a) / (j + 1)


def _square_root(f: BSpline) -> tuple[BSpline, mpq] | None:
    """A spline r and a constant c with ``f = c r²``, of a spline of one segment."""
    c, m = primitive(f.forms[0])
    if f.degree % 2 or not is_square_class(c, f.degree):
        return None
    unit, factors = c.factor_squarefree()
    root = fmpz_poly([1])
    for p, e in factors:
        root = root * p ** (e // 2)
    return BSpline.from_forms(f.degree // 2, f.mesh, (), [(root, ONE)]), ratio(unit, m)


def _square_part(q: mpq) -> tuple[mpq, int]:
    """``(r, n)`` with ``q = r² n`` and n a positive integer, square-free as far as trial division by small primes and a last root tell."""
    n = mpz(q.numerator * q.denominator)
    root = mpq(1, q.denominator)
    for prime in range(2, 1000):
        while n % (prime * prime) == 0:
            n, root = n // (prime * prime), root * prime
    if isqrt(n) ** 2 == n:
        n, root = mpz(1), root * isqrt(n)
    return root, int(n)


def _vanishes(f: BSpline) -> bool:
    return any(zero_on_segment(c, f.degree) is not None for c in f.polynomials)
