"""Sweeps over the fonts that matplotlib ships: contours per second in one process and in two, one of them killed and
continued, and the same lines from every backend.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path
from tempfile import TemporaryDirectory
from time import monotonic, process_time, sleep

from exactspline.batch.backends import BackendError
from exactspline.batch.lines import Line, Summary
from exactspline.batch.sweep import Where, Work, sweep_into_file
from workshop.bench.row import OURS, Options, Row, bounded, installed, missing

SWEEP = "sweep"
#: The fonts of a short run.
SAMPLED = ("cmr10.ttf", "cmss10.ttf", "cmti10.ttf")
#: Seconds between two checks of a growing file.
LOOK = 1 / 100


@dataclass(frozen=True)
class Swept:
    """A sweep into a file: its lines, wall-clock seconds since the first new one, and the summary of the lines."""

    new: int
    seconds: float
    summary: Summary


def sweep_rows(options: Options) -> Iterator[Row]:
    """Inflections, extrema and corners of all contours of the glyphs."""
    if not installed("matplotlib"):
        yield missing(SWEEP, "contours of the fonts of matplotlib", "matplotlib")
        return
    fonts = [str(font) for font in _fonts() if options.full or font.name in SAMPLED]
    with TemporaryDirectory() as folder:
        serial = Path(folder) / "serial.jsonl"
        start = process_time()
        one = swept(fonts, Where("serial"), serial)
        note = f"{1000 * (process_time() - start) / one.new:.2f} ms of processor time each; {_counted(one.summary)}"
        what = f"contours of {len(fonts)} fonts of matplotlib"
        yield Row(SWEEP, f"{what}, 1 process", OURS, one.new / one.seconds, "1/s", note=note)
        yield from _killed(fonts, what, one, Path(folder))
        yield from _on("dask", fonts, serial)


def _fonts() -> list[Path]:
    import matplotlib as mpl

    return sorted((Path(mpl.get_data_path()) / "fonts" / "ttf").glob("*.ttf"))


def swept(corpus: Sequence[str], where: Where, place: Path) -> Swept:
    """A sweep into a file, or the rest of one."""
    summary, new, start = Summary(), 0, monotonic()

    def tick(share: float, line: Line, known: bool) -> None:
        nonlocal new, start
        if not known:
            new += 1
            if new == 1:
                start = monotonic()

    sweep_into_file(corpus, Work.of(), where, str(place), summary, tick)
    return Swept(new, monotonic() - start, summary)


def differing(one: Path, other: Path) -> int:
    """How many lines of two files differ, byte for byte except for the processor time at the end of every line."""
    with open(one, "rb") as first, open(other, "rb") as second:
        return sum(_timeless(a) != _timeless(b) for a, b in zip_longest(first, second, fillvalue=b""))


def _timeless(line: bytes) -> bytes:
    return line.rpartition(b',"seconds":')[0]


def _counted(summary: Summary) -> str:
    counts = {name: 0 for name, _ in summary.found}
    for (name, _), count in summary.found.items():
        counts[name] += count
    parts = [f"{summary.segments} segments", *(f"{count} {name}" for name, count in counts.items())]
    return ", ".join([*parts, f"{summary.errors.total()} errors"])


def _killed(corpus: Sequence[str], what: str, one: Swept, folder: Path) -> Iterator[Row]:
    """A sweep in two processes, killed after half of the lines and continued: its rate, and the lines that differ from
    those of the undisturbed sweep.
    """
    place = folder / "killed.jsonl"
    half, seconds = killed_at(corpus, place, one.new // 2)
    before = place.read_bytes()
    rest = swept(corpus, Where("processes", 2), place)
    with open(place, "rb") as stream:
        kept = stream.read(len(before)).startswith(before[: before.rfind(b"\n") + 1])
    del before
    rate, alone = (half + rest.new) / (seconds + rest.seconds), one.new / one.seconds
    yield Row(SWEEP, f"{what}, 2 processes", OURS, rate, "1/s", note=f"{rate / alone:.2f} times one process")
    note = f"killed after {half} of {rest.summary.lines} lines" + ("" if kept else "; what was written was changed")
    lost = differing(folder / "serial.jsonl", place)
    yield bounded(SWEEP, "lines lost, repeated or changed by a kill, 2 processes", lost, "lines", 0, note)


def killed_at(corpus: Sequence[str], place: Path, lines: int) -> tuple[int, float]:
    """Start the command that sweeps a corpus in two processes into a file, and kill it, with all its processes, when
    there are this many lines; returns the number of lines, and the seconds since the first.
    """
    command = [sys.executable, "-m", "exactspline", "sweep", *corpus, "-o", str(place), "--jobs", "2", "-q"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    written, start = 0, monotonic()
    while process.poll() is None and not place.exists():
        sleep(LOOK)
    if process.poll() is not None and not place.exists():
        raise BackendError(f"the sweep ended with status {process.returncode}", remedy="run it: " + " ".join(command))
    with open(place, "rb") as stream:
        while process.poll() is None and written < lines:
            if new := stream.read().count(b"\n"):
                start, written = monotonic() if not written else start, written + new
            sleep(LOOK)
        seconds = monotonic() - start
        _kill(process)
        written += stream.read().count(b"\n")
    return written, seconds


def _kill(process: subprocess.Popen[bytes]) -> None:
    """End a process, together with those that it started where the system has process groups."""
    try:
        if hasattr(os, "killpg"):
            os.killpg(process.pid, signal.SIGKILL)
        else:
            process.kill()
    except ProcessLookupError:
        pass  # it had already ended
    process.wait()


def _on(backend: str, corpus: Sequence[str], serial: Path) -> Iterator[Row]:
    """A sweep on a cluster of two workers: its rate, and the lines that differ from those of one process."""
    case = f"lines on {backend}, 2 workers, that differ from those of one process"
    if not installed(backend):
        yield missing(SWEEP, case, backend)
        return
    place = serial.with_name(f"{backend}.jsonl")
    try:
        here = swept(corpus, Where(backend, 2), place)
    except BackendError as error:
        yield Row(SWEEP, case, backend, None, "lines", note=str(error))
        return
    note = f"of {here.new}, {here.new / here.seconds:.0f} a second"
    yield bounded(SWEEP, case, differing(serial, place), "lines", 0, note, backend)
    place.unlink()
