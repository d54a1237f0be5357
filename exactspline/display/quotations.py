r"""Words of a source, whose formulas stand there in TeX, as a page shows them.

Some sources are quoted with their dollars, some from inside a formula; commands of their own are those of their
preambles.
"""

from __future__ import annotations

import re

#: Commands that a source defines for itself (Petrunin and Zamora Barrera), or that only its typesetter reads.
COMMANDS = {
    r"\kur": r"\kappa",
    r"\skur": r"\kappa",
    r"\tor": r"\tau",
    r"\tan": r"\mathrm{T}",
    r"\norm": r"\mathrm{N}",
    r"\bi": r"\mathrm{B}",
}
_DROPPED = re.compile(r"\\(?:eqlbl|label|index)\{[^{}]*\}")
_COMMAND = re.compile(r"\\[A-Za-z]+")
_FORMULA = re.compile(r"\$([^$]+)\$|\\\((.+?)\\\)|\\\[(.+?)(?:\\\]|$)")
#: What stands in formulas without a command of TeX: an aligned sum, an index or an exponent; and what in none.
_INSIDE = re.compile(r"&|\b[a-z]_\d|[a-z)]\^\d\b")
_OTHERWISE = re.compile(r"[*;]|\b[a-z]{3,}\b|\d\.\d")


def parts(words: str) -> list[tuple[bool, str]]:
    r"""The words as pieces of prose and of formulas (True), these in TeX without delimiters.

    >>> parts(r"Assume $|\gamma|=1$ for any~$s$.")
    [(False, 'Assume '), (True, '|\\gamma|=1'), (False, ' for any\xa0'), (True, 's'), (False, '.')]
    >>> parts(r"\kappa = \frac{1}{R}"), parts("no root of f")
    ([(True, '\\kappa = \\frac{1}{R}')], [(False, 'no root of f')])
    """
    words = _DROPPED.sub("", words).strip()
    if not _FORMULA.search(words):
        is_formula = "\\" in words or (bool(_INSIDE.search(words)) and not _OTHERWISE.search(words))
        return [(is_formula, _formula(words) if is_formula else words)]
    found, last = [], 0
    for each in _FORMULA.finditer(words):
        found += [(False, _prose(words[last : each.start()])), (True, _formula(next(filter(None, each.groups()))))]
        last = each.end()
    return [(kind, text) for kind, text in [*found, (False, _prose(words[last:]))] if text]


def quoted(words: str) -> str:
    r"""The words as text whose formulas stand between dollars.

    >>> quoted(r"\[\kur=\frac1R,\]")
    '$\\kappa=\\frac1R,$'
    """
    return "".join(f"${text}$" if is_formula else text for is_formula, text in parts(words))


def _formula(tex: str) -> str:
    tex = _COMMAND.sub(lambda found: COMMANDS.get(found[0], found[0]), tex)
    return " ".join(tex.replace("&", r"\ ").strip("~ ").split())


def _prose(text: str) -> str:
    return re.sub(r"\\emph\{([^{}]*)\}", r"\1", text).replace("~", "\xa0")
