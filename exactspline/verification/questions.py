"""Questions about formulas: whether one formula is another times a factor, for all curves or on one curve; degrees; and
reductions. Formulas are given as objects or by name.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import product

from exactspline.errors import ExactSplineError, FormulaError, as_flag, as_integer, counted
from exactspline.hooks import Worded
from exactspline.interchange.examples import example
from exactspline.language.formula import Formula
from exactspline.language.kinds import CURVE, Kind, common_kind, kind_of
from exactspline.language.operand import Parameter
from exactspline.language.ruled import RuledSurface, split
from exactspline.numbers.exact import mpq
from exactspline.one_line import OneLine, one_line
from exactspline.papers import all_formulas, find, formula_of, resolve
from exactspline.papers.formula_check import LANGUAGE, formulas_of
from exactspline.papers.loading import guarded
from exactspline.readings.degree import Degree, DegreeReading
from exactspline.readings.differential_order import order_of
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of
from exactspline.symbolic.factorization import POLYNOMIAL, Factor, find_factor, jets_for
from exactspline.symbolic.reduction import Reduction, reduce
from exactspline.verification.decision import Equation
from exactspline.verification.evaluation import argument
from exactspline.verification.evidence import At, Difference, OnExample
from exactspline.verification.one_function import CURVES, expect_functions, expect_functions_on, expect_one_function
from exactspline.verification.verdict import PROVED, REFUTED, VACUOUS, VERIFIED, Finding, worst
from exactspline.verification.vocabulary import Name, Verdict
from exactspline.words import choice

# ---- formulas in one line


#: A power; a component; a number; a name, which may have its place (``file.py:f``); primes; a sign.
TOKEN = re.compile(
    r"(?:\^|\*\*)\s*([-−]?)\s*(\d+)|\[\d\]|(\d+(?:\.\d+)?)|((?:[^\s=+*^(),]+:)?[^\W\d]\w*)|([′'’]+)|[·×−@\0]"
)
#: A product that is written without a sign gets a special sign here, so that it can be refused after a division.
SIGNS = {"·": "*", "×": "*", "−": "-", "\0": "@", "@": "?"}
#: A blank between two operands, or a number before one: a product, as in factors.
BESIDE = re.compile(r"(?<=[\w)\]′'’])\s+(?=[\w(])|(?<![\w.])\d+(?:\.\d+)?(?=[^\W\d]|\()(?![^\s=+*^(),]*:)")
#: Other ways to write primes and powers.
OTHERWISE = str.maketrans({"″": "′′", "‴": "′′′", "²": "^2", "³": "^3"})
#: The longest line.
LONGEST = 2000
#: The place of a name.
PLACE = re.compile(r"[^\s=+*^(),]+(?=:)")
OPERANDS = {"γ"} | {name for n in CURVE.dimensions for name in CURVE.names(n)}


def _formula_of_line(text: str, named: Callable[[str], Formula]) -> Formula:
    """The formula that a line states; `named` returns the formulas in it. A name alone is that formula.

    >>> from exactspline.papers import find
    >>> _formula_of_line("f1", find), _formula_of_line("det(γ', γ'')", find).kind.name
    (<formula f1, §4.1, Remark 3.1>, 'plane')

    Raises `FormulaError` for a line that is not an expression of the language of formulas, or exists for no curve.
    """
    used: dict[str, Formula] = {}

    def python(match: re.Match[str]) -> str:
        minus, power, number, name, primes = match.groups()
        if name and name not in LANGUAGE and name not in OPERANDS:
            used[f"f{len(used)}"] = named(name)
            return f"f{len(used) - 1}(c)"
        if name:
            return str(name) if name in LANGUAGE else f"c.{'gamma' if name == 'γ' else name}"
        if power:
            return f"**{minus and '-'}{power}"
        if number:
            return f'rational("{number}")'
        return f".d({len(primes)})" if primes else SIGNS.get(match[0], match[0])

    if len(text := text.strip()) > LONGEST:
        raise FormulaError(f"a line of {len(text)} characters", remedy=f"write more than {LONGEST} in a file")
    if ".d(" in text:
        raise FormulaError(f"'.d(' in {text!r}", remedy="write a prime for each derivative: norm2(γ')', γ''")
    code = TOKEN.sub(python, BESIDE.sub("\\g<0>\0 ", text.translate(OTHERWISE)))
    if list(used) == [code.removesuffix("(c)")]:
        return used["f0"]
    if not (used or "c." in code):
        raise FormulaError(f"{text!r} is a number", remedy=f"for f = {text} write f + w = {text} + w")
    return _checked(text, code, used)


def _not_looked_up(text: str, *, functions: bool) -> list[str]:
    """The names in a line that are given without a place and mean operands, or `functions` of the language.

    >>> _not_looked_up("a.py:w = det(γ', γ'')/w", functions=True), _not_looked_up("det(p, p')", functions=False)
    (['det', 'w', 'γ'], ['p'])
    """
    known = OPERANDS | (LANGUAGE.keys() if functions else set())
    return sorted({match[4] for match in TOKEN.finditer(text)} & known)


def _checked(text: str, code: str, used: dict[str, Formula]) -> Formula:
    """The formula of a line in Python, of the arguments for which it exists."""
    try:
        code = ast.unparse(_in_python(ast.parse(code, mode="eval"), text))
    except (SyntaxError, RecursionError, MemoryError):
        raise FormulaError(f"{text!r} states no formula", remedy="write for example w^-3 * f2") from None
    imports = f"from exactspline.language.vector import {', '.join(LANGUAGE)}\n"
    imports += f"from exactspline.papers.line import {', '.join(used)}\n" * bool(used)
    known, errors = {f"papers.line:{name}": each for name, each in used.items()}, list[ExactSplineError]()
    for kind in _kinds([each.kind for each in used.values()]):
        try:
            file = f'{imports}@formula("", on="{kind.name}")\ndef line(c):\n    return {code}\n'
            made = formulas_of(file, text, known)
            found = guarded(Formula(made["line"].function, text, kind, ""), text)
            for n in kind.dimensions:
                order_of(found, n)
        except ExactSplineError as error:
            errors.append(error)
            continue
        found.name = found.__name__ = text
        found.checked = True
        return found
    raise errors[0]


def _in_python(tree: ast.AST, text: str) -> ast.AST:
    """Powers with negative exponents as quotients, and products without a sign as products, except after a division."""
    for node in ast.walk(tree):
        match node:
            case ast.BinOp(ast.BinOp(op=ast.Div(), col_offset=first), ast.MatMult()) if first == node.col_offset:
                signed = BESIDE.sub(r"\g<0>* ", text)
                raise FormulaError(
                    f"an unclear divisor in {text!r}", remedy=f"write {signed}, or parentheses around it"
                )
            case ast.BinOp(op=ast.MatMult()):
                node.op = ast.Mult()
            case ast.BinOp(base, ast.Pow(), ast.UnaryOp(operand=power)):
                node.left, node.op, node.right = ast.Constant(1), ast.Div(), ast.BinOp(base, ast.Pow(), power)
    return tree


def _kinds(given: list[Kind]) -> list[Kind]:
    """The kinds of argument on which formulas of all these kinds are defined, beginning with the kind of both
    dimensions.
    """
    common = common_kind(given)
    one = [re.sub("^curve(?! on)|(?<=framed)$", f" {each}", common.name).strip() for each in ("plane", "space")]
    kinds = [common, *map(kind_of, one)]
    if not (found := [kind for kind in kinds if all(kind.takes(each, n) for each in given for n in kind.dimensions)]):
        names = ", ".join(dict.fromkeys(repr(kind.name) for kind in given))
        raise FormulaError(f"formulas of the kinds {names}", remedy="name formulas of one kind of argument")
    return found


Named = Formula | str


@dataclass(frozen=True, repr=False)
class _Answer(Worded):
    """The answer to the question whether ``left = factor · right``; it can be used as a condition."""

    left: str
    right: str
    factor: str
    finding: Finding

    @one_line
    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.verdict}: {self.left} = {self.factor} {self.right}>"

    @property
    def verdict(self) -> Verdict:
        """The verdict. It is VACUOUS if both sides vanish identically (0 = 0 is true with any factor), or if a side or
        the factor does not exist on a segment.
        """
        return self.finding.verdict

    @property
    def holds(self) -> bool:
        """Whether the identity is proved for all curves, or verified on the given curve."""
        return self.verdict in (PROVED, VERIFIED)

    def __bool__(self) -> bool:
        return self.holds


@dataclass(frozen=True, repr=False)
class Proof(_Answer):
    """The answer of `prove`: whether ``left = factor · right`` for all curves of these dimensions."""

    dimensions: tuple[int, ...]
    #: The true quotient of the left side by the right side; None for vectors that are not parallel, and if roots are
    #: adjoined.
    quotient: Factor | None
    #: Whether roots are adjoined: then a quotient is not a product of polynomials.
    roots: bool = False
    #: An example curve on which a refuted identity fails, with the place; None if no example shows that.
    counterexample: OnExample | None = None

    @property
    def dimension(self) -> int:
        """The first dimension of the curves."""
        return self.dimensions[0]

    @property
    def spaces(self) -> str:
        """The dimensions in words: R2 and R3."""
        return " and ".join(f"R{n}" for n in self.dimensions)

    @one_line
    def __repr__(self) -> str:
        return f"{super().__repr__()[:-1]} in {self.spaces}>"

    def data(self) -> dict[str, object]:
        """The answer as data."""
        sides = {"key": f"{self.left} = {self.factor} {self.right}", "left": self.left, "right": self.right}
        stated = sides | {"factor": self.factor, "dimensions": [*self.dimensions], "holds": self.holds}
        shown = {"quotient": self.quotient, "counterexample": self.counterexample}
        texts = {name: None if value is None else str(value) for name, value in shown.items()}
        return stated | {"verdict": self.verdict} | texts


@dataclass(frozen=True, repr=False)
class Check(_Answer):
    """The answer of `verify`: whether ``left = factor · right`` on one curve."""

    @property
    def parameter(self) -> mpq | None:
        """A parameter at which the sides differ; None if they do not differ."""
        witness = self.finding.witness
        return witness.at.parameter if isinstance(witness, Difference) and isinstance(witness.at, At) else None

    @property
    def vacuous(self) -> bool:
        """Whether there is nothing to decide."""
        return self.verdict == VACUOUS


def prove(left: Named, right: Named = "", factor: str = "1", *, dimension: int | None = None) -> Proof:
    """Decide whether ``left = factor · right`` for all curves, by computing with indeterminate derivatives. Both sides
    may also be stated in one text, as expressions of the language of formulas.

    A factor is written like ``"2 w^29 f2"`` or ``"w^-4"``. Without a `dimension` the identity must hold in all
    dimensions in which the formulas are defined; otherwise the answer is about a dimension in which the identity fails.
    The answer also contains the true quotient.

    >>> print(prove("f1", "f2", "w"))
    f1 = w · f2 for all curves in R2
    >>> print(prove("f1", "f2"))
    not f1 = f2 in R2: the quotient is w
    >>> print(prove("det(γ', γ'') = w^-3 * f2"))
    det(γ', γ'') = w^-3 * f2 for all curves in R2

    Raises `FormulaError` for an unknown formula or two formulas without a common dimension, and `ClaimError` if the
    factor cannot be read.
    """
    if isinstance(left, str) and not right:
        if factor != "1" and "=" in left:
            raise FormulaError("a factor beside a line", remedy=f"write {left.replace('=', f'= {factor} * (', 1)})")
        return proof_of(left, dimension=dimension)
    sides = _formulas(left, right)
    return _decided(Equation(sides[0], sides[1], factor), _given_dimension(dimension))


def _decided(equation: Equation, dimension: int | None = None) -> Proof:
    kind = common_kind(f.kind for f in (equation.left, equation.right))
    defined = [n for n in (2, 3) if all(kind.takes(f.kind, n) for f in equation.formulas)]
    if not defined or (dimension is not None and dimension not in defined):
        names, where = [f.name for f in equation.formulas], f"R{dimension}" if dimension else "R2 or in R3"
        problem = f"{', '.join(names[:-1])} and {names[-1]} are not {'all' if names[2:] else 'both'} defined in {where}"
        raise FormulaError(problem, remedy="compare formulas of one kind of curve")
    found = [_proved(equation, kind, n) for n in (defined if dimension is None else [dimension])]
    least = worst([each.finding for each in found])
    alike = [each for each in found if each.verdict == least.verdict]
    # a quotient belongs to one dimension
    same = all(each.holds for each in alike)
    return replace(alike[0], dimensions=tuple(each.dimension for each in alike)) if same else alike[0]


def _proved(equation: Equation, kind: Kind, n: int) -> Proof:
    """The answer in one dimension."""
    curve = jets_for(equation.formulas, n, factor=equation.factor).remembering()  # these comparisons are the proof
    for each in equation.formulas:
        expect_one_function(each, curve)
    left, right = equation.left(curve), equation.right(curve)
    if isinstance(left, RuledSurface) or isinstance(right, RuledSurface):
        raise FormulaError("a ruled surface in an identity", remedy='write a claim of the kind "same surface"')
    quotient = None if kind.adjoins_roots or right.is_zero else find_factor(left, right)
    names = equation.left.name, equation.right.name
    finding = equation.decide(curve)
    shown = _counterexample(equation, kind, n) if finding.verdict == REFUTED else None
    return Proof(*names, equation.factor, finding, (n,), quotient, kind.adjoins_roots, shown)


def proof_of(text: str, *, trust: bool = False, dimension: int | None = None) -> Proof:
    """Decide an identity that one line states: ``file.py:left = w^3 * file.py:right``, ``2*f1 = f1 + f1``.

    >>> print(proof_of("2*f1 = f1 + f1"))
    2*f1 = f1 + f1 for all curves in R2
    >>> print(proof_of("f1 = f2").counterexample)
    on the example curve rational_cubic: the sides differ by -941369/13824 at the parameter 1/12

    Names are looked up in the place that the left side names, then in the library; ``w`` and ``p`` without a place are
    operands.

    Raises `FormulaError` for a text that states no identity, and for an operand with the name of a formula in one of
    the places; also the errors of `exactspline.papers.resolve` and `prove`.
    """
    left, _, right = text.partition("=")
    # the sides are shown as written, since formulas of two places may have one name
    return replace(
        _decided(_equation(text, trust), _given_dimension(dimension)), left=left.strip(), right=right.strip()
    )


def _counterexample(equation: Equation, kind: Kind, dimension: int) -> OnExample | None:
    """The first example curve of a dimension on which an identity fails."""
    for name in () if kind.adjoins_roots else CURVES[dimension]:
        with suppress(ExactSplineError):
            if (found := equation.decide(argument(kind.name, example(name)).argument, VERIFIED)).verdict == REFUTED:
                return OnExample(Name(name), found.witness)
    return None


def _equation(text: str, trust: bool) -> Equation:
    """The identity that a line states."""
    left, equal, right = text.partition("=")
    if not (equal and left.strip() and right.strip()) or "=" in right:
        raise FormulaError(f"{text!r} states no identity", remedy='write for example "f1 = w * f2"')
    _expect_operands(text, trust)
    places = PLACE.findall(left)

    def named(name: str) -> Formula:
        try:
            return resolve(f"{places[0]}:{name}" if places and ":" not in name else name, trust=trust)
        except FormulaError:
            if name not in all_formulas():
                raise
            return find(name)

    return Equation(_formula_of_line(left, named), _formula_of_line(right, named))


def _expect_operands(text: str, trust: bool) -> None:
    """Refuse a name without a place that means an operand, where a formula in one of the places has it too."""
    for place, name in product(dict.fromkeys(PLACE.findall(text)), _not_looked_up(text, functions=not trust)):
        try:
            resolve(f"{place}:{name}", trust=trust)
        except FormulaError:
            continue
        problem = f"{name!r} is a word of the language, and a formula of {place}"
        raise FormulaError(problem, remedy=f"write {place}:{name} for the formula, or give it another name")


@dataclass(frozen=True, repr=False)
class DegreeAnswer(OneLine):
    """The answer of `degree`: the degree by Table 1 of the paper, and the degree of the value in lowest terms on the
    generic curve.
    """

    formula: str
    dimension: int
    nominal: Degree
    lowest: Degree

    def __str__(self) -> str:
        return f"{self.formula} in R{self.dimension}: nominal {self.nominal}, in lowest terms {self.lowest}"


def degree(
    formula: Named, *, dimension: int | None = None, polynomial: bool = False, parameter: Parameter | str | None = None
) -> DegreeAnswer:
    """Return the degrees of a formula on the generic curve of degree d. For a formula with several parameters, these
    are the degrees in `parameter`, by default in the first parameter.

    >>> print(degree("g2"))
    g2 in R2: nominal 9d − 6, in lowest terms 9d − 12
    >>> print(degree("surfaces:L_lifted", parameter="v"))
    L_lifted in R3: nominal 4d_v − 1, in lowest terms 4d_v − 2

    Raises `FormulaError` for an unknown formula, and for a formula to whose kind of argument the degree theorem does
    not apply.
    """
    (named,) = _formulas(formula)
    dimension, polynomial = _given_dimension(dimension), as_flag(polynomial, POLYNOMIAL)
    n = named.kind.dimensions[0] if dimension is None else dimension
    known = named.kind.parameters(n)
    counted = known[0] if parameter is None else choice(Parameter, parameter, "parameter")
    if counted not in known:
        raise FormulaError(
            f"the degree of {named.name} in {counted}", remedy=f"it is a function of {' and '.join(known)}"
        )
    expect_functions((named,), n, polynomial=polynomial)
    nominal = DegreeReading(parameter=counted).count(named, n, polynomial=polynomial)
    reduction = reduce(named, dimension=n, polynomial=polynomial, parameter=counted)
    return DegreeAnswer(named.name, n, nominal, reduction.main.generic_lowest)


def verify(left: Named, right: Named, curve: Nurbs, factor: str = "1") -> Check:
    """Decide whether ``left = factor · right`` as functions on a curve, exactly.

    >>> from exactspline import example
    >>> bool(verify("f1", "f2", example("six_segment_cubic")))  # w = 1 here
    True
    >>> print(verify("f1", "f2", example("rational_cubic")))
    not f1 = f2 at the parameter 1/12
    >>> bool(verify("f1", "f2", example("rational_cubic"), "w"))
    True

    If a denominator vanishes on a segment, the answer is VACUOUS.

    Raises `FormulaError` for an unknown formula, for a formula that is not defined for curves of this dimension, and
    for formulas with different numbers of components.
    """
    sides, curve = _formulas(left, right), curve_of(curve)
    for f in sides:
        if curve.dimension not in f.kind.dimensions or not CURVE.takes(f.kind, curve.dimension):
            problem = f"{f.name} is a formula of the kind {f.kind.name}, and the curve is in R{curve.dimension}"
            raise FormulaError(problem, remedy="compare formulas of a curve like this one")
    expect_functions_on(sides, curve, curve.dimension, curve.polynomial)
    ps, qs = (split(f(curve))[0] for f in sides)
    if len(ps) != len(qs):
        problem = f"{sides[0].name} has {counted(len(ps), 'component')} and {sides[1].name} has {len(qs)}"
        raise FormulaError(problem, remedy="compare equals")
    finding = Equation(sides[0], sides[1], factor).decide(curve, VERIFIED)
    return Check(sides[0].name, sides[1].name, factor, finding)


def reduction(
    formula: Named | Callable[..., object],
    *,
    dimension: int | None = None,
    polynomial: bool = False,
    parameter: Parameter | str | None = None,
) -> Reduction:
    """Return the factors that cancel in a formula for all curves, and the lowest degree that remains. For a formula
    with several parameters, this is the degree in `parameter`, by default in the first parameter.

    >>> print(reduction("evolute").main.generic)
    6d − 6

    Raises `FormulaError` for an unknown formula, and `ShapeError` if the formula is not defined in this dimension.
    """
    named = find(formula) if isinstance(formula, str) else formula
    counted = None if parameter is None else choice(Parameter, parameter, "parameter")
    dimension, polynomial = _given_dimension(dimension), as_flag(polynomial, POLYNOMIAL)
    found = reduce(named, dimension=dimension, polynomial=polynomial, parameter=counted)
    read = named if isinstance(named, Formula) else Formula(named, found.name, found.kind, "")
    expect_functions((read,), found.dimension, polynomial=polynomial)
    return found


def _given_dimension(dimension: int | None) -> int | None:
    return None if dimension is None else as_integer(dimension, "a dimension", 1)


def _formulas(*given: Named) -> tuple[Formula, ...]:
    return tuple(map(formula_of, given))
