"""The symbols of strangers' formulas: LaTeX that writes a sign, and nothing that reads, writes or links."""

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
#: Commands of LaTeX that may stand in a symbol: letters, signs, accents and alphabets.
COMMANDS = frozenset(_COMMANDS.split())
#: Single signs after a backslash: blanks, and signs with another meaning without it.
SIGNS = frozenset(",;:!| {}")


def not_a_symbol(symbol: str) -> str:
    r"""Why a text is not LaTeX for a symbol, which stands in the pages and the LaTeX of others; empty where it is.

    >>> not_a_symbol(r"[\kappa_{1}\ \hat{D}']"), not_a_symbol(r"\input{x}"), not_a_symbol("a}^{b")
    ('', 'the command \\input', 'braces that do not match')
    """
    for command in re.findall(r"\\([A-Za-z]+|.|$)", symbol):
        if command not in COMMANDS and command not in SIGNS:
            return f"the command \\{command}"
    if found := re.search(r"[%#&~$]|\^\^", symbol):
        return f"{found[0]!r} in it"
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", symbol):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            break
    return "braces that do not match" if depth else ""
