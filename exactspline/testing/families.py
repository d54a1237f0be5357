"""The cases: curves whose numbers are doubles, in families, the same for the same version in every run; among them
cases from public bug reports (``reported.json`` beside this file), each with its link: the reported numbers, or a small
curve that shows the same defect.
"""

from __future__ import annotations

import json
import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from importlib.resources import files
from itertools import product
from math import frexp

from exactspline.errors import ExactSplineError
from exactspline.numbers.exact import double, from_float, mpq
from exactspline.numbers.once import cached_property
from exactspline.splines.nurbs import Nurbs


@dataclass(frozen=True)
class Reported:
    """A curve of a bug report: of one segment where no knots are given."""

    key: str
    link: str
    note: str
    points: list[tuple[float, ...]]
    degree: int
    knots: list[float]
    weights: list[float] | None = None
    parameter: float | None = None


def _reported() -> list[Reported]:
    rows = json.loads(files(__package__).joinpath("reported.json").read_text(encoding="utf-8"))
    for row in rows:
        row["points"] = list(map(tuple, row["points"]))
        count = len(row["points"])
        row.setdefault("degree", count - 1)
        row.setdefault("knots", [*[0] * count, *[1] * count])
    return [Reported(**row) for row in rows]


REPORTED: list[Reported] = _reported()


#: Increased whenever a case changes.
VERSION = 1
#: The exponents k of the near-degenerate family.
DIAL = range(2, 53, 2)


@dataclass(frozen=True)
class Case:
    """A curve for questions, a parameter for them, and the origin of the curve."""

    key: str
    family: str
    curve: Nurbs
    parameter: mpq
    link: str = ""
    note: str = ""
    #: ± k for ε = ± 2⁻ᵏ if the curve is near a degenerate one, otherwise 0.
    dial: int = 0

    @cached_property
    def partner(self) -> Nurbs:
        """Another curve, for questions about two; all its numbers are doubles.

        A curve near a degenerate one is moved in x, by about 2⁻ᵏ of its size; the partner of any other curve has the
        same control points in another order: the second, the fourth, …, then the first, the third, ….

        >>> case = next(all_cases(1))
        >>> case.partner.control_points[0] == case.curve.control_points[1]
        True
        """
        curve = self.curve
        if self.dial:
            largest = double(max(abs(x) for point in curve.control_points for x in point))
            step = from_float(2.0 ** (frexp(largest)[1] - 1 - min(abs(self.dial), MOST_MOVED)))
            points = [(x + step, *rest) for x, *rest in curve.control_points]
            return Nurbs(curve.degree, curve.knots, points, curve.weights, name=f"{self.key}, moved")
        order = [*range(1, len(curve.weights), 2), *range(0, len(curve.weights), 2)]
        others, weights = [curve.control_points[i] for i in order], [curve.weights[i] for i in order]
        return Nurbs(curve.degree, curve.knots, others, weights, name=f"{self.key}, in another order")

    @property
    def point(self) -> tuple[mpq, ...]:
        """A point, for questions about a curve and a point: the first control point of the partner."""
        return tuple(self.partner.control_points[0])


#: The largest k of a move, so that no coordinate is rounded.
MOST_MOVED = 48
Row = tuple[float, ...]


def all_cases(limit: int | None = None) -> Iterator[Case]:
    """Every case, or the first `limit` of each family.

    >>> [case.key for case in all_cases(1)]
    ['random 0', 'integers 0', 'fonts 0', 'cad 0', 'near 2 cusp', 'named geomdl-135']
    """
    for name, family in FAMILIES.items():
        for number, case in enumerate(filter(None, family(random.Random(f"{name} {VERSION}")))):
            if number == limit:
                break
            yield case


def made(
    key: str,
    family: str,
    degree: int,
    knots: Sequence[float],
    points: Sequence[Row],
    weights: Sequence[float] | None = None,
    parameter: float | None = None,
    link: str = "",
    note: str = "",
    dial: int = 0,
) -> Case | None:
    """A case made of these doubles, None if they are not a curve; its note gives its dial."""
    try:
        curve = Nurbs.from_floats(degree, knots, points, weights, name=key)
    except ExactSplineError:
        return None
    a, b = curve.domain
    t = from_float(float(parameter)) if parameter is not None else from_float(double(a + (b - a) * mpq(19, 64)))
    note = f"ε = {'−' * (dial < 0)}2⁻ᵏ, k = {abs(dial)}" if dial else note
    return Case(key, family, curve, t, link, note, dial)


def bezier_knots(degree: int) -> list[float]:
    """The knots of one segment on [0, 1]."""
    return [*[0] * (degree + 1), *[1] * (degree + 1)]


def _random(chance: random.Random) -> Iterator[Case | None]:
    for number in range(1500):
        degree, dimension = chance.choice((2, 3, 3, 4)), 3 if number % 4 == 3 else 2
        segments = chance.randint(2, 3) if number % 3 == 2 and degree < 4 else 1
        inner = sorted(chance.random() for _ in range(segments - 1))
        knots = [*[0] * (degree + 1), *inner, *[1] * (degree + 1)]
        points = [tuple(chance.uniform(-1, 1) for _ in range(dimension)) for _ in range(degree + segments)]
        weights = [chance.uniform(1, 3) for _ in points] if number % 5 == 4 else None
        yield made(f"random {number}", "random", degree, knots, points, weights, chance.random())


def _integers(chance: random.Random) -> Iterator[Case | None]:
    """The smallest cases first, so that the first failure is a small example."""

    number = 0
    for size, count in ((1, 300), (2, 500), (4, 700), (9, 300)):
        for _ in range(count):
            degree, dimension = chance.choice((2, 3, 3, 3, 3, 4)), 3 if number % 5 == 4 else 2
            segments = 2 if number % 4 == 3 else 1
            knots = [*[0] * (degree + 1), *range(1, segments), *[segments] * (degree + 1)]
            points = [tuple(chance.randint(-size, size) for _ in range(dimension)) for _ in range(degree + segments)]
            weights = [chance.randint(1, 3) for _ in points] if number % 6 == 5 else None
            t = segments * chance.choice((1, 2, 3, 5, 7)) / 8
            yield made(f"integers {number}", "integers", degree, list(knots), points, weights, t)
            number += 1


def _fonts(chance: random.Random) -> Iterator[Case | None]:
    """Contours and segments as in type design: whole units, points at extremes, smooth joins, serifs."""

    for number in range(700):
        if number % 7 == 6:
            yield _contour(number, chance)
            continue
        x, y = chance.randint(0, 900), chance.randint(-200, 800)
        dx, dy = chance.choice((-1, 1)) * chance.randint(20, 400), chance.choice((-1, 1)) * chance.randint(20, 400)
        if number % 2:
            # a quarter of a bowl, its handles along the axes
            first, second = round(dx * chance.uniform(0.3, 0.9)), round(dy * chance.uniform(0.3, 0.9))
            points: list[Row] = [(x, y), (x + first, y), (x + dx, y + dy - second), (x + dx, y + dy)]
        elif number % 4:
            points = [(x, y), (x + dx, y), (x + dx, y + dy)]
        else:
            # a spine, as of an s
            points = [(x, y), (x + dx, y), (x, y + dy), (x + dx, y + dy + chance.randint(-3, 3))]
        yield made(f"fonts {number}", "fonts", len(points) - 1, bezier_knots(len(points) - 1), points)


def _contour(number: int, chance: random.Random) -> Case | None:
    """A closed bowl of four cubics."""
    cx, cy, a, b = (chance.randint(100, 500) for _ in range(4))
    h, v = round(a * 0.5523), round(b * 0.5523)
    quarter = [(a, 0), (a, v), (h, b), (0, b), (-h, b), (-a, v), (-a, 0), (-a, -v), (-h, -b), (0, -b), (h, -b), (a, -v)]
    points: list[Row] = [(cx + x, cy + y) for x, y in [*quarter, quarter[0]]]
    knots = [*[0] * 4, *[1] * 3, *[2] * 3, *[3] * 3, *[4] * 4]
    return made(f"fonts {number}", "fonts", 3, list(knots), points)


def _cad(chance: random.Random) -> Iterator[Case | None]:
    """Arcs with rounded weights, decimal millimetres far from the origin, uneven knots, higher degrees."""

    for number in range(900):
        kind = number % 3
        x, y = round(chance.uniform(-2000, 2000), 3), round(chance.uniform(-2000, 2000), 3)
        if kind == 0:
            r = round(chance.uniform(0.5, 80), 2)
            points: list[Row] = [(x + r, y), (x + r, y + r), (x, y + r)]
            yield made(f"cad {number}", "cad", 2, bezier_knots(2), points, [1, double(mpq(1, 2)) ** 0.5, 1])
            continue
        degree = chance.choice((3, 3, 3, 5))
        inner = sorted(round(chance.uniform(0.01, 0.99), 4) for _ in range(chance.randint(0, 3)))
        knots = [*[0] * (degree + 1), *inner, *[1] * (degree + 1)]
        count, points = degree + 1 + len(inner), []
        for k in range(count):
            place = (x + 12.7 * k, y + round(chance.uniform(-9, 9), 3))
            points.append(tuple(round(c, 3) for c in (*place, chance.uniform(-3, 3))[: 3 if kind == 2 else 2]))
        yield made(f"cad {number}", "cad", degree, list(knots), points)


#: Curves that are degenerate for ε = 0: then a divisor of a formula vanishes, or a number whose sign matters.
SHAPES: dict[str, Callable[[float], list[Row]]] = {
    # γ′ = 0 at 1/2 for ε = 0
    "cusp": lambda e: [(0, 0), (1, 1), (e, 1), (1, 0)],
    # one inflection, at 1/3, for every ε except 1, for which the curve is a line
    "single inflection": lambda e: [(0, 0), (1, 1), (2, 1 + e), (3, 3)],
    # y touches 0 at 1/2 for ε = 0
    "touching": lambda e: [(0, 1 + e), (1, e - 1), (2, 1 + e)],
    # y has a threefold zero at 1/2 for ε = 0
    "threefold": lambda e: [(0, -1), (1, 1 + e), (2, -1 - e), (3, 1)],
    # a straight line for ε = 0
    "straight": lambda e: [(0, 0), (1, 1 + e), (2, 2), (3, 3)],
    # degree 2 in degree 3 for ε = 0
    "degree": lambda e: [(0, 0), (2, 2 + e), (4, 2), (6, e)],
    # the handle is on the end for ε = 0
    "no handle": lambda e: [(0, 0), (e, e / 2), (1, 2), (3, 0)],
    # x′ = 0 at an end for ε = 0
    "extremum at an end": lambda e: [(0, 0), (e, 1), (2, 2), (3, 1)],
}

#: Shapes that strategies draw and the families do not have.
FURTHER: dict[str, Callable[[float], list[Row]]] = {
    # y″ has a double zero at 1/2 for ε = 0: two inflections for ε < 0, none for ε > 0
    "undulation": lambda e: [(0, 0), (1, 0), (2, 1 + e), (3, 1 + 3 * e), (4, 2 + 6 * e)]
}


def _near(chance: random.Random) -> Iterator[Case | None]:
    """Curves at a distance ε = ±2⁻ᵏ from a degenerate case, in which a formula divides by zero or a sign is zero."""
    for k, (name, shape), sign in product(DIAL, SHAPES.items(), (1, -1)):
        points = [tuple(float(c) for c in point) for point in shape(sign / (1 << k))]
        degree = len(points) - 1
        key = f"near {k} {name}" + ("" if sign > 0 else " −")
        yield made(key, "near", degree, bezier_knots(degree), points, dial=sign * k)


def _named(chance: random.Random) -> Iterator[Case | None]:
    for n in REPORTED:
        yield made(f"named {n.key}", "named", n.degree, n.knots, n.points, n.weights, n.parameter, n.link, n.note)


FAMILIES: dict[str, Callable[[random.Random], Iterator[Case | None]]] = {
    "random": _random,
    "integers": _integers,
    "fonts": _fonts,
    "cad": _cad,
    "near": _near,
    "named": _named,
}
