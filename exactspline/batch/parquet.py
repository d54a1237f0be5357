"""Results as Parquet (the extra `sweep`): a folder of parts, each written whole or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any

from exactspline.atomic_write import write_atomically
from exactspline.batch.lines import Line, line_schema
from exactspline.batch.results import Results, ResultsError, Settings, locked
from exactspline.system import open_folder

if TYPE_CHECKING:
    import pyarrow

#: A part has at most this many rows, and is written after this many seconds: which bounds what a kill can lose.
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
            locked(self._handle, place)
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
                raise ResultsError(
                    f"is not the part that begins at row {index}, as written by a sweep",
                    where=str(part),
                    remedy="restore the folder",
                ) from None

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
    """The columns: the fields of a line about a curve, and in place of what was found one column per question."""
    fields: Any = line_schema()["properties"]
    found = fields["found"]["additionalProperties"]
    columns: dict[str, Any] = {}
    for name, form in fields.items():
        if name == "answers":
            continue
        columns |= dict.fromkeys(find, found) if name == "found" else {name: form}
    return pa.schema([(name, pa.int64() if name == "index" else _type(pa, form)) for name, form in columns.items()])


def _type(pa: Any, form: dict[str, Any]) -> Any:
    """The Arrow type of what a JSON Schema describes; a value may be missing in any case."""
    if "anyOf" in form:
        return _type(pa, form["anyOf"][1])
    kind = form["type"][0] if isinstance(form["type"], list) else form["type"]
    if kind == "array":
        return pa.list_(_type(pa, form["items"]))
    if kind == "object":
        return pa.struct([(name, _type(pa, each)) for name, each in form["properties"].items()])
    return {"string": pa.string, "integer": pa.int32, "boolean": pa.bool_, "number": pa.float64}[kind]()
