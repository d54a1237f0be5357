r"""Text with formulas in it as LaTeX: the words that belong to a formula are found, and each formula is written as a
whole.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import cast

from exactspline.papers.folder import read_toml

_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁽⁾ⁱᵀ", "0123456789-()iT")
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉ₓᵧ", "0123456789xy")
#: The pieces of a text: names such as f2, letters with an index, an exponent or a prime, runs of these, letters with a
#: bar, any other sign.
_PIECES = re.compile(
    r"\b(?P<name>[fgD]\d+)\b|\b(?P<letter>[A-Za-z])(?=[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁽₀₁₂₃₄₅₆₇₈₉′″‴])|(?P<raised>[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁽⁾ⁱᵀ]+)"
    "|(?P<lowered>[₀₁₂₃₄₅₆₇₈₉ₓᵧ]+)|(?P<barred>.)\u0304|(?P<other>.)",
    re.DOTALL,
)
#: Signs in formulas and in prose, the commands of a paper, and what proofs say.
TABLES = cast("dict[str, dict[str, str]]", read_toml(Path(__file__).with_name("latex.toml"), "latex.toml"))
SIGNS, LETTERS = TABLES["signs"], TABLES["letters"]


def in_mathematics(tex: str) -> str:
    r"""A LaTeX formula in which signs that LaTeX does not know are replaced.

    >>> in_mathematics("4d − 2")
    '4d - 2'
    """
    return "".join(SIGNS.get(sign, sign) if sign not in "|<>" else sign for sign in tex)


def prose(text: str) -> str:
    r"""A text as LaTeX: each whole formula between dollars, everything else unchanged.

    >>> print(prose("λ = ζ/‖γ′‖: then ‖γ̄″‖² = w⁴ f2 & 5 % of a curve (of degree d)"))
    $\lambda = \zeta /\|\gamma '\|$: then $\|\bar{\gamma }''\|^{2} = w^{4}\,f_{2}$ \& 5 \% of a curve (of degree $d$)
    """
    return " ".join(_joined(text.split(" ")))


#: Short words that are not formulas; a word of one letter is a formula if it is next to an operator.
_ARTICLES = {"a", "A", "I"}
_SHORT = frozenset(
    ("is", "of", "in", "at", "to", "by", "an", "no", "it", "as", "be", "or", "on", "if", "so", "up", "do")
)
#: Signs that stand between formulas.
_OPERATOR = re.compile(r"[=+−·×/<>≤≥≠≢±∗↦]")
#: The parts of which a formula may consist: letters one by one, digits, signs; not the number of a section, claim or
#: page.
_SIGN = rf"[A-Za-z0-9+=/()\[\]|<>,\u0304{re.escape(''.join(SIGNS))}⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁽⁾ⁱᵀ₀₁₂₃₄₅₆₇₈₉ₓᵧ]"
_FORMULA = re.compile(rf"(?![A-CE-Z]\d){_SIGN}+")
_WORD = re.compile(r"[A-Za-z]{2,}(?!\u0304)(?:_\w+)*|[A-Za-z]\w*_\w+")
#: Products of two letters: degrees such as kd, and two letters next to other signs.
_PRODUCT = re.compile(r"[a-z][A-Za-z]")
_AFTER = ".,;:?!”"
_OPEN, _CLOSED = "([⟨⁽", ")]⟩⁾"


def _kind_of(token: str) -> str:
    """The kind of a word: `formula`; `number` or `name`, which are formulas next to an operator; `operator`; or
    ``""``.
    """
    if _OPERATOR.fullmatch(token):
        return "operator"
    bare = token.strip("()[],")
    if re.fullmatch(r"\d+", bare):
        return "number"
    if not bare or bare in _SHORT:
        return ""
    if bare in _ARTICLES or re.fullmatch(r"[A-Za-z]\w*_\w+", bare) or _PRODUCT.fullmatch(bare):
        return "name"
    has_sign = any(sign in SIGNS and not sign.isascii() for sign in token)
    without = _WORD.sub(lambda word: "" if has_sign or _is_product(word[0]) else word[0], token)
    return "formula" if _FORMULA.fullmatch(token) and not _WORD.search(without) else ""


def _is_product(word: str) -> bool:
    return bool(_PRODUCT.fullmatch(word)) and word not in _SHORT


def _joined(tokens: list[str]) -> Iterator[str]:
    """The words, with every run of words that is one formula joined."""
    at = 0
    while at < len(tokens):
        end = _end_of_formula(tokens, at)
        yield _formula(" ".join(tokens[at:end])) if end > at else _in_pieces(tokens[at])
        at = max(end, at + 1)


def _end_of_formula(tokens: list[str], at: int) -> int:
    """The end of the formula that begins at a word; the word itself if no formula begins there."""
    end, good, kinds, depth = at, at, list[str](), 0
    while end < len(tokens):
        token = tokens[end]
        depth += sum(token.count(sign) for sign in _OPEN) - sum(token.count(sign) for sign in _CLOSED)
        after = token[len(token.rstrip(_AFTER)) :]
        kind = _kind_of(token.rstrip(_AFTER))
        before = kinds[-1] if kinds else ""
        beside = before in ("", "operator") or kind == "operator" or (before == kind == "formula")
        if not kind or not beside or (kind == "operator" and not kinds):
            break
        kinds.append(kind)
        end += 1
        is_whole = kind != "operator" and (len(kinds) > 1 or kind == "formula")
        good = end if is_whole and "formula" in kinds else good
        if after and (depth <= 0 or after != ","):
            break
    return good


def _formula(text: str) -> str:
    """A run of words between dollars, without the brackets and stops around it."""
    core = text.rstrip(_AFTER)
    before, after = "", text[len(core) :]
    while core and core[0] in _OPEN and _excess(core) > 0:
        before, core = before + core[0], core[1:]
    while core and core[-1] in _CLOSED and _excess(core) < 0:
        core, after = core[:-1], core[-1] + after
    if not core or _excess(core) or _kind_of(core.replace(" ", "")) == "number":
        return " ".join(map(_in_pieces, text.split(" ")))
    body = "".join(_in_formula(each) for each in _PARTS.finditer(core))
    return f"{before}${re.sub(' +', ' ', body).strip()}${after}"


def _excess(text: str) -> int:
    """The number of brackets that are opened and not closed."""
    return sum((letter in _OPEN) - (letter in _CLOSED) for letter in text)


#: The pieces of a formula: words, the space between factors, and those of any text.
_PARTS = re.compile(
    rf"(?P<word>{_WORD.pattern})|(?P<times>(?<![=+−·×/<>≤≥≠≢±∗↦,]) (?![=+−·×/<>≤≥≠≢±∗↦]))|(?P<index>\b[a-eh-z]\d+\b)"
    rf"|{_PIECES.pattern}",
    re.DOTALL,
)


def _in_formula(each: re.Match[str]) -> str:
    kind, text = str(each.lastgroup), each[str(each.lastgroup)]
    if kind == "times":
        return r"\,"
    if kind == "index":
        return f"{text[0]}_{{{text[1:]}}}"
    if kind == "word":
        return text if _is_product(text) else rf"\mathrm{{{literal(text)}}}"
    return _tex(kind, text)


def _in_pieces(text: str) -> str:
    """A word as LaTeX, its signs between dollars."""
    pieces = [_piece(str(each.lastgroup), each[str(each.lastgroup)]) for each in _PIECES.finditer(text)]
    return "".join(pieces).replace("$\0\0$", "").replace("\0", "")


def literal(text: str) -> str:
    r"""A name as LaTeX, without any formula.

    >>> literal("C42b-g1_g0")
    'C42b-g1\\_g0'
    """
    return "".join(LETTERS.get(sign, sign) for sign in text)


def _piece(kind: str, text: str) -> str:
    """A piece of a text; zero bytes mark where formulas touch."""
    if kind == "other" and text not in SIGNS:
        return LETTERS.get(text, text)
    return f"\0${_tex(kind, text)}$\0"


def _tex(kind: str, text: str) -> str:
    """A piece of a formula."""
    formula = {
        "name": f"{text[0]}_{{{text[1:]}}}",
        "letter": text,
        "raised": f"^{{{text.translate(_RAISED)}}}",
        "lowered": f"_{{{text.translate(_LOWERED)}}}",
        "barred": rf"\bar{{{SIGNS.get(text, text)}}}",
        "other": SIGNS.get(text, text),
    }
    return formula[kind]


# ---- the words of a source
#
# Some sources are quoted with dollar signs, some from inside a formula; some use commands from their preambles.


#: Bold letters in Markdown, and an index in HTML.
_MARKED = re.compile(r"\*\*(?P<bold>\w+)\*\*|\b(?P<name>[A-Za-z]\w*)<sub>(?P<index>\w+)</sub>")
_DROPPED = re.compile(r"\\(?:eqlbl|label|index)\{[^{}]*\}")
_COMMAND = re.compile(r"\\[A-Za-z]+")
_QUOTED = re.compile(r"\$([^$]+)\$|\\\((.+?)\\\)|\\\[(.+?)(?:\\\]|$)")
#: Signs of a formula without a TeX command: an aligned sum, an index or an exponent; and signs of plain text.
_INSIDE = re.compile(r"&|\b[a-z]_\d|[a-z)]\^\d\b")
_OTHERWISE = re.compile(r"[*;]|\b[a-z]{3,}\b|\d\.\d")


def parts(words: str) -> list[tuple[bool, str]]:
    r"""The words as pieces: (False, prose) or (True, a formula in TeX without delimiters).

    >>> parts(r"Assume $|\gamma|=1$ for any~$s$.")
    [(False, 'Assume '), (True, '|\\gamma|=1'), (False, ' for any\xa0'), (True, 's'), (False, '.')]
    >>> parts(r"\kappa = \frac{1}{R}"), parts("no root of f")
    ([(True, '\\kappa = \\frac{1}{R}')], [(False, 'no root of f')])
    >>> parts("1/point3<sub>x</sub>, **r**")
    [(False, '1/'), (True, '\\mathrm{point3}_{x}'), (False, ', '), (True, '\\mathbf{r}')]
    """
    words = _MARKED.sub(_marked, _DROPPED.sub("", words)).strip()
    if not _QUOTED.search(words):
        is_formula = "\\" in words or (bool(_INSIDE.search(words)) and not _OTHERWISE.search(words))
        return [(is_formula, _of_source(words) if is_formula else words)]
    pieces, last = [], 0
    for each in _QUOTED.finditer(words):
        pieces += [(False, _prose(words[last : each.start()])), (True, _of_source(next(filter(None, each.groups()))))]
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


def _of_source(tex: str) -> str:
    tex = _COMMAND.sub(lambda match: TABLES["commands"].get(match[0], match[0]), tex)
    return " ".join(tex.replace("&", r"\ ").strip("~ ").split())


def _prose(text: str) -> str:
    return re.sub(r"\\emph\{([^{}]*)\}", r"\1", text).replace("~", "\xa0")
