"""The line or the plane of solutions of one pair of parameters: exact, or in balls."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Flag, auto
from typing import Any, Generic, TypeVar

from flint import arb, ctx, fmpz_mpoly

from exactspline.geometry.bisectors.system import System
from exactspline.language.vector import Vector, cross, dot, norm2
from exactspline.numbers.exact import mpq, primitive
from exactspline.one_line import OneLine
from exactspline.polynomials.two_parameters import enclosed, lifted
from exactspline.roots.of_polynomials import Parameter, ball

Number = TypeVar("Number", mpq, arb)


class Conditions(Flag):
    """The effective planes of the system: a curve without a tangent has no normal plane."""

    FIRST = auto()
    SECOND = auto()
    MIDDLE = auto()


ALL = Conditions.FIRST | Conditions.SECOND | Conditions.MIDDLE


@dataclass(frozen=True, repr=False)
class Flat(OneLine, Generic[Number]):
    """A point, and the direction of a line through it or the normal of a plane; where it is exact, coprime integers."""

    point: tuple[Number, ...]
    direction: tuple[Number, ...]


def flat_at(system: System, s: mpq, t: mpq, conditions: Conditions, *, plane: bool) -> Flat[mpq]:
    """The solutions of a pair of rational parameters whose rank is known."""

    def value(p: fmpz_mpoly) -> mpq:
        return mpq(sum((int(x) * s ** int(i) * t ** int(j) for (i, j), x in p.terms()), mpq(0)))

    found = _flat(system, value, conditions, plane)
    return Flat(found.point, primitive(found.direction))


def enclosed_flat(
    system: System, s: Parameter, t: Parameter, conditions: Conditions, digits: int, *, plane: bool
) -> Flat[arb]:
    """The solutions of a pair of parameters whose rank is known, in balls."""
    with ctx.workprec(8 * digits + 128):
        balls = ball(s, digits + 10), ball(t, digits + 10)
        return _flat(system, lambda p: enclosed(p, *balls), conditions, plane)


def _flat(system: System, value: Any, conditions: Conditions, plane: bool) -> Flat[Any]:
    a, b, e = (Vector(*[value(x) for x in v]) for v in (system.a, system.b, system.chord))
    rows = [
        (condition, v, h)
        for condition, v, h in (
            (Conditions.FIRST, a, value(lifted(system.first.w, 0)) * 0),
            (Conditions.SECOND, b, dot(b, e)),
            (Conditions.MIDDLE, Vector(*[x * 2 for x in e]), norm2(e)),
        )
        if condition in conditions
    ]
    w, weight = value(lifted(system.first.w, 0)), value(system.weight)
    foot = [value(lifted(f, 0)) / w for f in system.first.p]
    if plane:
        _, normal, height = max(rows, key=lambda row: _size(norm2(row[1])))
        offset = [height * x / (norm2(normal) * weight) for x in normal]
        return Flat(_sum(foot, offset), tuple(normal))
    pairs = [(one, other) for i, one in enumerate(rows) for other in rows[:i]]
    (_, r, h), (_, q, k) = max(pairs, key=lambda pair: _size(norm2(cross(pair[0][1], pair[1][1]))))
    n = cross(r, q)
    below = norm2(n) * weight
    offset = [(h * x + k * y) / below for x, y in zip(cross(q, n), cross(n, r), strict=True)]
    return Flat(_sum(foot, offset), tuple(n))


def _sum(one: Any, other: Any) -> tuple[Any, ...]:
    return tuple(x + y for x, y in zip(one, other, strict=True))


def _size(x: Any) -> Any:
    """The key for choosing among several normals: any nonzero one is right, so that a rounded size is enough."""
    return x.lower() if isinstance(x, arb) else x
