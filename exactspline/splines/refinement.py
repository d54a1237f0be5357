"""Other representations of the same spline, and its parts: degree, knots, restriction. Functions behind the methods of
`BSpline`.
"""

from __future__ import annotations

from collections.abc import Iterator

from exactspline.errors import DomainError, KnotError, ReductionError, ShapeError, shown
from exactspline.numbers.exact import mpq, short_text, text
from exactspline.numbers.sides import Side
from exactspline.polynomials import bernstein
from exactspline.splines.knots import SMOOTH, Mesh
from exactspline.splines.piecewise import Piecewise, S


def aligned(f: S, g: S) -> tuple[S, S]:
    """Both splines over the union of their breakpoints; where one has no knot it counts as smooth."""
    mesh = f.mesh if f.mesh.breaks == g.mesh.breaks else f.mesh.union(g.mesh)
    return over(f, mesh), over(g, mesh)


def over(f: S, mesh: Mesh) -> S:
    """The spline over a finer mesh of the same domain."""
    if mesh is f.mesh or mesh.breaks == f.mesh.breaks:
        return type(f).from_forms(f.degree, mesh, f.continuity, f.forms, f.provenance)
    known = dict(zip(f.mesh.breaks[1:-1], f.continuity, strict=True))
    continuity = tuple(known.get(t, SMOOTH) for t in mesh.breaks[1:-1])
    return type(f).from_forms(f.degree, mesh, continuity, _parts(f, mesh), f.provenance)


def _parts(f: Piecewise, mesh: Mesh) -> Iterator[bernstein.Form]:
    for a, b in zip(mesh.breaks, mesh.breaks[1:], strict=False):
        i = f.mesh.locate(a)
        yield bernstein.restrict(f.forms[i], f.degree, f.mesh.local(i, a), f.mesh.local(i, b))


def elevate(f: S, by: int) -> S:
    """Degree raised by multiplying every form with a power of u + v."""
    lift = bernstein.raiser(by)
    return type(f).from_forms(f.degree + by, f.mesh, f.continuity, [(p * lift, k) for p, k in f.forms], f.provenance)


def reduce(f: S, by: int) -> S:
    """Degree lowered by dividing every form by a power of u + v, exactly or not at all."""
    if type(by) is not int or by < 0:
        raise ShapeError(
            f"degree reduction by {shown(by)}", remedy="an integer ≥ 0 (use elevate_degree to raise a degree)"
        )
    if by > f.degree:
        raise ReductionError(f"degree {f.degree} cannot be lowered by {by}", remedy=f"at most by {f.degree}")
    lower, divisor = [], bernstein.raiser(by)
    for i, (p, k) in enumerate(f.forms):
        whole, rest = divmod(p, divisor)
        if not rest:
            lower.append((whole, k))
            continue
        quotient, times = bernstein.divide_u_plus_v(p, by)
        if times < by:
            a, b = f.mesh.breaks[i : i + 2]
            raise ReductionError(
                f"the segment [{text(a)}, {text(b)}] has true degree {f.degree - times}",
                where=f"segment {i}",
                remedy=f"the degree can be lowered to {f.true_degree}, not to {f.degree - by}",
                segment=i,
                true_degree=f.degree - times,
            )
        lower.append((quotient, k))
    n = f.degree - by
    result = type(f).from_forms(n, f.mesh, tuple(min(c, n) for c in f.continuity), lower)
    return _without_smooth_knots(result)


def _without_smooth_knots(f: S) -> S:
    """Merge segments across breakpoints whose nominal continuity reaches the degree: there is no knot left."""
    keep = [i for i, c in enumerate(f.continuity) if c < f.degree]
    if len(keep) == len(f.continuity):
        return f
    starts = [0, *[i + 1 for i in keep]]
    breaks = [f.mesh.breaks[i] for i in starts] + [f.mesh.breaks[-1]]
    merged = [
        bernstein.restrict(f.forms[i], f.degree, mpq(0), f.mesh.local(i, b))
        for i, b in zip(starts, breaks[1:], strict=True)
    ]
    return type(f).from_forms(f.degree, Mesh(breaks), tuple(f.continuity[i] for i in keep), merged)


def _inner(f: Piecewise, t: mpq) -> None:
    a, b = f.domain
    if not a < t < b:
        raise DomainError(
            f"{short_text(t)} is not inside the domain ({text(a)}, {text(b)})",
            remedy="choose a parameter inside the domain",
            parameter=t,
        )


def insert_knot(f: S, t: mpq, times: int) -> S:
    """One more knot (or several) at t; the function does not change."""
    _inner(f, t)
    if type(times) is not int or times < 1:
        raise KnotError(f"{shown(times)} knots to insert", remedy="insert an integer of them, at least one")
    g = over(f, f.mesh if t in f.mesh.breaks else Mesh(sorted([*f.mesh.breaks, t])))
    position = g.mesh.breaks.index(t) - 1
    lowered = min(g.continuity[position], f.degree) - times
    if lowered < -1:
        raise KnotError(
            f"{text(t)} would get multiplicity {f.degree - lowered}",
            remedy=f"at most degree + 1 = {f.degree + 1}",
            knot=t,
        )
    return type(f).from_forms(f.degree, g.mesh, _replaced(g.continuity, position, lowered), g.forms)


def remove_knot(f: S, t: mpq, times: int) -> S:
    """One knot less (or several) at t, when enough derivatives agree there."""
    _inner(f, t)
    multiplicity = max(f.degree - f.continuity[f.mesh.breaks.index(t) - 1], 0) if t in f.mesh.breaks else 0
    if type(times) is not int or not 1 <= times <= multiplicity:
        raise KnotError(
            f"{shown(times)} of {multiplicity} knots at {text(t)} to remove",
            remedy="remove at least one, and no more than there are",
            knot=t,
        )
    position = f.mesh.breaks.index(t) - 1
    wanted, have = f.continuity[position] + times, continuity_at(f, t)
    if have < min(wanted, f.degree):
        jump = f.d(have + 1)
        raise ReductionError(
            f"the derivative of order {have + 1} jumps at {text(t)} by {text(jump(t) - jump(t, 'left'))}",
            remedy=f"{max(have - f.continuity[position], 0)} knots can be removed there",
            knot=t,
            continuity=have,
        )
    return _without_smooth_knots(
        type(f).from_forms(f.degree, f.mesh, _replaced(f.continuity, position, wanted), f.forms)
    )


def _replaced(continuity: tuple[int, ...], position: int, by: int) -> tuple[int, ...]:
    return (*continuity[:position], by, *continuity[position + 1 :])


def continuity_at(f: Piecewise, t: mpq) -> int:
    """Number of derivatives that agree at t, −1 at a jump; the degree where the sides are one polynomial."""
    _inner(f, t)
    if t not in f.mesh.breaks:
        return f.degree
    derivative = f
    for order in range(f.degree + 1):
        if derivative(t) != derivative(t, Side.LEFT):
            return order - 1
        derivative = derivative.d()
    return f.degree


def restricted(f: S, a: mpq, b: mpq) -> S:
    """The part over [a, b]."""
    low, high = f.domain
    if not low <= a < b <= high:
        raise DomainError(
            f"[{text(a)}, {text(b)}] is not part of the domain [{text(low)}, {text(high)}]",
            remedy="give a < b inside the domain",
            domain=f.domain,
        )
    inner = [t for t in f.mesh.breaks if a < t < b]
    known = dict(zip(f.mesh.breaks[1:-1], f.continuity, strict=True))
    mesh = Mesh([a, *inner, b])
    return type(f).from_forms(f.degree, mesh, tuple(known[t] for t in inner), _parts(f, mesh))


def reversed_(f: S) -> S:
    """``t ↦ f(a + b − t)`` on [a, b]."""
    a, b = f.domain
    mesh = Mesh([a + b - t for t in reversed(f.mesh.breaks)])
    return type(f).from_forms(
        f.degree, mesh, f.continuity[::-1], [bernstein.reverse(p, f.degree) for p in reversed(f.forms)]
    )


def reparametrized(f: S, a: mpq, b: mpq) -> S:
    """The affine image of the domain is [a, b]."""
    if not a < b:
        raise DomainError(f"[{text(a)}, {text(b)}] is empty", remedy="give a < b (see reverse)")
    low, high = f.domain
    mesh = Mesh([a + (t - low) * (b - a) / (high - low) for t in f.mesh.breaks])
    return type(f).from_forms(f.degree, mesh, f.continuity, f.forms)
