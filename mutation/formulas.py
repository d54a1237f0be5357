"""Mutants of formulas, judged by the ledger alone: the claims that name the formula, or one that calls it.

What no claim refutes is compared with the original: equal in the jets and in naive degrees, for everything that calls
it, means equivalent. Anything else has survived.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

from exactspline.language.formula import Formula
from exactspline.language.kinds import DIMENSIONS
from exactspline.language.parts import split
from exactspline.papers import all_formulas, papers
from exactspline.readings.degree import DegreeReading
from exactspline.readings.differential_order import order_of
from exactspline.readings.rational_jet import RationalJetReading
from exactspline.splines.examples import example
from exactspline.verification.claim import Claim
from exactspline.verification.claim_factor import factor_parts
from exactspline.verification.claims import all_claims
from exactspline.verification.kinds.identity import Identity
from exactspline.verification.ledger import proved, tasks
from exactspline.verification.verdict import Row
from mutation.forked import Result, forked
from mutation.mutants import Mutant, live, mutants

#: What is checked beside the proof for all curves: polynomial ones first, whose splines stay small.
CURVES = ("cubic_s", "twisted_cubic", "rational_cubic", "rational_space_cubic")
#: The place of a function: its module and its name.
Place = tuple[str, str]


def files() -> list[str]:
    """The files of the formulas."""
    return [
        f"exactspline/papers/{source.name}/{module.replace('.', '/')}.py"
        for source in papers()
        for module in source.modules
    ]


def all_mutants() -> list[Mutant]:
    """Every mutant of every formula."""
    return [mutant for file in files() for mutant in mutants(file)]


def home(formula: Formula) -> Place:
    """Where a formula stands."""
    return formula.function.__module__, formula.function.__name__


@cache
def reached(place: Place) -> frozenset[Place]:
    """A function and all those of papers that it calls, directly or not."""
    function = live(*place)
    found, todo = {place}, list(_called(function))
    for other in todo:
        found |= reached(other)
    return frozenset(found)


def _called(function: Any) -> Iterator[Place]:
    codes = [function.__code__]
    for code in codes:
        codes += [c for c in code.co_consts if hasattr(c, "co_names")]
        for name in code.co_names:
            value = function.__globals__.get(name)
            value = value.function if isinstance(value, Formula) else value
            module = getattr(value, "__module__", None) or ""
            if module.startswith("exactspline.papers.") and hasattr(value, "__code__"):
                yield module, value.__name__


def calling(place: Place) -> list[str]:
    """The names of the formulas that reach a function."""
    return [name for name, formula in all_formulas().items() if place in reached(home(formula))]


def speaking(names: list[str]) -> list[Claim]:
    """The claims that name one of these formulas, also in a factor."""
    wanted = set(names) | {name.rpartition(":")[2] for name in names}
    return [c for c in all_claims() if wanted & {*c.named, *_in_factor(c)}]


def _in_factor(claim: Claim) -> list[str]:
    return [name for name, _ in factor_parts(claim.factor)] if isinstance(claim, Identity) else []


def quick(claim: Claim) -> Iterator[Row]:
    """The claim on a few curves; a degree for all curves before, which is only counted."""
    if claim.kind == "degree":
        yield proved(claim)
    for task in tasks([claim], [example(name) for name in CURVES]):
        yield task()


def slow(claim: Claim) -> Iterator[Row]:
    """The claim for all curves: where a mutant takes what cancels away, this may not end."""
    if claim.kind != "degree":
        yield proved(claim)


def _extent(claim: Claim) -> int:
    """How many functions its formulas reach: of a claim with few the numbers stay small."""
    return len(frozenset[Place]().union(*[reached(home(claim.find(name))) for name in claim.named]))


def _baseline(claim: Claim) -> Result:
    found = [*quick(claim), *slow(claim)]
    return {"verdict": "ok", "time": sum(r.seconds for r in found), "as_recorded": [r.as_recorded for r in found]}


def _refuted(claim: Claim, rows: Callable[[Claim], Iterator[Row]]) -> str:
    """What a claim has against the formulas as they are; empty when all is as recorded."""
    try:
        wrong = next((row for row in rows(claim) if not row.as_recorded), None)
        return f"{claim.key} {wrong.curve or 'for all curves'}" if wrong else ""
    except Exception as error:  # the ledger would break off
        return f"{claim.key}: {error!r}"[:200]


def judged(chosen: list[Mutant], seconds: float, jobs: int) -> Iterator[tuple[Mutant, Result]]:
    """The verdict on every mutant: ``killed``, ``equivalent``, ``survived``, ``timeout``, or ``broken`` (the comparison
    with the original failed).
    """
    places = {(mutant.module, mutant.function) for mutant in chosen}
    claims = speaking(sorted({name for place in places for name in calling(place)}))
    times: dict[int, float] = {}
    for i, result in forked(range(len(claims)), lambda i: _baseline(claims[i]), seconds, jobs):
        if result["verdict"] == "ok" and all(result["as_recorded"]):
            times[id(claims[i])] = result["time"]

    def work(mutant: Mutant) -> Result:
        place = mutant.module, mutant.function
        names = calling(place)
        chosen_claims = sorted((c for c in speaking(names) if id(c) in times), key=lambda c: (_extent(c), times[id(c)]))
        original = live(*place).__code__
        mutant.apply()
        for made in (quick, slow):
            if told := next(filter(None, (_refuted(claim, made) for claim in chosen_claims)), ""):
                return {"verdict": "killed", "by": told}
        changed, live(*place).__code__ = live(*place).__code__, original
        before = list(_meanings(names, place))
        live(*place).__code__ = changed
        return {"verdict": "equivalent" if _same(before, list(_meanings(names, place))) else "survived"}

    yield from forked(chosen, work, seconds, jobs)


def _meanings(names: list[str], place: Place) -> Iterator[tuple[str, Any]]:
    """The naive degrees of formulas, and what they are in the jets: of those nearest to a function only, where it has
    no meaning of its own.
    """
    own = [name for name in names if home(all_formulas()[name]) == place]
    for name in names:
        formula = all_formulas()[name]
        for dimension in DIMENSIONS[formula.curve]:
            for polynomial in () if formula.kind.adjoins_roots else (False, True):
                for parameter in ("s", "s̄") if formula.curve == "pair" else ("s",):
                    reading = DegreeReading(parameter=parameter)
                    c = reading.argument(formula.kind, dimension, polynomial=polynomial)
                    yield name, _text(formula(c).degree)
            if name in own or not own:
                c = RationalJetReading(order_of(formula, dimension)).argument(formula.kind, dimension)
                yield name, _jets(formula(c))


def _text(degree: Any) -> str:
    return str(degree)


def _jets(value: Any) -> list[tuple[str, str]]:
    parts, denominator = split(value)
    return [
        (str(x.top), str(x.bottom)) if hasattr(x, "top") else (repr(x), "")
        for x in ([*parts] if denominator is None else [*parts, denominator])
    ]


def _same(before: list[tuple[str, Any]], after: list[tuple[str, Any]]) -> bool:
    return before == after
