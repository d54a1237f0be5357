"""Composition of splines, exact or refused."""

from __future__ import annotations

from itertools import pairwise

from exactspline.errors import DomainError, ReductionError
from exactspline.numbers.exact import mpq, ratio, text, to_fmpz
from exactspline.numbers.intervals import Interval
from exactspline.numbers.sides import Side
from exactspline.polynomials import bernstein
from exactspline.polynomials.factors import factorize
from exactspline.polynomials.isolation import LocalZero, end_signs, is_nonnegative, isolate
from exactspline.splines.knots import Mesh
from exactspline.splines.piecewise import Piecewise, S


def composed(outer: S, inner: S) -> S:
    """``t ↦ outer(inner(t))``, of the product of the degrees.

    The domain is cut at the knots of `inner` and wherever `inner` crosses a knot of `outer`. Raises `DomainError` when
    `inner` leaves the domain of `outer` and `ReductionError` when a crossing is irrational: the composition is then not
    a spline with rational knots.
    """
    if outer.degree < 0 or inner.degree < 0:
        return inner.constant(outer(0) if outer.degree >= 0 else 0)
    _check_range(outer, inner)
    kinks = dict(zip(outer.mesh.breaks[1:-1], outer.continuity, strict=True))
    continuity = {t: c for knot, c in kinks.items() for t in _preimages(inner, knot)}
    for t, c in zip(inner.mesh.breaks[1:-1], inner.continuity, strict=True):
        continuity[t] = min([c, *[kinks[x] for x in (inner(t, Side.LEFT), inner(t)) if x in kinks]])
    a, b = inner.domain
    mesh = Mesh([a, *sorted(t for t in continuity if a < t < b), b])
    parts = []
    for low, high in pairwise(mesh.breaks):
        i = inner.mesh.locate(low)
        piece = bernstein.restrict(inner.forms[i], inner.degree, inner.mesh.local(i, low), inner.mesh.local(i, high))
        j = outer.mesh.locate(_typical(inner, outer, low, high))
        parts.append(
            bernstein.compose(
                outer.forms[j], outer.degree, _localized(piece, inner.degree, outer.mesh, j), inner.degree
            )
        )
    inside = tuple(continuity[t] for t in mesh.breaks[1:-1])
    return type(outer).from_forms(outer.degree * inner.degree, mesh, inside, parts)


def _typical(inner: Piecewise, outer: Piecewise, low: mpq, high: mpq) -> mpq:
    """A value of the inner spline on (low, high) that is not a knot of the outer one, where it has any: it may touch
    knots there but crosses none.
    """
    values = [inner(low + (high - low) * mpq(k, inner.degree + 4)) for k in range(1, inner.degree + 4)]
    return next((x for x in values if x not in outer.mesh.breaks), values[0])


def _localized(piece: bernstein.Form, degree: int, mesh: Mesh, j: int) -> bernstein.Form:
    """The inner form in the local parameter of segment j of the outer mesh."""
    start, width = mesh.breaks[j], mesh.breaks[j + 1] - mesh.breaks[j]
    c, m = bernstein.add(piece, _constant(-start, degree))
    return c * to_fmpz(width.denominator), m * to_fmpz(width.numerator)


def _constant(value: mpq, degree: int) -> bernstein.Form:
    return int(value.numerator) * bernstein.raiser(degree), to_fmpz(value.denominator)


def _check_range(outer: Piecewise, inner: Piecewise) -> None:
    low, high = outer.domain
    for i, piece in enumerate(inner.forms):
        below = bernstein.add(piece, _constant(-low, inner.degree))[0]
        above = bernstein.add((-piece[0], piece[1]), _constant(high, inner.degree))[0]
        for c in (below, above):
            if not is_nonnegative(c, inner.degree):
                a, b = inner.mesh.breaks[i : i + 2]
                raise DomainError(
                    f"the inner spline leaves the outer domain [{text(low)}, {text(high)}] on [{text(a)}, {text(b)}]",
                    remedy="restrict it first",
                    segment=i,
                )


def _preimages(inner: Piecewise, knot: mpq) -> list[mpq]:
    """Parameters strictly inside segments where `inner` crosses `knot`; all rational, or an error."""
    found = []
    for i, piece in enumerate(inner.forms):
        c, _ = bernstein.add(piece, _constant(-knot, inner.degree))
        if not c:
            continue
        segment = Interval(*inner.mesh.breaks[i : i + 2])
        for zero in isolate(c, inner.degree).inner:
            if zero.signs[0] != zero.signs[1]:
                found.append(segment.at(_rational(zero, knot, segment)))
    return found


def _rational(zero: LocalZero, knot: mpq, segment: Interval) -> mpq:
    """The local parameter at which a knot of the outer spline is met, or the error where it is irrational."""
    if zero.low == zero.high:
        return zero.low
    factors = factorize(zero.factor.polynomial).bases
    own = next(q for q in factors if len(set(end_signs(q, zero.low, zero.high))) > 1)
    if own.degree() == 1:
        return ratio(own[0], own[0] - own[1])
    raise ReductionError(
        f"the knot {text(knot)} of the outer spline has an irrational preimage on {segment}",
        remedy=(
            "the composition is not a spline with rational knots; split the outer spline there or approximate the "
            "inner one"
        ),
        knot=knot,
        polynomial=[int(x) for x in own.coeffs()],
    )
