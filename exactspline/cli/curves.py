"""``exactspline curves``: the example curves."""

from __future__ import annotations

from exactspline.cli.common import AsJson, described, print_json


def curves(as_json: AsJson = False) -> None:
    """List the named example curves."""
    from exactspline.display import console
    from exactspline.splines.examples import example, example_names

    found = [example(name) for name in example_names()]
    if as_json:
        print_json(
            [
                {
                    "name": c.name,
                    "degree": c.degree,
                    "dimension": c.dimension,
                    "polynomial": c.polynomial,
                    "segments": c.segments,
                    "note": c.note,
                }
                for c in found
            ]
        )
        return
    made = console.table("name", "curve", "note")
    for c in found:
        made.add_row(c.name, described(c), c.note)
    console.console().print(made)
