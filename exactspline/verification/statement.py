"""A claim written out: the statement as text and as LaTeX, its naive and its reduced side with their degrees, the
factor, the verdict.

Nothing is written by hand: formulas, degrees and verdict are computed from the claim.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import chain

from exactspline.errors import InapplicableError
from exactspline.hooks import Displayed
from exactspline.language.formula import Formula
from exactspline.language.kinds import TABLE
from exactspline.language.operand import Counting, Parameter
from exactspline.one_line import OneLine, one_line
from exactspline.papers import find
from exactspline.readings.degree import Degree, DegreeReading
from exactspline.readings.printing import Operation, print_latex, print_text, symbol_text
from exactspline.readings.tree import Node, nodes, trace
from exactspline.symbolic.factorization import Factor, named_by, naming_formulas
from exactspline.verification.claim import Claim
from exactspline.verification.claims import select
from exactspline.verification.combined import combined
from exactspline.verification.generic_proof import degree_in_table_1
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.verdict import NOT_ASKED, Finding
from exactspline.verification.vocabulary import Name, Reason, Scope

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


def letters_of_factor(claim: Claim, finding: Finding) -> tuple[Definition, ...]:
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
    return Side(
        role,
        name,
        formula.source,
        f"{shown} = {print_text(tree)}",
        f"{claim.symbol(name)} = {print_latex(tree)}",
        *degrees,
    )


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
