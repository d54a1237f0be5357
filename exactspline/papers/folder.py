"""The folder of a paper: its description, its formulas and its claims, read by the same code whoever wrote them. A
folder contains formulas (``formulas.py``), claims (``claims.toml``) and its description (``paper.toml``), which may
also stand in the first lines of ``claims.toml``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from hashlib import sha256
from importlib import import_module, resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, TypedDict, cast

from exactspline.errors import ClaimError, FormulaError, as_path, nearest
from exactspline.language.formula import Formula
from exactspline.papers.loading import Importable, checked_formulas, trusted_formulas

try:  # compiled, and with bounds on the depth of what strangers write
    import tomli as toml
except ModuleNotFoundError:  # in a browser
    import tomllib as toml  # type: ignore[no-redef]  # the same functions under another name


class Told(TypedDict):
    """The description of a folder."""

    title: str
    reference: str
    formulas: list[str]
    formulas_in: str
    claims: list[str]
    uses: list[str]
    errors: dict[str, str]
    default: bool
    order: int


#: The largest size of a table in bytes.
CHARACTERS = 4_000_000
#: The defaults of the description.
SILENT: Told = {
    "title": "",
    "reference": "",
    "formulas": ["formulas"],
    "formulas_in": "",
    "claims": ["claims.toml"],
    "uses": [],
    "errors": {},
    "default": False,
    "order": 0,
}


@dataclass(frozen=True)
class Table:
    """A table of a file of a paper, with its place: ``file, entry number``."""

    place: str
    entry: dict[str, Any]


@dataclass(frozen=True, eq=False)
class Paper:
    """A source: its folder, its title, the modules of its formulas and the files of its claims.

    ``uses`` are the papers whose formulas its own may build on and its claims may name. ``errors`` are its errors, each
    a name that groups the claims failing for one reason, with an explanation. A ``default`` paper is used where none
    is named. ``package`` is where its modules are imported from (its own, or one in `exactspline.formulas` for what
    belongs to no single source), empty for a user's folder; then formulas are checked before they run, unless the
    folder is ``trusted``; what they may import from other papers is ``importable``.
    """

    name: str
    title: str
    reference: str
    folder: Traversable
    modules: tuple[str, ...]
    claim_files: tuple[str, ...]
    uses: tuple[Paper, ...]
    errors: dict[str, str]
    default: bool = False
    package: str = ""
    trusted: bool = False
    importable: Importable = dict
    _kept: dict[str, dict[str, Formula]] = field(default_factory=dict, repr=False)

    def __repr__(self) -> str:
        return f"<Paper {self.name}: {self.title}>"

    @property
    def formulas(self) -> dict[str, Formula]:
        """Its own formulas by name, in the order of the source."""
        if "formulas" not in self._kept:
            self._kept["formulas"] = self._read_formulas()
        return self._kept["formulas"]

    def _read_formulas(self) -> dict[str, Formula]:
        found: dict[str, Formula] = {}
        for module in self.modules if self.package else ():
            home = f"{self.package}.{module}"
            values = vars(import_module(home)).values()
            found |= {f.name: f for f in values if isinstance(f, Formula) and f.__module__ == home}
        for _, file in () if self.package else self.formula_files():
            found |= trusted_formulas(file) if self.trusted else checked_formulas(file, self.importable)
        return found

    def formula_files(self) -> list[tuple[str, Traversable]]:
        """The files of its formulas that there are, by their names."""
        home = resources.files(self.package) if self.package else self.folder
        files = [(f"{module}.py", home.joinpath(*f"{module}.py".split("/"))) for module in self.modules]
        return [(name, file) for name, file in files if file.is_file()]

    def find(self, name: str) -> Formula:
        """The formula with this name: its own, or one of a paper that it uses.

        >>> from exactspline.papers import paper
        >>> paper("chen_riesenfeld_cohen_2007").find("f2")
        <formula f2, eq. (8)>

        Raises `FormulaError` with the nearest names, and where several papers that it uses have one.
        """
        if name in self.formulas:
            return self.formulas[name]
        having = [source for source in self.uses if name in source.formulas]
        if len({source.formulas[name] for source in having}) > 1:
            told = " and of ".join(source.name for source in having)
            raise FormulaError(f"{name!r} is a formula of {told}", remedy="call the one meant in a formula of your own")
        if having:
            return having[0].formulas[name]
        known = [known for source in (self, *self.uses) for known in source.formulas]
        raise FormulaError(f"no formula of {self.name} is called {name!r}", remedy=nearest(name, known))

    def claim_tables(self) -> Iterator[Table]:
        """Its claims as written in its files; the fields of ``common`` in a file belong to each of its claims.

        Raises `ClaimError` for what is not a table of claims.
        """
        for file in self.claim_files:
            data = self._read(file)
            common, entries = data.get("common", {}), data.get("claim", [])
            if not isinstance(common, dict) or not isinstance(entries, list):
                raise ClaimError("not a table of claims", where=f"{self.name}/{file}", remedy="write [[claim]]")
            for i, entry in enumerate(entries):
                place = f"{self.name}/{file}, claim {i + 1}"
                if not isinstance(entry, dict):
                    raise ClaimError("a claim is not a table", where=place, remedy="write [[claim]]")
                yield Table(place, common | entry)

    def construction_tables(self) -> dict[str, Table]:
        """Its constructions by name, as written in ``constructions.toml``."""
        file = "constructions.toml"
        tables = self._read(file).items()
        return {name: Table(f"{self.name}/{file}, {name}", each) for name, each in tables if isinstance(each, dict)}

    def curve_files(self) -> list[Traversable]:
        """The files of its own curves, in ``curves/``."""
        place = self.folder.joinpath("curves")
        return sorted((f for f in place.iterdir() if f.is_file()), key=lambda f: f.name) if place.is_dir() else []

    def digests(self) -> dict[str, str]:
        """The SHA-256 digests of its files by their names."""
        found = dict(_files(self.folder)) | dict(self.formula_files())
        # what is read is listed also where it is a link; other links lead nowhere
        names = ("paper.toml", "claims.toml", "constructions.toml", "README.md")
        for path in (*names, *self.claim_files):
            if (file := self.folder.joinpath(*path.split("/"))).is_file():
                found[path] = file
        found |= {f"curves/{file.name}": file for file in self.curve_files()}
        return {name: _digest(file) for name, file in sorted(found.items())}

    def _read(self, file: str) -> dict[str, object]:
        return read_toml(self.folder.joinpath(*file.split("/")), f"{self.name}/{file}")


def _files(folder: Traversable, path: str = "") -> Iterator[tuple[str, Traversable]]:
    for each in folder.iterdir():
        if each.name.startswith((".", "__pycache__")) or (isinstance(each, Path) and each.is_symlink()):
            continue
        if each.is_dir():
            yield from _files(each, f"{path}{each.name}/")
        elif each.is_file():
            yield path + each.name, each


def _digest(file: Traversable) -> str:
    found = sha256()
    with file.open("rb") as stream:
        while part := stream.read(1 << 20):
            found.update(part)
    return found.hexdigest()


def read_toml(file: Traversable, place: str) -> dict[str, object]:
    """A file of tables; empty where there is none.

    Raises `ClaimError` for what is not TOML, with the line.
    """
    if not file.is_file():
        return {}
    try:
        with file.open("rb") as stream:
            data = stream.read(CHARACTERS + 1)
        if len(data) > CHARACTERS:
            raise ClaimError("is too large", where=place, remedy=f"at most {CHARACTERS} bytes are read")
        return toml.loads(data.decode("utf-8"))
    except (toml.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ClaimError(f"not TOML:  {error}", where=place, remedy="correct the file") from None


#: How the files of a folder are listed.
LISTED = 'formulas = ["plane"] means plane.py, claims = ["section2.toml"] that file'


def told_of(folder: Traversable, name: str) -> Told:
    """The description of a folder.

    Raises `ClaimError` for an unknown field, one of the wrong type, or a file that is listed and does not exist.
    """
    file = "paper.toml"
    data = read_toml(folder.joinpath(file), f"{name}/{file}")
    if not data:
        file = "claims.toml"
        whole = read_toml(folder.joinpath(file), f"{name}/{file}")
        data = {key: value for key, value in whole.items() if key not in ("common", "claim")}
    usual: dict[str, object] = {**SILENT}
    for key, value in data.items():
        if key not in usual:
            raise ClaimError(f"a paper has no {key!r}", where=f"{name}/{file}", remedy=nearest(key, usual))
        texts = value if isinstance(value, list) else [*value.values()] if isinstance(value, dict) else []
        good = all(isinstance(text, str) and text.isprintable() for text in [*texts, *[value] * isinstance(value, str)])
        if type(value) is not type(usual[key]) or not good:
            raise ClaimError(f"{key} is {value!r}", where=f"{name}/{file}", remedy=f"write it like {usual[key]!r}")
    told = cast(Told, usual | data)
    for path in (*told["formulas"], *told["claims"]):
        if any(part in ("", ".", "..") for part in path.split("/")):
            raise ClaimError(f"the file {path!r}", where=f"{name}/{file}", remedy="name files inside the folder")
    listed = [f"{module}.py" for module in told["formulas"] if "formulas" in data and not told["formulas_in"]]
    listed += [claims for claims in told["claims"] if "claims" in data]
    for path in listed:
        if not folder.joinpath(*path.split("/")).is_file():
            raise ClaimError(f"the file {path!r} does not exist", where=f"{name}/{file}", remedy=LISTED)
    return told


def paper_in(
    folder: Traversable,
    name: str,
    used: Callable[[str], Paper],
    *,
    package: str = "",
    trusted: bool = False,
    importable: Importable = dict,
) -> Paper:
    """The paper in a folder; `used` gives the papers that it uses.

    Raises `ClaimError` for a user's folder that says that its formulas are modules of a package.
    """
    told = told_of(folder, name)
    if told["formulas_in"] and not package:
        raise ClaimError("formulas_in", where=f"{name}/paper.toml", remedy="name files of the folder in `formulas`")
    return Paper(
        name,
        told["title"] or _heading(folder) or name,
        told["reference"],
        folder,
        tuple(told["formulas"]),
        tuple(told["claims"]),
        tuple(used(other) for other in told["uses"]),
        told["errors"],
        told["default"],
        package and (told["formulas_in"] or package),
        trusted,
        importable,
    )


def _heading(folder: Traversable) -> str:
    """The first heading of ``README.md``."""
    file = folder.joinpath("README.md")
    lines = file.read_bytes().decode("utf-8", "replace").splitlines() if file.is_file() else []
    heading = next((line.lstrip("# ").strip() for line in lines if line.startswith("#")), "")
    return "".join(letter for letter in heading if letter.isprintable())


def folder_at(path: str | Path) -> Path:
    """The folder of a paper at a path.

    Raises `ClaimError` where there is none, or none of a paper.
    """
    folder = Path(as_path(path))
    if not folder.is_dir():
        raise ClaimError("there is no such folder", where=str(path), remedy="exactspline paper new FOLDER writes one")
    if not any((folder / file).is_file() for file in ("paper.toml", "claims.toml", "formulas.py")):
        raise ClaimError("is not a folder of a paper", where=str(path), remedy="it holds formulas.py and claims.toml")
    return folder
