"""``coq``: claims as theorems for the proof assistant Coq."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from exactspline.cli.common import claims_of_papers
from exactspline.cli.output import OptionsError
from exactspline.cli.prove import named_claims, of_sections
from exactspline.errors import counted

if TYPE_CHECKING:
    from exactspline.splines.nurbs import Nurbs


def coq(
    folder: str,
    claim: list[str] | None = None,
    section: list[str] | None = None,
    paper: list[str] | None = None,
    trust: bool = False,
) -> None:
    """Write claims that state equalities as theorems of Coq: all such claims, or only the claims with some ids,
    sections or papers.
    """
    from exactspline.display import console
    from exactspline.extras.coq.emission import emit

    some = bool(claim or section or paper)
    claims = of_sections(named_claims(claim or [], claims_of_papers(paper, trust)), section or []) if some else None
    made = emit(Path(folder), claims)
    shown = console.console()
    theorems = [each for own in made.theorems.values() for each in own if not each.reason]
    console.lines(
        shown,
        f"{counted(len(theorems), 'theorem')} in {counted(len(made.files), 'file')}, listed in {folder}/_CoqProject",
    )
    for each in made.unstated:
        console.lines(shown, f"{each.claim.key}: no theorem, {each.why}")


def see_that_coq_can_name(path: str) -> None:
    """Refuse a file name that Coq does not accept as the name of a module."""
    import re

    if not Path(path).name:
        raise OptionsError(f"--emit-coq {path!r} is a folder", remedy="name a file in it")
    named = re.sub(r"\W", "_", Path(path).name.removesuffix(".v"), flags=re.ASCII)
    named = named if named[:1].isalpha() or named[:1] == "_" else f"curve_{named}"
    if Path(path).name != f"{named}.v":
        raise OptionsError(
            f"--emit-coq {path!r}: a file of Coq is named by letters, digits and underscores, a letter first, and .v",
            remedy=f"write --emit-coq {Path(path).with_name(f'{named}.v')}",
        )


def write_theorems(path: str, *curves: Nurbs) -> None:
    """Write the theorems about a curve, or about the common points of two curves, into a file."""
    from exactspline.atomic_write import write_text
    from exactspline.extras.coq.answers import meeting_theorem, theorem_of

    see_that_coq_can_name(path)
    write_text(path, (theorem_of if len(curves) == 1 else meeting_theorem)(*curves))
