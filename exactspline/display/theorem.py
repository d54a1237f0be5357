r"""A claim as a LaTeX theorem with its proof: the statement, with the formulas written out, and its decision. The text
needs `PREAMBLE`. Words of a source are escaped.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from exactspline.display.evidence import curve_of_witness, values_there, worded, written_out
from exactspline.display.latex_prose import in_mathematics, literal, prose
from exactspline.papers import Paper, option_of
from exactspline.release import releases
from exactspline.verification.claims import claims_of
from exactspline.verification.divisors import divisors
from exactspline.verification.errata import numbered, true_relation
from exactspline.verification.evidence import ExactQuotient
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity
from exactspline.verification.statement import Statement
from exactspline.verification.verdict import PROVED, REFUTED, VERIFIED
from exactspline.verification.vocabulary import Measure, Status

#: The lines of the preamble that theorems need, as a comment.
PREAMBLE = r"""% In the preamble:
% \usepackage{amsmath,amssymb,amsthm}
% \newtheorem{theorem}{Theorem}
% \newtheorem{conjecture}{Conjecture}"""
#: The method of proof for all curves, by the kind of the claim; for degrees, by the measure.
METHODS = {
    "identity": "Let the derivatives of the arguments be indeterminates. Both sides are quotients of polynomials in "
    "them, and multiplied out they are equal.",
    "vanishing": "Let the derivatives of the arguments be indeterminates. Multiplied out, the numerator is the zero "
    "polynomial in them.",
    "same surface": "Let the derivatives of the arguments be indeterminates. Multiplied out, the generators are "
    "parallel, and the directrices differ by a multiple of a generator.",
    "iso-curve": "Let the derivatives of the arguments be indeterminates. Multiplied out, the two curves are equal.",
    "invariance": "Substitute the change of the curve, with indeterminates for its constants and for the derivatives "
    "of the curve; multiplied out, both sides are equal.",
    "zero set": "Let the derivatives of the arguments be indeterminates. The formulas are equal up to factors that "
    "have no zero by what is assumed.",
    "square class": "Let the derivatives of the arguments be indeterminates. In the quotient of the two every "
    "irreducible factor occurs an even number of times.",
    "type": "Let the derivatives of the curve be indeterminates, with the roots of squares adjoined. The value has "
    "roots, or a denominator, or neither; that it has no more special type is seen on one curve.",
    "contact": "Let the derivatives of the curve be indeterminates, and differentiate with respect to the second "
    "parameter: the first derivative that does not vanish at the point of contact gives the order.",
    "sign": "Up to its sign, the value is a positive factor times a sum of squares: an identity of polynomials in "
    "indeterminate derivatives.",
}
COUNTED = "The degree is counted as in Table 1 of the paper, operation by operation, without cancellation."


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
        yield f"{prose(begun(said))}.{assumed}"
        yield rf"\[ {in_mathematics(s.latex)} \]"
    yield from _displayed("Here", [side.latex for side in s.sides])
    yield from _displayed("where", [each.latex for each in s.defined])


def _displayed(word: str, formulas: Sequence[str]) -> Iterator[str]:
    """A word, then formulas below each other."""
    if formulas:
        yield from (word, r"\begin{gather*}")
        yield " \\\\\n".join(map(in_mathematics, formulas))
        yield r"\end{gather*}"


def begun(sentence: str) -> str:
    """A sentence with a capital, unless it begins with a symbol."""
    word = sentence.partition(" ")[0]
    return sentence[:1].upper() + sentence[1:] if word.isascii() and word.isalpha() and len(word) > 1 else sentence


def _proof(s: Statement) -> Iterator[str]:
    """The decision of the claim, with the evaluation mode, and the command that repeats it."""
    c, f = s.claim, s.finding
    if f.verdict == PROVED:
        yield method(s)
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


def method(s: Statement) -> str:
    """The method by which claims of this kind are proved for all curves."""
    if isinstance(s.claim, DegreeClaim):
        return COUNTED if s.claim.measure == Measure.NOMINAL else "The degree is that of the generic curve."
    return METHODS.get(s.claim.kind, "It is decided by exact computation.")


def _instead(s: Statement) -> Iterator[str]:
    """The corrected statements in place of a refuted one."""
    for claim in claims_of(s.claim.source_paper):
        if claim.status == Status.MEANT and claim.error and claim.error == s.claim.error:
            yield f"Instead: {prose(numbered(claim))} ({literal(claim.key)})."
