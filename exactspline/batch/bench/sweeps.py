"""Sweeps over the fonts that matplotlib ships: contours per second, the same lines on every backend, and continuation
after a kill.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from time import monotonic, sleep

from exactspline.batch.backends import CHUNK, mapped
from exactspline.batch.bench.row import OURS, Options, Row, bounded, installed, missing
from exactspline.batch.corpus import Source, items
from exactspline.batch.lines import Line
from exactspline.batch.recorded import Where, recorded
from exactspline.batch.results import JsonLines
from exactspline.batch.summary import Summary
from exactspline.batch.work import Work

SWEEP = "sweep"
#: Contours of the sample in a short run, and of the sweep that is killed.
SAMPLE, KILLED = 600, "cmss10.ttf"
#: The complete results are cut after so many lines.
EARLY = 20


def sweep_rows(options: Options) -> Iterator[Row]:
    """Inflections, extrema and corners of glyph contours."""
    if not installed("matplotlib"):
        yield missing(SWEEP, "contours of the fonts of matplotlib", "matplotlib")
        return
    fonts = _fonts()
    most = None if options.full else SAMPLE
    what = f"contours of the {len(fonts)} fonts of matplotlib" if options.full else f"{SAMPLE} contours"
    sources: list[Source] = [*map(str, fonts)] if options.full else [str(f) for f in fonts if f.name in SAMPLED]
    kept: dict[str, list[Line]] = {}
    for jobs in (1, 2):
        took = _rate(sources, most, jobs, kept)
        own = kept["processes" if jobs > 1 else "serial"]
        note = f"{1000 * sum(line.seconds for line in own) / len(own):.2f} ms of processor time each"
        yield Row(SWEEP, f"{what}, {jobs} process{'es' if jobs > 1 else ''}", OURS, took, "1/s", note=note)
    for backend in ("processes", "dask"):
        told = f"lines of {backend} that differ from serial ones"
        if backend == "dask" and not installed("dask"):
            yield missing(SWEEP, told, "dask")
            continue
        given = islice(items(sources), SAMPLE)
        lines = list(mapped(Work.of().lines, given, backend, 2))
        differing = sum(a != b for a, b in zip(lines, kept["serial"], strict=False))
        yield bounded(SWEEP, told, differing, "lines", 0, f"of {len(lines)}", OURS)
    yield from _killed([str(f) for f in fonts if f.name == KILLED])


#: Fonts with curves of degree 2: two of text, one of mathematics.
SAMPLED = ("cmr10.ttf", "DejaVuSans.ttf", "STIXGeneral.ttf")


def _fonts() -> list[Path]:
    import matplotlib as mpl

    return sorted((Path(mpl.get_data_path()) / "fonts" / "ttf").glob("*.ttf"))


def _rate(sources: list[Source], most: int | None, jobs: int, kept: dict[str, list[Line]]) -> float:
    """Contours per second, without the start of the processes; the first lines are kept."""
    backend, work = "processes" if jobs > 1 else "serial", Work.of()
    lines = mapped(work.lines, islice(items(sources), most), backend, jobs)
    start, first, seen, own = monotonic(), 0, 0, kept.setdefault(backend, [])
    for line in lines:
        seen += 1
        if seen == CHUNK:
            start, first = monotonic(), seen
        if len(own) < SAMPLE:
            own.append(line)
    return (seen - first) / (monotonic() - start)


def _killed(corpus: list[str]) -> Iterator[Row]:
    """A sweep into a file, killed and continued: the lines that differ from an undisturbed sweep."""
    with TemporaryDirectory() as folder:
        place = Path(folder) / "lines.jsonl"
        command = [sys.executable, "-m", "exactspline", "sweep", *corpus, "-o", str(place), "-q"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and (not place.exists() or place.read_bytes().count(b"\n") < EARLY):
            sleep(1 / 100)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
        torn = place.read_bytes()
        recorded(corpus, Work.of(), Where("serial"), str(place), Summary())
        whole = place.read_bytes()
        with JsonLines(place, {}) as results:
            lines = list(results.existing())
        undisturbed = list(mapped(Work.of().lines, items(corpus)))
    differing = abs(len(lines) - len(undisturbed)) + sum(a != b for a, b in zip(lines, undisturbed, strict=False))
    before = torn.rfind(b"\n") + 1
    note = f"killed after {torn.count(bytes([10]))} of {len(lines)} lines"
    if not whole.startswith(torn[:before]):
        note += "; what was written was changed"
    yield bounded(SWEEP, "lines lost, repeated or changed by a kill", differing, "lines", 0, note)
