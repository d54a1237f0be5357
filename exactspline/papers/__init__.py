"""Papers as data: one folder per source, with its formulas, its claims, its constructions and the words of the source.
Folders of the library are in this package, folders of users anywhere, and the same code reads all of them
(`exactspline.papers.folder`). No code outside this package refers to a particular paper. Every formula is written in
one place, and everything else (tables, proofs, LaTeX, programs) is derived from it. Formulas that do not belong to a
single paper are in `exactspline.formulas`, and a folder here contains their claims.
"""

from __future__ import annotations

import copyreg
import re
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from shlex import quote
from typing import TYPE_CHECKING

from exactspline.errors import FormulaError, as_text, counted, nearest
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import CURVE
from exactspline.papers.folder import Paper, Table, description_of, folder_at, paper_in
from exactspline.papers.loading import checked_formulas, guarded, run_file

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable

__all__ = ["Paper", "Table"]

#: Papers loaded from folders, by name.
_loaded: dict[str, Paper] = {}


@cache
def papers() -> tuple[Paper, ...]:
    """The papers included in the library, each after the papers that it uses.

    >>> [p.name for p in papers() if p.default]
    ['chen_riesenfeld_cohen_2007', 'lifted']
    """
    folders = {f.name: f for f in Path(__file__).parent.iterdir() if f.joinpath("paper.toml").is_file()}
    made: dict[str, Paper] = {}

    def make(name: str) -> Paper:
        if name not in made:
            made[name] = paper_in(folders[name], name, make, package=f"{__package__}.{name}")
        return made[name]

    for name in sorted(folders, key=lambda name: (description_of(folders[name], name)["order"], name)):
        make(name)
    return tuple(made.values())


@cache
def default_papers() -> tuple[Paper, ...]:
    """The default papers."""
    return tuple(each for each in papers() if each.default)


def paper(name: str | Path, *, trust: bool = False, partly: bool = False) -> Paper:
    """Return the paper with this name from the library, or the paper in a user's folder (see `load_paper`).

    >>> paper("lifted").uses[0].name
    'chen_riesenfeld_cohen_2007'

    Raises `FormulaError`, with the nearest names, for a text that is neither a name nor a folder.
    """
    said = str(name) if isinstance(name, Path) else as_text(name, "the name of a paper")
    if said not in _by_name() and (Path(said).is_dir() or "/" in said):
        return load_paper(said, trust=trust, partly=partly)
    return paper_named(said)


def paper_named(name: str) -> Paper:
    """The paper with this name: one included in the library, or one that was loaded.

    Raises `FormulaError`, with the nearest names, for an unknown one.
    """
    if name in _loaded:
        return _loaded[name]
    known = _by_name()
    if name not in known:
        remedy = f"{nearest(name, known | _loaded)}; or name a folder"
        raise FormulaError(f"there is no paper called {name!r}", remedy=remedy)
    return known[name]


copyreg.pickle(Paper, lambda each: (paper_named, (each.name,)))  # pickled by name: formulas are code


@cache
def _by_name() -> dict[str, Paper]:
    return {each.name: each for each in papers()}


def owner(formula: Formula) -> Paper | None:
    """The paper to which a formula belongs, among those of the library and those that were loaded; None if there is
    none.

    >>> owner(find("f2")).name
    'chen_riesenfeld_cohen_2007'
    """
    known = [*papers(), *_loaded.values()]
    return next((each for each in known if each.formulas.get(formula.name) is formula), None)


def load_paper(folder: str | Path, *, trust: bool = False, partly: bool = False) -> Paper:
    """The paper in a user's folder. Its formulas are checked before they run; with `trust` they run unchecked.

    Raises `ClaimError` if this is not the folder of a paper, and `FormulaError`, with file and line, for invalid
    formulas; with `partly`, the paper has the valid formulas, and lists the invalid ones as ``refused``.
    """
    place = folder_at(folder)
    for paper_here in papers():
        if _is_folder(paper_here.folder, place):
            return paper_here
    name = place.resolve().name
    taken = {each.name: each.folder for each in papers()}
    taken |= {each.name: each.folder for each in _loaded.values()}
    while name in taken and not _is_folder(taken[name], place):
        name += "′"
    loaded = paper_in(place, name, paper_named, trusted=trust, importable=formulas_by_module)
    for error in () if partly else loaded.refused.values():  # reported before anything is decided
        raise error
    _loaded[name] = loaded
    return loaded


def _is_folder(folder: Traversable, place: Path) -> bool:
    return isinstance(folder, Path) and folder.resolve() == place.resolve()


def named_papers(names: Iterable[str], *, trust: bool = False, partly: bool = False) -> tuple[Paper, ...]:
    """Papers given by name or folder (`partly` as in `load_paper`), ``all`` for all papers of the library; without
    names, the default papers.

    Raises `FormulaError`, with the nearest names, for a name that is neither.
    """
    named = [
        each for name in names for each in (papers() if name == "all" else [paper(name, trust=trust, partly=partly)])
    ]
    return tuple(dict.fromkeys(named)) or default_papers()


def option_of(name: str) -> str:
    """The option by which a command finds a loaded paper: empty for a default paper, otherwise with its name or folder.

    >>> option_of("chen_riesenfeld_cohen_2007"), option_of("primer_on_bezier_curves")
    ('', ' --paper primer_on_bezier_curves')
    """
    if any(each.name == name for each in default_papers()):
        return ""
    return f" --paper {quote(str(_loaded[name].folder) if name in _loaded else name)}"


@cache
def all_formulas() -> dict[str, Formula]:
    """The formulas of the default papers by name, or by ``paper:name`` if a name occurs twice."""
    formulas: dict[str, Formula] = {}
    for source in default_papers():
        for name, formula in source.formulas.items():
            formulas[name if name not in formulas else f"{source.name}:{name}"] = formula
    return formulas


def formulas_by_module() -> Mapping[str, Formula]:
    """The formulas of the library, which users' formulas may import, by ``papers.paper.module:name`` or
    ``formulas.module:name``.
    """
    return {
        f"{formula.__module__.removeprefix('exactspline.')}:{name}": formula
        for source in papers()
        for name, formula in source.formulas.items()
    }


def known_as(formula: Formula) -> str:
    """The name by which `find` returns a formula: its name, preceded by the paper if several papers have this name.

    >>> known_as(find("f2"))
    'f2'
    """
    source = next((each for each in (*default_papers(), *papers()) if each.formulas.get(formula.name) is formula), None)
    if source is None or (source.default and len(_owners(formula.name)) < 2):
        return formula.name
    return f"{source.name}:{formula.name}"


@cache
def _owners(name: str) -> tuple[Paper, ...]:
    """The papers of the library with a formula of this name, determined from the text of their files, so that papers
    that are not needed are not imported.
    """
    defined = re.compile(rf"^def {re.escape(name)}\(", re.MULTILINE)
    return tuple(
        each
        for each in papers()
        if (name in each.formulas if each.default else any(defined.search(text) for text in _sources(each)))
        and name in each.formulas
    )


@cache
def _sources(source: Paper) -> tuple[str, ...]:
    return tuple(file.read_text(encoding="utf-8") for _, file in source.formula_files())


def find(name: str) -> Formula:
    """The formula of the library with this name: ``name`` if only one paper has it, or ``paper:name``, where the paper
    may also be one that was loaded.

    >>> find("f2"), find("lifted:evolute_lifted").name
    (<formula f2, eq. (8)>, 'evolute_lifted')

    Raises `FormulaError` for an unknown name, with the nearest ones, and for a name that several papers have.
    """
    source, _, formula_name = as_text(name, "the name of a formula").rpartition(":")
    if source:
        return paper(source).find(formula_name)
    known = all_formulas()
    if len(owners := _owners(name) if name in known else ()) > 1:
        options = " or ".join(f"{each.name}:{name}" for each in owners)
        raise FormulaError(f"{counted(len(owners), 'paper')} have a formula called {name!r}", remedy=f"write {options}")
    if name not in known:
        remedy = nearest(name, known, listed_by="list formulas")
        raise FormulaError(f"there is no formula called {name!r}", remedy=remedy)
    return known[name]


def formula_of(given: Formula | str) -> Formula:
    """Return the given formula, or the formula of the library with the given name.

    Raises `FormulaError` for anything else.
    """
    return find(given) if isinstance(given, str) else expect_formula(given)


def resolve(name: str, *, trust: bool = False) -> Formula:
    """A formula as named by a user: ``name``, ``paper:name``, ``FOLDER:name`` or ``file.py:name``.

    Raises `FormulaError` for an unknown name, with the nearest ones, and for errors in a file or folder.
    """
    place, _, formula_name = name.rpartition(":")
    if place.endswith(".py"):
        return _of_file(Path(place), formula_name, trust)
    if place and (Path(place).is_dir() or "/" in place):
        return load_paper(place, trust=trust, partly=True).find(formula_name)
    return find(name)


def _of_file(file: Path, name: str, trust: bool) -> Formula:
    if not file.is_file():
        raise FormulaError("there is no such file", where=str(file), remedy="write file.py:function")
    if not trust:
        formulas = checked_formulas(file, formulas_by_module, plain=True)
        if name not in formulas:
            raise FormulaError(f"there is no formula called {name!r}", where=str(file), remedy=nearest(name, formulas))
        return formulas[name]
    function = getattr(run_file(file), name, None)
    if isinstance(function, Formula):
        return guarded(function, str(file))
    if not callable(function):
        raise FormulaError(f"{file} has no function {name!r}", where=name, remedy="write file.py:function")
    return guarded(Formula(function, str(file), CURVE, ""), str(file))
