"""Claims written out: the statement as text and as LaTeX, its naive and its reduced side with their degrees, the
factor, the verdict. Nothing is written by hand: formulas, degrees and verdict are computed from the claim.

Errors of a paper: the printed statement, the corrected statement, the reason, and a check in three lines of Python. The
list is generated from the printed claims whose verdict is REFUTED, grouped by error, and from the claims that state the
corrections.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from itertools import chain

from exactspline.errors import ClaimError, InapplicableError, as_items
from exactspline.hooks import Displayed
from exactspline.language.formula import Formula
from exactspline.language.kinds import TABLE, kind_of
from exactspline.language.operand import Counting, Parameter
from exactspline.one_line import OneLine, one_line
from exactspline.papers import Paper, default_papers, find, known_as
from exactspline.readings.degree import Degree, DegreeReading
from exactspline.readings.printing import Operation, print_latex, print_text, symbol_text
from exactspline.readings.tree import Node, nodes, trace
from exactspline.symbolic.factorization import Factor, named_by, naming_formulas
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of, select
from exactspline.verification.combined import combined
from exactspline.verification.evidence import Evidence, Found, Relating, StatedFactor
from exactspline.verification.generic_proof import degree_in_table_1, factor_of
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity, Vanishing
from exactspline.verification.kinds.examples import Count
from exactspline.verification.ledger import error_of
from exactspline.verification.notation import WEIGHTS, factor_parts
from exactspline.verification.verdict import NOT_ASKED, PROVED, REFUTED, VERIFIED, Finding
from exactspline.verification.vocabulary import Extent, Measure, Name, Reason, Scope, Status, Verdict

NAIVE, REDUCED = "naive", "reduced"
#: The parts of a formula that are explained: formulas that it calls, roots, the parameter along a line.
DEFINED = (Operation.NAMED, Operation.LEAF, Operation.RULED)


@dataclass(frozen=True, repr=False)
class Side(OneLine):
    """One formula of a claim: its role, its name and source, its text and LaTeX, its degree for a rational
    and a polynomial curve.
    """

    role: str
    name: str
    source: str
    text: str
    latex: str
    rational: str
    polynomial: str

    @property
    def degrees(self) -> str:
        """Both degrees in one line."""
        return self.rational if self.rational == self.polynomial else f"{self.rational} (polynomial: {self.polynomial})"


@dataclass(frozen=True, repr=False)
class Definition(OneLine):
    """The meaning of a letter in the formulas of a claim, as text and as LaTeX."""

    text: str
    latex: str


#: The roots that are adjoined to curves with frames, and the parameter of ruled surfaces.
ROOTS = {
    "sigma": Definition("σ = ‖γ′‖", r"\sigma = \|\gamma'\|"),
    "rho": Definition("ρ = ‖γ′ × γ″‖", r"\rho = \|\gamma' \times \gamma''\|"),
}
PARAMETER = Definition("ζ runs along the line", r"\zeta \in \mathbb{R}")


@dataclass(frozen=True)
class Statement(Displayed):
    """A claim with its sides, the letters that these contain, and its verdict for all curves."""

    claim: Claim
    latex: str
    sides: tuple[Side, ...]
    defined: tuple[Definition, ...]
    reading: Name
    finding: Finding

    @one_line
    def __repr__(self) -> str:
        return f"<Statement {self.claim.key}: {self.finding.verdict}>"

    @property
    def as_recorded(self) -> bool:
        """Whether the verdict is the recorded one."""
        return self.finding.verdict == self.claim.expected

    @property
    def differs(self) -> bool:
        """Whether the verdict contradicts the record. UNDECIDED because of the cost and NOT ASKED do not contradict
        it.
        """
        return not (self.as_recorded or self.finding.reason == Reason.COST or self.finding.verdict == NOT_ASKED)


def statements(claim_id: str) -> Iterator[Statement]:
    """Return the statements of the claims whose ids are this id or begin with this id, each decided anew.

    >>> [(s.sides[0].name, s.sides[-1].name, str(s.finding.factor)) for s in statements("C4.1a")]
    [('f1', 'f2', 'w'), ('f0', 'f2', 'w⁻³')]

    Raises `ClaimError`, with the existing ids, for an unknown id.
    """
    return (statement(claim) for claim in select([claim_id]))


def statement(claim: Claim) -> Statement:
    """A claim written out, with its combined verdict: the proof, compared with the example curves."""
    return stated(claim, *combined(claim))


def stated(claim: Claim, reading: Name, finding: Finding) -> Statement:
    """A claim written out, with a finding for all curves."""
    return Statement(claim, claim.latex, sides(claim), definitions(claim, finding), reading, finding)


def sides(claim: Claim) -> tuple[Side, ...]:
    """The formulas of a claim. If it compares several, the formula of the highest degree is the naive side, and that of
    the lowest degree the reduced side. A claim without formulas has no sides.
    """
    names = dict.fromkeys(claim.named)
    if not names:
        return ()
    ranked = sorted(names, key=lambda name: -degree_of_cubic(name, claim))
    first, last = degree_of_cubic(ranked[0], claim), degree_of_cubic(ranked[-1], claim)
    roles = {ranked[0]: NAIVE, ranked[-1]: REDUCED} if first != last else {}
    return tuple(_side(name, roles.get(name, "formula"), claim) for name in ranked)


def definitions(claim: Claim, finding: Finding) -> tuple[Definition, ...]:
    """The meanings of the letters in the formulas of a claim, in the factor that was found, and in these meanings
    themselves.

    >>> sorted(each.text for each in statement(select(["C4.1a"])[0]).defined)
    ['D1 = p′ w − p w′', 'D2 = p″ w − p w″']
    """
    own = [_tree(name, claim) for name in dict.fromkeys(claim.named)]
    named: dict[str, Definition | None] = {symbol_text(claim.shown(name)): None for name in claim.named}
    return (*_defined([*own, *_trees_of_factor(claim, finding)], named), *_velocity(claim, finding))


def _letters_of_factor(claim: Claim, finding: Finding) -> tuple[Definition, ...]:
    """The meanings of the letters in the factor that was found."""
    return (*_defined(_trees_of_factor(claim, finding), {}), *_velocity(claim, finding))


def _velocity(claim: Claim, finding: Finding) -> Iterator[Definition]:
    """The formula of γ′ in terms of D1, if the formulas of a claim contain γ′ and the factor that was found contains
    D1.
    """
    parts = [*chain.from_iterable(nodes(_tree(name, claim)) for name in dict.fromkeys(claim.named))]
    factor = [*chain.from_iterable(map(nodes, _trees_of_factor(claim, finding)))]
    own, new = ({print_text(node) for node in each} for each in (parts, factor))
    if "γ′" in own and "D1" in new - own:
        velocity = trace(find("velocity_shared"), claim.dimensions[0])
        yield Definition(f"γ′ = {print_text(velocity)}", rf"\gamma' = {print_latex(velocity)}")


def _trees_of_factor(claim: Claim, finding: Finding) -> list[Node]:
    if not isinstance(claim, Identity) or not isinstance(finding.factor, Factor):
        return []
    with named_by(claim.source_paper):
        return [trace(each, dimension_of(each, claim)) for each in naming_formulas(finding.factor)]


def _defined(trees: list[Node], found: dict[str, Definition | None]) -> tuple[Definition, ...]:
    """The definitions of the letters in some trees, except of those that are `found` already."""
    for node in chain.from_iterable(map(nodes, trees)):
        if node.op not in DEFINED:
            continue
        text = print_text(node)
        if node.op is Operation.LEAF:
            found.setdefault(text, ROOTS.get(str(node.value)))
        elif node.op is Operation.RULED:
            found.setdefault("ζ", PARAMETER)
        elif (meaning := print_text(body := node.args[0])) != text:
            found.setdefault(text, Definition(f"{text} = {meaning}", f"{print_latex(node)} = {print_latex(body)}"))
    return tuple(each for each in found.values() if each)


def _tree(name: str, claim: Claim) -> Node:
    formula = claim.find(name)
    return telling_tree(formula, dimension_of(formula, claim))


def _side(name: str, role: str, claim: Claim) -> Side:
    formula = claim.find(name)
    tree = _tree(name, claim)
    shown = symbol_text(claim.shown(name)) or name
    degrees = [_degrees(name, claim, polynomial) for polynomial in (False, True)]
    written = f"{shown} = {print_text(tree)}", f"{claim.symbol(name)} = {print_latex(tree)}"
    return Side(role, name, formula.source, *written, *degrees)


def dimension_of(formula: Formula, claim: Claim) -> int:
    """The dimension in which a formula is read: the claim's, if the formula is defined in it, otherwise the
    formula's.
    """
    own = formula.kind.dimensions
    return claim.dimensions[0] if claim.dimensions[0] in own else own[0]


def _degrees(name: str, claim: Claim, polynomial: bool) -> str:
    """The degree of a formula, for surfaces in each parameter."""
    parameters = (claim.parameter,) if isinstance(claim, DegreeClaim) else claim.find(name).kind.counted
    degrees = [_degree(name, claim, polynomial, parameter) for parameter in parameters]
    return ", ".join("–" if degree is None else str(degree) for degree in degrees) or "–"


def _degree(name: str, claim: Claim, polynomial: bool, parameter: Parameter) -> Degree | None:
    """The degree of a formula; None for a formula over roots and for a function that is given by an equation."""
    formula = claim.find(name)
    counting = claim.counting if isinstance(claim, DegreeClaim) else Counting.TABLE_1
    if formula.kind is TABLE:
        return degree_in_table_1(formula)
    if formula.kind.adjoins_roots:
        return None
    return _represented(formula, dimension_of(formula, claim), polynomial, parameter, counting)


@cache
def _represented(
    formula: Formula, dimension: int, polynomial: bool, parameter: Parameter, counting: Counting
) -> Degree | None:
    """The degree that a formula has as written, computed once for all claims about it."""
    try:
        return DegreeReading("d", parameter, counting).count(formula, dimension, polynomial=polynomial)
    except InapplicableError:
        return None


def degree_of_cubic(name: str, claim: Claim) -> int:
    """The represented degree of a side on a curve of degree 3."""
    parameter = next(iter(claim.find(name).kind.counted), Parameter.FIRST)
    degree = _degree(name, claim, claim.of == Scope.POLYNOMIAL, parameter)
    return 0 if degree is None else degree.at(dict.fromkeys(degree.names, 3))


def telling_tree(formula: Formula, dimension: int) -> Node:
    """The tree of a formula. If the tree only repeats the symbol (as for the derivative of a named formula), the names
    in it are expanded.

    >>> telling_tree(find("curvature_squared_derivative"), 2)
    ([γ′ γ″]²/(‖γ′‖²)³)′
    """
    tree = trace(formula, dimension)
    repeats = formula.symbol and print_text(tree) == symbol_text(formula.symbol)
    return trace(formula, dimension, expand=True) if repeats else tree


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
    where = tuple(each.text for each in _letters_of_factor(claim, finding))
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
