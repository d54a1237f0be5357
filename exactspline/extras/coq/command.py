"""``coq``: claims as theorems for the proof assistant Coq."""

from __future__ import annotations

from typing import Annotated

from exactspline.cli.common import Papers, Trust, claims_of_papers
from exactspline.cli.parameters import Argument
from exactspline.cli.prove import Claims, Sections, named_claims, of_sections
from exactspline.errors import counted


def coq(
    folder: Annotated[str, Argument(help="The folder to write into.")],
    claim: Claims = None,
    section: Sections = None,
    paper: Papers = None,
    trust: Trust = False,
) -> None:
    """Write the claims of equalities as theorems of Coq: all of them, or those of some claims, sections or papers."""
    from pathlib import Path

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
