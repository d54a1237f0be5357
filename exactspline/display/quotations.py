r"""The words of a source, with formulas in TeX, prepared for display on a page.

Some sources are quoted with dollar signs, some from inside a formula; some use commands from their preambles.
"""

from __future__ import annotations

import re

#: Commands that a source defines for itself (Petrunin and Zamora Barrera), or that affect typesetting only.
COMMANDS = {
    r"\kur": r"\kappa",
    r"\skur": r"\kappa",
    r"\tor": r"\tau",
    r"\tan": r"\mathrm{T}",
    r"\norm": r"\mathrm{N}",
    r"\bi": r"\mathrm{B}",
}
#: Bold letters of Markdown, and an index of HTML.
_MARKED = re.compile(r"\*\*(?P<bold>\w+)\*\*|\b(?P<name>[A-Za-z]\w*)<sub>(?P<index>\w+)</sub>")
_DROPPED = re.compile(r"\\(?:eqlbl|label|index)\{[^{}]*\}")
_COMMAND = re.compile(r"\\[A-Za-z]+")
_FORMULA = re.compile(r"\$([^$]+)\$|\\\((.+?)\\\)|\\\[(.+?)(?:\\\]|$)")
#: Signs of a formula without a TeX command: an aligned sum, an index or an exponent; and signs of plain text.
_INSIDE = re.compile(r"&|\b[a-z]_\d|[a-z)]\^\d\b")
_OTHERWISE = re.compile(r"[*;]|\b[a-z]{3,}\b|\d\.\d")


def parts(words: str) -> list[tuple[bool, str]]:
    r"""The words as pieces of prose (False) and of formulas (True, in TeX without delimiters).

    >>> parts(r"Assume $|\gamma|=1$ for any~$s$.")
    [(False, 'Assume '), (True, '|\\gamma|=1'), (False, ' for any\xa0'), (True, 's'), (False, '.')]
    >>> parts(r"\kappa = \frac{1}{R}"), parts("no root of f")
    ([(True, '\\kappa = \\frac{1}{R}')], [(False, 'no root of f')])
    >>> parts("1/point3<sub>x</sub>, **r**")
    [(False, '1/'), (True, '\\mathrm{point3}_{x}'), (False, ', '), (True, '\\mathbf{r}')]
    """
    words = _MARKED.sub(_marked, _DROPPED.sub("", words)).strip()
    if not _FORMULA.search(words):
        is_formula = "\\" in words or (bool(_INSIDE.search(words)) and not _OTHERWISE.search(words))
        return [(is_formula, _formula(words) if is_formula else words)]
    pieces, last = [], 0
    for each in _FORMULA.finditer(words):
        pieces += [(False, _prose(words[last : each.start()])), (True, _formula(next(filter(None, each.groups()))))]
        last = each.end()
    return [(kind, text) for kind, text in [*pieces, (False, _prose(words[last:]))] if text]


def quoted(words: str) -> str:
    r"""The words as text with formulas between dollar signs.

    >>> quoted(r"\[\kur=\frac1R,\]")
    '$\\kappa=\\frac1R,$'
    """
    return "".join(f"${text}$" if is_formula else text for is_formula, text in parts(words))


def _marked(found: re.Match[str]) -> str:
    if found["bold"]:
        return rf"$\mathbf{{{found['bold']}}}$"
    return rf"$\mathrm{{{found['name']}}}_{{{found['index']}}}$"


def _formula(tex: str) -> str:
    tex = _COMMAND.sub(lambda match: COMMANDS.get(match[0], match[0]), tex)
    return " ".join(tex.replace("&", r"\ ").strip("~ ").split())


def _prose(text: str) -> str:
    return re.sub(r"\\emph\{([^{}]*)\}", r"\1", text).replace("~", "\xa0")
