"""Results on disk that survive a kill: JSON Lines in one file, or Parquet in a folder of parts.

When the same sweep is started again, it continues after the last complete line. The settings of a sweep are stored next
to its results; results of other settings are refused, never mixed.
"""

from __future__ import annotations

import json
import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from mmap import ACCESS_READ, mmap
from pathlib import Path
from time import monotonic
from types import TracebackType
from typing import IO, TYPE_CHECKING, Any, Self, TypeVar

from exactspline.atomic_write import write_atomically, write_text
from exactspline.batch.lines import Line, line_schema
from exactspline.errors import ExactSplineError
from exactspline.system import lock, open_folder

if TYPE_CHECKING:
    import pyarrow


Settings = Mapping[str, object]
V = TypeVar("V")


class ResultsError(ExactSplineError):
    """The error for results that cannot be written, or that belong to another sweep."""


class Results(ABC):
    """The lines of a sweep on disk, to which lines are added; other writers are locked out."""

    def __init__(self, place: Path, settings: Settings) -> None:
        self.place, self.settings = place, json.loads(json.dumps(settings))

    @abstractmethod
    def existing(self) -> Iterator[Line]:
        """The existing lines, in order; they must be read before a line is added. Raises `ResultsError`."""

    @abstractmethod
    def add(self, line: Line) -> None:
        """Add a line; JSON Lines are passed to the operating system immediately."""

    @abstractmethod
    def close(self) -> None:
        """Write the buffered lines, and release the lock."""

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, where: TracebackType | None
    ) -> None:
        self.close()

    def check_settings(self, place: Path, *, new: bool) -> None:
        """Write the settings next to new results, or compare them with the existing ones."""
        if new:
            write_text(place, json.dumps(self.settings, ensure_ascii=False, indent=1) + "\n", ResultsError)
            return
        try:
            known = json.loads(place.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            raise ResultsError(
                "exists, and was not written by a sweep", where=str(self.place), remedy="write to another file"
            ) from None
        own = known if isinstance(known, dict) else {}
        if differing := [name for name in self.settings if own.get(name) != self.settings[name]]:
            raise ResultsError(
                f"was begun with other settings ({', '.join(differing)})",
                where=str(self.place),
                remedy=f"repeat the command that began it ({place.name} has its settings), or write to another file",
            )


class JsonLines(Results):
    """One JSON object per line, appended."""

    def __init__(self, place: Path, settings: Settings) -> None:
        super().__init__(place, settings)
        # the file is open as long as the results are in use: `close` closes it
        self._file = _reporting(place, lambda: open(place, "a+b", buffering=0))  # noqa: SIM115
        try:
            _locked(self._file.fileno(), place)
            new = os.fstat(self._file.fileno()).st_size == 0
            self.check_settings(place.with_name(place.name + ".settings.json"), new=new)
            _repair(self._file)
        except BaseException:
            self._file.close()
            raise

    def existing(self) -> Iterator[Line]:
        """The lines of the file; an incomplete last line (after a kill) has been removed."""
        with open(self.place, "rb") as stream:
            for index, text in enumerate(stream):
                try:
                    line = Line.from_data(json.loads(text))
                    whole = line.index == index
                except (ValueError, KeyError, TypeError, AssertionError):
                    whole = False
                if not whole:
                    problem = f"line {index + 1} is not a line as written by a sweep"
                    raise ResultsError(problem, where=str(self.place), remedy="restore the file")
                yield line

    def add(self, line: Line) -> None:
        """Append a line."""
        rest = memoryview(line_text(line).encode())
        while rest:
            written = _reporting(self.place, lambda part=rest: self._file.write(part))  # type: ignore[misc]  # a default
            rest = rest[written:]

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def line_text(line: Line) -> str:
    """A line as JSON, with its line break."""
    return json.dumps(line.data(), ensure_ascii=False, separators=(",", ":")) + "\n"


def _repair(stream: IO[bytes]) -> None:
    """Remove everything after the last line break: a line left incomplete by a kill."""
    if end := stream.seek(0, os.SEEK_END):
        with mmap(stream.fileno(), end, access=ACCESS_READ) as whole:
            keep = whole.rfind(b"\n") + 1
        if keep < end:
            stream.truncate(keep)


def _locked(handle: int | None, place: Path) -> None:
    """Prevent other processes from writing to the same results until the file is closed or the process ends, if the
    system supports locks.

    Raises `ResultsError` if another process is writing.
    """
    if not lock(handle):
        raise ResultsError(
            "is being written by another sweep", where=str(place), remedy="wait for it, or write to another file"
        )


def _reporting(place: Path, call: Callable[[], V]) -> V:
    try:
        return call()
    except OSError as error:
        raise ResultsError(
            f"cannot be written ({error.strerror})", where=str(place), remedy="name a file that can be written"
        ) from None


# ---- tables of Arrow


#: A part has at most this many rows, and is written after this many seconds, so that a kill loses little.
ROWS, SECONDS = 10_000, 60


class Parquet(Results):
    """A folder of parts ``part-000000000.parquet``, each named by the index of its first row.

    One column per question, a list of the fields of `Found` each; readers of folders (pyarrow, pandas,
    DuckDB, polars) combine the parts and ignore the settings.
    """

    def __init__(self, place: Path, settings: Settings) -> None:
        super().__init__(place, settings)
        try:
            import pyarrow as pa
        except ImportError:
            raise ResultsError("pyarrow is not installed", where=str(place), remedy="pip install pyarrow") from None
        find = self.settings["find"]
        self._find: list[str] = list(find)
        self._schema = _schema(pa, self._find)
        self._kept: list[dict[str, object]] = []
        self._last = monotonic()
        try:
            place.mkdir(exist_ok=True)
            self._handle = open_folder(place)
        except OSError as error:
            raise ResultsError(
                f"no folder can be made there ({error.strerror})", where=str(place), remedy="name another folder"
            ) from None
        try:
            _locked(self._handle, place)
            self.check_settings(place / "_settings.json", new=not any(place.iterdir()))
            for torn in place.glob(".part-*"):
                torn.unlink()
        except BaseException:
            self._unlock()
            raise

    def existing(self) -> Iterator[Line]:
        """The rows of all parts."""
        import pyarrow as pa
        import pyarrow.parquet as pq

        index = 0
        for part in sorted(self.place.glob("part-*.parquet")):
            try:
                with pq.ParquetFile(part) as stream:
                    for batch in stream.iter_batches():
                        for row in batch.to_pylist():
                            line = self._line(row)
                            if line.index != index:
                                raise ValueError
                            yield line
                            index += 1
            except (pa.ArrowInvalid, ValueError, KeyError, TypeError):
                problem = f"is not the part that begins at row {index}, as written by a sweep"
                raise ResultsError(problem, where=str(part), remedy="restore the folder") from None

    def add(self, line: Line) -> None:
        """One more row, written with its part."""
        data = line.data()
        points_by_name: Any = data.pop("found")
        if data.pop("answers"):
            raise ResultsError(
                "answers about surfaces", where=str(self.place), remedy="write lines: name a .jsonl file"
            )
        self._kept.append(data | {name: points_by_name.get(name) for name in self._find})
        if len(self._kept) >= ROWS or monotonic() - self._last > SECONDS:
            self._write()

    def close(self) -> None:
        """Write the unfinished part."""
        try:
            self._write()
        finally:
            self._unlock()

    def _unlock(self) -> None:
        if self._handle is not None:
            os.close(self._handle)

    def _write(self) -> None:
        import pyarrow as pa
        import pyarrow.parquet as pq

        if self._kept:
            table = pa.Table.from_pylist(self._kept, schema=self._schema)
            place = self.place / f"part-{self._kept[0]['index']:09d}.parquet"
            write_atomically(place, lambda stream: pq.write_table(table, stream), ResultsError)
        self._kept, self._last = [], monotonic()

    def _line(self, row: dict[str, Any]) -> Line:
        found = {name: points for name in self._find if (points := row.pop(name)) is not None}
        return Line.from_data(row | {"found": found, "answers": {}})


def _schema(pa: Any, find: list[str]) -> pyarrow.Schema:
    """The columns: the fields of a line about a curve, where the points and pieces have one column per question."""
    fields: Any = line_schema()["properties"]
    found = fields["found"]["additionalProperties"]
    columns: dict[str, Any] = {}
    for name, form in fields.items():
        if name == "answers":
            continue
        columns |= dict.fromkeys(find, found) if name == "found" else {name: form}
    return pa.schema([(name, pa.int64() if name == "index" else _type(pa, form)) for name, form in columns.items()])


def _type(pa: Any, form: dict[str, Any]) -> Any:
    """The Arrow type of values that a JSON Schema describes; every value may be missing."""
    if "anyOf" in form:
        return _type(pa, form["anyOf"][1])
    kind = form["type"][0] if isinstance(form["type"], list) else form["type"]
    if kind == "array":
        return pa.list_(_type(pa, form["items"]))
    if kind == "object":
        return pa.struct([(name, _type(pa, each)) for name, each in form["properties"].items()])
    return {"string": pa.string, "integer": pa.int32, "boolean": pa.bool_, "number": pa.float64}[kind]()
