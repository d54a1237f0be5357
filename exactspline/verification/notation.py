"""The notation of claims: factors as text, read and evaluated, and names, degrees and factors in LaTeX."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from exactspline.errors import ClaimError, as_text, shown
from exactspline.language.arguments import Evaluated
from exactspline.language.formula import Formula
from exactspline.language.operand import Operand
from exactspline.numbers.exact import rational
from exactspline.papers import find as find_anywhere

#: The names of the denominators of the first and of the second curve.
WEIGHTS = ("w", "W")
#: The largest length of a name or number, and the largest number of factors, powers counted with multiplicity.
LETTERS, FACTORS = 200, 64


def factor_parts(text: str) -> list[tuple[str, int]]:
    """The names and numbers of a factor with their exponents.

    >>> factor_parts("2 w^16 D1_squared^-4")
    [('2', 1), ('w', 16), ('D1_squared', -4)]

    Raises `ClaimError` when it cannot be read, or is zero or divided by zero.
    """
    parts, remaining = [], FACTORS
    for part in as_text(text, "a factor").split():
        match = re.fullmatch(r"([A-Za-z]\w*|-?\d+(?:/\d+)?)(?:\^(-?\d+))?", part)
        if not match:
            raise ClaimError(
                f"the factor {text!r} cannot be read", where=part, remedy='write for example "-2 w^29 f2" or "w^-4"'
            )
        if not match[1][0].isalpha() and re.fullmatch(r"-?0+(/\d+)?|-?\d+/0+", match[1]):
            raise ClaimError(f"the factor {text!r} is zero or divided by zero", where=part, remedy="remove the zero")
        exponent = int(match[2] or 1) if len(match[2] or "") < LETTERS else FACTORS + 1
        remaining -= abs(exponent)
        if remaining < 0 or len(match[1]) > LETTERS:
            raise ClaimError(
                f"the factor {shown(text)} is too large", where=part[:60], remedy=f"at most {FACTORS} factors in all"
            )
        parts.append((match[1], exponent))
    if not parts:
        raise ClaimError("the factor is empty", remedy='write "1"')
    return parts


def factor_formulas(text: str, find: Callable[[str], Formula] = find_anywhere) -> list[Formula]:
    """The formulas in a factor.

    >>> [formula.name for formula in factor_formulas("2 w^16 D1_squared^-4")]
    ['D1_squared']

    Raises `ClaimError` when it cannot be read.
    """
    return [find(name) for name, _ in factor_parts(text) if name[0].isalpha() and name not in WEIGHTS]


def factor_of_text(
    text: str, curve: Evaluated, find: Callable[[str], Formula] = find_anywhere
) -> tuple[Operand, Operand]:
    """A factor as stated in a claim, ``"2 w^29 f2"`` or ``"w^-4"``, as numerator and denominator in the evaluation mode
    of the curve. `find` gives the formulas in it.

    Raises `ClaimError` when it cannot be read.
    """
    known: Mapping[str, Any] = curve.operands()
    one = next(known[name] for name in ("w", "w1", *known) if name in known)
    top = bottom = one.constant(1)
    for name, exponent in factor_parts(text):
        value = (
            known[name]
            if name in WEIGHTS and name in known
            else find(name)(curve)
            if name[0].isalpha()
            else one.constant(rational(name))
        )
        if exponent > 0:
            top = top * value**exponent
        else:
            bottom = bottom * value ** (-exponent)
    return top, bottom


def spelled(name: str) -> str:
    r"""The name of a formula without a symbol, as LaTeX.

    >>> spelled("evolute_contact_1")
    '\\mathrm{evolute\\_contact\\_1}'
    """
    return rf"\mathrm{{{name.replace('_', chr(92) + '_')}}}"


def degree_latex(claimed: str) -> str:
    """A degree in the notation of claims, as LaTeX."""
    return re.sub(r"d(\d)", r"d_\1", claimed.replace("−", "-").replace("max", r"\max"))


def factor_latex(factor: str, find: Callable[[str], Formula] = find_anywhere) -> str:
    r"""A factor in the notation of claims, as LaTeX; empty for 1.

    >>> factor_latex("2 w^16 D1_squared^-4")
    '2\\,w^{16}\\,(\\|D_1\\|^2)^{-4}\\,'
    """
    parts = []
    for part in factor.split():
        name, _, exponent = part.partition("^")
        is_formula = name[0].isalpha() and name not in WEIGHTS
        base = find(name).symbol or spelled(name) if is_formula else name.replace("W", r"\bar w")
        base = f"({base})" if exponent and "^" in base else base
        parts.append(f"{base}^{{{exponent}}}" if exponent else base)
    return "" if factor == "1" else r"\,".join([*parts, ""])
