"""``exactspline errata``: where a paper is wrong."""

from __future__ import annotations

from exactspline.cli.common import AsJson, print_json


def errata(as_json: AsJson = False) -> None:
    """List the errors of the paper: where, what is printed, what is true, how to check it in three lines."""
    from exactspline.display import console
    from exactspline.verification.errata import errata as found

    entries = list(found())
    if as_json:
        print_json([vars(entry) for entry in entries])
        return
    out = console.console()
    for entry in entries:
        out.print(console.erratum(entry))
    out.print(f"{len(entries)} errors", markup=False)
