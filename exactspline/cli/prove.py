"""``prove``: the ledger, that is the verdicts on all claims of a paper."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from exactspline.cli.common import also_in_their_planes, claims_of_papers, each_read, loaded, tell_written
from exactspline.cli.output import Exit, OptionsError, Output, leave_out, printing, tracked
from exactspline.errors import ClaimError, nearest

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs
    from exactspline.splines.surface import NurbsSurface
    from exactspline.verification.claim import Claim
    from exactspline.verification.ledger import Row

#: Up to this many claims are listed one by one; more are summarized.
FEW = 12


@printing
def prove(
    out: Output,
    claim: list[str] | None = None,
    curve: list[str] | None = None,
    surface: list[str] | None = None,
    section: list[str] | None = None,
    verdict: list[str] | None = None,
    judge: str = "",
    rows: bool = False,
    html: str = "",
    paper: list[str] | None = None,
    trust: bool = False,
    limit: int | None = None,
    report: str = "",
    tex: str = "",
    bib: str = "",
    digits: int = 0,
    exact: bool = False,
    fresh: bool = False,
) -> None:
    """Decide every claim of a paper, for all curves at once, and also check every claim exactly on single curves and
    surfaces: on those given by --curve and --surface, by default on the curves in the folder of the paper or on the
    example curves.
    """
    from exactspline.atomic_write import write_text
    from exactspline.cli.common import read_surfaces
    from exactspline.display.ledger import WORDS
    from exactspline.display.ledger_pages import Run
    from exactspline.display.numbers import Numbers
    from exactspline.display.theorem import PREAMBLE, bibliography, theorem
    from exactspline.verification.statement import stated
    from exactspline.verification.verdict import NOT_ASKED

    requested = [_word(each, WORDS) for each in verdict or []]
    known = claims_of_papers(paper or (["surfaces"] if surface and not curve else None), trust)
    claims = of_sections(named_claims(claim or [], known), section or [])
    given, good = loaded(curve or [])
    read, all_read = each_read(surface or [], read_surfaces)
    on: list[Nurbs | NurbsSurface] = [*also_in_their_planes(given), *[each for several in read for each in several]]
    curves = on if curve or surface else None
    if judge and curves is not None:
        options = "--judge and --curve" if curve else "--judge and --surface"
        raise OptionsError(options, remedy="omit --judge: the second verifier decides for all curves")
    second = None
    if judge:
        from exactspline.verification.judges import judge_named, second_opinion

        second = judge_named(judge, claims)
    found, remembered = _decided(claims, curves, limit, fresh)
    if second:
        found = tracked([partial(second_opinion, second, row, limit) for row in found], second.name)
    chosen = [row for row in found if not requested or row.verdict in requested]
    if html:
        from exactspline.display.ledger_pages import ledger_page

        write_text(html, ledger_page(chosen))
    if report:
        from exactspline.display.ledger_pages import report as referee_report

        write_text(report, referee_report(claims, found))
        tell_written(report)
    if tex:
        proved = [theorem(stated(row.claim, row.reading, row.finding)) for row in found if not row.curve]
        write_text(tex, "\n\n".join([PREAMBLE, *proved]) + "\n")
    if bib:
        write_text(bib, bibliography(dict.fromkeys(each.source_paper for each in claims)))
    listed = rows or bool(claim or section or verdict) or len(claims) <= FEW
    run = Run(chosen, claims, curves, Numbers(digits, exact), second.column if second else "", remembered)
    out.give(
        "prove",
        run.data(),
        run.sheets(),
        lambda: run.print(listed=listed, everything=rows, quiet=out.quiet),
        by="curve",
    )
    if not (good and all_read) or any(row.refused for row in found):
        raise Exit(2)
    if any(row.out_of_reach or row.verdict == NOT_ASKED for row in found):
        leave_out()
    if any(row.differs for row in found):
        raise Exit(1)


def _decided(
    claims: Sequence[Claim], curves: Sequence[Nurbs | NurbsSurface] | None, limit: int | None, fresh: bool
) -> tuple[list[Row], int]:
    """The rows, and how many of them are those of earlier runs."""
    from exactspline.verification.ledger import Memory, cache_file, settled, tasks

    memory = Memory(None if fresh else cache_file())
    found = settled(tracked(tasks(claims, curves, limit, memory.around), "proving"))
    memory.save()
    return found, memory.found


def named_claims(ids: Sequence[str], claims: Sequence[Claim]) -> Sequence[Claim]:
    """The claims with these ids or places, in the order of the papers; all claims if `ids` is empty."""
    from exactspline.verification.claims import located

    keep = {claim for name in ids for claim in located(name, claims)}
    return [claim for claim in claims if not ids or claim in keep]


def _word(name: str, known: Sequence[str]) -> str:
    if name.upper() not in known:
        raise ClaimError(f"there is no verdict called {name!r}", remedy=nearest(name, known, listed_by="list words"))
    return name.upper()


def of_sections(claims: Sequence[Claim], requested: Sequence[str]) -> list[Claim]:
    """The claims of some sections; all claims if no section is named."""
    from exactspline.display.ledger import section

    known = list(dict.fromkeys(map(section, claims)))
    for name in requested:
        if not any(_within(each, name) for each in known):
            raise ClaimError(f"there is no section called {name!r}", remedy=nearest(name, known))
    return [claim for claim in claims if not requested or any(_within(section(claim), name) for name in requested)]


def _within(section: str, requested: str) -> bool:
    """Whether a section is the requested one or a part of it, as §4.2 is a part of 4."""
    a, b = section.lower().removeprefix("§"), requested.lower().removeprefix("§").strip()
    return a == b or a.startswith(f"{b}.")
