"""Where the paper is wrong: what is printed, what is true, and how to check it in three lines.

Nothing here is written by hand: the list is made from the claims whose verdict is REFUTED and from those that say,
under the same id, how it must read.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from exactspline.language.services import Displayed
from exactspline.verification.claim import Claim, combined
from exactspline.verification.claims import all_claims
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.kinds import Count, DegreeClaim, Identity, Vanishing
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED
from exactspline.verification.vocabulary import Measure, Parameter, Status


@dataclass(frozen=True)
class Erratum(Displayed):
    """One error of the paper.

    ``error`` joins the statements that fail for one reason; ``quoted`` are the words of the source. ``truth`` lists
    statements with their verdicts; ``check`` is Python that shows that the claim fails.
    """

    id: str
    key: str
    error: str
    quoted: str
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
        if claim.expected == REFUTED and claim.status == Status.PRINTED:
            finding = combined(claim)[1]
            if finding.verdict == REFUTED:
                yield Erratum(
                    claim.id,
                    claim.key,
                    claim.error,
                    claim.words,
                    claim.source,
                    f"{claim.statement}: {claim.claimed}" if isinstance(claim, Count) else claim.statement,
                    finding.witness or finding.computed,
                    _truth(claim),
                    claim.note,
                    check(claim),
                )


def _truth(claim: Claim) -> tuple[str, ...]:
    """What holds instead: the corrected statements of the same error that are decided in the affirmative."""
    found = []
    for other in all_claims():
        if other.paper == claim.paper and other.error == claim.error and other.status == Status.MEANT:
            verdict = combined(other)[1].verdict
            if verdict in (PROVED, VERIFIED):
                counted = f" ({other.claimed})" if isinstance(other, Count) else ""
                found.append(f"{other.statement}{counted} [{verdict}]")
    return tuple(found)


def check(claim: Claim) -> tuple[str, ...]:
    """Three lines of Python that show that the claim fails."""
    d = claim.dimensions[0]
    if isinstance(claim, Identity) and factor_of(claim.find(claim.left), claim.find(claim.right), d) is not None:
        return (
            "from exactspline.verification.generic_proof import factor_of",
            f'factor = factor_of("{claim.left}", "{claim.right}", {d})',
            "print(factor)",
        )
    if isinstance(claim, Vanishing):
        return (
            "from exactspline.symbolic.factorization import jets_for",
            "from exactspline.papers import find",
            f'print(find("{claim.left}")(jets_for(("{claim.left}",), {d})))',
        )
    if isinstance(claim, DegreeClaim) and claim.measure == Measure.LOWEST_TERMS:
        return (
            "from exactspline.verification.generic_degree import lowest_degree",
            "from exactspline.papers import find",
            f'print(lowest_degree(find("{claim.formula}"), {d}))',
        )
    if isinstance(claim, DegreeClaim):
        parameter = f', parameter="{claim.parameter}"' if claim.parameter != Parameter.S else ""
        return (
            "from exactspline.papers import find",
            "from exactspline.readings.degree import degree_argument",
            f'print(find("{claim.formula}")(degree_argument("{claim.find(claim.formula).curve}", {d}, '
            f"polynomial={claim.of == 'polynomial'}{parameter})).degree)",
        )
    if isinstance(claim, Count):
        return (
            "from exactspline.papers import find; from exactspline.splines.examples import example",
            "from exactspline.verification.measure import measure",
            f'print(measure(find("{claim.formula}"), example("{claim.example}")))',
        )
    return (
        "from exactspline.verification.claims import select",
        f'(claim,) = select(["{claim.key}"])',
        "print(claim.refuted_on_examples().witness or claim.prove()[1].witness)",
    )
