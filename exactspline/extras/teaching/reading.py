"""Parsing of students' answers: numbers, points and polynomials in t, read exactly or rejected."""

from __future__ import annotations

import ast
import re

from flint import fmpq, fmpq_poly

from exactspline.errors import ExactSplineError, counted, shown
from exactspline.extras.teaching.parts import Point, Polynomial
from exactspline.numbers.exact import from_flint, mpq, rational, to_fmpq

#: The longest answer and the highest degree that are accepted.
MAX_TEXT, MAX_FORMULA, MAX_DEGREE = 20_000, 300, 60
#: The longest intermediate coefficient.
MAX_BITS = 20_000
_GROUP = re.compile(r"\(([^()]*)\)")
_SIGNS = str.maketrans({"−": "-", "[": "(", "]": ")", ";": ",", '"': " ", "'": " ", "\ufeff": " "})
_POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")


class AnswerError(ExactSplineError):
    """An answer that cannot be read."""


def cleaned(answer: str) -> str:
    """The answer with uniform minus signs and brackets; raises `AnswerError` if it is too long."""
    if len(answer) > MAX_TEXT:
        raise AnswerError(counted(len(answer), "character"), where="answer", remedy=f"at most {MAX_TEXT} are read")
    return answer.translate(_SIGNS).strip()


def numbers(answer: str) -> Point:
    """Numbers separated by commas or blanks.

    >>> numbers("1/2, −3")
    (mpq(1,2), mpq(-3,1))

    Raises `AnswerError` for anything else.
    """
    bare = cleaned(answer)
    if bare.startswith("(") and bare.endswith(")"):
        bare = bare[1:-1]
    return tuple(map(_number, bare.replace(",", " ").split()))


def points(answer: str, dimension: int) -> tuple[Point, ...]:
    """Points in brackets, or one point per line; plain numbers if the dimension is 1.

    >>> points("(0, 1) (1/2, 2)", 2) == points("0 1\\n1/2 2", 2) == points('[[0, 1], ["1/2", 2]]', 2)
    True

    Raises `AnswerError` for anything else.
    """
    bare = cleaned(answer)
    if bare.count("(") != bare.count(")"):
        raise AnswerError("a bracket is missing", where="answer", remedy="write (x, y), (x, y), …")
    if dimension == 1 and "(" in bare:
        bare = bare.replace("(", " ").replace(")", " ")
    if "(" not in bare:
        rows = [bare.replace("\n", " ")] if dimension == 1 else bare.splitlines()
        points_read = [numbers(row) for row in rows if row.strip()]
        return tuple((x,) for x in points_read[0]) if dimension == 1 and points_read else tuple(points_read)
    if rest := _GROUP.sub(" ", bare).translate(str.maketrans("(),", "   ")).strip():
        raise AnswerError(f"{shown(rest)} between points", where="answer", remedy="write (x, y), (x, y), …")
    return tuple(numbers(group) for group in _GROUP.findall(bare))


def polynomials(answer: str) -> tuple[Polynomial, ...]:
    """Polynomials in t separated by commas or line breaks, written as in ``1 - 3t + 2t^2`` or ``2t(1-t)``.

    >>> polynomials("(1-t)^2, 2t(1 - t)")[1]
    <Polynomial (0, 2, -2)>

    Raises `AnswerError` for anything else.
    """
    parts = [part for part in re.split(r"[,\n]", _without_outer_brackets(cleaned(answer))) if part.strip()]
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
    # a number, t or a bracket followed by t or a bracket is a product
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
