"""Mutants of formulas, judged by the ledger alone, that is by the claims that name the formula, or one that calls it.

A mutant that no claim refutes is compared with the original: if all formulas that call it are equal in the jets and in
naive degrees, it is equivalent. Any other has survived.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from random import Random
from typing import Any

from exactspline.errors import FormulaError, InapplicableError
from exactspline.interchange.examples import example
from exactspline.language.adjoined_root import Adjoined
from exactspline.language.arguments import Symbol
from exactspline.language.formula import Formula
from exactspline.language.kinds import kind_of
from exactspline.language.ruled import split
from exactspline.language.surface_kind import BOTH
from exactspline.numbers.exact import mpq
from exactspline.papers import papers
from exactspline.readings.degree import DegreeReading
from exactspline.readings.differential_order import order_of, orders
from exactspline.readings.jet import RationalJetReading
from exactspline.readings.taylor import DoubleSeries
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_in
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.ledger import Row, decide, tasks
from exactspline.verification.notation import WEIGHTS, factor_of_text, factor_parts
from exactspline.verification.paper_curves import own_curves
from exactspline.verification.vocabulary import Scope, Verdict
from workshop.mutation.forked import Result, forked
from workshop.mutation.mutants import Mutant, live, mutants

#: The curves on which claims are checked in addition to the proof for all curves: polynomial ones first, whose splines
#: stay small.
CURVES = ("cubic_s", "twisted_cubic", "rational_cubic", "rational_space_cubic")
#: The number of derivatives of a surface that get random values.
TERMS = 6
#: The place of a function: its module and its name.
Place = tuple[str, str]


def files() -> list[str]:
    """The files of the formulas."""
    return [f"{source.package}.{module}".replace(".", "/") + ".py" for source in papers() for module in source.modules]


def all_mutants() -> list[Mutant]:
    """Every mutant of every formula."""
    return [mutant for file in files() for mutant in mutants(file)]


def home(formula: Formula) -> Place:
    """The module and the name of a formula."""
    return formula.function.__module__, formula.function.__name__


@cache
def reached(place: Place) -> frozenset[Place]:
    """A function and all those of papers that it calls, directly or not."""
    function = live(*place)
    places, todo = {place}, list(_called(function))
    for other in todo:
        places |= reached(other)
    return frozenset(places)


def _called(function: Any) -> Iterator[Place]:
    codes = [function.__code__]
    for code in codes:
        codes += [c for c in code.co_consts if hasattr(c, "co_names")]
        for name in code.co_names:
            value = function.__globals__.get(name)
            value = value.function if isinstance(value, Formula) else value
            module = getattr(value, "__module__", None) or ""
            if module.startswith(("exactspline.papers.", "exactspline.formulas.")) and hasattr(value, "__code__"):
                yield module, value.__name__


@cache
def every_formula() -> tuple[Formula, ...]:
    """The formulas of all papers that come with the library."""
    return tuple(formula for source in papers() for formula in source.formulas.values())


def calling(place: Place) -> list[Formula]:
    """The formulas that reach a function."""
    return [formula for formula in every_formula() if place in reached(home(formula))]


def spoken_of(claim: Claim) -> list[Formula]:
    """The formulas that a claim names, including those in a factor and in its assumptions."""
    factor = getattr(claim, "factor", "")
    in_factor = (
        [name for name, _ in factor_parts(factor) if name[0].isalpha() and name not in WEIGHTS] if factor else []
    )
    known = claim.source_paper, *claim.source_paper.uses
    stated = [re.split(" [≠≢] ", each.name)[0] for each in claim.assumes]
    assumed = [name for name in stated if any(name in source.formulas for source in known)]
    return [claim.find(name) for name in (*claim.named, *in_factor, *assumed)]


@cache
def _reached_by(claim: Claim) -> frozenset[Place]:
    return frozenset[Place]().union(*[reached(home(formula)) for formula in spoken_of(claim)])


def speaking(places: Iterable[Place]) -> list[Claim]:
    """The claims of all papers about a formula that reaches one of these functions."""
    requested = frozenset(places)
    return [claim for claim in claims_in(papers()) if requested & _reached_by(claim)]


def quick(claim: Claim) -> Iterator[Row]:
    """The claim on a few curves; before that, a degree for all curves, which is only counted."""
    if claim.kind == "degree":
        yield decide(claim)
    for task in tasks([claim], list(own_curves(claim.source_paper).values()) or [example(name) for name in CURVES]):
        yield task()


def slow(claim: Claim) -> Iterator[Row]:
    """The claim for all curves: where a mutant removes a cancellation, this may not end."""
    if claim.kind != "degree":
        yield decide(claim)


def wrong_at_a_point(claim: Claim) -> str:
    """How an identity fails with random numbers for the derivatives of a surface at a point; this is fast even for
    products that are too large for polynomials. Empty where the identity holds, or the claim is of another kind.
    """
    kind = kind_of(claim.curve)
    if not isinstance(claim, Identity) or {s.parameters for s in kind.symbols(kind.dimensions[0])} != {BOTH}:
        return ""
    random = Random(claim.key)
    places = [(i, j) for i in range(TERMS) for j in range(TERMS - i)]

    def operand(_: Symbol) -> DoubleSeries:
        return DoubleSeries({place: mpq(random.randint(1, 9)) for place in places}, TERMS)

    one, polynomial = DoubleSeries({(0, 0): mpq(1)}, TERMS), claim.of is Scope.POLYNOMIAL
    c = kind.argument(kind.dimensions[0], operand, one, polynomial=polynomial)
    try:
        left, right = (split(claim.find(name)(c))[0] for name in (claim.left, claim.right))
        top, bottom = factor_of_text(claim.factor, c, claim.find)
        wrong = any((x * bottom - y * top).value for x, y in zip(left, right, strict=True))
    except FormulaError:  # a divisor vanishes here
        return ""
    except Exception as error:  # the ledger would fail
        return f"{claim.key}: {error!r}"[:200]
    return f"{claim.key} at a point" if wrong else ""


def _extent(claim: Claim) -> int:
    """How many functions its formulas reach: for a claim with few of them the numbers stay small."""
    return len(_reached_by(claim))


def _baseline(claim: Claim) -> Result:
    found = [*quick(claim), *slow(claim)]
    return {"verdict": "ok", "time": sum(r.seconds for r in found), "as_recorded": [r.as_recorded for r in found]}


def refuted(claim: Claim, rows: Callable[[Claim], Iterator[Row]]) -> str:
    """How a claim fails with the current formulas; empty when everything is as recorded."""
    try:
        wrong = next((row for row in rows(claim) if not row.as_recorded), None)
        return f"{claim.key} {wrong.curve or 'for all curves'}" if wrong else ""
    except Exception as error:  # the ledger would fail
        return f"{claim.key}: {error!r}"[:200]


def judged(chosen: list[Mutant], seconds: float, jobs: int) -> Iterator[tuple[Mutant, Result]]:
    """The verdict on every mutant: ``killed``, ``equivalent``, ``survived``, ``timeout``, or ``broken`` (the comparison
    with the original failed).
    """
    places = {(mutant.module, mutant.function) for mutant in chosen}
    claims = speaking(places)
    times: dict[int, float] = {}
    for i, result in forked(range(len(claims)), lambda i: _baseline(claims[i]), seconds, jobs):
        if result["verdict"] == "ok" and all(result["as_recorded"]):
            times[id(claims[i])] = result["time"]

    sound = {claim for claim in claims if claim.expected == Verdict.PROVED and not wrong_at_a_point(claim)}

    def work(mutant: Mutant) -> Result:
        place = mutant.module, mutant.function
        mine = (claim for claim in speaking([place]) if id(claim) in times)
        chosen_claims = sorted(mine, key=lambda c: (_extent(c), times[id(c)]))
        original = live(*place).__code__
        mutant.apply()
        if refutation := next(filter(None, map(wrong_at_a_point, filter(sound.__contains__, chosen_claims))), ""):
            return {"verdict": "killed", "by": refutation}
        for made in (quick, slow):
            if refutation := next(filter(None, (refuted(claim, made) for claim in chosen_claims)), ""):
                return {"verdict": "killed", "by": refutation}
        changed, live(*place).__code__ = live(*place).__code__, original
        orders.cache_clear()  # the order of a changed formula, which may be lower
        before = list(_meanings(place))
        live(*place).__code__ = changed
        orders.cache_clear()
        return {"verdict": "equivalent" if before == list(_meanings(place)) else "survived"}

    yield from forked(chosen, work, seconds, jobs)


def _meanings(place: Place) -> Iterator[tuple[str, Any]]:
    """The naive degrees of formulas, and their values in the jets; for a function that is not itself a formula, of the
    formulas that call it most directly.
    """
    formulas = calling(place)
    formulas_here = [formula for formula in formulas if home(formula) == place]
    for formula in formulas:
        for dimension in formula.kind.dimensions:
            for polynomial in () if formula.kind.adjoins_roots else (False, True):
                yield formula.name, degrees_counted(formula, dimension, polynomial)
            if formula in formulas_here or not formulas_here:
                c = RationalJetReading(order_of(formula, dimension)).argument(formula.kind, dimension)
                yield formula.name, [in_the_jets(part) for part in split(formula(c))[0]]


def degrees_counted(formula: Formula, dimension: int, polynomial: bool) -> list[str]:
    """The degrees counted as in Table 1, in each parameter; empty where a value depending on an argument has
    no degree.
    """
    degrees = []
    symbols = formula.kind.symbols(dimension, polynomial=polynomial)
    for parameter in dict.fromkeys(each for symbol in symbols for each in symbol.parameters):
        try:
            c = DegreeReading(parameter=parameter).argument(formula.kind, dimension, polynomial=polynomial)
        except InapplicableError:
            return []
        degrees.append(str(formula(c).degree))
    return degrees


def in_the_jets(x: Any) -> Any:
    """What two parts have alike exactly if they are one function of the derivatives, written alike."""
    if isinstance(x, Adjoined):
        return [in_the_jets(part) for part in (x.plain, x.rooted, x.square)]
    return str(x.top), str(x.bottom)
