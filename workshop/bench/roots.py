"""All zeros on [0, 1] of polynomials that the library solves, to a given precision; ours are proved intervals."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import cache
from random import Random
from typing import cast

from flint import acb, ctx, fmpz_poly

from exactspline.papers import find
from exactspline.polynomials.bernstein import substituted
from exactspline.roots.zero_set import zeros
from exactspline.splines.bspline import BSpline
from workshop.bench.inputs import curve
from workshop.bench.row import OURS, Options, Row, Timed, best, compared, installed, missing

ROOTS = "roots"
#: Above this degree sympy and python-flint's complex roots take minutes.
MODERATE = 60


def bernstein(degree: int) -> BSpline:
    """A polynomial with random Bernstein coefficients of 400 bits."""
    chance = Random(degree)
    return BSpline.bezier([chance.randint(-(2**400), 2**400) for _ in range(degree + 1)])


CASES: dict[str, Callable[[], BSpline]] = {
    "f2 of a quartic": lambda: find("f2")(curve(4)),
    "g2 of a cubic": lambda: find("g2")(curve(3)),
    "g2 of a quintic": lambda: find("g2")(curve(5)),
    "a random form": lambda: bernstein(100),
}


@cache
def in_powers(case: str) -> fmpz_poly:
    """The polynomial of a case in powers of t."""
    f = CASES[case]()
    p = substituted(f.numerators[0], f.degree, fmpz_poly([1, -1]), fmpz_poly([0, 1]))
    return p // p.content()


def root_rows(options: Options) -> Iterator[Row]:
    """To 50 digits and to 1000."""
    for case in CASES:
        for digits in (50, 1000):
            yield from _case(case, digits)


def _case(case: str, digits: int) -> Iterator[Row]:
    f = CASES[case]()
    name = f"zeros of {case} (degree {f.degree}), {digits} digits"

    def made() -> BSpline:
        return BSpline.from_forms(f.degree, f.mesh, f.continuity, f.forms)

    def ours(g: object) -> object:
        assert isinstance(g, BSpline)
        return zeros(g).refine(digits)

    timed: dict[str, Timed] = {OURS: (ours, made)}
    if installed("PARI"):
        timed["PARI"] = _pari(case, digits)
    if f.degree <= MODERATE:
        timed["python-flint"] = _flint(case, digits), lambda: None
    took: dict[str, float] = best(timed)
    if f.degree <= MODERATE and digits <= 50:
        took["sympy"] = _sympy(case, digits)
    yield from compared(ROOTS, name, took, {})
    if "PARI" not in timed:
        yield missing(ROOTS, name, "PARI")


def _pari(case: str, digits: int) -> Timed:
    from cypari import pari

    polynomial = pari(str(in_powers(case)))
    return lambda _: polynomial.polrootsreal([0, 1], precision=digits * 10 // 3 + 2), lambda: None


def _flint(case: str, digits: int) -> Callable[[object], object]:
    polynomial = in_powers(case)

    def call(_: object) -> object:
        with ctx.workdps(digits):
            # python-flint's stubs omit the multiplicities
            roots = [found[0] for found in cast(list[tuple[acb, int]], polynomial.complex_roots())]
            return [z for z in roots if z.imag == 0 and 0 <= z.real <= 1]

    return call


IN_SYMPY = """
import sys, json
import sympy
from workshop.bench import roots, row
case, digits = sys.argv[1], int(sys.argv[2])
p = sympy.Poly([int(x) for x in reversed(roots.in_powers(case).coeffs())], sympy.Symbol("t"))
call = lambda _: p.intervals(inf=0, sup=1, eps=sympy.Rational(1, 10**digits))
print(json.dumps(row.best({"sympy": (call, lambda: None)})["sympy"]))
"""


def _sympy(case: str, digits: int) -> float:
    """Milliseconds of sympy's polynomials, in a separate process."""
    done = subprocess.run(
        [sys.executable, "-c", IN_SYMPY, case, str(digits)],
        capture_output=True,
        text=True,
        check=True,
        env=os.environ | {"SYMPY_GROUND_TYPES": "gmpy"},
    )
    return float(json.loads(done.stdout))
