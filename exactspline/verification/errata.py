"""Where the paper is wrong: what is printed, what is true, and how to check it in three lines.

Nothing here is written by hand: the list is made from the claims whose verdict is REFUTED and from those that say,
under the same id, how it must read.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from exactspline.language.services import Displayed
from exactspline.papers import find
from exactspline.verification.claims import Claim, all_claims
from exactspline.verification.generic_proof import dimensions, factor_of, prove
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED


@dataclass(frozen=True)
class Erratum(Displayed):
    """One error of the paper.

    ``truth`` lists statements with their verdicts; ``check`` is Python that prints what ``shows`` says.
    """

    id: str
    where: str
    printed: str
    found: str
    truth: tuple[str, ...]
    why: str
    check: tuple[str, ...]


def errata() -> Iterator[Erratum]:
    """The errors of the paper, in its order, each decided anew.

    >>> [e.id for e in errata()][:2]
    ['C3c', 'C3f']
    """
    for claim in all_claims():
        if claim.expected == REFUTED:
            finding = prove(claim)[1]
            if finding.verdict == REFUTED:
                yield Erratum(
                    claim.id,
                    claim.source,
                    _printed(claim),
                    finding.witness or finding.computed,
                    _truth(claim),
                    claim.note,
                    check(claim),
                )


def _printed(claim: Claim) -> str:
    return f"{claim.statement}: {claim.claimed}" if claim.kind == "count" else claim.statement


def _truth(claim: Claim) -> tuple[str, ...]:
    """What holds instead: the corrected statements of the same id that are decided in the affirmative."""
    found = []
    for other in all_claims():
        if other.id == claim.id and other.as_meant and (other.formula == claim.formula or claim.kind != "count"):
            verdict = prove(other)[1].verdict
            if verdict in (PROVED, VERIFIED):
                computed = f" ({other.claimed})" if other.kind == "count" else ""
                found.append(f"{other.statement}{computed} [{verdict}]")
    return tuple(found)


def check(claim: Claim) -> tuple[str, ...]:
    """Three lines of Python that show that the claim fails."""
    d = dimensions(claim)[0]
    if claim.kind == "identity" and factor_of(claim.left, claim.right, d) is not None:
        return (
            "from exactspline.verification.generic_proof import factor_of",
            f'factor = factor_of("{claim.left}", "{claim.right}", {d})',
            "print(factor)",
        )
    if claim.kind == "vanishing":
        return (
            "from exactspline.symbolic.factorization import jets_for",
            "from exactspline.papers import find",
            f'print(find("{claim.left}")(jets_for(("{claim.left}",), {d})))',
        )
    if claim.kind == "degree" and claim.measure == "lowest terms":
        return (
            "from exactspline.verification.generic_degree import lowest_degree",
            "from exactspline.papers import find",
            f'print(lowest_degree(find("{claim.formula}"), {d}))',
        )
    if claim.kind == "degree":
        parameter = f', parameter="{claim.parameter}"' if claim.parameter != "s" else ""
        return (
            "from exactspline.papers import find",
            "from exactspline.readings.degree import degree_argument",
            f'print(find("{claim.formula}")(degree_argument("{find(claim.formula).curve}", {d}, '
            f"polynomial={claim.of == 'polynomial'}{parameter})).degree)",
        )
    if claim.kind == "count":
        return (
            "from exactspline.papers import find; from exactspline.splines.examples import example",
            "from exactspline.verification.measure import measure",
            f'print(measure(find("{claim.formula}"), example("{claim.example}")))',
        )
    return (
        "from exactspline.verification.claims import select",
        "from exactspline.verification.generic_proof import prove",
        f'print(*[prove(c)[1].witness for c in select(["{claim.id}"])], sep="\\n")',
    )
