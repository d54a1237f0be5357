"""Correct answers of several kinds; each can read the answer of a student and report the differences. A student's curve
or formula is compared with the reference: they are equal, or the places where they differ are named.
"""

from __future__ import annotations

import ast
import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import count, pairwise, zip_longest

from flint import fmpq, fmpq_poly

from exactspline.errors import ExactSplineError, counted, shown
from exactspline.extras.teaching import differences as say
from exactspline.extras.teaching.differences import Difference, Entries, Wrong
from exactspline.extras.teaching.parts import Math, Part, Point, Polynomial
from exactspline.interchange.examples import example, example_names
from exactspline.language.formula import Formula
from exactspline.language.ruled import split
from exactspline.numbers.exact import from_flint, mpq, point_text, rational, text, to_fmpq
from exactspline.one_line import OneLine, one_line
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.questions import prove, verify
from exactspline.verification.vocabulary import Name

# ---- what students write


#: The longest answer and the highest degree that are accepted.
MAX_TEXT, MAX_FORMULA, MAX_DEGREE = 20_000, 300, 60
#: The longest intermediate coefficient.
MAX_BITS = 20_000
_GROUP = re.compile(r"\(([^()]*)\)")
_SIGNS = str.maketrans({"−": "-", "[": "(", "]": ")", "{": "(", "}": ")", ";": ",", '"': " ", "'": " ", "\ufeff": " "})
#: Texts that people write before a number: its name (``x =``, ``y(t) =``, ``centre:``), and words around it.
_LABELS = re.compile(r"[^\W\d][^=:,\n]*?[=:]|\b(?:yes|centre|center|radius|and|or)\b", re.IGNORECASE)
_POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")


class AnswerError(ExactSplineError):
    """An answer that cannot be read."""


def _cleaned(answer: str) -> str:
    """The answer with uniform minus signs and brackets, without names of numbers; raises `AnswerError` if it is too
    long, or a bracket is missing.
    """
    if len(answer) > MAX_TEXT:
        raise AnswerError(counted(len(answer), "character"), where="answer", remedy=f"at most {MAX_TEXT} are read")
    if (bare := answer.translate(_SIGNS)).count("(") != bare.count(")"):
        raise AnswerError("a bracket is missing", where="answer", remedy="write (x, y), (x, y), …")
    return _LABELS.sub(" ", bare).strip()


def _negative(answer: str) -> bool:
    """Whether the answer says "none" or "no".

    >>> [_negative(each) for each in ("none", "No, it is not.", "∅", "0")]
    [True, True, True, False]
    """
    return bool(re.match(r"(none|no|∅|\(\s*\))(\W|$)", _cleaned(answer), re.IGNORECASE))


def _numbers(answer: str) -> Point:
    """Numbers separated by commas or blanks, with or without names and brackets.

    >>> _numbers("1/2, −3") == _numbers("x = 1/2, y = -3") == _numbers("(1/2, -3)")
    True
    >>> _numbers("yes: centre (1, 2), r² = 5")
    (mpq(1,1), mpq(2,1), mpq(5,1))

    Raises `AnswerError` for anything else.
    """
    return tuple(map(_number, re.sub("[(),]", " ", _cleaned(answer)).split()))


def _points(answer: str, dimension: int) -> tuple[Point, ...]:
    """Points in brackets, or one point per line; plain numbers if the dimension is 1.

    >>> _points("(0, 1) (1/2, 2)", 2) == _points("0 1\\n1/2 2", 2) == _points('[[0, 1], ["1/2", 2]]', 2)
    True

    Raises `AnswerError` for anything else.
    """
    if dimension == 1:
        return tuple((x,) for x in _numbers(answer))
    bare = _cleaned(answer)
    if "(" not in bare:
        return tuple(_numbers(row) for row in bare.splitlines() if row.strip())
    if rest := _GROUP.sub(" ", bare).translate(str.maketrans("(),", "   ")).strip():
        raise AnswerError(f"{shown(rest)} between points", where="answer", remedy="write (x, y), (x, y), …")
    return tuple(_numbers(group) for group in _GROUP.findall(bare))


def _polynomials(answer: str) -> tuple[Polynomial, ...]:
    """Polynomials in t separated by commas or line breaks, written as in ``1 - 3t + 2t^2`` or ``2t(1-t)``.

    >>> _polynomials("(1-t)^2, 2t(1 - t)")[1]
    <Polynomial (0, 2, -2)>

    Raises `AnswerError` for anything else.
    """
    parts = [part for part in re.split(r"[,\n]", _without_outer_brackets(_cleaned(answer))) if part.strip()]
    return tuple(_polynomial(part) for part in parts)


def _without_outer_brackets(bare: str) -> str:
    """``(1 + t, t^2)`` without its outer brackets, if the first bracket closes at the end and encloses a comma."""
    depth = 0
    for i, sign in enumerate(bare):
        depth += (sign == "(") - (sign == ")")
        if not depth:
            return bare[1:-1] if i == len(bare) - 1 and "," in bare else bare
    return bare


def _number(word: str) -> mpq:
    try:
        return rational(word)
    except ExactSplineError:
        raise AnswerError(
            f"{shown(word)} is not a number", where="answer", remedy="write 3, -1/2 or 0.25, nothing else"
        ) from None


def _polynomial(formula: str) -> Polynomial:
    raised = re.sub(r"[⁰¹²³⁴⁵⁶⁷⁸⁹]+", lambda m: f"^{m[0].translate(_POWERS)}", formula)
    code = raised.replace("·", "*").replace("**", "^").replace("^", "**")
    # a number, t or a bracket, followed by t or a bracket, is a product
    code = re.sub(r"(?<=[\dt)])\s*(?=[t(])", "*", "".join(code.split()))
    problem = AnswerError(f"{shown(formula.strip())} is not a polynomial in t", where="answer", remedy="1 - 3t + 2t^2")
    if len(code) > MAX_FORMULA or not re.fullmatch(r"[0-9t+\-*/().]+", code):
        raise problem
    try:
        made = _value(ast.parse(code, mode="eval").body, code)
    except (SyntaxError, ValueError, ZeroDivisionError, RecursionError, MemoryError):
        raise problem from None
    return Polynomial(tuple(from_flint(c) for c in made.coeffs()))


def _value(node: ast.AST, code: str) -> fmpq_poly:
    match node:
        case ast.Name(id="t"):
            return fmpq_poly([0, 1])
        case ast.Constant():
            return fmpq_poly([to_fmpq(rational(ast.get_source_segment(code, node) or ""))])
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return -_value(inner, code)
        case ast.UnaryOp(op=ast.UAdd(), operand=inner):
            return _value(inner, code)
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int(power))) if 0 <= power <= MAX_DEGREE:
            return _checked(_value(left, code), power) ** power
        case ast.BinOp(left=left, op=operation, right=right):
            return _combined(operation, _value(left, code), _value(right, code))
    raise ValueError


def _combined(operation: ast.operator, a: fmpq_poly, b: fmpq_poly) -> fmpq_poly:
    match operation:
        case ast.Add():
            return a + b
        case ast.Sub():
            return a - b
        case ast.Mult():
            return _checked(a, 1) * _checked(b, 1)
        case ast.Div() if b.degree() == 0:
            return a * (fmpq(1) / b[0])
    raise ValueError


def _checked(p: fmpq_poly, power: int) -> fmpq_poly:
    """The polynomial, if its power has neither a high degree nor huge coefficients."""
    bits = max((max(int(c.p).bit_length(), int(c.q).bit_length()) for c in p.coeffs()), default=0)
    if p.degree() * power > MAX_DEGREE or bits * power > MAX_BITS:
        raise ValueError
    return p


@dataclass(frozen=True)
class Finding:
    """Whether an answer is right, and its errors otherwise. It is true if the answer is right."""

    differences: tuple[Difference, ...]

    @property
    def right(self) -> bool:
        """Whether there are no differences."""
        return not self.differences

    def __bool__(self) -> bool:
        return self.right

    @one_line
    def __repr__(self) -> str:
        return f"<Finding: {'; '.join(map(str, self.differences)) or 'right'}>"


class Answer(ABC):
    """A correct answer."""

    @property
    @abstractmethod
    def form(self) -> str:
        """How the answer is to be written."""

    @property
    @abstractmethod
    def parts(self) -> tuple[Part, ...]:
        """The answer as it is printed."""

    @property
    @abstractmethod
    def written(self) -> str:
        """The answer as a student would write it."""

    @abstractmethod
    def differences(self, answer: str) -> Iterator[Difference]:
        """The errors in an answer, none if it is right. Raises `AnswerError` if it cannot be read."""

    def check(self, answer: str) -> Finding:
        """The finding on the answer of a student.

        >>> print(*Numbers(("x", "y"), (mpq(1, 2), mpq(3))).check("0.5, 4").differences)
        y is 3, not 4

        Raises `AnswerError` if it cannot be read.
        """
        if not answer.strip():
            raise AnswerError("the answer is empty", where="answer", remedy=f"write {self.form}")
        try:
            return Finding(tuple(self.differences(answer)))
        except AnswerError as error:
            raise AnswerError(error.problem, where="answer", remedy=f"write {self.form}") from None


def _named_values(names: Sequence[str], values: Sequence[mpq | Polynomial]) -> tuple[Part, ...]:
    """Values with their names, separated by commas, for printing."""
    joined: list[Part] = []
    for name, value in zip(names, values, strict=True):
        joined += [*([", "] if joined else []), Math(name, (value,))]
    return tuple(joined)


@dataclass(frozen=True, repr=False)
class Numbers(Answer, OneLine):
    """Named numbers in a given order."""

    names: tuple[str, ...]
    values: Point

    @property
    def form(self) -> str:
        """How the answer is to be written."""
        return f"{', '.join(self.names)}: numbers separated by commas" if len(self.names) > 1 else "a number"

    @property
    def parts(self) -> tuple[Part, ...]:
        """The answer as it is printed."""
        return _named_values(self.names, self.values)

    @property
    def written(self) -> str:
        """The answer as a student would write it."""
        return ", ".join(map(text, self.values))

    def differences(self, answer: str) -> Iterator[Difference]:
        """Each wrong number, or a difference in their number."""
        answers = _numbers(answer)
        if len(answers) != len(self.values):
            yield say.other_count(Entries.NUMBERS, len(self.values), len(answers))
            return
        for name, right, given in zip(self.names, self.values, answers, strict=True):
            if given != right:
                yield say.other_number(Name(name), right, given)


@dataclass(frozen=True, repr=False)
class Parameters(Answer, OneLine):
    """A set of parameters, in any order; the empty set is written ``none``."""

    values: Point
    form = "numbers separated by commas, or none"

    @property
    def parts(self) -> tuple[Part, ...]:
        """The answer as it is printed."""
        return (Math("t", self.values),) if self.values else ("none",)

    @property
    def written(self) -> str:
        """The answer as a student would write it."""
        return ", ".join(map(text, self.values)) or "none"

    def differences(self, answer: str) -> Iterator[Difference]:
        """Each parameter that is missing or wrong."""
        answers = () if _negative(answer) else _numbers(answer)
        for t in self.values:
            if t not in answers:
                yield say.missing(t)
        for t in dict.fromkeys(answers):
            if t not in self.values:
                yield say.invented(t)


@dataclass(frozen=True, repr=False)
class Points(Answer, OneLine):
    """The control points of a curve or a function over the knots of the exercise; they are unique."""

    reference: Nurbs | BSpline

    @property
    def rows(self) -> tuple[Point, ...]:
        """The correct control points; for a function its ordinates."""
        if isinstance(self.reference, BSpline):
            return tuple((x,) for x in self.reference.control_points)
        return tuple(tuple(point) for point in self.reference.control_points)

    @property
    def form(self) -> str:
        """How the answer is to be written."""
        many = len(self.rows[0]) > 1
        return "points in order: (x, y), (x, y), …" if many else "numbers in order, separated by commas"

    @property
    def parts(self) -> tuple[Part, ...]:
        """The answer as it is printed."""
        plain = self.rows if len(self.rows[0]) > 1 else tuple(row[0] for row in self.rows)
        return (Math("", plain),)

    @property
    def written(self) -> str:
        """The answer as a student would write it."""
        return ", ".join(map(point_text, self.rows))

    def differences(self, answer: str) -> Iterator[Difference]:
        """Each wrong control point, then a parameter with both values there."""
        rows, dimension = self.rows, len(self.rows[0])
        answers = _points(answer, dimension)
        if any(len(point) != dimension for point in answers):
            yield say.other_coordinates(dimension)
            return
        if len(answers) != len(rows):
            yield say.other_count(Entries.POINTS, len(rows), len(answers))
            return
        wrong = [i for i, (right, given) in enumerate(zip(rows, answers, strict=True)) if right != given]
        for i in wrong:
            yield say.other_point(i, rows[i], answers[i])
        if wrong:
            yield _witness(self._value, self._of(answers), self.reference.domain)

    def _value(self, t: mpq) -> Point:
        value = self.reference(t)
        return value if isinstance(value, tuple) else (value,)

    def _of(self, rows: tuple[Point, ...]) -> Callable[[mpq], Point]:
        """The function given by a student's control points."""
        degree, knots = self.reference.degree, self.reference.knots
        splines = [BSpline(degree, knots, column) for column in zip(*rows, strict=True)]
        return lambda t: tuple(f(t) for f in splines)


@dataclass(frozen=True, repr=False)
class Polynomials(Answer, OneLine):
    """Named polynomials in t, in any notation."""

    names: tuple[str, ...]
    values: tuple[Polynomial, ...]

    @property
    def form(self) -> str:
        """How the answer is to be written."""
        return f"{', '.join(self.names)}: polynomials in t separated by commas, such as 1 - 3t + 2t^2"

    @property
    def parts(self) -> tuple[Part, ...]:
        """The answer as it is printed."""
        return _named_values(self.names, self.values)

    @property
    def written(self) -> str:
        """The answer as a student would write it."""
        return ", ".join(
            " + ".join(f"({text(c)})*t^{i}" for i, c in enumerate(p.coefficients)) or "0" for p in self.values
        )

    def differences(self, answer: str) -> Iterator[Difference]:
        """Each wrong coefficient, then a parameter with both values there."""
        answers = _polynomials(answer)
        if len(answers) != len(self.values):
            yield say.other_count(Entries.POLYNOMIALS, len(self.values), len(answers))
            return
        for name, right, given in zip(self.names, self.values, answers, strict=True):
            pairs = list(zip_longest(right.coefficients, given.coefficients, fillvalue=mpq(0)))
            wrong = [(i, a, b) for i, (a, b) in enumerate(pairs) if a != b]
            for i, a, b in wrong:
                yield say.other_coefficient(Name(name), i, a, b)
            if wrong:
                yield _witness(_values_of(right), _values_of(given), (mpq(0), mpq(1)), Name(name))


@dataclass(frozen=True, repr=False)
class Circle(Answer, OneLine):
    """The answer to the question whether an arc is circular: ``no``, or the centre and the square of the radius."""

    #: Centre and squared radius; empty if it is not a circle.
    values: Point
    form = "no, or centre x, centre y, radius²"

    @property
    def parts(self) -> tuple[Part, ...]:
        """The answer as it is printed."""
        if not self.values:
            return ("no",)
        *centre, square = self.values
        return ("yes: centre ", Math("", (tuple(centre),)), ", ", Math("r²", (square,)))

    @property
    def written(self) -> str:
        """The answer as a student would write it."""
        return ", ".join(map(text, self.values)) or "no"

    def differences(self, answer: str) -> Iterator[Difference]:
        """The error: it is, or is not, a circle, or a number is wrong."""
        if _negative(answer):
            yield from [Wrong.CIRCLE] * bool(self.values)
        elif self.values:
            yield from Numbers(("centre x", "centre y", "radius²"), self.values).differences(answer)
        else:
            _numbers(answer)
            yield Wrong.NOT_A_CIRCLE


def _values_of(p: Polynomial) -> Callable[[mpq], Point]:
    def value(t: mpq) -> Point:
        total = mpq(0)
        for c in reversed(p.coefficients):
            total = total * t + c
        return (total,)

    return value


def _simple_parameters(low: mpq, high: mpq) -> Iterator[mpq]:
    """The rational parameters of an interval, in the order of their denominators; an infinite sequence.

    >>> from itertools import islice
    >>> [str(t) for t in islice(_simple_parameters(mpq(0), mpq(1)), 5)]
    ['0', '1', '1/2', '1/3', '2/3']
    """
    yield from (low, high)
    for below in count(2):
        for above in range(1, below):
            share = mpq(above, below)
            if share.denominator == below:
                yield low + (high - low) * share


def _witness(
    right: Callable[[mpq], Point], given: Callable[[mpq], Point], domain: tuple[mpq, mpq], name: Name | None = None
) -> Difference:
    """A parameter at which two different functions differ: polynomials do so at all but finitely many parameters."""
    t = next(t for t in _simple_parameters(*domain) if right(t) != given(t))
    return say.other_value(name, t, right(t), given(t))


def compare_curves(given: Nurbs, reference: Nurbs) -> Finding:
    """Whether two curves are the same function, regardless of degrees and knots; if not, a parameter with both points.

    >>> line = Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 4)])
    >>> compare_curves(line.elevate_degree(), line).right
    True
    >>> print(*compare_curves(Nurbs(1, [0, 0, 1, 1], [(0, 0), (2, 3)]), line).differences, sep="; ")
    control point 1 is (2, 4), not (2, 3); at t = 1 it gives (2, 3) instead of (2, 4)
    """
    if given.dimension != reference.dimension:
        return Finding((say.other_dimension(reference.dimension, given.dimension),))
    if given.domain != reference.domain:
        return Finding((say.other_domain(*reference.domain, *given.domain),))
    if given == reference:
        return Finding(())
    differences: list[Difference] = (
        [Wrong.REVERSED] if given == reference.reverse() else _other_points(given, reference)
    )
    # on one segment polynomials differ at all but finitely many parameters; elsewhere the curves may be the same
    breaks = sorted({*given.breakpoints, *reference.breakpoints})
    a, b = next((a, b) for a, b in pairwise(breaks) if given.restrict(a, b) != reference.restrict(a, b))
    t = next(t for t in _simple_parameters(a, b) if given(t) != reference(t))
    return Finding((*differences, say.other_value(None, t, reference(t), given(t))))


def _other_points(given: Nurbs, reference: Nurbs) -> list[Difference]:
    """The control points that differ, if the curves have the same degree, knots and weights."""
    alike = (given.degree, given.knots) == (reference.degree, reference.knots)
    if not (alike and given.polynomial and reference.polynomial):
        return []
    pairs = enumerate(zip(given.control_points, reference.control_points, strict=True))
    return [say.other_point(i, right, wrong) for i, (wrong, right) in pairs if wrong != right]


def compare_formulas(given: Formula, reference: Formula, factor: str = "1") -> Finding:
    """Whether ``given = factor · reference`` for all curves, proved with indeterminate derivatives; if not, the true
    quotient, and a curve and a parameter with both values.

    >>> from exactspline.papers import find
    >>> compare_formulas(find("f1"), find("f2"), "w").right
    True
    >>> print(compare_formulas(find("f1"), find("f2")).differences[0])
    not f1 = f2 in R2: the quotient is w

    Raises `FormulaError` for formulas that cannot be compared.
    """
    proof = prove(given, reference, factor)
    if proof:
        return Finding(())
    witness = _on_an_example(given, reference, factor, proof.dimension)
    return Finding((say.not_proved(proof), *([witness] if witness else [])))


def _on_an_example(given: Formula, reference: Formula, factor: str, dimension: int) -> Difference | None:
    """Values of both sides at a point of an example curve where they differ; None if the formulas do not apply to a
    single curve.
    """
    for name in example_names():
        curve = example(name)
        if curve.dimension != dimension:
            continue
        try:
            result = verify(given, reference, curve, factor)
        except ExactSplineError:
            continue
        if (t := result.parameter) is not None:
            left, right = (_value_of(f, curve, t) for f in (given, reference))
            return say.other_on_example(Name(name), t, right, left, None if factor == "1" else Name(factor))
    return None


def _value_of(formula: Formula, curve: Nurbs, t: mpq) -> Point | None:
    parts, denominator = split(formula(curve))
    below = mpq(1) if denominator is None else denominator(t)
    return tuple(part(t) / below for part in parts) if below else None
