"""Errors of a paper: the printed statement, the corrected statement, the reason, and a check in three lines of Python.
The list is generated from the printed claims whose verdict is REFUTED, grouped by error, and from the claims that state
the corrections.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from exactspline.errors import ClaimError, as_items
from exactspline.hooks import Displayed
from exactspline.language.kinds import kind_of
from exactspline.language.operand import Counting, Parameter
from exactspline.one_line import OneLine, one_line
from exactspline.papers import Paper, default_papers, known_as
from exactspline.readings.printing import symbol_text
from exactspline.symbolic.factorization import Factor
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of
from exactspline.verification.combined import combined
from exactspline.verification.evidence import Evidence, Found, Relating, StatedFactor
from exactspline.verification.generic_proof import factor_of
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity, Vanishing
from exactspline.verification.kinds.examples import Count
from exactspline.verification.ledger import error_of
from exactspline.verification.notation import WEIGHTS, factor_parts
from exactspline.verification.statement import letters_of_factor
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED, Finding
from exactspline.verification.vocabulary import Extent, Measure, Name, Scope, Status, Verdict


@dataclass(frozen=True)
class Refuted:
    """A statement that fails: the verbatim words and their place, the claimed and the computed value, the witness, and
    Python code that shows the failure. `where` explains the letters of the factor that was found.
    """

    id: str
    key: str
    place: str
    words: str
    statement: str
    claimed: str
    found: Found | None
    witness: Evidence | None
    check: tuple[str, ...]
    where: tuple[str, ...]

    @one_line
    def __repr__(self) -> str:
        return f"<Refuted {self.id}: {self.statement}>"


@dataclass(frozen=True, repr=False)
class Holds(OneLine):
    """A corrected statement: the key of its claim, and its verdict."""

    key: str
    statement: str
    verdict: Verdict

    def __str__(self) -> str:
        return f"{self.statement} [{self.verdict}]"


@dataclass(frozen=True)
class Erratum(Displayed):
    """One error of a paper: the statements that fail for one reason, and the corrected statements with their
    verdicts.
    """

    paper: str
    error: str
    title: str
    statements: tuple[Refuted, ...]
    truth: tuple[Holds, ...]
    why: tuple[str, ...]

    @one_line
    def __repr__(self) -> str:
        return f"<Erratum {self.id}: {self.title}>"

    @property
    def id(self) -> str:
        """The id of the claim to which the first of its statements belongs."""
        return self.statements[0].id


def errata(sources: Iterable[Paper] | None = None) -> tuple[Erratum, ...]:
    """Return the errors of these papers (by default of the default papers), in the order of each paper, with claims
    decided anew.

    >>> first, *others = errata()
    >>> first.error, [each.id for each in first.statements], len(others)
    ('span', ['C3c'], 18)
    """
    return tuple(_joined(Status.PRINTED, sources))


def remarks(sources: Iterable[Paper] | None = None) -> tuple[Erratum, ...]:
    """Misreadings, in the form of errors: statements that fail although no paper makes them.

    >>> [each.error for each in remarks()]
    ['replacement', 'second-parameter', 'tilted-plane']
    """
    return tuple(_joined(Status.OURS, sources))


def _joined(status: Status, sources: Iterable[Paper] | None) -> Iterator[Erratum]:
    """The statements of one status that fail, grouped by error."""
    for source in default_papers() if sources is None else as_items(sources, "papers"):
        claims = claims_of(source)
        for error, title in source.errors.items():
            own = [claim for claim in claims if claim.error == error]
            fails = [claim for claim in own if claim.status == status and claim.expected == REFUTED]
            refuted = tuple(found for claim in fails if (found := _refuted(claim)))
            if refuted:
                why = tuple(dict.fromkeys(claim.note for claim in fails if claim.note))
                yield Erratum(source.name, error, title, refuted, _truth(own), why)
        if not source.default:
            printed = status == Status.PRINTED
            yield from unrecorded(claim for claim in claims if (claim.status == Status.PRINTED) == printed)


def unrecorded(claims: Iterable[Claim]) -> Iterator[Erratum]:
    """Unrecorded failures: each statement is a separate error."""
    for claim in claims:
        unknown = claim.expected != REFUTED or claim.status == Status.PRINTED
        if not claim.error and unknown and (found := _refuted(claim)):
            why = (claim.note,) if claim.note else ()
            yield Erratum(claim.paper, error_of(claim), claim.statement, (found,), (), why)


def left_open(sources: Iterable[Paper]) -> Iterator[tuple[Claim, Verdict]]:
    """The undecided claims of the papers all of whose claims `errata` decides, with their verdicts.

    >>> from exactspline.papers import named_papers
    >>> list(left_open(named_papers(["levien_parallel_curves"])))
    []
    """
    for claim in (each for source in sources if not source.default for each in claims_of(source)):
        verdict = combined(claim)[1].verdict
        if verdict not in (PROVED, VERIFIED, REFUTED):
            yield claim, verdict


def _refuted(claim: Claim) -> Refuted | None:
    finding = combined(claim)[1]
    if finding.verdict != REFUTED:
        return None
    place = ", ".join(dict.fromkeys(part for part in (claim.source, claim.place.split(",")[0]) if part))
    relation = true_relation(claim, finding)
    computed, witness = (relation, None) if relation else (finding.computed, finding.witness)
    where = tuple(each.text for each in letters_of_factor(claim, finding))
    return Refuted(
        claim.id, claim.key, place, claim.words, numbered(claim), claim.claims, computed, witness, check(claim), where
    )


def true_relation(claim: Claim, finding: Finding) -> Relating | None:
    """The true relation between the two sides of an identity; None if no factor is known."""
    factor = finding.factor
    if not isinstance(claim, Identity) or not isinstance(factor, Factor | StatedFactor):
        return None
    if claim.on == Extent.CURVE and finding.verdict == REFUTED:  # the factor is the claimed one
        return None
    return Relating(symbol_or_name(claim, claim.left), factor, symbol_or_name(claim, claim.right))


def claimed_relation(claim: Identity) -> Relating:
    """The relation between the two sides that an identity claims."""
    powers = tuple((_symbol(claim, name), exponent) for name, exponent in factor_parts(claim.factor))
    return Relating(symbol_or_name(claim, claim.left), StatedFactor(powers), symbol_or_name(claim, claim.right))


def _symbol(claim: Claim, name: str) -> Name:
    plain = name in (*WEIGHTS, *kind_of(claim.curve).constants) or not name[0].isalpha()
    return Name(name) if plain else symbol_or_name(claim, name)


def symbol_or_name(claim: Claim, formula: str) -> Name:
    """A formula of a claim by its symbol, or by its name if the symbol is ambiguous."""
    symbol = claim.shown(formula)
    return Name(symbol_text(symbol) if symbol else formula)


def _truth(claims: list[Claim]) -> tuple[Holds, ...]:
    """The corrected statements of an error that are proved or verified."""
    decided = [(claim, combined(claim)[1].verdict) for claim in claims if claim.status == Status.MEANT]
    return tuple(
        Holds(claim.key, numbered(claim), verdict) for claim, verdict in decided if verdict in (PROVED, VERIFIED)
    )


def numbered(claim: Claim) -> str:
    """A statement with the number that it claims.

    >>> from exactspline.verification.claims import select
    >>> numbered(select(["Fig1-g0"])[0])
    'g0 of a cubic of six segments: degree 6, 24 control points'
    """
    said = isinstance(claim, (Count, DegreeClaim)) and claim.claims not in claim.statement
    return f"{claim.statement}: {claim.claims}" if said else claim.statement


def _has_factor(claim: Identity, dimension: int) -> bool:
    """Whether one side is the other side times a product of powers. False if roots are adjoined or the right side
    vanishes.
    """
    try:
        alone = not kind_of(claim.curve).adjoins_roots
        return alone and factor_of(claim.find(claim.left), claim.find(claim.right), dimension) is not None
    except ClaimError:
        return False


#: The imports of the checks.
FACTOR = "from exactspline.verification.generic_proof import factor_of"
JETS = "from exactspline.symbolic.factorization import jets_for"
LOWEST = "from exactspline.verification.generic_proof import lowest_degree"
NOMINAL = "from exactspline.readings.degree import DegreeReading"
#: The functions that count a degree, by its measure; other degrees are shown by their claim.
DEGREES = {
    (Measure.NOMINAL, Parameter.FIRST, Counting.TABLE_1): (NOMINAL, "DegreeReading().count"),
    (Measure.LOWEST_TERMS, Parameter.FIRST, Counting.TABLE_1): (LOWEST, "lowest_degree"),
}


def check(claim: Claim) -> tuple[str, ...]:
    """A few lines of Python that show that the claim fails. Each printing line names the printed value: lines that
    occur in the checks of several claims (those that import) are written only once.
    """
    return (*_loading(claim.source_paper), *_shown(claim))


def _loading(source: Paper) -> tuple[str, ...]:
    """The lines that load a user's folder; none for a paper of the library. Names chosen by others are quoted."""
    if source.package:
        return ()
    trust = ", trust=True" if source.trusted else ""
    return ("import exactspline", f"paper = exactspline.paper({str(source.folder)!r}{trust})")


def _shown(claim: Claim) -> tuple[str, ...]:
    d, source = claim.dimensions[0], claim.source_paper

    def found(formula: str) -> str:
        """A formula by the name that `find` knows, or from the loaded folder."""
        known = repr(known_as(claim.find(formula))).replace("'", '"')
        return f"find({known})" if source.package else f"paper.find({formula!r})"

    finding = ("from exactspline.papers import find",) if source.package else ()
    curves = f"{d}, polynomial=True" if claim.of == Scope.POLYNOMIAL else f"{d}"
    if isinstance(claim, Identity) and claim.on == Extent.ALL and _has_factor(claim, d):
        loading, shown = FACTOR, f"factor_of({found(claim.left)}, {found(claim.right)}, {curves})"
    elif isinstance(claim, Vanishing) and claim.on == Extent.ALL:
        loading, shown = JETS, f"{found(claim.left)}(jets_for(({found(claim.left)},), {curves}))"
    elif isinstance(claim, DegreeClaim) and claim.on == Extent.ALL and _counted(claim) in DEGREES:
        loading, degree = DEGREES[_counted(claim)]
        shown = f"{degree}({found(claim.formula)}, {curves})"
    else:
        chosen = repr(source.name).replace("'", '"') if source.package else "paper"
        return (
            "from exactspline.verification.claims import claims_of",
            f"(claim,) = [each for each in claims_of({chosen}) if each.key == {claim.key!r}]; "
            "print(claim.refuted_on_examples().witness or claim.prove()[1].witness)",
        )
    return (*finding, loading, f"print({shown})")


def _counted(claim: DegreeClaim) -> tuple[Measure, Parameter, Counting]:
    return claim.measure, claim.parameter, claim.counting
