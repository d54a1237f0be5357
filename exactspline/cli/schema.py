"""``schema``: the format of the JSON of a command."""

from __future__ import annotations

import json
from typing import Any

from exactspline.cli.output import VERSION, print_json
from exactspline.errors import ExactSplineError, nearest

#: The schema of a line of `exactspline sweep`, which is not a document of rows.
LINE = "sweep_line"


class SchemaError(ExactSplineError):
    """A schema that does not exist."""


def schema(name: str = "") -> None:
    """Print the JSON Schema of what a command prints with --json."""
    if not name:
        print_json({"version": VERSION, "schemas": sorted([*_schemas(), LINE])})
        return
    from exactspline.batch.lines import line_schema

    print_json(line_schema() if name == LINE else _schema_of(name))


def _schemas() -> dict[str, dict[str, dict[str, object]]]:
    """The fields of a row, for every schema by its name."""
    from importlib import resources

    from exactspline.display.answer_forms import FORMS_BESIDE, form_of
    from exactspline.geometry.analysis.ask import REGISTRY

    text = resources.files(__package__).joinpath("schemas.json").read_text(encoding="utf-8")
    found = {name: _fields(by_type) for name, by_type in json.loads(text).items()}
    found["inspect"] |= _answers("plane curve", "space curve")
    found["inspect surface"] |= _answers("surface in space", "map of a rectangle into the plane")
    # a row may also be the bisector of a point and a curve
    found["bisector"] |= {name: field | {"optional": True} for name, field in _answers("pair of space curves").items()}
    found["between"] |= _answers("two curves")
    for name, fields in FORMS_BESIDE.items():
        found[name] |= {field: form.schema | {"optional": True} for field, form in fields.items()}
    forms = [form_of(entry).schema for entries in REGISTRY.values() for entry in entries.values()]
    found["answers"]["answer"] = {"anyOf": [*{str(form): form for form in forms}.values(), {"type": "null"}]}
    return found


def _fields(by_type: dict[str, Any]) -> dict[str, dict[str, object]]:
    """The fields of a row: its key, and the fields listed by their type or under ``form`` with their own form. The name
    of an optional field ends with a question mark.
    """
    forms: dict[str, dict[str, object]] = {"key": {"type": "string"}}
    for kind, names in by_type.items():
        forms |= names if kind == "form" else dict.fromkeys(names, _form(kind))
    return {
        name.removesuffix("?"): form | ({"optional": True} if name.endswith("?") else {})
        for name, form in forms.items()
    }


def _form(kind: str) -> dict[str, object]:
    """The JSON form of a type: the JSON names of the types that it may be, and after ``of`` the type of its elements.

    >>> _form("array null of integer")
    {'type': ['array', 'null'], 'items': {'type': 'integer'}}
    """
    head, _, element = kind.partition(" of ")
    types = head.split()
    inside = "items" if "array" in types else "additionalProperties"
    return {"type": types if len(types) > 1 else head} | ({inside: _form(element)} if element else {})


def _answers(*of: str) -> dict[str, dict[str, object]]:
    """The fields of an inspection of these kinds of objects: the questions that it answers, each with the form of its
    answer. A question that is not asked about all of the kinds is optional.
    """
    from exactspline.display.answer_forms import form_of
    from exactspline.geometry.analysis.ask import REGISTRY
    from exactspline.questions.entry import Of

    kinds = [Of(kind) for kind in of]
    entries = {name: entry for kind in kinds for name, entry in REGISTRY[kind].items()}
    return {
        name: form_of(entry).schema
        | {"description": entry.meaning}
        | ({} if set(kinds) <= set(entry.about.of) else {"optional": True})
        for name, entry in entries.items()
        if entry.about.reported
    }


def _schema_of(name: str) -> dict[str, object]:
    """The JSON Schema of a document with the fields ``schema``, ``version``, ``releases`` and ``rows``.

    >>> _schema_of("glossary")["properties"]["rows"]["items"]["required"]
    ['key', 'meaning']

    Raises `SchemaError` with the nearest names.
    """
    known = _schemas()
    if name not in known:
        raise SchemaError(
            f"there is no schema called {name!r}", remedy=nearest(name, [*known, LINE], listed_by="schema")
        )
    fields = known[name]
    row = {
        "type": "object",
        "required": [field for field, form in fields.items() if not form.get("optional")],
        "additionalProperties": False,
        "properties": {
            field: {word: what for word, what in form.items() if word != "optional"} for field, form in fields.items()
        },
    }
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"exactspline/{name}, version {VERSION}",
        "type": "object",
        "required": ["schema", "version", "releases", "rows"],
        "additionalProperties": False,
        "properties": {
            "schema": {"const": f"exactspline/{name}"},
            "version": {"const": VERSION},
            "releases": {"type": "object", "additionalProperties": {"type": "string"}},
            "unchecked": {"type": "array", "items": {"type": "string"}},
            "rows": {"type": "array", "items": row},
        },
    }
