"""Claims in LaTeX: the names of formulas, degrees and factors."""

from __future__ import annotations

import re
from collections.abc import Callable

from exactspline.language.formula import Formula
from exactspline.papers import find as find_anywhere


def symbol(name: str, find: Callable[[str], Formula] = find_anywhere) -> str:
    r"""The LaTeX name of a formula: its symbol in the paper, or its name where it has none. `find` gives formulas.

    >>> symbol("f2"), symbol("evolute_contact_1")
    ('f_2', '\\mathrm{evolute\\_contact\\_1}')
    """
    return find(name).symbol or rf"\mathrm{{{name.replace('_', chr(92) + '_')}}}"


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
        base = symbol(name, find) if name[0].isalpha() and name not in ("w", "W") else name.replace("W", r"\bar w")
        base = f"({base})" if exponent and "^" in base else base
        parts.append(f"{base}^{{{exponent}}}" if exponent else base)
    return "" if factor == "1" else r"\,".join([*parts, ""])
