"""The base of all claims, and how their fields are read and checked."""

from __future__ import annotations

import re
from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import MISSING, Field, dataclass, field, fields, replace
from enum import StrEnum
from string import Template
from typing import Any, ClassVar, NamedTuple, TypeVar, dataclass_transform

from exactspline.errors import ClaimError, ExactSplineError, FormulaError, ReachError, VanishingDivisorError
from exactspline.hooks import Displayed
from exactspline.language.arguments import Evaluated, Operands
from exactspline.language.formula import Formula, constant_formula
from exactspline.language.kinds import HodographKind, Kind, PairKind, TableKind, kind_of
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.numbers.exact import mpq, rational, text
from exactspline.numbers.once import Immutable
from exactspline.one_line import one_line
from exactspline.papers import Paper, paper_named
from exactspline.readings.differential_order import order_of
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.symbolic.assumptions import ASSUMPTIONS, Assumption, assumption, stated_assumption
from exactspline.symbolic.factorization import sharing
from exactspline.verification import phrases as say
from exactspline.verification.decision import Statement
from exactspline.verification.evaluation import Evaluation, evaluation, free_operands, on_segments, too_long
from exactspline.verification.evidence import Evidence, Fact, OnExample
from exactspline.verification.notation import WEIGHTS, spelled
from exactspline.verification.one_function import expect_functions, expect_functions_on
from exactspline.verification.paper_curves import check_curve_name, curve_named, curve_names, one_patch_surfaces
from exactspline.verification.verdict import (
    CONTRADICTION,
    NOT_ASKED,
    PROVED,
    REFUTED,
    UNDECIDED,
    VACUOUS,
    VERIFIED,
    Finding,
    inapplicable,
    left,
    sampled,
    undecided,
    vacuous,
    worst_case,
)
from exactspline.verification.vocabulary import ArgumentKind, Extent, Name, Scope, Status, Verdict, word

K = TypeVar("K")


@dataclass_transform(kw_only_default=True, frozen_default=True, eq_default=False, field_specifiers=(field,))
def claim_kind(kind: type[K]) -> type[K]:
    """Declare a kind of claims: a dataclass with named fields, whose methods are inherited from `Claim` (generating
    them for each kind would take longer than reading all its claims).
    """
    return dataclass(init=False, repr=False, eq=False, kw_only=True)(kind)


class _Declared(NamedTuple):
    """Data about the dataclass of a kind of claims: the reader of each field (None for a text) and its default; the
    fields compared by equality; the fields that an entry may have; the fields that it must have; and the values of all
    others.
    """

    checks: tuple[tuple[str, Callable[..., object] | None, object], ...]
    compared: tuple[str, ...]
    entries: dict[str, Field[object]]
    needed: tuple[str, ...]
    defaults: dict[str, object]


_DECLARED: dict[type, _Declared] = {}


def declared(kind: type) -> _Declared:
    """The fields of a kind of claims.

    >>> from exactspline.verification.kinds.equality import Vanishing
    >>> declared(Vanishing).needed
    ('id', 'source', 'statement', 'status', 'key', 'left')
    """
    if kind not in _DECLARED:
        _DECLARED[kind] = _sorted_out(fields(kind))
    return _DECLARED[kind]


def _sorted_out(own: tuple[Field[object], ...]) -> _Declared:
    entries = {f.name: f for f in own if f.name != "paper"}
    return _Declared(
        checks=tuple((f.name, f.metadata.get("check"), f.default) for f in own),
        compared=tuple(f.name for f in own if f.compare),
        entries=entries,
        needed=tuple(name for name, f in entries.items() if f.default is MISSING),
        defaults={f.name: f.default for f in own if f.default is not MISSING},
    )


E = TypeVar("E", bound=StrEnum)
V = TypeVar("V")


def read(check: Callable[[Claim, str, V], object]) -> dict[str, object]:
    """The metadata of a field that is not free text: `check` reads its value, or raises `ClaimError`."""
    return {"check": check}


def one_of(kind: type[E]) -> Callable[[Claim, str, object], E]:
    """A word of an enumeration."""
    return lambda claim, name, value: word(kind, value, name)


def _recorded(claim: Claim, name: str, value: object) -> Verdict:
    """A verdict that can be recorded. CONTRADICTION cannot: it shows an error of this library. NOT ASKED cannot either:
    such statements are a kind of claims of their own.
    """
    verdict = word(Verdict, value, name)
    if verdict == NOT_ASKED:
        raise ClaimError("what is not asked has no verdict", where=name, remedy='write kind = "not asked", and why')
    if verdict == CONTRADICTION:
        raise ClaimError(
            "a contradiction as the recorded verdict", where=name, remedy="one of two routes is wrong: report this"
        )
    return verdict


def formula_name(claim: Claim, name: str, value: str) -> Name:
    """The name of a formula that applies to the arguments of the claim."""
    if value in WEIGHTS:
        raise ClaimError(
            f"a formula called {value!r}, which is a denominator in factors", where=name, remedy="give it another name"
        )
    formula, handed = claim.find(value), claim.kind_of_field(name)
    if value in {s.name for n in handed.dimensions for s in handed.symbols(n) if not s.parameters}:
        problem = f"a formula called {value!r}, which is a constant of {claim.curve!r}: a factor could mean either"
        raise ClaimError(problem, where=name, remedy="give it another name")
    if not all(handed.takes(formula.kind, n) for n in handed.dimensions):
        raise ClaimError(
            f"the formula {value!r} takes arguments of the kind {formula.curve!r}, the claim is about {claim.curve!r}",
            where=name,
            remedy=f"name a formula that takes a {handed.name!r}",
        )
    return Name(str(value))


def any_formula(claim: Claim, name: str, value: str) -> str:
    """The name of a formula with any kind of argument."""
    claim.find(value)
    return str(value)


def formula_names(claim: Claim, name: str, value: Iterable[str]) -> tuple[Name, ...]:
    """Several names of formulas."""
    return tuple(formula_name(claim, name, each) for each in value)


def _kind_name(claim: Claim, name: str, value: str) -> str:
    """The name of a kind of argument."""
    try:
        return kind_of(str(value)).name
    except FormulaError as error:
        raise ClaimError(error.problem, where=name, remedy=error.remedy) from None


def example_name(claim: Claim, name: str, value: str) -> str:
    """The name of an example curve to which the claim applies; empty for none."""
    if value:
        try:
            check_curve_name(claim.source_paper, value)
        except ClaimError as error:
            raise ClaimError(error.problem, where=name, remedy=error.remedy) from None
    return str(value)


def _example_list(claim: Claim, name: str, value: Iterable[str]) -> tuple[str, ...]:
    """Several names of example curves."""
    return tuple(example_name(claim, name, each) for each in value)


def _assumption_list(claim: Claim, name: str, value: Iterable[str | Assumption]) -> tuple[Assumption, ...]:
    """Assumptions by their names, each about the arguments of the claim."""
    assumptions = tuple(each if isinstance(each, Assumption) else _assumed(claim, each) for each in value)
    for each in assumptions:
        if claim.curve != ArgumentKind.TABLE and not each.applies_to(kind_of(claim.curve)):
            problem = f"the assumption {each.name!r} does not apply to {str(claim.curve)!r}"
            raise ClaimError(problem, where=name, remedy=f"it is about {', '.join(map(repr, each.kinds))}")
    return assumptions


def _assumed(claim: Claim, text: str) -> Assumption:
    """An assumption of the library, or one that the author states: a formula of the paper, or a constant, has no zero
    (``f ≠ 0``), or vanishes on no whole segment (``f ≢ 0``).
    """
    name, sign, zero = text.partition(" ≠ ") if " ≠ " in text else text.partition(" ≢ ")
    if text in ASSUMPTIONS or zero != "0":
        return assumption(text)
    kind = kind_of(claim.curve)
    constants = {s.name for s in kind.symbols(kind.dimensions[0]) if not s.parameters}
    if name not in constants:
        formula_name(claim, "assumes", name)
    return stated_assumption(text, name if name in constants else claim.find(name), kind, "≠" in sign)


#: The largest count that a claim may state.
LARGEST = 1000


def count_from(least: int) -> Callable[[Claim, str, object], int]:
    """An integer with a lower bound."""

    def check(claim: Claim, name: str, value: object) -> int:
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= LARGEST:
            raise ClaimError(f"{value!r} is not a number ≥ {least} and ≤ {LARGEST}", where=name, remedy="an integer")
        return value

    return check


def number(claim: Claim, name: str, value: int | str) -> mpq:
    """A number, exactly as written: ``"1/3"``, ``5.76`` (a decimal of a table is read as text)."""
    return rational(value)


def numbers(claim: Claim, name: str, value: tuple[int | str, ...] | int | str) -> tuple[mpq, ...]:
    """One number, exactly as written, or several."""
    return tuple(number(claim, name, each) for each in (value if isinstance(value, tuple) else (value,)))


def _identifier(claim: Claim, name: str, value: str) -> str:
    """A key: the id of the claim without spaces and dots, and words after hyphens."""
    begin = claim.begin_of_key
    if not (value.startswith(begin) and re.fullmatch(r"(-[\w′]+)+", value[len(begin) :])):
        raise ClaimError(
            f"the key {value!r} does not begin with the id", where=name, remedy=f"write for example {begin + '-a'!r}"
        )
    return str(value)


@claim_kind
class Claim(Immutable, Displayed):
    """One checkable statement.

    ``key`` is its name, unique in its paper; ``id`` that of the claim to which it belongs. ``words`` are the verbatim
    words of the source and ``place`` is their place in it, ``section`` the one under which the claim is listed (by
    default its source). ``curve`` is the kind of its arguments, ``of`` states whether it is about polynomial curves,
    rational ones or both. ``assumes`` are assumptions of `exactspline.symbolic.assumptions`; ``context`` explains the
    letters in words. ``error`` groups the statements that fail for one reason. ``witness`` is the example curve that is
    tried first as a counterexample, and ``vacuous`` lists the example curves on which there is nothing to decide.
    ``on = "curve"`` makes it a claim about one curve only, the ``example``; it holds if it is VERIFIED.

    Raises `ClaimError` for a word, a name or a combination without meaning.
    """

    kind: ClassVar[str] = ""
    reading: ClassVar[Name] = Name("jet")
    #: The claimed value, and the statement in LaTeX: ``$name`` is the value of a field, in LaTeX the symbol of a
    #: formula.
    value: ClassVar[str] = ""
    notation: ClassVar[str] = ""
    #: The fields that name two formulas, which must be different ones.
    sides: ClassVar[tuple[str, ...]] = ()
    #: Whether such claims are about a single curve, and not about pairs or the operands of Table 1 of the paper.
    of_one_curve: ClassVar[bool] = False
    #: Whether such claims can be decided where roots are adjoined.
    of_frames: ClassVar[bool] = False
    #: Whether such claims are decided by zeros or signs of functions of one parameter.
    asks_for_zeros: ClassVar[bool] = False
    #: Whether `examine` decides for all arguments with the given curve, and not only for the given one.
    tries_all: ClassVar[bool] = False
    #: Whether the formulas are evaluated before a check, to see that they exist on the whole curve.
    evaluated_first: ClassVar[bool] = True

    paper: str
    id: str
    source: str
    statement: str
    status: Status = field(metadata=read(one_of(Status)))
    curve: str = field(default="curve", metadata=read(_kind_name))
    of: Scope = field(default=Scope.BOTH, metadata=read(one_of(Scope)))
    key: str = field(metadata=read(_identifier))
    words: str = ""
    place: str = ""
    section: str = ""
    error: str = ""
    assumes: tuple[Assumption, ...] = field(default=(), metadata=read(_assumption_list))
    context: str = ""
    expected: Verdict = field(default=Verdict.PROVED, metadata=read(_recorded))
    witness: str = field(default="", metadata=read(example_name))
    vacuous: tuple[str, ...] = field(default=(), metadata=read(_example_list))
    on: Extent = field(default=Extent.ALL, metadata=read(one_of(Extent)))
    example: str = field(default="", metadata=read(example_name))
    note: str = field(default="", compare=False)

    def __init__(self, **values: object) -> None:
        own, given = declared(type(self)), vars(self)
        if wrong := [*(values.keys() - own.entries.keys() - {"paper"}), *({"paper", *own.needed} - values.keys())]:
            raise TypeError(f"{type(self).__name__}: {', '.join(sorted(wrong))} unknown or missing")
        given |= own.defaults
        given |= values
        for name, check, default in own.checks:
            value = given[name]
            if value is default:
                continue
            if check is not None:
                given[name] = check(self, name, value)
            elif not isinstance(value, str):
                raise ClaimError(f"{value!r} is not a text", where=name, remedy="write a text")
            elif not value.replace("\n", "").isprintable():
                raise ClaimError("a text that cannot be printed", where=name, remedy="remove control characters")
        self._validate_common()
        self._validate_example()
        self.validate()

    def __eq__(self, other: object) -> bool:
        """Whether all fields except notes are equal."""
        return self is other or (
            type(other) is type(self)
            and all(getattr(self, name) == getattr(other, name) for name in declared(type(self)).compared)
        )

    def __hash__(self) -> int:
        return hash((self.paper, self.key))

    @one_line
    def __repr__(self) -> str:
        return f"<claim {self.key} of {self.paper}>"

    def _validate_common(self) -> None:
        if self.status == Status.PRINTED and not (self.words or self.place):
            raise ClaimError(
                "a printed claim has neither words nor a place", where="words", remedy="quote what is printed"
            )
        # in one's own paper each is an error of its own
        refuted, own = self.expected == REFUTED, not self.source_paper.package
        if self.status == Status.PRINTED and (bool(self.error) > refuted or refuted > bool(self.error or own)):
            problem = "a printed claim belongs to an error exactly if it is refuted"
            raise ClaimError(problem, where="error", remedy="name the error, or omit the field")

        if self.sides and len({getattr(self, name) for name in self.sides}) < len(self.sides):
            raise ClaimError("both sides are one formula", where=self.sides[-1], remedy="name another one")
        if self.of_one_curve and (self.of_pair or self.curve == ArgumentKind.TABLE):
            problem = f"claims of the kind {self.kind!r} are not decided for {str(self.curve)!r}"
            raise ClaimError(problem, where="curve", remedy="name a curve")
        if kind_of(self.curve).adjoins_roots and not self.of_frames:
            problem = f"claims of the kind {self.kind!r} are not decided where roots are adjoined"
            raise ClaimError(problem, where="curve", remedy="splines and degrees have no roots: state an identity")

    def _validate_example(self) -> None:
        """A claim about one curve names one to which it applies, and is VERIFIED where it holds."""
        if (self.on == Extent.CURVE) != bool(self.example):
            problem = 'on = "curve" and example = "NAME" belong together'
            raise ClaimError(problem, where="example", remedy="write both, or none")
        if not self.example:
            return
        curve, kind = self.curve_named(self.example), kind_of(self.curve)
        decidable = kind.made_of_a_curve and not (isinstance(kind, TableKind | HodographKind) or kind.adjoins_roots)
        if not decidable or curve.dimension not in self.dimensions or curve.polynomial not in self.of.worlds:
            problem = f"{self.example!r} is not a curve to which the claim applies"
            raise ClaimError(problem, where="example", remedy="name another one (none gives a hodograph or a frame)")
        if self.expected == PROVED:
            vars(self)["expected"] = VERIFIED

    def validate(self) -> None:
        """Refuse combinations without meaning, with `ClaimError`."""

    @property
    def begin_of_key(self) -> str:
        """The id in the form used in keys."""
        return re.sub(r"[ .]+", "", self.id)

    @property
    def named(self) -> tuple[Name, ...]:
        """The names of the formulas of the claim."""
        chosen: list[Name] = []
        for name, check, _ in declared(self.__class__).checks:
            if check in (formula_name, formula_names):
                value = getattr(self, name)
                chosen += [Name(value)] if isinstance(value, str) else value
        return tuple(name for name in chosen if name)

    def kind_of_field(self, name: str) -> Kind:
        """The kind of argument of the formula in that field."""
        return kind_of(self.curve)

    @property
    def source_paper(self) -> Paper:
        """The paper that makes the claim."""
        return paper_named(self.paper)

    def find(self, name: str) -> Formula:
        """A formula of the claim's paper, or of one that this paper uses."""
        return self.source_paper.find(name)

    def find_in_factor(self, name: str) -> Formula:
        """A constant of the arguments, or such a formula."""
        kind = kind_of(self.curve)
        return constant_formula(kind, name) if name in kind.constants else self.find(name)

    def curve_named(self, name: str) -> Nurbs:
        """A curve of the claim's paper, or an example."""
        return curve_named(self.source_paper, name)

    @property
    def of_pair(self) -> bool:
        """Whether the claim is about two curves."""
        return isinstance(kind_of(self.curve), PairKind)

    def shown(self, name: str) -> str:
        """The symbol of a formula; empty if the formula has no symbol, or if another formula of the claim has the same
        symbol.
        """
        own = self.find(name).symbol
        others = (self.find(other).symbol for other in self.named if other != name)
        return "" if own in others else own

    def symbol(self, name: str) -> str:
        """The LaTeX name of a formula of its paper."""
        return self.shown(name) or spelled(name)

    @property
    def assumed(self) -> str:
        """Context and assumptions in words."""
        polynomial = ["polynomial: w = 1"] if self.of == Scope.POLYNOMIAL else []
        context = [self.context] if self.context else []
        interval = getattr(self, "interval", ())
        part = f"[{', '.join(map(text, interval))}] of " if interval else ""
        curve = [f"on {part}the curve {self.example}"] if self.example else []
        return "; ".join([*context, *polynomial, *[each.words for each in self.assumes], *curve])

    @property
    def dimensions(self) -> tuple[int, ...]:
        """The dimensions to which the claim applies."""
        return kind_of(self.curve).dimensions

    def applies_to(self, dimension: int, polynomial: bool, *, surface: bool = False) -> bool:
        """Whether the claim applies to single curves (or surfaces) of that dimension and kind. Claims with adjoined
        roots do not: splines have no roots.
        """
        kind = kind_of(self.curve)
        made = kind.made_of_a_surface if surface else kind.made_of_a_curve
        decidable = self.curve != ArgumentKind.TABLE and not kind.adjoins_roots and made and self.on == Extent.ALL
        return decidable and dimension in self.dimensions and polynomial in self.of.worlds

    @property
    def claims(self) -> str:
        """The claimed value, as a row of the ledger shows it."""
        return Template(self.value).substitute(vars(self))

    @property
    def latex(self) -> str:
        """The statement as LaTeX."""
        fields: dict[str, Any] = vars(self) | {"claims": self.claims}
        for name, check, _ in declared(self.__class__).checks:
            if check in (formula_name, any_formula):
                fields[name] = self.symbol(fields[name])
            elif check is example_name:
                fields[name] = spelled(fields[name])
        return Template(self.notation).substitute(fields)

    def prove(self) -> tuple[Name, Finding]:
        """The evaluation mode in which the claim is decided for all its curves, and the finding."""
        return (Name("spline"), self._on_its_curve()) if self.on == Extent.CURVE else self.for_all()

    def _on_its_curve(self) -> Finding:
        """The finding on the one curve of the claim."""
        finding = self.check(self.curve_named(self.example), lambda: (self.reading, Finding(UNDECIDED)))
        witness = OnExample(Name(self.example), finding.witness) if finding.verdict == REFUTED else finding.witness
        return replace(finding, witness=witness)

    def for_all(self) -> tuple[Name, Finding]:
        """The evaluation mode in which the claim is decided for all curves, and the finding: the worst of all cases,
        that is of rational and polynomial curves of every dimension to which it applies. An error in one case, such as
        a denominator that vanishes where w = 1, is raised unless another case refutes it.
        """
        with sharing():
            found = worst_case(lambda polynomial, n: self._decided(n, polynomial), self.of.worlds, self.dimensions)
        return self.reading, found

    def _decided(self, dimension: int, polynomial: bool) -> Finding:
        expect_functions(self.compared, dimension, polynomial=polynomial)
        return self.decide(dimension, polynomial)

    @property
    def equality(self) -> Statement | None:
        """The statement of the claim, if it is an equality. An equality is decided in any exact evaluation mode, and on
        one curve for all values of the free operands.
        """
        return None

    @abstractmethod
    def decide(self, dimension: int, polynomial: bool) -> Finding:
        """The finding for all curves of a dimension, with w = 1 or with any w."""

    def check(
        self,
        curve: Nurbs | NurbsSurface | Operands | Evaluation,
        proof: Callable[[], tuple[Name, Finding]] | None = None,
    ) -> Finding:
        """The finding on one curve or surface (or on the `Evaluation` of one).

        If only a part of the curve could be checked, and the claim holds there, it holds on the whole curve if it is
        proved for all curves and the curve satisfies its assumptions. `proof` gives that proof; by default it is
        `prove`.
        """
        own = evaluation(curve)
        if isinstance(own.curve, NurbsSurface) and self.asks_for_zeros:
            return left(Fact.ZEROS_IN_TWO_PARAMETERS)
        if isinstance(own.curve, NurbsSurface) and (long := too_long(map(self.find, self.named), own.curve)):
            return left(long)
        argument = own.argument(self.curve)
        gone = self.missing(argument)
        if self.curve != ArgumentKind.TABLE:
            again = argument if self.evaluated_first and not gone else None
            expect_functions_on(self.compared, again, own.curve.dimension, own.curve.polynomial)
        finding = vacuous(gone) if gone else self.examine(argument, own)
        if finding.verdict in (REFUTED, VACUOUS) and (failing := own.failing(self.curve, self.assumes)):
            return inapplicable(failing, finding.computed, finding.relation)
        part = self.part_tried(own)
        if part and finding.verdict == VERIFIED:
            if self.equality is None or not isinstance(own.curve, Nurbs):
                return sampled(finding, part)
            holds = not own.failing(self.curve, self.assumes) and self._is_proved(proof or self.prove)
            return finding if holds else self._on_all(self.equality, finding, own, part)
        if part and finding.verdict == REFUTED:
            return replace(finding, witness=say.on_part(finding.witness, part))
        return finding

    def _is_proved(self, proof: Callable[[], tuple[Name, Finding]]) -> bool:
        try:
            return proof()[1].verdict == PROVED
        except ExactSplineError:  # reported where the proof is requested
            return False

    def _on_all(self, equality: Statement, finding: Finding, own: Evaluation, part: Evidence) -> Finding:
        """A finding on a part, decided on the whole curve with indeterminates for the free operands; undecided if too
        expensive.
        """
        free = free_operands(self.curve) or say.with_any(())
        try:
            for segment in on_segments(kind_of(self.curve), own.curve, self.highest_derivative(own.curve.dimension)):
                if failing := [x for x in equality.residues(segment.argument) if not x.is_zero]:
                    fails = say.fails_with_others(segment.place(failing[0]), free, part)
                    return replace(finding, verdict=REFUTED, computed=Fact.NOT_SO, witness=fails)
        except VanishingDivisorError:
            gone = say.undefined_there(free)
            broken = own.failing(self.curve, self.assumes)
            return inapplicable(broken, gone) if broken else vacuous(gone)
        except (FormulaError, ReachError) as error:
            return sampled(finding, part, error)
        return finding

    @abstractmethod
    def examine(self, argument: Evaluated, own: Evaluation) -> Finding:
        """The finding on one curve, given as the argument of the formulas."""

    def highest_derivative(self, dimension: int) -> int:
        """The highest derivative that its formulas need."""
        return max(order_of(formula, dimension) for formula in self.compared)

    def part_tried(self, own: Evaluation) -> Evidence | None:
        """The part of all arguments with a curve that is tried in a check; None if all of them are tried."""
        given = own.given(self.curve)
        # h of a hodograph is the weight function here, which is positive: for another h, signs and zeros may be
        # different
        part = given.part or (given.beside if self.asks_for_zeros else None)
        return None if self.tries_all else part

    @property
    def compared(self) -> list[Formula]:
        """The formulas of the claim."""
        return list(map(self.find, self.named))

    def beside(self, own: Evaluation) -> Evidence | None:
        """The operands in addition to the curve in a check; None if there are none."""
        free = free_operands(self.curve) if self.equality else None
        return free or own.given(self.curve).beside

    def missing(self, argument: Evaluated) -> Evidence | None:
        """The formula that does not exist on this curve, because a denominator vanishes on a whole segment; None when
        all exist.
        """
        if self.curve == ArgumentKind.TABLE or not self.evaluated_first:
            return None
        for name in self.named:
            value = self.find(name)(argument)
            parts = [value.directrix, value.generator] if isinstance(value, RuledSurface) else [value]
            if any(isinstance(part, Rational) and not all(part.denominator.numerators) for part in parts):
                return say.undefined(name)
        return None

    def only_component(self, name: str, components: Sequence[V]) -> V:
        """The one component of a scalar. Raises `ClaimError` for a vector."""
        if len(components) > 1:
            raise ClaimError(f"{name!r} is a vector", where=self.key, remedy="name a formula whose value is a scalar")
        return components[0]

    def refuted_on_examples(self, proof: Callable[[], tuple[Name, Finding]] | None = None) -> Finding:
        """The first example curve on which the claim fails, as a witness; UNDECIDED if there is none. `proof` is that
        of `check`; by default there is none, since proofs call this method in search of a witness.
        """
        for surface, name, example in self._examples():
            try:
                finding = self.check(example, proof or (lambda: (self.reading, Finding(UNDECIDED))))
            except ExactSplineError as error:  # the error is reported when this curve is checked
                finding = undecided(error)
            if finding.verdict == REFUTED:
                witness = OnExample(Name(name), finding.witness, surface)
                return Finding(REFUTED, finding.computed, witness=witness, relation=finding.relation)
        return Finding(UNDECIDED)

    def _examples(self) -> Iterator[tuple[bool, str, Nurbs | NurbsSurface]]:
        """The example curves and surfaces to which the claim applies, beginning with its witness."""
        for name in sorted(curve_names(self.source_paper), key=lambda name: name != self.witness):
            curve = self.curve_named(name)
            if self.applies_to(curve.dimension, curve.polynomial):
                yield False, name, curve
        if kind_of(self.curve).made_of_a_surface:
            for surface in one_patch_surfaces():
                if self.applies_to(surface.dimension, surface.polynomial, surface=True):
                    yield True, surface.name, surface


@claim_kind
class TwoSided(Claim):
    """A claim about two formulas, its left and its right side."""

    sides: ClassVar[tuple[str, ...]] = ("left", "right")

    left: Name = field(metadata=read(formula_name))
    right: Name = field(metadata=read(formula_name))
