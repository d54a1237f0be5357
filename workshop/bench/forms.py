"""Forms of one segment and of many: our times compared with inline code over other polynomials; growth with degree,
segments and bits.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import product
from math import inf
from typing import Any, cast

from flint import fmpz_poly

from exactspline.errors import counted
from exactspline.language.arguments import Pair
from exactspline.language.formula import Formula
from exactspline.papers import find
from exactspline.programs import evaluated
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import surface_pair
from workshop.bench import inline
from workshop.bench.inputs import curve, forms
from workshop.bench.peers import FractionPoly, powers
from workshop.bench.row import OURS, Options, Row, Timed, best, compared

FORMS, GROWTH = "forms", "growth"
INLINE, SYMPY, ON_FLINT, FRACTION = "python-flint inline", "sympy", "sympy on FLINT", "Fraction"
#: The inline versions, by the name of the formula.
BY_HAND: dict[str, Callable[..., Any]] = {"f2": inline.f2, "g2": inline.g2, "vertices_lifted": inline.vertices}
#: Our time on integers at hand at most twice that of python-flint inline; sympy at least ten times ours on one segment,
#: thirty times with ten or more.
TWICE, TENTH, THIRTIETH = Fraction(2), Fraction(1, 10), Fraction(1, 30)
SEGMENTS = (1, 10)
DEGREES, MANY, BITS = (2, 3, 5, 8, 12), (1, 10, 100, 1000), (10, 100, 1000, 10_000)


def form_rows(options: Options) -> Iterator[Row]:
    """f2, g2 and the lifted vertex form of rational cubics, torsion, and the bisector of two cubics."""
    for name, segments in product(BY_HAND, SEGMENTS):
        c = curve(3, segments)
        yield from _form(options, name, c, f"{name}, rational cubic, {counted(segments, 'segment')}", with_peers=True)
    yield from _torsion()
    yield from _bisector()


def growth_rows(options: Options) -> Iterator[Row]:
    """g2 by degree, by segments, by bits."""
    for degree in DEGREES:
        yield from _form(options, "g2", curve(degree), f"g2 by degree: {degree}", section=GROWTH)
    for segments in MANY:
        yield from _form(options, "g2", curve(3, segments), f"g2 by segments: {segments}", section=GROWTH)
    for bits in BITS:
        yield from _form(options, "g2", curve(3, bits=bits), f"g2 by bits: {bits}", section=GROWTH)


def _afresh(formula: Formula, c: Nurbs) -> Timed:
    """A formula on a newly constructed curve, without any memoized values."""

    def call(made: object) -> object:
        assert isinstance(made, Nurbs)
        return evaluated(formula, made)

    return call, lambda: Nurbs(c.degree, c.knots, c.control_points, c.weights)


def _form(
    options: Options, name: str, c: Nurbs, case: str, *, section: str = FORMS, with_peers: bool = False
) -> Iterator[Row]:
    by_hand, segments = BY_HAND[name], list(forms(c))

    def flint(_: object) -> list[fmpz_poly]:
        return [by_hand(*row, c.degree, inline.form_derivative) for row, _ in segments]

    timed: dict[str, Timed] = {OURS: _afresh(find(name), c), INLINE: (flint, lambda: None)}
    if with_peers:
        rows = [[FractionPoly(p) for p in row] for row in powers(c)]
        timed[FRACTION] = (
            lambda _: [by_hand(*row, c.degree, lambda p, n: p.derivative()) for row in rows],
            lambda: None,
        )
    took: dict[str, float] = best(timed)
    targets: dict[str, Fraction] = {}
    if with_peers:
        for _ in range(TURNS):
            for who in GROUNDS:
                took[who] = min(_sympy(who, name, c.degree, c.segments), took.get(who, inf))
            took[OURS] = min(best({OURS: timed[OURS]})[OURS], took[OURS])
        targets[SYMPY] = TENTH if c.segments == 1 else THIRTIETH
    yield from compared(section, case, took, targets)
    if section == FORMS:
        yield from _in_two(find(name), c, case, (flint, lambda: None))


def _in_two(formula: Formula, c: Nurbs, case: str, flint: Timed) -> Iterator[Row]:
    """The integers of a new curve apart from the formula on them."""
    call, new = _afresh(formula, c)

    def converted() -> object:
        made = new()
        list(forms(cast(Nurbs, made)))
        return made

    conversion: dict[str, Timed] = {OURS: (lambda made: list(forms(cast(Nurbs, made))), new)}
    evaluation: dict[str, Timed] = {OURS: (call, converted), INLINE: flint}
    yield from compared(FORMS, f"{case}: its integers alone", best(conversion), {})
    yield from compared(FORMS, f"{case}: on these integers", best(evaluation), {INLINE: TWICE})


#: How often our runs alternate with sympy's, since the load of a machine changes from minute to minute.
TURNS = 3
#: sympy's polynomials, and those that it delegates to FLINT (chosen when sympy is first imported); with the library's
#: formulas, and with inline code.
GROUNDS = {SYMPY: "gmpy", ON_FLINT: "flint", "sympy inline": "gmpy", "sympy on FLINT inline": "flint"}
IN_SYMPY = """
import json, sys
from workshop.bench import forms, inputs, peers, row
name, degree, segments = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
c, by_hand, formula = inputs.curve(degree, segments), forms.BY_HAND[name], forms.find(name)
rows, arguments = peers.sympy_polys(c), peers.sympy_arguments(c)
if sys.argv[4] == "inline":
    call = lambda _: [by_hand(*each, degree, lambda p, n: p.diff()) for each in rows]
else:
    call = lambda _: [formula(type(each)(each.p, each.w)) for each in arguments]
print(json.dumps(row.best({"sympy": (call, lambda: None)})["sympy"]))
"""


def _sympy(who: str, name: str, degree: int, segments: int) -> float:
    """Milliseconds over sympy's polynomials, in a separate process."""
    how = "inline" if who.endswith("inline") else "formulas"
    done = subprocess.run(
        [sys.executable, "-c", IN_SYMPY, name, str(degree), str(segments), how],
        capture_output=True,
        text=True,
        check=True,
        env=os.environ | {"SYMPY_GROUND_TYPES": GROUNDS[who]},
    )
    return float(json.loads(done.stdout))


def _torsion() -> Iterator[Row]:
    c = curve(3, dimension=3)
    ((*p, w), _), *_ = forms(c)
    took = best(
        {
            OURS: _afresh(find("torsion_reduced"), c),
            INLINE: (lambda _: inline.torsion(p, w, c.degree, inline.form_derivative), lambda: None),
        }
    )
    yield from compared(FORMS, "torsion, rational cubic, 1 segment", took, {INLINE: TWICE})


#: Packing stride: room for degree 11 in the first of two parameters packed into one polynomial.
STRIDE = 12


def packed_bisector(one: Nurbs, two: Nurbs) -> list[tuple[list[fmpz_poly], fmpz_poly]]:
    """The symmetric bisector of two cubics, all patches, the second parameter a power of the first."""
    rows = [inline.one_parameter(x, y, z, w, one.degree, inline.form_derivative) for (x, y, z, w), _ in forms(one)]
    columns = [
        [p.inflate(STRIDE) for p in inline.one_parameter(x, y, z, w, two.degree, inline.form_derivative)]
        for (x, y, z, w), _ in forms(two)
    ]
    return [inline.bisector_patch(row, column) for row, column in product(rows, columns)]


def _bisector() -> Iterator[Row]:
    one, two = curve(3, dimension=3, seed=1), curve(3, dimension=3, seed=2)
    formula = find("bisector_symmetric")

    def prepare() -> object:
        return surface_pair(*[Nurbs(c.degree, c.knots, c.control_points, c.weights) for c in (one, two)])

    def by_hand(_: object) -> object:
        return packed_bisector(one, two)

    def ours(pair: object) -> object:
        assert isinstance(pair, Pair)
        return evaluated(formula, pair)

    took = best({OURS: (ours, prepare), INLINE: (by_hand, lambda: None)})
    yield from compared(FORMS, "bisector of two rational cubics, 1 × 1 segments", took, {INLINE: TWICE})
