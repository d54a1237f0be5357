"""Results on disk that survive a kill: JSON Lines in one file, or Parquet in a folder of parts.

When the same sweep is started again, it continues after the last complete line. The settings of a sweep are stored next
to its results; results of other settings are refused, never mixed.
"""

from __future__ import annotations

import json
import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import IO, Self, TypeVar

from exactspline.atomic_write import write_text
from exactspline.batch.lines import Line
from exactspline.errors import ExactSplineError
from exactspline.system import lock

Settings = Mapping[str, object]
V = TypeVar("V")


class ResultsError(ExactSplineError):
    """Results that cannot be written, or are not of this sweep."""


class Results(ABC):
    """Existing lines, and lines that are added; other writers are locked out."""

    def __init__(self, place: Path, settings: Settings) -> None:
        self.place, self.settings = place, json.loads(json.dumps(settings))

    @abstractmethod
    def existing(self) -> Iterator[Line]:
        """The existing lines, in order; to be read before any is added. Raises `ResultsError`."""

    @abstractmethod
    def add(self, line: Line) -> None:
        """Add a line; JSON Lines are passed to the operating system immediately."""

    @abstractmethod
    def close(self) -> None:
        """Write what is buffered, and release the lock."""

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
        # open as long as the results are in use: `close` closes it
        self._file = _reporting(place, lambda: open(place, "a+b", buffering=0))  # noqa: SIM115
        try:
            locked(self._file.fileno(), place)
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
                    raise ResultsError(
                        f"line {index + 1} is not a line as written by a sweep",
                        where=str(self.place),
                        remedy="restore the file",
                    )
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
    end = stream.seek(0, os.SEEK_END)
    keep = end
    while keep:
        start = max(keep - (1 << 16), 0)
        stream.seek(start)
        position = stream.read(keep - start).rfind(b"\n")
        if position >= 0:
            keep = start + position + 1
            break
        keep = start
    if keep < end:
        stream.truncate(keep)


def locked(handle: int | None, place: Path) -> None:
    """Keep others from writing to the same results until the file is closed or the process ends, where the system
    supports it.

    Raises `ResultsError` where another process writes.
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
