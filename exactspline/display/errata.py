"""Errors of papers as data."""

from __future__ import annotations

from exactspline.display.evidence import worded
from exactspline.verification.errata import Erratum


def erratum_data(entry: Erratum) -> dict[str, object]:
    """An error of a paper as data.

    >>> from exactspline.verification.errata import errata
    >>> data = erratum_data(next(errata()))
    >>> data["error"], len(data["statements"])
    ('span', 1)
    """
    statements = [
        vars(each) | {"found": worded(each.found), "witness": worded(each.witness)} for each in entry.statements
    ]
    return {"key": f"{entry.paper}: {entry.error}"} | vars(entry) | {"statements": statements}
