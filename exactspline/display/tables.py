"""Tables for notebooks and terminals: degrees, verdicts, and printed numbers next to computed ones."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from html import escape

from rich.console import Console

from exactspline.display import console
from exactspline.display.evidence import worded
from exactspline.display.latex_prose import quoted
from exactspline.display.ledger import claimed
from exactspline.display.numbers import Numbers, decimal_milliseconds
from exactspline.display.sheet import Sheet, code_lines
from exactspline.errors import as_flag, as_items, as_text, as_texts, command_name, counted
from exactspline.hooks import Displayed
from exactspline.one_line import one_line
from exactspline.papers import find, option_of
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of
from exactspline.symbolic.factorization import POLYNOMIAL
from exactspline.symbolic.reduction import reduce
from exactspline.verification.claim import Claim
from exactspline.verification.claims import select
from exactspline.verification.degree_tables import construction_table, generic_table, measurable, measure
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.examples import Count
from exactspline.verification.ledger import Row, audit, decide
from exactspline.verification.statement import Erratum, Holds, Refuted, Statement, statement
from exactspline.verification.verdict import CONTRADICTION, PROVED, REFUTED, VERIFIED
from exactspline.verification.vocabulary import Status, Verdict

#: Colours behind verdicts, dark enough for white letters on any page; colour-blind readers can distinguish them too
#: (they are also given in words).
COLOURS = dict.fromkeys(Verdict, "#666666") | {
    PROVED: "#00694D",
    VERIFIED: "#0060A0",
    REFUTED: "#B34700",
    CONTRADICTION: "#B00020",
}
#: A remark in a table is shortened when it has more characters.
LONGEST = 160
#: More rows that hold than these are folded away.
FEW = 6
#: Words up to this many characters are not broken in HTML; longer ones after a sign, or after this many characters
#: without one.
SHORT_WORD, LONGEST_WORD = 14, 24
_PIECE = re.compile(rf"\S{{4,{LONGEST_WORD - 1}}}?[_.(,:/=]|\S{{1,{LONGEST_WORD}}}")
#: The columns with words of a source.
QUOTATIONS = ("words", "printed")


class Grid(Sheet, Displayed):
    """A table of texts, shown as HTML in a notebook and as aligned columns in a terminal. A cell between dollar signs
    is LaTeX.

    >>> print(Grid(["curve", "degree"], [["circle", 2], ["ellipse", 2]]))
    curve    degree
    circle   2
    ellipse  2
    """

    def __init__(self, columns: Sequence[str], rows: Iterable[Sequence[object]], title: str = "") -> None:
        cells = (list(as_items(row, "cells")) for row in as_items(rows, "rows"))
        super().__init__(*as_texts(columns, "columns", "a heading"), rows=cells, title=as_text(title, "a title"))

    def __len__(self) -> int:
        return len(self.rows)

    def __eq__(self, other: object) -> bool:
        """Whether both tables show the same."""
        return isinstance(other, Grid) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]  # its lists can be changed

    def __getitem__(self, column: str) -> list[str]:
        """Return the cells of a column."""
        i = self.columns.index(column)
        return [row[i] for row in self.rows]

    def __str__(self) -> str:
        return self.text(console.width())

    @one_line
    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {', '.join(self.columns)}: {counted(len(self.rows), 'row')}>"

    def html(self) -> str:
        """Return the table as HTML."""
        return self._table(self.rows)

    def _table(self, rows: Iterable[Sequence[str]]) -> str:
        style = "text-align:left;padding:2px 10px 2px 0;vertical-align:top;overflow-wrap:break-word"
        head = "".join(f'<th style="{style}">{escape(c)}</th>' for c in self.columns)
        body = "".join(
            "<tr>" + "".join(f'<td style="{style}">{_marked(cell)}</td>' for cell in self._typeset(row)) + "</tr>"
            for row in rows
        )
        title = f'<caption style="{style};caption-side:top"><b>{escape(self.title)}</b></caption>' if self.title else ""
        return f"<table>{title}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"

    def _typeset(self, row: Sequence[str]) -> Iterator[str]:
        """The cells of the table; words of a source have their formulas between dollar signs."""
        return (quoted(cell) if column in QUOTATIONS else cell for column, cell in zip(self.columns, row, strict=True))


def _marked(cell: str) -> str:
    """The text of a cell; a verdict has its colour as background."""
    if cell not in COLOURS:
        return escape(cell) if "$" in cell else breakable(cell)
    style = f"background:{COLOURS[Verdict(cell)]};color:white;padding:0 5px;border-radius:3px;white-space:nowrap"
    return f'<b style="{style}">{cell}</b>'


def breakable(text: str) -> str:
    """A text as HTML in which a word that is too long for a column is broken.

    >>> breakable("a < b"), breakable("1234567890" * 3)
    ('a &lt; b', '123456789012345678901234<wbr>567890')
    >>> breakable("claim.refuted_on_examples().witness")
    'claim.<wbr>refuted_<wbr>on_examples(<wbr>).witness'
    """
    return "".join(
        "<wbr>".join(map(escape, _PIECE.findall(word))) if len(word) > SHORT_WORD else escape(word)
        for word in re.split(r"(\s+)", text)
    )


class _Decided(Grid):
    """A table of decided statements, with a column of verdicts."""

    def html(self) -> str:
        """The table as HTML: rows that hold are folded away if other rows are refuted, or if there are many rows."""
        rows = list(zip(self.rows, self["verdict"], strict=True))
        holds = [cells for cells, verdict in rows if verdict in (PROVED, VERIFIED)]
        others = [cells for cells, verdict in rows if verdict not in (PROVED, VERIFIED)]
        if not holds or not (others or len(holds) > FEW):
            return super().html()
        verb = "holds" if len(holds) == 1 else "hold"
        summary = f"<summary>{counted(len(holds), 'statement')} {verb}</summary>"
        return f"{self._table(others) if others else ''}<details>{summary}{self._table(holds)}</details>"


class Verdicts(_Decided):
    """The rows of a ledger as a table; `rows_of_ledger` are the rows themselves."""

    def __init__(self, rows: Iterable[Row]) -> None:
        self.rows_of_ledger = list(rows)
        columns = ["verdict", "claim", "on", "statement", "claimed", "computed", "factor or witness", "source"]
        cells: list[tuple[str, ...]] = [
            (r.verdict, r.id, r.curve, r.statement, claimed(r.claim), worded(r.computed), _remark(r), r.claim.source)
            for r in self.rows_of_ledger
        ]
        if any(r.curve for r in self.rows_of_ledger):
            super().__init__(columns, cells)
        else:
            super().__init__([*columns[:2], *columns[3:]], [(*c[:2], *c[3:]) for c in cells], "for all curves")

    @property
    def as_recorded(self) -> bool:
        """Whether every verdict is the recorded one."""
        return all(r.as_recorded for r in self.rows_of_ledger)


def _remark(row: Row) -> str:
    """The factor or the witness of a row, shortened if it is long.

    >>> _remark(decide(select(["C4.1a"])[0]))
    'w'
    """
    return _cut(worded(row.witness or row.factor, Numbers()))


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 20]} … ({counted(len(text), 'character')})"


def verdicts(*ids: str, curves: Iterable[Nurbs] = (), without: Sequence[str] = ()) -> Verdicts:
    """Decide the claims with these ids, for all curves or, if `curves` are given, on these curves. Claims of the kinds
    `without` are left out.

    >>> verdicts("C4.1a")["verdict"]
    ['PROVED', 'PROVED']

    Raises `ClaimError`, with the existing ids, for an unknown id.
    """
    curves = [curve_of(curve) for curve in as_items(curves, "curves")]
    left_out = as_texts(without, "kinds of claims", "the kind of a claim")
    claims = [claim for claim in select(ids) if claim.kind not in left_out]
    return Verdicts(audit(claims, curves) if curves else map(decide, claims))


def degree_table(curve: Nurbs) -> Grid:
    """Return a table of all constructions on a curve in all their variants: degrees, numbers of control points, and
    times.

    >>> from exactspline.interchange.examples import example
    >>> degree_table(example("ellipse"))["control points"][:3]
    ['52', '16', '16']
    """
    cells = []
    for r in [call() for call in construction_table(curve_of(curve))]:
        counts = ("–" if count is None else count for count in (r.represented, r.true, r.control_points))
        cells.append((r.formula, r.variant, r.nominal, *counts, r.generic, decimal_milliseconds(r.seconds)))
    degrees = ("degree in d", "degree here", "true degree", "control points", "true degree in d")
    columns = ["construction", "variant", *degrees, "ms"]
    return Grid(columns, cells, f"{curve.name}: degree {curve.degree}, {counted(curve.segments, 'segment')}")


def measured(curve: Nurbs, *names: str) -> Grid:
    """Return a table of formulas on a curve (by default of all formulas that apply): nominal, represented and true
    degrees, and numbers of control points.

    >>> from exactspline.interchange.examples import example
    >>> measured(example("ellipse"), "f2")["degree in d"]
    ['3d − 3']
    """
    curve = curve_of(curve)
    formulas = [find(name) for name in names] or measurable(curve.dimension)
    measurements = [measure(formula, curve) for formula in formulas]
    rows = [
        (m.formula, m.nominal, m.represented, "–" if m.true is None else m.true, m.control_points) for m in measurements
    ]
    return Grid(["formula", "degree in d", "degree here", "true degree", "control points"], rows, curve.name)


def symbolic_table(*, polynomial: bool = False) -> Grid:
    """Return a table of degrees of constructions, generators of ruled surfaces and bisectors on the generic curve of
    degree d: without cancellation (naive), of the formula in the paper, and the minimal degree.

    The degree theorem proves the minimal degree; for the degrees d in the last column, certified curves attain it.

    >>> table = symbolic_table()
    >>> [table[column][0] for column in ("object", "naive", "paper", "minimal")]
    ['zero curvature', '6d', '3d − 3', '3d − 6']
    """
    rows = [call() for call in generic_table(polynomial=as_flag(polynomial, POLYNOMIAL))]
    columns = ["object", "naive", "paper", "fully reduced", "minimal", "attained at d ="]
    cells = [(r.object, r.naive, r.paper, r.nominal, r.true, ", ".join(map(str, r.attained))) for r in rows]
    return Grid(columns, cells, f"{'polynomial' if polynomial else 'rational'} curves of degree d")


def reduction_table(*names: str) -> Grid:
    """Return a table of the factors of formulas for all curves: the cancelled factors, the remaining factor, and the
    degrees.

    >>> reduction_table("g0")["cancelled"]
    ['1/2·w⁻⁸']
    """
    rows = []
    for name in names:
        for part in reduce(find(name)).parts:
            d = part.data()
            rows.append((name, d["part"], d["naive"], d["cancelled"], d["reduced"], d["nominal"], d["true"]))
    return Grid(["formula", "part", "naive", "cancelled", "remaining factor", "its degree", "true degree"], rows)


class PrintedNumbers(_Decided):
    """Printed numbers next to the computed ones."""

    def __init__(self, statements: Iterable[Statement]) -> None:
        statements = list(statements)
        self.as_recorded = all(s.as_recorded for s in statements)
        super().__init__(["claim", "source", "statement", "printed", "computed", "verdict"], map(_printed, statements))


def printed_numbers(*ids: str) -> PrintedNumbers:
    """Return a table of every degree and every count that the paper prints, each next to the computed number.

    >>> printed_numbers("C4.2d")["computed"]
    ['6d − 6', '24d']
    """
    return PrintedNumbers(map(statement, numerical_claims(*ids)))


def numerical_claims(*ids: str) -> list[Claim]:
    """Return the claims that state a degree or a count, among the claims with these ids; without ids, among all claims
    of the paper.
    """
    return [
        claim
        for claim in select(ids)
        if isinstance(claim, DegreeClaim | Count) and (ids or claim.status != Status.OURS)
    ]


def _printed(s: Statement) -> tuple[str, ...]:
    claim, finding = s.claim, s.finding
    claimed = str(getattr(claim, "claimed", claim.claims))
    printed = claimed if claim.status == Status.PRINTED else f"({claimed})"
    return claim.id, claim.source, claim.statement, printed, worded(finding.computed), finding.verdict


# ---- errors


def erratum_data(entry: Erratum) -> dict[str, object]:
    """An error of a paper as data.

    >>> from exactspline.verification.statement import errata
    >>> data = erratum_data(errata()[0])
    >>> data["error"], len(data["statements"])
    ('span', 1)
    """
    statements = [
        vars(each) | {"found": worded(each.found), "witness": worded(each.witness)} for each in entry.statements
    ]
    truth = [vars(each) | {"verdict": str(each.verdict)} for each in entry.truth]
    return {"key": f"{entry.paper}: {entry.error}"} | vars(entry) | {"statements": statements, "truth": truth}


def errata_sheet(entries: Sequence[Erratum], numbers: Numbers) -> Sheet:
    """The statements of errors, one per row."""
    columns = ("error", "place", "printed", "which says", "found", "witness", "true", "why")
    cells = [
        (e.title, each.place, each.words, each.statement, found_text(each), worded(each.witness, numbers), *reasons)
        for e in entries
        for reasons in [("; ".join(map(true_text, e.truth)), "; ".join(e.why))]
        for each in e.statements
    ]
    return Sheet(*columns, rows=cells, prose=columns[1:])


def print_errata(
    entries: Sequence[Erratum],
    errors: Sequence[Erratum],
    numbers: Numbers,
    undecided: Sequence[tuple[Claim, Verdict]] = (),
    *,
    quiet: bool,
) -> None:
    """Print entries: errors, each with its number among all errors, then the other entries as remarks, then the keys of
    the undecided claims.
    """
    shown = console.console()
    listed = [entry for entry in entries if entry in errors]
    for entry in listed:
        _print(shown, f"{errors.index(entry) + 1}. ", entry, numbers)
    for entry in entries:
        if entry not in errors:
            _print(shown, "Remark: ", entry, numbers)
    statements = sum(len(entry.statements) for entry in listed)
    console.lines(shown, f"{counted(len(listed), 'error')} of the paper, {counted(statements, 'statement')} refuted")
    if undecided:
        keys = ", ".join(f"{claim.key} ({verdict})" for claim, verdict in undecided)
        console.lines(shown, f"neither proved nor refuted: {keys}")
    if not quiet:
        console.legend(shown, [*dict.fromkeys(verdict for _, verdict in undecided), "PROVED", "VERIFIED"])


def _print(shown: Console, number: str, entry: Erratum, numbers: Numbers) -> None:
    console.lines(shown, f"{number}{entry.title}", indent=3, style="bold")
    for each in entry.statements:
        words = f": “{each.words}”" if each.words else ""
        where = "printed in" if number[0].isdigit() else "beside"
        console.lines(shown, f"{where} {each.place}{words}", indent=5, first=3)
        console.lines(shown, f"which says: {each.statement} ({_names(each)})", indent=7, first=5)
        console.lines(shown, f"found: {found_text(each)}", indent=7, first=5)
        if each.witness:
            console.lines(shown, f"witness: {worded(each.witness, numbers)}", indent=7, first=5)
    for held in entry.truth:
        console.lines(shown, f"true: {true_text(held)}", indent=5, first=3)
    for line in entry.why:
        console.lines(shown, f"why: {line}", indent=5, first=3)
    console.lines(shown, "check:", first=3)
    # code is not indented, so that it can be pasted
    for line in dict.fromkeys(line for each in entry.statements for line in each.check):
        for part in code_lines(line, shown.width):
            console.unbroken(shown, part)
    first = entry.statements[0].key
    also = " (or another of these keys)" if len(entry.statements) + len(entry.truth) > 1 else ""
    shows = f"show {first}{option_of(entry.paper)} --latex"
    console.lines(shown, f"a theorem to cite: {command_name()} {shows}{also}", indent=5, first=3)
    shown.print()


def _names(statement: Refuted) -> str:
    """The claim to which a statement belongs, and its own key."""
    return statement.key if statement.key == statement.id else f"{statement.id}, {statement.key}"


def true_text(each: Holds) -> str:
    """The corrected statement, with its verdict and its key."""
    return f"{each} ({each.key})"


def found_text(statement: Refuted) -> str:
    """The relation that holds instead of a statement, with the meanings of its letters."""
    found = worded(statement.found)
    return f"{found}, where {', '.join(statement.where)}" if statement.where else found
