"""Heavy cases, each in a separate process, so that its memory can be measured and it can be stopped when it takes too
long.

``python -m workshop.bench.alone NAME COUNT LIMIT JOBS`` prints the time and memory of a case.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

#: Wall-clock seconds for each second of processor time, on a machine that is not idle.
PATIENCE = 4


@dataclass(frozen=True)
class Took:
    """Processor seconds, and the growth of the peak resident size in MB (where the system reports it)."""

    seconds: float | None = None
    megabytes: float | None = None
    note: str = ""


def run(name: str, count: int, limit: int, jobs: int = 1) -> Took:
    """Run one case, stopped after this many seconds of processor time."""
    numbers = map(str, (count, limit, jobs))
    command = [sys.executable, "-m", "workshop.bench.alone", name, *numbers]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=PATIENCE * limit)
    except subprocess.TimeoutExpired:
        return Took(note=f"more than {limit} s")
    if done.returncode < 0:
        return Took(note=f"more than {limit} s")
    if done.returncode:
        return Took(note=done.stderr.strip().splitlines()[-1])
    measured = json.loads(done.stdout)
    return Took(measured["seconds"], measured["megabytes"])


def _inspect(count: int) -> Callable[[], object]:
    from exactspline.geometry.analysis.inspection import inspect_curve
    from workshop.bench.inputs import along

    # formulas are traced once per kind of curve, whatever its length
    inspect_curve(along(1))
    c = along(count)
    return lambda: inspect_curve(c).answers


def _write(count: int) -> Callable[[], object]:
    from exactspline.display.answer_forms import inspection_data
    from workshop.bench.inputs import along

    inspection_data(along(3), 12)
    c = along(count)
    return lambda: inspection_data(c, 12)


def _read(count: int) -> Callable[[], object]:
    from workshop.bench.inputs import along

    return lambda: along(count)


def _analyse(count: int) -> Callable[[], object]:
    from exactspline.geometry.analysis.curves import analyse
    from workshop.bench.inputs import along

    def call() -> object:
        facts = analyse(along(count))
        return facts.inflections.points, facts.curvature_extrema.points

    return call


def _first_use(count: int) -> Callable[[], object]:
    from exactspline.geometry.analysis.curves import analyse
    from workshop.bench.inputs import MIXED

    curves = [MIXED.curve(i) for i in range(count)]
    return lambda: [(len(analyse(c).inflections), len(analyse(c).curvature_extrema)) for c in curves]


def _trim(_: int) -> Callable[[], object]:
    from exactspline.geometry.bisectors.trimmed import trimmed_bisector
    from workshop.bench.inputs import wandering

    c = wandering(3, 500, rational=False)
    return lambda: trimmed_bisector(c, (7, 100))


def _trim_rational(_: int) -> Callable[[], object]:
    from exactspline.geometry.bisectors.trimmed import trimmed_bisector
    from workshop.bench.inputs import wandering

    c = wandering(5, 10, rational=True)
    return lambda: trimmed_bisector(c, (7, 100))


def _sweep(count: int) -> Callable[[], object]:
    from exactspline.batch.corpus import Family
    from exactspline.batch.lines import Summary
    from exactspline.batch.sweep import Where, Work, sweep_into_file

    family, jobs = Family.parsed(f"degree=3 count={count}"), int(sys.argv[4])
    where = Where("processes" if jobs > 1 else "serial", jobs)

    def call() -> None:
        with TemporaryDirectory() as folder:
            sweep_into_file([family], Work.of(), where, f"{folder}/lines.jsonl", Summary())

    return call


def _bisector(degree: int) -> Callable[[], object]:
    from exactspline.papers import find
    from exactspline.splines.tensor import surface_pair
    from workshop.bench.inputs import curve

    pair = surface_pair(*[curve(degree, 4, dimension=3, seed=seed) for seed in (1, 2)])
    return lambda: find("bisector_symmetric")(pair)


CASES: dict[str, Callable[[int], Callable[[], object]]] = {
    "inspect": _inspect,
    "write": _write,
    "read": _read,
    "analyse": _analyse,
    "first use": _first_use,
    "trim": _trim,
    "trim rational": _trim_rational,
    "sweep": _sweep,
    "bisector": _bisector,
}


def peak() -> float | None:
    """The largest resident size of this process so far in MB, where the system reports it."""
    try:
        match = re.search(r"VmHWM:\s*(\d+)", Path("/proc/self/status").read_text(encoding="ascii"))
    except OSError:
        return None
    return int(match[1]) / 1024 if match else None


def main() -> None:
    """Run one case and print its time and memory."""
    name, count, limit = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    call = CASES[name](count)
    try:
        import resource

        so_far = int(process_time())
        resource.setrlimit(resource.RLIMIT_CPU, (so_far + limit, so_far + limit + 5))
    except (ImportError, ValueError):
        pass  # then the limit on wall-clock time ends it
    before, start = peak(), process_time()
    call()
    seconds, after = process_time() - start, peak()
    grown = after - before if before is not None and after is not None else None
    print(json.dumps({"seconds": seconds, "megabytes": grown}))


if __name__ == "__main__":
    main()
