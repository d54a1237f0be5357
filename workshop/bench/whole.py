"""Whole commands, as a user starts them: `prove` cold, files inspected, the cost of an import."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

from exactspline.batch.corpus import Problem, items
from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.inspection import inspect_curve
from exactspline.interchange.examples import example_names
from exactspline.splines.nurbs import Nurbs
from workshop.bench.row import OURS, Options, Row, best, bounded

COMMANDS = "commands"
#: The number of runs, of which the fastest counts.
RUNS = 3
#: The number of runs where a difference is measured.
MANY = 9
#: What `exactspline.cli.main` does before its process ends: so that only the imports are subtracted.
AT_THE_END = "import gc\ngc.freeze()\n"


def command_rows(options: Options) -> Iterator[Row]:
    """Processor time of separate processes, and of files inspected in this process."""
    with TemporaryDirectory() as folder, _keeping_bytecode(folder):
        yield from _command_rows()
    yield from _files(options.curves)


@contextmanager
def _keeping_bytecode(folder: str) -> Iterator[None]:
    """Within this context processes keep the bytecode of what they import, as they do by default, and verdicts."""
    names = ("PYTHONDONTWRITEBYTECODE", "PYTHONPYCACHEPREFIX", "EXACTSPLINE_CACHE")
    kept = {name: os.environ.get(name) for name in names}
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["PYTHONPYCACHEPREFIX"] = folder
    os.environ["EXACTSPLINE_CACHE"] = f"{folder}/verdicts"
    try:
        yield
    finally:
        for name, value in kept.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value


def _command_rows() -> Iterator[Row]:
    processor_time(["-m", "exactspline", "prove", "--claim", "C4.1a", "-q"], runs=1)  # compiles what it imports
    took, _ = processor_time(["-m", "exactspline", "prove", "-q", "--fresh"])
    yield bounded(COMMANDS, "prove, whole and cold", took, "s", 5)
    took, _ = processor_time(["-m", "exactspline", "prove", "-q"])
    yield bounded(COMMANDS, "prove, unchanged formulas", took, "s", 1)
    loaded = imported_by(["prove", "--curve", "rational_cubic", "-q"])
    whole, _ = processor_time(["-m", "exactspline", "prove", "--curve", "rational_cubic", "-q", "--fresh"], runs=MANY)
    imports, _ = processor_time(["-c", "".join(f"import {name}\n" for name in loaded) + AT_THE_END], runs=MANY)
    packages = dict.fromkeys(name.split(".")[0] for name in loaded)
    above, note = whole - imports, f"{whole:.2f} s less {imports:.2f} s of {', '.join(packages)}"
    yield bounded(COMMANDS, "prove on one curve, above its imports", above, "s", Fraction(15, 100), note)
    nothing, _ = processor_time(["-c", "pass"])
    for command, arguments in (
        ("import exactspline", ["-c", "import exactspline"]),
        ("exactspline --help", ["-m", "exactspline", "--help"]),
    ):
        took, _ = processor_time(arguments)
        yield Row(COMMANDS, f"{command}, above Python itself", OURS, took - nothing, "s")
    for given, most in (("--help", Fraction(1, 10)), ("inspect cubic_s", Fraction(23, 100))):
        took, _ = processor_time(["-m", "exactspline", *given.split()], runs=MANY)
        yield bounded(COMMANDS, f"exactspline {given}, whole", took, "s", most)
    slow = "formula degrees --paper surfaces --generic"
    took, _ = processor_time(["-m", "exactspline", *slow.split(), "-q"], runs=1)
    yield Row(COMMANDS, f"exactspline {slow}", OURS, took, "s")


def processor_time(arguments: Sequence[str], runs: int = RUNS) -> tuple[float, str]:
    """The least processor time of a Python process in seconds, and what it printed."""
    times, printed = [], ""
    for _ in range(runs):
        before = _of_children()
        done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False)
        times.append(_of_children() - before)
        printed = done.stdout
        if done.returncode:
            raise ExactSplineError(f"{' '.join(arguments)} ended with status {done.returncode}", remedy=done.stderr)
    return min(times), printed


def _of_children() -> float:
    """The processor time of the child processes that have ended, as exactly as the system measures it."""
    try:
        from resource import RUSAGE_CHILDREN, getrusage
    except ImportError:
        times = os.times()
        return times.children_user + times.children_system
    used = getrusage(RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


LOADED = """
import sys
sys.argv = ["exactspline", *sys.argv[1:]]
from exactspline.cli import main
try:
    main()
except SystemExit:
    pass
from importlib.metadata import packages_distributions
known = packages_distributions()
print("\\nloaded", *[name for name in sys.modules if name.split(".")[0] in known])
"""


def imported_by(arguments: Sequence[str]) -> list[str]:
    """The modules of installed packages that a command loads, in their order, without ours and those that no statement
    can import.
    """
    _, printed = processor_time(["-c", LOADED, *arguments], runs=1)
    names = printed.rsplit("loaded", 1)[-1].split()
    return [
        name for name in names if all(map(str.isidentifier, parts := name.split("."))) and parts[0] != "exactspline"
    ]


def _files(folder: str) -> Iterator[Row]:
    """All curves of a folder, or the examples, inspected in this process, each read again."""
    case = f"all curves of {Path(folder).name or folder}" if folder else "all example curves"
    places = [folder] if folder else list(example_names())
    curves = [item.curve() for item in items(places) if not isinstance(item.given, Problem)]

    def fresh() -> list[Nurbs]:
        return [Nurbs(c.degree, c.knots, c.control_points, c.weights) for c in curves]

    def inspected(given: object) -> None:
        assert isinstance(given, list)
        for each in given:
            assert inspect_curve(each).answers

    took = best({OURS: (inspected, fresh)})[OURS] / 1000
    yield bounded(COMMANDS, f"{case} ({len(curves)}) inspected in one process", took, "s", Fraction(15, 100))
