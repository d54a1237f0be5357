"""The lists of ``list curves``, ``list formulas``, ``list words``, …."""

from __future__ import annotations

from exactspline.cli.output import Output, printing
from exactspline.display.forms import picked
from exactspline.display.sheet import Sheet


def _kind(polynomial: bool) -> str:
    return "polynomial" if polynomial else "rational"


@printing
def curves(out: Output) -> None:
    """List the named example curves."""
    from exactspline.interchange.examples import example, example_names

    found = [example(name) for name in example_names()]
    shape = ("name", "degree", "dimension", "polynomial", "segments")
    rows = [
        {"key": c.name, **picked(c, *shape), "control_points": len(c.control_points), "note": c.note} for c in found
    ]
    numbers = ("degree", "segments", "points", "dimension")
    cells = [
        (c.name, _kind(c.polynomial), c.degree, c.segments, len(c.control_points), c.dimension, c.note) for c in found
    ]
    out.give("curves", rows, [Sheet("name", "kind", *numbers, "note", rows=cells, numbers=numbers, prose=["note"])])


@printing
def surfaces(out: Output) -> None:
    """List the named example surfaces."""
    from exactspline.interchange.examples import example_surface, example_surface_names

    found = [example_surface(name) for name in example_surface_names()]
    shape = ("name", "degree", "dimension", "polynomial", "patches", "note")
    rows = [{"key": s.name, **picked(s, *shape)} for s in found]
    cells = [
        (s.name, _kind(s.polynomial), *(f"{m} × {n}" for m, n in (s.degree, s.patches)), s.dimension, s.note)
        for s in found
    ]
    columns = ("name", "kind", "degree", "patches", "dimension", "note")
    out.give("surfaces", rows, [Sheet(*columns, rows=cells, numbers=["dimension"], prose=["note"])])


@printing
def formulas(out: Output) -> None:
    """List everything that `derive` can compute from a curve: constructions with their variants, and formulas."""
    from exactspline.geometry.derived.constructions import all_constructions
    from exactspline.language.kinds import CURVE, PLANE, SPACE
    from exactspline.papers import all_formulas

    found = [(name, "construction", c.curve, list(c.all_variants)) for name, c in all_constructions().items()]
    found += [
        (name, "formula", str(f.curve), []) for name, f in all_formulas().items() if f.kind in (CURVE, PLANE, SPACE)
    ]
    rows = [
        {"key": f"{'formula ' * (kind == 'formula')}{name}", "name": name, "kind": kind, "curve": of, "variants": made}
        for name, kind, of, made in found
    ]
    of_a = {"plane": "plane curve", "space": "space curve"}
    cells = [(name, kind, of_a.get(of, "curve"), ", ".join(made)) for name, kind, of, made in found]
    out.give("derivable", rows, [Sheet("name", "what", "of a", "variants", rows=cells, prose=["variants"])])


@printing
def papers(out: Output) -> None:
    """List the papers whose formulas and claims come with exactspline."""
    from exactspline.papers import papers as found
    from exactspline.verification.claims import claims_of

    rows = [
        {"key": p.name, "title": p.title, "formulas": len(p.formulas), "claims": len(claims_of(p))} for p in found()
    ]
    numbers, cells = ("formulas", "claims"), [tuple(row.values()) for row in rows]
    out.give("papers", rows, [Sheet("name", "title", *numbers, rows=cells, numbers=numbers, prose=["title"])])


@printing
def questions(out: Output) -> None:
    """List all questions that --ask, --find and xs.ask take, with the types of objects to which they apply."""
    from exactspline.geometry.analysis.ask import questions as all_questions

    found = all_questions()
    rows = [
        {"key": f"{name} of a {of[0]}", "asked": form, "of": list(of), "meaning": meaning}
        for name, form, of, meaning in found
    ]
    cells = [(form, ", ".join(of), meaning) for _, form, of, meaning in found]
    out.give("questions", rows, [Sheet("question", "of a", "meaning", rows=cells, prose=["of a", "meaning"])])


@printing
def words(out: Output, term: list[str] | None = None) -> None:
    """Explain the words and signs in tables: nominal, true, minimal, k, m, j, X, P, and every verdict."""
    from exactspline.display.console import glossary, meaning

    topics = {"": {each: meaning(each) for each in term}} if term else glossary()
    cells = [(each, explained) for terms in topics.values() for each, explained in terms.items()]
    rows = [{"key": each, "meaning": explained} for each, explained in cells]
    out.give("glossary", rows, [Sheet("term", "meaning", rows=cells, prose=["meaning"])], lambda: _print(topics))


def _print(topics: dict[str, dict[str, str]]) -> None:
    from exactspline.display import console

    out = console.console()
    for i, (topic, terms) in enumerate(topics.items()):
        if topic:
            out.print("\n" * bool(i) + topic, style="bold")
        for term, meaning in terms.items():
            console.lines(out, f"{term}: {meaning}", indent=4 if topic else 2, first=2 if topic else 0)
