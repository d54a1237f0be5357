"""Papers as data: one folder a source, with its formulas, its claims, its constructions and its own words.

A folder holds ``paper.toml`` (what it is and which files belong to it), modules of formulas and tables of claims and
constructions. No folder has a privilege, and nothing outside this package names one. Every formula stands in one place
and everything else (tables, proofs, LaTeX, programs) is derived from it.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib import import_module, resources
from importlib.resources.abc import Traversable
from typing import Any

from exactspline.errors import FormulaError, nearest
from exactspline.language.formula import Formula


@dataclass(frozen=True)
class Table:
    """A table as it stands in a file of a paper, with the place where it stands: ``file, entry number``."""

    place: str
    entry: dict[str, Any]


@dataclass(frozen=True, eq=False)
class Paper:
    """A source: its folder, its title, the modules of its formulas and the files of its claims.

    ``uses`` are the papers whose formulas its own may build on and its claims may name. ``errors`` are its errors by
    the name under which claims are joined that fail for one reason, with what is wrong.
    """

    name: str
    title: str
    reference: str
    folder: Traversable
    modules: tuple[str, ...]
    claim_files: tuple[str, ...]
    uses: tuple[Paper, ...]
    errors: dict[str, str]

    @property
    def formulas(self) -> dict[str, Formula]:
        """Its own formulas by name, in the order of the source."""
        return _formulas(self)

    def find(self, name: str) -> Formula:
        """The formula with this name: its own, or one of a paper that it uses.

        >>> paper("chen_riesenfeld_cohen_2007").find("f2")
        <formula f2, eq. (8)>

        Raises `FormulaError` with the nearest names.
        """
        for source in (self, *self.uses):
            if name in source.formulas:
                return source.formulas[name]
        known = [known for source in (self, *self.uses) for known in source.formulas]
        raise FormulaError(f"no formula of {self.name} is called {name!r}", remedy=nearest(name, known))

    def claim_tables(self) -> Iterator[Table]:
        """Its claims as they stand in its files; what a file says in ``common`` belongs to each of its claims."""
        for file in self.claim_files:
            data = self._read(file)
            common = data.get("common", {})
            for i, entry in enumerate(data["claim"]):
                yield Table(f"{self.name}/{file}, claim {i + 1}", common | entry)

    def construction_tables(self) -> dict[str, Table]:
        """Its constructions by name, as they stand in ``constructions.toml``."""
        file = "constructions.toml"
        return {name: Table(f"{self.name}/{file}, {name}", entry) for name, entry in self._read(file).items()}

    def _read(self, file: str) -> dict[str, Any]:
        place = self.folder.joinpath(*file.split("/"))
        return tomllib.loads(place.read_text(encoding="utf-8")) if place.is_file() else {}


@cache
def _formulas(source: Paper) -> dict[str, Formula]:
    found = {}
    for module in source.modules:
        home = f"{__package__}.{source.name}.{module}"
        for value in vars(import_module(home)).values():
            if isinstance(value, Formula) and value.__module__ == home:
                found[value.name] = value
    return found


@cache
def papers() -> tuple[Paper, ...]:
    """The papers that come with the library, each after those that it uses.

    >>> [p.name for p in papers()]
    ['chen_riesenfeld_cohen_2007', 'lifted']
    """
    folders = {f.name: f for f in resources.files(__package__).iterdir() if f.joinpath("paper.toml").is_file()}
    told = {name: tomllib.loads(f.joinpath("paper.toml").read_text(encoding="utf-8")) for name, f in folders.items()}
    made: dict[str, Paper] = {}

    def make(name: str) -> Paper:
        if name not in made:
            data = told[name]
            made[name] = Paper(
                name,
                data["title"],
                data["reference"],
                folders[name],
                tuple(data["formulas"]),
                tuple(data["claims"]),
                tuple(make(other) for other in data.get("uses", ())),
                data.get("errors", {}),
            )
        return made[name]

    for name in sorted(told, key=lambda name: (told[name].get("order", 0), name)):
        make(name)
    return tuple(made.values())


def paper(name: str) -> Paper:
    """The paper with this name.

    >>> paper("lifted").uses[0].name
    'chen_riesenfeld_cohen_2007'

    Raises `FormulaError` with the nearest names.
    """
    for known in papers():
        if known.name == name:
            return known
    raise FormulaError(f"no paper is called {name!r}", remedy=f"there are {', '.join(p.name for p in papers())}")


@cache
def all_formulas() -> dict[str, Formula]:
    """Every formula of the papers that come with the library; where two papers share a name, ``paper:name``."""
    found: dict[str, Formula] = {}
    for source in papers():
        for name, formula in source.formulas.items():
            found[name if name not in found else f"{source.name}:{name}"] = formula
    return found


def known_as(formula: Formula) -> str:
    """The name by which `find` finds a formula: its own, with its paper where two papers share it.

    >>> known_as(find("f2"))
    'f2'
    """
    return next((name for name, known in all_formulas().items() if known is formula), formula.name)


def find(name: str) -> Formula:
    """The formula with this name, ``name`` or ``paper:name``.

    >>> find("f2"), find("lifted:evolute_lifted").name
    (<formula f2, eq. (8)>, 'evolute_lifted')

    Raises `FormulaError` with the nearest names.
    """
    source, _, own = name.rpartition(":")
    if source:
        return paper(source).find(own)
    known = all_formulas()
    if name not in known:
        remedy = nearest(name, known, listed_by="exactspline derive")
        raise FormulaError(f"no formula is called {name!r}", remedy=remedy)
    return known[name]
