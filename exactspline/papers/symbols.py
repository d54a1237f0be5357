"""Symbols of users' formulas: only LaTeX that typesets a symbol is allowed, no commands that read, write or link."""

from __future__ import annotations

import re

_COMMANDS = """
alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi pi rho varrho sigma tau
upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega nabla partial ell hbar
prime infty perp parallel times cdot star ast circ pm mp wedge oplus otimes langle rangle lVert rVert lvert rvert
Vert vert hat widehat tilde widetilde bar overline underline vec dot ddot breve check acute grave mathrm mathbf
mathit mathsf mathcal mathbb mathfrak boldsymbol operatorname text frac tfrac sqrt left right quad qquad bot top
dagger ddagger flat sharp natural
"""
#: LaTeX commands that are allowed in a symbol: letters, signs, accents and alphabets.
COMMANDS = frozenset(_COMMANDS.split())
#: The largest number of characters.
LONGEST = 200
#: Single characters allowed after a backslash: spaces, and characters that need to be escaped.
SIGNS = frozenset(",;:!| {}")


def not_a_symbol(symbol: str) -> str:
    r"""The reason why a text is not acceptable as LaTeX for a symbol, which appears in HTML and LaTeX of others; empty
    if it is acceptable.

    >>> not_a_symbol(r"[\kappa_{1}\ \hat{D}']"), not_a_symbol(r"\input{x}"), not_a_symbol("a}^{b")
    ('', 'the command \\input', 'unbalanced braces')
    """
    for command in re.findall(r"\\([A-Za-z]+|.|$)", symbol):
        if command not in COMMANDS and command not in SIGNS:
            return f"the command \\{command}"
    if character := re.search(r"[%#&~$]|\^\^", symbol):
        return f"{character[0]!r} in it"
    if len(symbol) > LONGEST:
        return f"more than {LONGEST} characters"
    if len(re.findall(r"\\left(?![A-Za-z])", symbol)) != len(re.findall(r"\\right(?![A-Za-z])", symbol)):
        return r"a \left without its \right"
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", symbol):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            break
    return "unbalanced braces" if depth else ""
