"""The folder of a paper, read by the same code for papers of the library and of users. A folder contains formulas
(``formulas.py``), claims (``claims.toml``) and a description (``paper.toml``), which may also be given in the first
lines of ``claims.toml``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from hashlib import sha256
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, cast

from exactspline.errors import ClaimError, ExactSplineError, FormulaError, as_path, command_name, nearest
from exactspline.language.formula import Formula
from exactspline.one_line import one_line
from exactspline.papers.loading import Importable, checked_formulas, trusted_formulas

try:  # compiled, and with limits on the nesting depth of untrusted input
    import tomli as toml
except ModuleNotFoundError:  # in a browser
    import tomllib as toml  # type: ignore[no-redef]  # has the same functions

if TYPE_CHECKING:
    from importlib.resources.abc import Traversable


class Description(TypedDict):
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


#: The largest size of a file of tables in bytes.
CHARACTERS = 4_000_000
#: The default values of the description.
SILENT: Description = {
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
    """A table in a file of a paper, with its place: ``file, entry number``."""

    place: str
    entry: dict[str, Any]


@dataclass(frozen=True, eq=False)
class Paper:
    """A source: its folder, its title, the modules of its formulas and the files of its claims.

    ``uses`` are the papers whose formulas may be used by its formulas and named in its claims. ``errors`` are its
    errors: each is a name for the group of claims that fail for the same reason, with an explanation. A ``default``
    paper is used if no paper is named. ``package`` is the package from which its modules are imported (its package, or
    one in `exactspline.formulas` for formulas that do not belong to a single source). It is empty for a user's folder;
    then formulas are checked before they run, unless the folder is ``trusted``, and may import the formulas in
    ``importable`` from other papers.
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
    _refused: dict[str, ExactSplineError] = field(default_factory=dict, repr=False)

    @one_line
    def __repr__(self) -> str:
        return f"<Paper {self.name}: {self.title}>"

    @property
    def formulas(self) -> dict[str, Formula]:
        """The formulas of this paper by name, in the order of the source."""
        if "formulas" not in self._kept:
            self._kept["formulas"] = self._read_formulas()
        return self._kept["formulas"]

    def _read_formulas(self) -> dict[str, Formula]:
        formulas: dict[str, Formula] = {}
        for module in self.modules if self.package else ():
            home = f"{self.package}.{module}"
            values = vars(import_module(home)).values()
            formulas |= {f.name: f for f in values if isinstance(f, Formula) and f.__module__ == home}
        for each in formulas.values():
            each.checked = True
        for name, file in () if self.package else self.formula_files():
            try:
                formulas |= (
                    trusted_formulas(file)
                    if self.trusted
                    else checked_formulas(file, self.importable, refused=self._refused)
                )
            except FormulaError as error:
                self._refused[name] = error
        return formulas

    @property
    def refused(self) -> dict[str, ExactSplineError]:
        """The reasons why formulas, lines and files of a user's folder were refused, by their names."""
        return self._refused if self.formulas is not None else {}

    def formula_files(self) -> list[tuple[str, Traversable]]:
        """The existing files of its formulas, with their names."""
        home = Path(cast(str, import_module(self.package).__file__)).parent if self.package else self.folder
        files = [(f"{module}.py", home.joinpath(*f"{module}.py".split("/"))) for module in self.modules]
        return [(name, file) for name, file in files if file.is_file()]

    def find(self, name: str) -> Formula:
        """The formula with this name, of this paper or of a paper that it uses.

        >>> from exactspline.papers import paper
        >>> paper("chen_riesenfeld_cohen_2007").find("f2")
        <formula f2, eq. (8)>

        Raises `FormulaError` for an unknown name, with the nearest ones, and if several of the papers that it uses have
        such a formula.
        """
        if name in self.formulas:
            return self.formulas[name]
        having = [source for source in self.uses if name in source.formulas]
        files = [] if having else [f"{module}.py" for module in self.modules]
        for refused in (name, *files):
            if refused in self._refused:
                raise self._refused[refused]
        if len({source.formulas[name] for source in having}) > 1:
            papers = " and of ".join(source.name for source in having)
            raise FormulaError(
                f"{name!r} is a formula of {papers}", remedy="define a formula that calls the intended one"
            )
        if having:
            return having[0].formulas[name]
        known = [known for source in (self, *self.uses) for known in source.formulas]
        raise FormulaError(f"{self.name} has no formula called {name!r}", remedy=nearest(name, known))

    def has(self, name: str) -> bool:
        """Whether this paper, or a paper that it uses, has a formula with this name, valid or refused."""
        return name in self.refused or any(name in source.formulas for source in (self, *self.uses))

    def claim_tables(self) -> Iterator[Table]:
        """The claims as written in the files of the paper; the fields of ``common`` in a file apply to each of its
        claims. A file of a user's folder that is not a table of claims is listed as ``refused``.

        Raises `ClaimError` for such a file of the library.
        """
        for file in self.claim_files:
            try:
                common, entries = self._entries(file)
            except ClaimError as error:
                if self.package:
                    raise
                self.refused[file] = error
                continue
            for i, entry in enumerate(entries):
                yield Table(f"{self.name}/{file}, claim {i + 1}", common | entry)

    def _entries(self, file: str) -> tuple[dict[str, Any], list[Any]]:
        """The common fields of the claims in a file, and the claims."""
        data = self._read(file)
        common, entries = data.get("common", {}), data.get("claim", [])
        if not isinstance(common, dict) or not isinstance(entries, list):
            raise ClaimError("not a table of claims", where=f"{self.name}/{file}", remedy="write [[claim]]")
        for i, entry in enumerate(entries):
            if not isinstance(entry, dict):
                place = f"{self.name}/{file}, claim {i + 1}"
                raise ClaimError("a claim is not a table", where=place, remedy="write [[claim]]")
        return common, entries

    def construction_tables(self) -> dict[str, Table]:
        """The constructions of the paper by name, as written in ``constructions.toml``."""
        file = "constructions.toml"
        tables = self._read(file).items()
        return {name: Table(f"{self.name}/{file}, {name}", each) for name, each in tables if isinstance(each, dict)}

    def curve_files(self) -> list[Traversable]:
        """The files of its curves, in ``curves/``."""
        place = self.folder.joinpath("curves")
        return sorted((f for f in place.iterdir() if f.is_file()), key=lambda f: f.name) if place.is_dir() else []

    def digests(self) -> dict[str, str]:
        """The SHA-256 digests of its files by name."""
        files = dict(files_in(self.folder)) | dict(self.formula_files())
        # files that are read are listed even if they are links; other links are ignored
        names = ("paper.toml", "claims.toml", "constructions.toml", "README.md")
        for path in (*names, *self.claim_files):
            if (file := self.folder.joinpath(*path.split("/"))).is_file():
                files[path] = file
        files |= {f"curves/{file.name}": file for file in self.curve_files()}
        return {name: _digest(file) for name, file in sorted(files.items())}

    def _read(self, file: str) -> dict[str, object]:
        return read_toml(self.folder.joinpath(*file.split("/")), f"{self.name}/{file}")


def files_in(folder: Traversable, path: str = "") -> Iterator[tuple[str, Traversable]]:
    """The files in a folder and in its subfolders, by their paths, except hidden files and links."""
    for each in folder.iterdir():
        if each.name.startswith((".", "__pycache__")) or (isinstance(each, Path) and each.is_symlink()):
            continue
        if each.is_dir():
            yield from files_in(each, f"{path}{each.name}/")
        elif each.is_file():
            yield path + each.name, each


def _digest(file: Traversable) -> str:
    digest = sha256()
    with file.open("rb") as stream:
        while part := stream.read(1 << 20):
            digest.update(part)
    return digest.hexdigest()


def read_toml(file: Traversable, place: str) -> dict[str, object]:
    """The contents of a TOML file; empty if it does not exist.

    Raises `ClaimError`, with the line, for a file that is not TOML.
    """
    if not file.is_file():
        return {}
    try:
        with file.open("rb") as stream:
            data = stream.read(CHARACTERS + 1)
        if len(data) > CHARACTERS:
            raise ClaimError("is too large", where=place, remedy=f"at most {CHARACTERS} bytes are read")
        return toml.loads(data.decode("utf-8"), parse_float=str)  # decimals are exact as written
    except (toml.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ClaimError(f"not TOML:  {error}", where=place, remedy="correct the file") from None


#: Explains how to list the files of a folder.
LISTED = 'formulas = ["plane"] means plane.py, claims = ["section2.toml"] that file'


def description_of(folder: Traversable, name: str) -> Description:
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
    description = cast(Description, usual | data)
    for path in (*description["formulas"], *description["claims"]):
        if any(part in ("", ".", "..") for part in path.split("/")):
            raise ClaimError(f"the file {path!r}", where=f"{name}/{file}", remedy="name files inside the folder")
    listed = [
        f"{module}.py" for module in description["formulas"] if "formulas" in data and not description["formulas_in"]
    ]
    listed += [claims for claims in description["claims"] if "claims" in data]
    for path in listed:
        if not folder.joinpath(*path.split("/")).is_file():
            raise ClaimError(f"the file {path!r} does not exist", where=f"{name}/{file}", remedy=LISTED)
    return description


def paper_in(
    folder: Traversable,
    name: str,
    used: Callable[[str], Paper],
    *,
    package: str = "",
    trusted: bool = False,
    importable: Importable = dict,
) -> Paper:
    """The paper in a folder; `used` returns the paper with a name, for those that it uses.

    Raises `ClaimError` for a user's folder that declares its formulas as modules of a package.
    """
    description = description_of(folder, name)
    if description["formulas_in"] and not package:
        raise ClaimError("formulas_in", where=f"{name}/paper.toml", remedy="name files of the folder in `formulas`")
    return Paper(
        name,
        description["title"] or _heading(folder) or name,
        description["reference"],
        folder,
        tuple(description["formulas"]),
        tuple(description["claims"]),
        tuple(used(other) for other in description["uses"]),
        description["errors"],
        description["default"],
        package and (description["formulas_in"] or package),
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

    Raises `ClaimError` if it does not exist or is not the folder of a paper.
    """
    folder = Path(as_path(path))
    if not folder.is_dir():
        raise ClaimError(
            "there is no such folder", where=str(path), remedy=f"`{command_name()} paper new FOLDER` creates one"
        )
    if not any((folder / file).is_file() for file in ("paper.toml", "claims.toml", "formulas.py")):
        raise ClaimError(
            "is not the folder of a paper", where=str(path), remedy="it must contain formulas.py and claims.toml"
        )
    return folder
