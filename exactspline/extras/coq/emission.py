"""The theorems of all papers as files of Coq: a base written by hand, formulas and claims generated from the papers."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

from flint import fmpq_mpoly

from exactspline.atomic_write import write_text
from exactspline.display.forms import grouped
from exactspline.errors import ClaimError, ExactSplineError, FormulaError, VanishingDivisorError
from exactspline.extras.coq.formulas import (
    HEADER,
    THEORY,
    Calling,
    Formulas,
    Writer,
    comment,
    identifier,
    integer,
    sum_of_products,
    type_of,
    written_for,
)
from exactspline.extras.coq.theorems import STATED, Nonzero, Statement, concluded, theorem
from exactspline.language.arguments import COORDINATES, POINT, Accompanied, Curve, embedded
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE, POINT_IN_SPACE, CurveKind, FramedKind, ImplicitKind, Kind, Symbol, kind_of
from exactspline.language.vector import Vector
from exactspline.papers import Paper, papers
from exactspline.readings.jet import JetFraction, JetRing
from exactspline.readings.printing import Operation
from exactspline.readings.tree import Node
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of
from exactspline.verification.divisors import Evaluation, factored
from exactspline.verification.evaluation import with_explicit_curve
from exactspline.verification.vocabulary import Extent, Scope, Verdict

# ---- claims that fail


#: A difference that is not zero, the negated statement, and the steps that prove it.
Difference = tuple[Node, str, str]


def _refutation(claim: Claim, dimension: int, named: Callable[[Formula], str]) -> str:
    """The theorem that a claim fails.

    Raises `ClaimError` if none of the curves tried is a counterexample.
    """
    for curve in _candidates(kind_of(claim.curve), dimension, polynomial=claim.of == Scope.POLYNOMIAL):
        attempt = _Attempt(claim, dimension, named, curve)
        if attempt.succeeds():
            return attempt.text()
    raise ClaimError("no explicit curve refutes it", where=claim.key, remedy="add one")


class _Attempt(Statement[Iterator[Difference]]):
    """A claim on one explicit curve."""

    def __init__(self, claim: Claim, dimension: int, named: Callable[[Formula], str], curve: _ExplicitCurve) -> None:
        self.claim, self.curve, self.dimension = claim, curve, dimension
        self.kind = kind_of(claim.curve)
        self.traced = Calling(self.kind, dimension)
        self.writer = Writer(named)
        self.argument = curve.argument(self.kind)
        self.evaluation = Evaluation(self.argument)
        self.units = Nonzero()
        self.premises: list[Node] = []
        self.difference: Difference | None = None

    def succeeds(self) -> bool:
        """Whether the assumptions hold and the statement fails."""
        try:
            self.premises = [self.assumed(a) for a in self.claim.assumes if a.formula]
            if any(self.evaluation(node).is_zero for node in self.premises):
                return False
            differences: Iterator[Difference] = concluded(self.claim, self)
            self.difference = next(differences, None)
        except VanishingDivisorError:
            return False
        if self.difference is None:
            return False
        self._recognize(self.argument.w)
        for node in self.premises:
            self._recognize(self.evaluation(node))
        for _, value in self.evaluation.denominators:
            self._recognize(value)
        return True

    def _recognize(self, value: Any) -> None:
        """Add a function that is not zero."""
        self.units.recognize(factored(value))

    def equal(self, left: Node, right: Node | None) -> Iterator[Difference]:
        """The components in which two trees differ, as differences."""
        a = self.evaluation(left)
        zeros = "[" + "; ".join(["zero K"] * len(a)) + "]" if isinstance(a, Vector) else "zero K"
        said = f"{self.writer(left)} <> {zeros if right is None else self.writer(right)}"
        if not isinstance(a, Vector):
            difference = left if right is None else left - right
            if not self.evaluation(difference).is_zero:
                closing = "exact U." if right is None else "apply different; vm_cast_no_check U."
                yield difference, said, closing
            return
        for i in range(len(a)):
            difference = left[i] if right is None else left[i] - right[i]
            if not self.evaluation(difference).is_zero:
                step = difference if right is not None else left[i] - Node(Operation.NUMBER, value=0)
                self.evaluation(step)
                yield step, said, f"apply (different_vectors K {i}); vm_cast_no_check U."

    def on_surface(self, left: Node, right: Formula) -> Iterator[Difference]:
        """The components in which a plane curve is not the directrix of a surface of the same curve in space."""
        directrix = Calling(POINT_IN_SPACE, 3).calls(right).directrix
        in_space = Evaluation(embedded(self.argument))
        inside = Writer(self.writer.named, "(embedded c)")
        planar, spatial = self.evaluation(left), in_space(directrix)
        assert isinstance(planar, Vector)
        assert isinstance(spatial, Vector)
        for i in range(2):
            difference = planar[i] - spatial[i]
            if not difference.is_zero:
                self.evaluation.denominators += in_space.denominators
                self._recognize(difference)
                said = f"{self.writer(left)} ++ [zero K] <> {inside(directrix)}"
                text = f"component {i} ({self.writer(left)} ++ [number 0]) - component {i} ({inside(directrix)})"
                yield Node(Operation.LEAF, value=text), said, f"apply (different_vectors K {i}); vm_cast_no_check U."

    def one_surface(self, left: Node, right: Node) -> Iterator[Difference]:
        """The products that would vanish if two ruled surfaces were equal."""
        (d, g), (e, h) = ((side.directrix, side.generator) for side in (left, right))
        said = f"~ same_surface ({self.writer(left)}) ({self.writer(right)})"
        values = [f"(map (value K l) ({self.writer(node)}))" for node in (d, g, e, h)]
        for part, other in enumerate((h, e - d)):
            product = Node(Operation.CROSS, (g, other), vector=True)
            for i in range(3):
                if not self.evaluation(product[i]).is_zero:
                    one = f"same_surface ({values[0]}, {values[1]}) ({values[2]}, {values[3]})"
                    closing = (
                        f"intro Z. assert (Y : {one}) by vm_cast_no_check Z.\n  destruct (parallel_of_one_surface "
                        f"K {' '.join(values)} eq_refl eq_refl eq_refl eq_refl Y) as [Y1 Y2].\n  apply U. "
                        f"vm_cast_no_check (f_equal (component {i}) Y{part + 1})."
                    )
                    yield product[i], said, closing

    def text(self) -> str:
        """Statement and proof."""
        assert self.difference is not None
        difference, said, closing = self.difference
        if difference.op is not Operation.LEAF:
            self._recognize(self.evaluation(difference))
        text = difference.value if difference.op is Operation.LEAF else self.writer(difference)
        curve = self.curve.term(self.kind, "t", "number")
        holds = ["w c <> zero K", *[f"{self.writer.at(node, 1)} <> zero K" for node in self.premises]]
        keys = list(map(_coefficients_of, self.units.atoms))
        atoms = [_polynomial_term(key, "var 1", "num") for key in keys]
        unit = "{ apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }"
        lines = [
            "intros K t Hz Ht.",
            "pose (l := [t]).",
            "assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).",
            f"pose (atoms := [{'; '.join(atoms)}]%formula : list expr).",
            f"pose (known := {self.units.known_list}).",
            f"pose (c := ({self.curve.term(self.kind, '(var 1)', 'number')})%formula : {type_of(self.kind)[:-1]}expr).",
            "assert (N : all_nonzero K l atoms).",
            "{ repeat apply Forall_cons; try apply Forall_nil.",
        ]
        for key in keys:
            lines.append(f"  - apply (explicit_nonzero K t Hz Ht {len(key) - 1}). vm_cast_no_check (eq_refl true).")
        lines[-1] += " }"
        for i, node in enumerate(["w c", *[self.writer(node) for node in self.premises]]):
            lines += [f"assert (H{i} : value K l ({node} : expr)%formula <> zero K).", unit]
        equalities = _equalities(self.kind)
        for i, (kind, left, right, _) in enumerate(equalities):
            name, value = ("one_vector", "map (value K l)") if kind == "list expr" else ("one_value", "value K l")
            lines.append(f"assert (E{i} : {value} ({left} : {kind})%formula = {value} ({right} : {kind})%formula).")
            lines.append(
                f"{{ apply ({name} K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }}"
            )
        lines += [f"assert (U : value K l ({text} : expr)%formula <> zero K).", unit]
        lines += [f"split; [vm_cast_no_check H{i}|]." for i in range(len(holds))]
        lines += [f"split; [vm_cast_no_check E{i}|]." for i in range(len(equalities))]
        holds += [said for *_, said in equalities]
        lines.append(closing)
        conclusion = " /\\\n  ".join([*holds, said])
        several = len(self.kind.dimensions) > 1
        name = identifier(self.claim.key) + (f"_in_dimension_{self.dimension}" if several else "") + "_fails"
        return (
            f"(** {comment(self.claim.id)}, {comment(self.claim.source)}, fails. *)\n"
            f"Theorem {name} : forall (K : differential_field) (t : K),\n"
            "  characteristic_zero K -> derivative K s t = one K ->\n"
            f"  let c := {curve} in\n  {conclusion}.\n"
            "Proof.\n  " + "\n  ".join(lines) + "\nQed.\n"
        )


def _equalities(kind: Kind) -> list[tuple[str, str, str, str]]:
    """The equalities that hold for every argument of a kind and must be proved for an explicit one: a type, two terms,
    and the statement.
    """
    if isinstance(kind, FramedKind):
        velocity = "(vder s (gamma c))"
        binormal = f"(cross {velocity} (vders s 2 (gamma c)))"
        vectors = {"sigma": velocity} | ({"rho": binormal} if 3 in kind.dimensions else {})
        pairs = [(f"{root} c * {root} c", f"dot {vector} {vector}") for root, vector in vectors.items()]
        return [("expr", left, right, f"{left} = {right}") for left, right in pairs]
    if isinstance(kind, ImplicitKind):
        left, right = "vder s (gamma c)", "vmul (pace_of c) (perp (gradient_f c))"
        chained = "map (fun row => dot row (vder s (gamma c))) (hessian_f c)"
        return [
            ("list expr", left, right, f"{left} = {right}"),
            ("list expr", "vder s (gradient_f c)", chained, "chain_rule c"),
        ]
    return []


# ---- explicit functions of t

#: A polynomial in t by its coefficients.
Coefficients = tuple[int, ...]


#: Polynomials in t: the functions of a curve that is explicit.
RING = JetRing(with_explicit_curve(CURVE, both=False), 2, 0)


def _explicit_function(coefficients: Coefficients) -> JetFraction:
    """A polynomial in t.

    >>> t = _explicit_function((0, 1))
    >>> (1 / t).d() == -1 / (t * t)
    True
    """
    polynomial = RING.of_terms(tuple(((k,), c, 1) for k, c in enumerate(coefficients) if c))
    return JetFraction(RING, polynomial, RING.context.constant(1))


def _coefficients_of(polynomial: fmpq_mpoly | int) -> Coefficients:
    """The integer coefficients of a polynomial in t."""
    if isinstance(polynomial, int):
        return (polynomial,)
    return tuple(int(polynomial[k,]) for k in range(polynomial.total_degree() + 1))


@dataclass(frozen=True)
class _ExplicitCurve:
    """Numerators, denominator and additional operands by their coefficients, constants first."""

    numerators: tuple[Coefficients, ...]
    denominator: Coefficients = (1,)
    point: tuple[int, ...] = ()
    beside: Mapping[str, Coefficients] = field(default_factory=dict)

    def argument(self, kind: Kind) -> Curve[JetFraction]:
        """The argument of formulas."""
        dimension = len(self.numerators)
        functions = dict(zip(COORDINATES, self.numerators, strict=False)) | {"w": self.denominator, **self.beside}
        functions |= {name: (value,) for name, value in zip(POINT, self.point, strict=False)}

        def operand(symbol: Symbol) -> JetFraction:
            return _explicit_function(functions.get(symbol.name, ()))

        if isinstance(kind, FramedKind):
            plain = CURVE.argument(dimension, operand, _explicit_function((1,)))
            assert isinstance(plain, Curve)
            return Accompanied(plain, {name: _explicit_function(value) for name, value in self.beside.items()})
        made = kind.argument(dimension, operand, _explicit_function((1,)))
        assert isinstance(made, Curve)  # explicit curves exist only for kinds of one curve
        return made

    def term(self, kind: Kind, t: str, number: str) -> str:
        """The argument as a term of Coq in t, with this function symbol for numbers."""

        def beside(*names: str) -> str:
            return f"[{'; '.join(_polynomial_term(self.beside.get(name, (0,)), t, number) for name in names)}]"

        parts = "; ".join(_polynomial_term(key, t, number) for key in self.numerators)
        point = "; ".join(f"number {integer(value)}" for value in self.point)
        curve = f"rational_curve s [{parts}] ({_polynomial_term(self.denominator, t, number)}) [{point}]"
        if isinstance(kind, FramedKind):
            roots = (_polynomial_term(self.beside.get(root, (0,)), t, number) for root in ("sigma", "rho"))
            return f"Framed ({curve}) ({') ('.join(roots)})"
        if isinstance(kind, ImplicitKind):
            axes = COORDINATES[: len(self.numerators)]
            rows = (beside(*["f" + "".join(sorted(x + y)) for y in axes]) for x in axes)
            return f"Implicit ({curve}) {beside(*kind.free)} {beside(*['f' + x for x in axes])} [{'; '.join(rows)}]"
        if isinstance(kind, CurveKind) and kind.constants:
            return f"Accompanied ({curve}) {beside(*kind.constants)}"
        return curve


def _polynomial_term(coefficients: Coefficients, t: str, number: str) -> str:
    """A polynomial in t as a term.

    >>> _polynomial_term((1, 0, -2), "t", "number")
    'number 1 - number 2 * t ^ 2'
    """
    return sum_of_products(((c, [(t, k)] if k else []) for k, c in enumerate(coefficients) if c), number)


#: The numerators, denominators, points and constants to try, the simplest first.
_NUMERATORS = ((0, 1), (0, 0, 1), (1, 0, 0, 1), (0, 1, 0, 0, 1))
_DENOMINATORS = ((1, 1), (1, 0, 1))
_POINT = (1, 2, 5)
_CONSTANTS = (2, 3, 5, 7, 11)
#: Curves for which the roots of the frame are polynomials: γ′ = 3(1 − t², 2t), and γ′ = 3(1, 2t, 2t²).
_FRAMED = {
    2: _ExplicitCurve(((0, 3, 0, -1), (0, 0, 3)), beside={"sigma": (3, 0, 3)}),
    3: _ExplicitCurve(((0, 3), (0, 0, 3), (0, 0, 0, 2)), beside={"sigma": (3, 0, 6), "rho": (18, 0, 36)}),
}
#: The parabola y = x², along which F = y − x² is constant.
_PARABOLA = _ExplicitCurve(
    ((0, 1), (0, 0, 1)), beside={"pace": (-1,), "fx": (0, -2), "fy": (1,), "fxx": (-2,), "fxy": (0,), "fyy": (0,)}
)


def _candidates(kind: Kind, dimension: int, *, polynomial: bool) -> Iterator[_ExplicitCurve]:
    """Explicit arguments of a kind; only polynomial arguments for a claim about polynomial curves.

    Raises `ClaimError` for a kind without explicit arguments.
    """
    if isinstance(kind, FramedKind) and not kind.constants:
        yield _FRAMED[dimension]
    elif isinstance(kind, ImplicitKind) and kind.dimensions == (2,):
        yield _PARABOLA
    elif type(kind) is CurveKind:
        point = _POINT[:dimension] if kind.with_point else ()
        beside = {name: (value,) for name, value in zip(kind.constants, _CONSTANTS, strict=False)}
        for w in ((1,),) if polynomial else _DENOMINATORS:
            for i in range(len(_NUMERATORS) - dimension + 1):
                yield _ExplicitCurve(_NUMERATORS[i : i + dimension], w, point, beside)
    else:
        raise ClaimError(f"no explicit curves of the kind {kind.name!r}", remedy="state claims about one curve")


#: The files written by hand: those required by the theorems about papers, one that shows that their assumptions are
#: consistent, and one for answers about one curve.
BY_HAND = (*THEORY, "Models", "Answers", "Meetings")
#: The logical name of the directory.
ROOT = "ExactSpline"


@dataclass(frozen=True)
class Stated:
    """A claim in one dimension as a theorem: its name and its text, or the reason why there is none."""

    claim: Claim
    name: str
    text: str
    reason: ExactSplineError | None = None

    @property
    def why(self) -> str:
        """The reason why there is no theorem, as text."""
        return "" if self.reason is None else self.reason.problem


@dataclass(frozen=True)
class Library:
    """The files by name, each after those that it requires, and the theorems by file."""

    files: dict[str, str]
    theorems: dict[str, tuple[Stated, ...]]

    def write(self, directory: Path) -> None:
        """Write the files, and the list of them by which they are compiled."""
        for name, text in self.files.items():
            _write(directory / f"{name}.v", text)
        listed = "\n".join([f"-R . {ROOT}", *[f"{name}.v" for name in self.files]])
        _write(directory / "_CoqProject", f"{listed}\n")

    def of(self, claims: Iterable[Claim]) -> Library:
        """The theorems of some claims only, and the files that they require.

        Raises `ClaimError`, with the reasons, if none of them has a theorem.
        """
        chosen = list(claims)
        keys = {(claim.paper, claim.key) for claim in chosen}
        files = {name: text for name, text in self.files.items() if name not in self.theorems}
        theorems: dict[str, tuple[Stated, ...]] = {}
        for name, own in self.theorems.items():
            if kept := tuple(each for each in own if (each.claim.paper, each.claim.key) in keys):
                theorems[name] = kept
                if any(each.reason is None for each in kept):
                    files[name] = _claims_file(kept[0].claim.source_paper, kept)
        known = {(each.claim.paper, each.claim.key) for own in theorems.values() for each in own}
        without = [Stated(c, "", "", why_unstated(c)) for c in chosen if (c.paper, c.key) not in known]
        if without:
            theorems[""] = tuple(without)
        made = Library(files, theorems)
        if len(made.unstated) == sum(map(len, theorems.values())):
            reasons = dict.fromkeys(f"{each.claim.key}: {each.why}" for each in made.unstated)
            raise ClaimError("no theorem", where="; ".join(list(reasons)[:3]), remedy="name an equality of a paper")
        return made

    @property
    def unstated(self) -> list[Stated]:
        """The claims of equalities that have no theorem, with the reason."""
        return [each for own in self.theorems.values() for each in own if each.reason is not None]


def _write(path: Path, text: str) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as reason:
        raise ClaimError(
            f"no directory can be made here ({reason.strerror})", where=str(path.parent), remedy="name another one"
        ) from None
    write_text(path, text, ClaimError)


def _theory(name: str) -> str:
    """The text of a file written by hand."""
    return resources.files(__package__).joinpath("theory", f"{name}.v").read_text(encoding="utf-8")


@cache
def library() -> Library:
    """The theorems of every paper that comes with the library."""
    formulas = Formulas(papers())
    files = {name: _theory(name) for name in BY_HAND}
    files |= {f"formulas/{paper.name}": formulas.definitions(paper) for paper in formulas.papers}
    theorems: dict[str, tuple[Stated, ...]] = {}
    for paper in formulas.papers:
        tables = (Path(table.place.split(",")[0]).stem for table in paper.claim_tables())
        by_table = grouped(zip(tables, claims_of(paper.name), strict=True))
        for table, claims in by_table.items():
            theorems_of_table = tuple(each for claim in claims for each in _stated(claim, paper, formulas))
            if theorems_of_table:
                name = f"claims/{paper.name}_{table}"
                theorems[name] = theorems_of_table
                if any(each.reason is None for each in theorems_of_table):
                    files[name] = _claims_file(paper, theorems_of_table)
    return Library(files, theorems)


def _stated(claim: Claim, paper: Paper, formulas: Formulas) -> list[Stated]:
    """A claim of an equality as theorems, one per dimension: that it holds, or that it fails, depending on the recorded
    verdict.
    """
    if not isinstance(claim, STATED) or claim.on == Extent.CURVE:
        return []
    kind = kind_of(claim.curve)
    if not written_for(kind):
        return [Stated(claim, "", "", FormulaError(f"arguments of the kind {kind.name!r} are not written"))]
    make = _refutation if claim.expected == Verdict.REFUTED else theorem
    theorems = []
    for dimension in kind.dimensions:
        try:
            text = make(claim, dimension, lambda formula: formulas.named(formula, paper))
        except ExactSplineError as error:
            theorems.append(Stated(claim, "", "", error))
            continue
        match = re.search(r"^Theorem (\S+)", text, re.MULTILINE)
        assert match is not None
        theorems.append(Stated(claim, match[1], text))
    return theorems


def _claims_file(paper: Paper, theorems: Iterable[Stated]) -> str:
    """The file of the theorems of one table of claims."""
    texts = [each.text for each in theorems if each.reason is None]
    return "\n".join([claims_header(paper.name, "".join(texts)), *texts])


def claims_header(name: str, text: str) -> str:
    """The header of a file with theorems about a paper, derived from their text."""
    own = next(each for each in papers() if each.name == name)
    used = [each for each in papers() if each is not own and f"{each.name}." in text]
    others = [f"From {ROOT}.formulas Require {each.name}." for each in used]
    return "\n".join(
        [
            HEADER.format(title=own.title, about="its claims"),
            "Require Import ZArith List.",
            f"From {ROOT} Require Import {' '.join(THEORY)}.",
            *others,
            f"From {ROOT}.formulas Require Import {own.name}.",
            "Import ListNotations.",
            "Local Open Scope formula_scope.",
            "",
        ]
    )


def why_unstated(claim: Claim) -> ExactSplineError:
    """The reason why a claim has no theorem."""
    if not isinstance(claim, STATED):
        return FormulaError(f"claims of the kind {claim.kind!r} are not equalities")
    foreign = not claim.source_paper.package
    return FormulaError("formulas of users' folders are not written in Coq" if foreign else "it has none")


def emit(directory: Path, claims: Iterable[Claim] | None = None) -> Library:
    """Write theorems into a directory: those of these claims, by default of all papers."""
    made = library() if claims is None else library().of(claims)
    made.write(directory)
    return made
