"""``schema``: the format of the JSON of a command."""

from __future__ import annotations

import json
from typing import Annotated

import typer

from exactspline.cli.output import VERSION, print_json
from exactspline.errors import ExactSplineError, nearest

#: The schema of a line of `exactspline sweep`, which is not a document of rows.
LINE = "sweep_line"


class SchemaError(ExactSplineError):
    """A schema that does not exist."""


def schema(
    name: Annotated[str, typer.Argument(help="The name of a schema; without it the names are listed.")] = "",
) -> None:
    """Print the JSON Schema of what a command prints with --json."""
    if not name:
        print_json({"version": VERSION, "schemas": sorted([*schemas(), LINE])})
        return
    from exactspline.batch.lines import line_schema

    print_json(line_schema() if name == LINE else schema_of(name))


def schemas() -> dict[str, dict[str, dict[str, object]]]:
    """The fields of a row by the name of the schema."""
    from importlib import resources

    text = resources.files(__package__).joinpath("schemas.json").read_text(encoding="utf-8")
    found: dict[str, dict[str, dict[str, object]]] = json.loads(text)
    return found


def schema_of(name: str) -> dict[str, object]:
    """The JSON Schema of a document: its schema, its version, its rows, each with a key of its own.

    >>> schema_of("glossary")["properties"]["rows"]["items"]["required"]
    ['key', 'meaning']

    Raises `SchemaError` with the nearest names.
    """
    known = schemas()
    if name not in known:
        raise SchemaError(
            f"there is no schema called {name!r}", remedy=nearest(name, [*known, LINE], listed_by="exactspline schema")
        )
    fields = known[name]
    row = {
        "type": "object",
        "required": [field for field, told in fields.items() if not told.get("optional")],
        "additionalProperties": False,
        "properties": {
            field: {word: what for word, what in told.items() if word != "optional"} for field, told in fields.items()
        },
    }
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"exactspline/{name}, version {VERSION}",
        "type": "object",
        "required": ["schema", "version", "rows"],
        "additionalProperties": False,
        "properties": {
            "schema": {"const": f"exactspline/{name}"},
            "version": {"const": VERSION},
            "rows": {"type": "array", "items": row},
        },
    }
