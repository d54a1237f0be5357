"""Claims × readings → verdicts: the ledger."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from time import perf_counter
from typing import Any

from exactspline.errors import ExactSplineError
from exactspline.splines.examples import example, example_names
from exactspline.verification import curve_check, generic_proof
from exactspline.verification.check_arguments import argument
from exactspline.verification.claims import Claim
from exactspline.verification.verdict import UNDECIDED, Finding, Row, row

UNNAMED = "(unnamed curve)"
TABLE = "splines of degrees 2 and 3 over different knots"


def audit(claims: Iterable[Claim], curves: Iterable[Any] | None = None) -> Iterator[Row]:
    """The rows of the ledger, one by one.

    Without curves: every claim decided for all curves, and then checked on every example curve it speaks of. With
    curves: checked on these.

    >>> from exactspline.verification.claims import select
    >>> [(row.reading, row.verdict) for row in audit(select(["C4.1a"]), [example("circle")])]
    [('spline', 'VERIFIED'), ('spline', 'VERIFIED')]
    """
    for task in tasks(claims, curves):
        yield task()


def tasks(claims: Iterable[Claim], curves: Iterable[Any] | None = None) -> list[Any]:
    """The checks to be made, as calls that give a row each: so that progress can be shown."""
    chosen = list(claims)
    concrete = [example(name) for name in example_names()] if curves is None else list(curves)
    calls: list[Any] = []
    if curves is None:
        calls += [lambda claim=claim: proved(claim) for claim in chosen]
        calls += [
            lambda claim=claim: _checked(claim, curve_check.spline_table(), TABLE)
            for claim in chosen
            if claim.curve == "table"
        ]
    for curve in concrete:
        calls += [
            lambda claim=claim, curve=curve: _checked(
                claim, curve, curve.name or UNNAMED, argument(claim.curve, curve)[1]
            )
            for claim in chosen
            if claim.speaks_of(curve.dimension, curve.polynomial)
        ]
    return calls


def proved(claim: Claim) -> Row:
    """A claim decided for all curves."""
    start = perf_counter()
    try:
        reading, finding = generic_proof.prove(claim)
    except ExactSplineError as error:
        reading, finding = "jet", Finding(UNDECIDED, claim.claimed, witness=str(error))
    return row(claim, reading, "", finding, perf_counter() - start)


def _checked(claim: Claim, curve: Any, name: str, beside: str = "") -> Row:
    start = perf_counter()
    try:
        finding = curve_check.check(claim, curve)
    except ExactSplineError as error:
        finding = Finding(UNDECIDED, claim.claimed, witness=str(error))
    return row(claim, f"spline{beside}", name, finding, perf_counter() - start)
