"""``prove``: the ledger."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

from exactspline.cli.common import (
    CurveFiles,
    Digits,
    Exact,
    Papers,
    Trust,
    also_in_their_planes,
    claims_of_papers,
    described,
    loaded,
    tracked,
)
from exactspline.cli.output import OptionsError, Output, printing
from exactspline.cli.parameters import Exit, Option
from exactspline.errors import ClaimError, command_name, nearest

if TYPE_CHECKING:
    from rich.console import Console

    from exactspline.display.ledger import Failure
    from exactspline.display.numbers import Numbers
    from exactspline.display.sheet import Sheet
    from exactspline.splines.nurbs import Nurbs
    from exactspline.splines.surface import NurbsSurface
    from exactspline.verification.claim import Claim
    from exactspline.verification.judges import Judge
    from exactspline.verification.rows import Row

#: Up to this many claims are listed one by one; more are summarized.
FEW = 12

Claims = Annotated[
    list[str] | None,
    Option(
        "--claim",
        metavar="ID",
        help="The id of a claim, what it begins (C3: all of section 3), or a place (eq. (12)). May be repeated.",
    ),
]
Sections = Annotated[
    list[str] | None,
    Option("--section", metavar="SECTION", help="Only this section, for example 4.2. May be repeated."),
]
Verdicts = Annotated[
    list[str] | None, Option("--verdict", metavar="VERDICT", help="Only rows with this verdict. May be repeated.")
]
Surfaces = Annotated[
    list[str] | None,
    Option(
        "--surface",
        metavar="SURFACE",
        help="A surface file (JSON) or an example surface, to check claims of surfaces on (of the paper surfaces, "
        "unless --paper names others). May be repeated.",
    ),
]
JudgeName = Annotated[
    str,
    Option(
        "--judge",
        metavar="JUDGE",
        help="A second judge of the identities, for all curves: sympy, or the kernel of coq (in a column).",
    ),
]
Rows = Annotated[bool, Option("--rows", help="Print every row of the ledger instead of the summary.")]
Page = Annotated[str, Option("--html", metavar="FILE", help="Write the ledger as a page with filters.")]
Report = Annotated[
    str, Option("--report", metavar="FILE", help="Write a referee's report: one page, complete in itself.")
]


@printing
def prove(
    out: Output,
    claim: Claims = None,
    curve: CurveFiles = None,
    surface: Surfaces = None,
    section: Sections = None,
    verdict: Verdicts = None,
    judge: JudgeName = "",
    rows: Rows = False,
    html: Page = "",
    paper: Papers = None,
    trust: Trust = False,
    report: Report = "",
    digits: Digits = 0,
    exact: Exact = False,
) -> None:
    """Decide every claim of a paper: for all curves at once, and exactly on the curves and surfaces given (without any:
    on the curves in its folder, or on the example curves).
    """
    from exactspline.display.ledger import WORDS
    from exactspline.display.numbers import Numbers
    from exactspline.verification.ledger import settled, tasks

    wanted = [_word(each, WORDS) for each in verdict or []]
    known = claims_of_papers(_papers(paper, curve, surface), trust)
    claims = of_sections(named_claims(claim or [], known), section or [])
    given, good = loaded(curve or [])
    patches, all_read = _surfaces(surface or [])
    curves: list[Nurbs | NurbsSurface] | None = None
    if curve or surface:
        curves = [*also_in_their_planes(given), *patches]
    if judge and curves is not None:
        told = "--judge and --curve" if curve else "--judge and --surface"
        raise OptionsError(told, remedy="another judge decides for all: leave it out")
    found, kernel = _judged(judge, claims) if judge else (settled(tracked(tasks(claims, curves), "proving")), None)
    chosen = [row for row in found if not wanted or row.verdict in wanted]
    if html:
        from exactspline.atomic_write import write_text
        from exactspline.display.ledger_page import ledger_page

        write_text(html, ledger_page(chosen))
    if report:
        from exactspline.atomic_write import write_text
        from exactspline.display.report import report as referee_report

        write_text(report, referee_report(claims, found))
    listed = rows or bool(claim or section or verdict) or len(claims) <= FEW
    pages = _Ledger(chosen, claims, curves, Numbers(digits, exact), kernel)
    out.give(
        "prove", pages.data, pages.sheets, lambda: pages.print(out, found, listed=listed, everything=rows), by="curve"
    )
    if not (good and all_read):
        raise Exit(2)
    if not all(row.as_recorded for row in found):
        raise Exit(1)


def _papers(named: list[str] | None, curves: Sequence[str] | None, surfaces: Sequence[str] | None) -> list[str] | None:
    """The papers named; without one, that of surfaces where nothing but surfaces is to be checked."""
    return ["surfaces"] if surfaces and not curves and not named else named


def _surfaces(names: Sequence[str]) -> tuple[list[NurbsSurface], bool]:
    """The surfaces that can be read, and whether all could: a bad one is reported, and the rest are read."""
    from exactspline.display.console import show_error
    from exactspline.errors import ExactSplineError
    from exactspline.interchange.examples import load_surface

    found, good = [], True
    for name in names:
        try:
            found.append(load_surface(name))
        except ExactSplineError as error:
            show_error(error)
            good = False
    return found, good


def named_claims(ids: Sequence[str], claims: Sequence[Claim]) -> Sequence[Claim]:
    """The claims with these ids or places, in the order of the papers; all of them for none."""
    from exactspline.verification.claims import located

    keep = {claim for name in ids for claim in located(name, claims)}
    return [claim for claim in claims if not ids or claim in keep]


def _judged(name: str, claims: Sequence[Claim]) -> tuple[list[Row], dict[tuple[str, str], str] | None]:
    """The rows of another judge, or those of the ledger with the column of the kernel; a CONTRADICTION where two judges
    decide the opposite.
    """
    from exactspline.verification.coq_judge import Coq
    from exactspline.verification.judges import compared_rows, judge_named, second_opinions
    from exactspline.verification.ledger import settled, tasks

    judge = judge_named(name)
    if not isinstance(judge, Coq):
        return tracked(second_opinions(judge, claims), "proving"), None
    kernel = Coq(claims)
    return compared_rows(settled(tracked(tasks(claims), "proving")), kernel), _kernel(claims, kernel)


def _kernel(claims: Sequence[Claim], kernel: Judge) -> dict[tuple[str, str], str]:
    """The column of the kernel: what Coq says, claim by claim."""
    from exactspline.display.evidence import opinion

    return {(claim.paper, claim.key): opinion(kernel.decide(claim)) for claim in claims}


def _word(name: str, known: Sequence[str]) -> str:
    if name.upper() not in known:
        raise ClaimError(f"there is no verdict called {name!r}", remedy=nearest(name, known, listed_by="list words"))
    return name.upper()


def of_sections(claims: Sequence[Claim], wanted: Sequence[str]) -> list[Claim]:
    """The claims of some sections; all of them where none is wanted."""
    from exactspline.display.ledger import section

    known = list(dict.fromkeys(map(section, claims)))
    for name in wanted:
        if not any(_within(each, name) for each in known):
            raise ClaimError(f"there is no section called {name!r}", remedy=nearest(name, known))
    return [claim for claim in claims if not wanted or any(_within(section(claim), name) for name in wanted)]


def _within(section: str, wanted: str) -> bool:
    """Whether a section is the wanted one or a part of it: §4.2 is one of 4."""
    a, b = section.lower().removeprefix("§"), wanted.lower().removeprefix("§").strip()
    return a == b or a.startswith(f"{b}.")


class _Ledger:
    """The rows of a run, as data and as tables."""

    def __init__(
        self,
        rows: list[Row],
        claims: Sequence[Claim],
        curves: Sequence[Nurbs | NurbsSurface] | None,
        numbers: Numbers,
        kernel: dict[tuple[str, str], str] | None = None,
    ) -> None:
        self.rows, self.claims, self.curves, self.numbers = rows, claims, curves, numbers
        self.kernel = kernel

    @property
    def own(self) -> bool:
        """Whether the claims are checked on curves of their own papers."""
        from exactspline.verification.paper_curves import own_curves

        return any(own_curves(claim.source_paper) for claim in self.claims)

    def data(self) -> list[dict[str, object]]:
        """Every row, with a unique key."""
        from exactspline.display.ledger import keyed, row_data

        return [
            row_data(row) | {"key": key, "claim": row.key, "as_recorded": row.as_recorded} | self._said(row)
            for key, row in keyed(self.rows)
        ]

    def _said(self, row: Row) -> dict[str, object]:
        """What the kernel says, where it was asked."""
        return {} if self.kernel is None else {"kernel": self.kernel.get((row.paper, row.key), "")}

    def sheets(self) -> list[Sheet]:
        """The ledger, curve by curve."""
        from exactspline.display.ledger import ledger

        shown = []
        for name in dict.fromkeys(row.curve for row in self.rows):
            own = [row for row in self.rows if row.curve == name]
            title = name or "For all curves"
            told = None if name else self.kernel
            shown.append(ledger(own, title, self.numbers, name=name or "all curves", kernel=told))
        return shown

    def print(self, out: Output, found: Sequence[Row], *, listed: bool, everything: bool) -> None:
        """The text output: the answer first, and the rows where they are asked for."""
        from exactspline.display import console
        from exactspline.display.ledger import closing

        shown = console.console()
        if self.curves is not None:
            self._on_curves(shown, listed)
        elif listed:
            self._listed(shown, everything)
        else:
            self._summary(shown)
        shown.print()
        console.lines(shown, closing(self.rows))
        if not out.quiet:
            if not listed:
                called = command_name()
                told = f"{called} prove --rows prints every row; {called} errata the errors, each with its witness"
                console.lines(shown, f"{told} and a check; {called} show CLAIM one claim.")
            counted = [] if listed or self.curves is not None else ["statement", "error", "row"]
            console.legend(shown, [*self._words(), *counted])

    def _words(self) -> list[str]:
        from exactspline.display.ledger import WORDS

        present = {row.verdict for row in self.rows}
        return [each for each in WORDS if each in present]

    def _summary(self, shown: Console) -> None:
        from exactspline.display import console
        from exactspline.display.ledger import by_section, headline, refuted

        general = [row for row in self.rows if not row.curve]
        console.lines(shown, headline(self.rows), style="bold")
        shown.print()
        shown.print(by_section(general))
        fails = refuted(general)
        if fails:
            shown.print("\nRefuted, and what is true", style="bold")
        for failure in fails:
            self._failure(shown, failure)
        self._not_as_recorded(shown)

    def _failure(self, shown: Console, failure: Failure) -> None:
        from exactspline.display import console
        from exactspline.display.ledger import found, said, witness

        ids = ", ".join(dict.fromkeys(row.id for row in failure.rows))
        console.lines(shown, f"{ids}: {failure.title}", style="bold magenta")
        for row in failure.rows:
            console.lines(shown, f"claimed: {said(row)} ({row.claim.source})", indent=4, first=2)
            console.lines(shown, f"found: {found(row)}", indent=4, first=2)
            if told := witness(row, self.numbers):
                console.lines(shown, f"witness: {told}", indent=4, first=2)
        for row in failure.truth:
            console.lines(shown, f"true: {said(row)}", indent=4, first=2)

    def _listed(self, shown: Console, everything: bool) -> None:
        from exactspline.display.ledger import by_curve

        sheets = self.sheets()
        for i, sheet in enumerate(sheets if everything else [s for s in sheets if s.name == "all curves"]):
            if i:
                shown.print()
            shown.print(sheet)
        concrete = [row for row in self.rows if row.curve]
        if concrete and not everything:
            made = by_curve(concrete)
            of = "its own" if self.own else "the example"
            made.title = f"On {of} curves, exactly (each in full with --curve CURVE, all of them with --rows)"
            shown.print()
            shown.print(made)
            self._not_as_recorded(shown)

    def _not_as_recorded(self, shown: Console) -> None:
        from exactspline.display.ledger import ledger

        if differing := [row for row in self.rows if not row.as_recorded]:
            shown.print()
            shown.print(ledger(differing, "Not as recorded", self.numbers))

    def _on_curves(self, shown: Console, listed: bool) -> None:
        from exactspline.display import console
        from exactspline.display.ledger import by_section, ledger, reasons
        from exactspline.splines.nurbs import Nurbs
        from exactspline.verification.check_arguments import is_tried_whole
        from exactspline.verification.verdict import REFUTED

        for i, c in enumerate(self.curves or []):
            if i:
                shown.print()
            on_surface = not isinstance(c, Nurbs)
            title = f"{c.name}: {described(c) if isinstance(c, Nurbs) else _described_surface(c)}"
            own = [row for row in self.rows if row.curve == c.name]
            if own and not isinstance(c, Nurbs) and not is_tried_whole(c):
                title += "; tried on the first patch"
            if not own:
                console.lines(shown, title)
            elif listed:
                shown.print(ledger(own, title, self.numbers))
            else:
                made = by_section(own)
                made.title = title
                shown.print(made)
                wrong = [row for row in own if row.verdict == REFUTED or not row.as_recorded]
                if wrong:
                    shown.print()
                    shown.print(ledger(wrong, "Refuted on this curve", self.numbers))
            speaks = [claim.speaks_of(c.dimension, c.polynomial, surface=on_surface) for claim in self.claims]
            if silent := [claim for claim, told in zip(self.claims, speaks, strict=True) if not told]:
                told = "1 claim says" if len(silent) == 1 else f"{len(silent)} claims say"
                console.lines(
                    shown, f"{told} nothing of this {'surface' if on_surface else 'curve'}: {reasons(silent, c)}"
                )


def _described_surface(surface: NurbsSurface) -> str:
    from exactspline.display.surface_data import described_surface  # brings the geometry of surfaces along

    return described_surface(surface)
