"""A claim as a LaTeX theorem with its proof: the statement, with the formulas written out, and its decision. The text
needs `PREAMBLE`. Words of a source are escaped.

A section of a source is shown passage by passage: the words of the source, the claims that they make, with formula,
proof and degree, and the verdicts in the margin.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from html import escape
from itertools import chain, groupby, repeat

from exactspline.display.evidence import curve_of_witness, values_there, worded, written_out
from exactspline.display.latex_prose import TABLES, in_mathematics, literal, prose, quoted
from exactspline.display.ledger import fields
from exactspline.display.page import style
from exactspline.display.tables import breakable
from exactspline.errors import ClaimError, as_instance, counted, nearest
from exactspline.hooks import Displayed
from exactspline.one_line import one_line
from exactspline.papers import Paper, default_papers, option_of
from exactspline.papers.passages import Passage, passages, sections_of
from exactspline.release import releases
from exactspline.verification.claims import claims_of
from exactspline.verification.divisors import divisors
from exactspline.verification.evidence import ExactQuotient
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.ledger import Counts, count_statements
from exactspline.verification.statement import Statement, numbered, statement, true_relation
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED
from exactspline.verification.vocabulary import Measure, Status

#: The lines of the preamble that theorems need, as a comment.
PREAMBLE = TABLES["theorems"]["preamble"]


def theorem(s: Statement) -> str:
    r"""The claim with its proof, as LaTeX.

    >>> from exactspline.verification.statement import statements
    >>> for line in theorem(next(statements("C4.1a"))).splitlines()[:5]:
    ...     print(line)
    % PROVED: chen_riesenfeld_cohen_2007/C41a-f1-f2
    \begin{theorem}[{C4.1a; \S{}4.1, eq. (8)}]\label{C41a-f1-f2}
    $f_{1} = w\,f_{2}$. Assumed: $\gamma = p/w$ of degree $d$ in the plane; $w$ has no zero.
    \[ f_1 = w\,f_2 \]
    Here
    """
    c = s.claim
    environment = "theorem" if s.finding.verdict in (PROVED, VERIFIED, REFUTED) else "conjecture"
    status = "corrected" if c.status == Status.MEANT else ""
    head = "; ".join(prose(part) for part in (c.id, c.source, status) if part)
    lines = [f"% {s.finding.verdict}: {c.paper}/{c.key}", rf"\begin{{{environment}}}[{{{head}}}]\label{{{c.key}}}"]
    lines += [*_stated(s), rf"\end{{{environment}}}", r"\begin{proof}", *_proof(s), r"\end{proof}"]
    return "\n".join(lines)


def bibliography(sources: Iterable[Paper]) -> str:
    """BibTeX entries of the sources of claims, and of the exactspline release that decided them.

    >>> from exactspline.papers import paper
    >>> print(bibliography([paper("lifted")]).splitlines()[0])
    @misc{lifted,
    """
    lines = {each.name: (each.title, each.reference) for each in sources}
    lines |= {"exactspline": ("exactspline: B-splines without rounding", f"version {releases()['exactspline']}")}
    entry = "@misc{{{},\n  title = {{{{{}}}}},\n  note = {{{}}}\n}}\n"
    return "".join(entry.format(re.sub(r"\W", "", name), *map(literal, said)) for name, said in lines.items())


def _stated(s: Statement) -> Iterator[str]:
    """The statement, or its negation if it is refuted, and the formulas in it."""
    c = s.claim
    said = numbered(c)
    assumed = f" Assumed: {prose(c.assumed)}." if c.assumed else ""
    if s.finding.verdict == REFUTED:
        yield rf"It is \emph{{not}} true that {prose(said)}.{assumed}"
        yield rf"\[ \text{{not:}}\quad {in_mathematics(s.latex)} \]"
    else:
        yield f"{prose(_begun(said))}.{assumed}"
        yield rf"\[ {in_mathematics(s.latex)} \]"
    yield from _displayed("Here", [side.latex for side in s.sides])
    yield from _displayed("where", [each.latex for each in s.defined])


def _displayed(word: str, formulas: Sequence[str]) -> Iterator[str]:
    """A word, then formulas below each other."""
    if formulas:
        yield from (word, r"\begin{gather*}")
        yield " \\\\\n".join(map(in_mathematics, formulas))
        yield r"\end{gather*}"


def _begun(sentence: str) -> str:
    """A sentence with a capital, unless it begins with a symbol."""
    word = sentence.partition(" ")[0]
    return sentence[:1].upper() + sentence[1:] if word.isascii() and word.isalpha() and len(word) > 1 else sentence


def _proof(s: Statement) -> Iterator[str]:
    """The decision of the claim, with the evaluation mode, and the command that repeats it."""
    c, f = s.claim, s.finding
    if f.verdict == PROVED:
        yield _method(s)
    if found := worded(true_relation(c, f) or f.computed):
        yield f"Found: {prose(found)}."
    if f.factor and not isinstance(c, DegreeClaim | Identity):
        yield f"{prose(worded(f.factor))}."
    if f.witness and not isinstance(f.witness, ExactQuotient):
        yield f"Witness: {prose(worded(f.witness))}."
        yield from _example(s)
    if f.assumptions:
        yield f"This uses {prose(', '.join(f.assumptions))}."
    if divided := divisors(c):
        yield f"It divides by {prose(', '.join(divided))}."
    if f.verdict == REFUTED:
        yield from _instead(s)
    judge = r" (\texttt{--judge sympy} and \texttt{--judge coq} ask others)" if c.equality is not None else ""
    again = rf"\texttt{{exactspline prove --claim {literal(c.key + option_of(c.paper))}}}"
    yield rf"Verified by exactspline, evaluation mode \emph{{{s.reading}}}; {again}{judge}."


def _example(s: Statement) -> Iterator[str]:
    """The curve that a witness names, written out, and the values there."""
    curve = curve_of_witness(s.claim, s.finding)
    if curve is not None:
        parts = "; ".join(f"{what.capitalize()}: ${numbers}$" for what, numbers in written_out(curve).items())
        yield f"The curve {prose(curve.name)} has degree {curve.degree}. {parts}."
    if values := values_there(s.claim, s.finding):
        yield f"There {prose(', '.join(values))}."


def _method(s: Statement) -> str:
    """The method by which claims of this kind are proved for all curves."""
    said = TABLES["theorems"]
    if isinstance(s.claim, DegreeClaim):
        return said["counted" if s.claim.measure == Measure.NOMINAL else "generic"]
    return TABLES["methods"].get(s.claim.kind, said["otherwise"])


def _instead(s: Statement) -> Iterator[str]:
    """The corrected statements in place of a refuted one."""
    for claim in claims_of(s.claim.source_paper):
        if claim.status == Status.MEANT and claim.error and claim.error == s.claim.error:
            yield f"Instead: {prose(numbered(claim))} ({literal(claim.key)})."


#: A sign that the text of a source lost.
LOST = "\ufffd"
#: The names for claims that a source does not print.
STATUS = {Status.MEANT: "corrected statement", Status.OURS: "our own statement"}
#: The fields of a statement that unfold below its proof.
UNFOLDED = ("found", "factor", "witness", "assumes", "divides by", "used", "note")


@dataclass(frozen=True)
class ReadingAlong(Displayed):
    """A section of a source: its number and title, its passages, and its decided claims by their keys."""

    source: Paper
    section: str
    title: str
    passages: tuple[Passage, ...]
    decided: dict[str, Statement]

    @one_line
    def __repr__(self) -> str:
        return f"<Reading along §{self.section}: {self.head}>"

    @property
    def counts(self) -> dict[Status, Counts]:
        """The numbers of statements of the section by status: those that hold, and those that are refuted."""
        return count_statements((each.claim, each.finding.verdict) for each in self.decided.values())

    @property
    def head(self) -> str:
        """The heading: the number of decided statements of the section, and their verdicts."""
        printed = self.counts[Status.PRINTED]
        said = f"{printed.hold + printed.refuted} of {counted(printed.statements, 'printed statement')} decided"
        refuted = (
            f"{printed.refuted} refuted ({counted(printed.errors, 'error')})" if printed.refuted else "none refuted"
        )
        others = ", ".join(
            f"{self.counts[status].statements} {name}"
            for status, name in STATUS.items()
            if self.counts[status].statements
        )
        return f"{said}: {printed.hold} hold, {refuted}" + (f"; {others}" if others else "")

    @property
    def as_recorded(self) -> bool:
        """Whether every verdict is the recorded one."""
        return all(each.as_recorded for each in self.decided.values())

    @property
    def left_out(self) -> str:
        """The numbers of passages without a claim, by their kind."""
        words = Counter(each.read["nothing"] for each in self.passages if "nothing" in each.read)
        return ", ".join(f"{word} {n}" for word, n in words.most_common())


def reading_along(section: str, source: Paper | None = None) -> ReadingAlong:
    """Return a section of a paper: each passage with its claims and their verdicts. A claim is shown with the first
    passage that makes the claim.

    >>> reading_along("5.2")
    <Reading along §5.2: 8 of 8 printed statements decided: 7 hold, 1 refuted (1 error); 1 corrected statement>

    Raises `ClaimError` for a section that the paper does not have.
    """
    own = default_papers()[0] if source is None else as_instance(source, Paper, "a paper", 'give paper("lifted")')
    sections, number = sections_of(own), str(section).lstrip("§ ")
    if number not in sections:
        remedy = nearest(number, list(sections)) or f"name one of {', '.join(sections)}"
        raise ClaimError(f"{own.title!r} has no section {section!r}", where="section", remedy=remedy)
    first: dict[str, str] = {}
    for each in passages(own):
        for key in each.claims:
            first.setdefault(key, each.section)
    chosen = [claim for claim in claims_of(own) if first.get(claim.key) == number]
    inside = tuple(each for each in passages(own) if each.section == number)
    return ReadingAlong(own, number, sections[number], inside, {each.key: statement(each) for each in chosen})


def along_html(read: ReadingAlong) -> str:
    """The section as a fragment of HTML, with formulas between dollar signs."""
    shown: set[str] = set()
    body = "".join(part for each in read.passages for part in _passage(each, read, shown))
    nothing = f"<p>Passages that decide nothing: {escape(read.left_out)}.</p>" if read.left_out else ""
    return f'<style>{style("along")}</style><div class="along"><p><b>{escape(read.head)}.</b></p>{body}{nothing}</div>'


def _passage(one: Passage, read: ReadingAlong, shown: set[str]) -> Iterator[str]:
    """One passage: its first words, its kind, and its claims; empty for a passage without claims."""
    if set(one.read) <= {"nothing", "reason"}:
        return
    new = [read.decided[key] for key in one.claims if key in read.decided and key not in shown]
    again = [key for key in one.claims if key not in read.decided or key in shown]
    shown.update(each.claim.key for each in new)
    yield _row("said", f"p. {one.page}", f"“{escape(one.begins.replace(LOST, '□'))}”")
    for name in ("definition", "citation", "slip", "open"):
        if name in one.read:
            yield _row("", name, f"<p>{escape(str(one.read[name]))}</p>")
    for words, group in groupby(new, key=lambda each: each.claim.words):
        for each, said in zip(group, chain([words], repeat("")), strict=False):
            yield _claim(each, said)
    if again:
        ids = dict.fromkeys(claim.id for claim in claims_of(read.source) if claim.key in again)
        yield _row("", "see", f"<p>{escape(', '.join(ids))}</p>")


def _row(kind: str, margin: str, body: str, key: str = "") -> str:
    place = f' id="{escape(key)}"' if key else ""
    grid = f"passage {kind}" if kind == "said" else "passage"
    edge = "margin" if kind == "said" else f"margin {kind}".strip()
    return f'<div class="{grid}"{place}><div class="{edge}">{margin}</div><div>{body}</div></div>'


def _claim(s: Statement, words: str) -> str:
    """A claim with its verdict in the margin; its proof and further details unfold."""
    c, verdict = s.claim, s.finding.verdict
    status = f"<br>{STATUS[c.status]}" if c.status in STATUS else ""
    said = f"<p>“{escape(quoted(words))}”</p>" if words else ""
    stated = f"<p>{escape(_begun(numbered(c)))}.</p>"
    formulas = "".join(_formula(*each) for each in _formulas(s))
    more = "".join(f"<p>{line}</p>" for line in _proof_html(s))
    body = f"{said}{stated}{formulas}<details><summary>Proof</summary>{more}</details>"
    return _row(str(verdict), f"<b>{verdict}</b><br>{escape(c.id)}{status}", body, c.key)


def _formulas(s: Statement) -> Iterator[tuple[str, str]]:
    """The statement as a formula, unless both of its sides are one symbol, and the formulas in it with their
    degrees.
    """
    left, _, right = s.latex.partition(" = ")
    if left != right:
        yield s.latex, ""
    for side in s.sides:
        yield side.latex, f"degree {side.degrees}" if side.degrees != "–" else ""


def _formula(tex: str, remark: str) -> str:
    shown = f' <span class="degree">{escape(remark)}</span>' if remark else ""
    return f'<div class="formula">${escape(in_mathematics(tex))}${shown}</div>'


def _proof_html(s: Statement) -> Iterator[str]:
    """The decision of the claim, as lines of HTML."""
    if s.finding.verdict == PROVED:
        yield escape(_method(s))
    yield from (f"{_begun(name)}: {breakable(text)}" for name, text in fields(s) if name in UNFOLDED)
    yield f"Again: <code>exactspline show {escape(s.claim.key)}</code>, reading <i>{escape(str(s.reading))}</i>"
