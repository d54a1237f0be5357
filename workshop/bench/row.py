"""A row of the table: what was measured, for which library, and the target."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass
from fractions import Fraction
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from time import process_time

#: Ours, in the column of peers.
OURS = "exactspline"
#: A round of the stopwatch lasts this many milliseconds at least, and the best of this many rounds counts.
ROUND, ROUNDS = 20, 5
#: Peer → the distribution whose version is shown, and the module that it needs.
PEERS = {
    OURS: ("exactspline", "exactspline"),
    "python-flint inline": ("python-flint", "flint"),
    "python-flint": ("python-flint", "flint"),
    "sympy": ("sympy", "sympy"),
    "sympy on FLINT": ("sympy", "sympy"),
    "sympy inline": ("sympy", "sympy"),
    "sympy on FLINT inline": ("sympy", "sympy"),
    "PARI": ("cypari", "cypari"),
    "Fraction": ("", "fractions"),
    "pynurbs": ("pynurbs", "pynurbs"),
    "Open CASCADE": ("cadquery-ocp-novtk", "OCP"),
    "geomdl": ("geomdl", "geomdl"),
    "scipy": ("scipy", "scipy"),
    "dask": ("distributed", "distributed"),
    "ray": ("ray", "ray"),
    "numpy": ("numpy", "numpy"),
    "matplotlib": ("matplotlib", "matplotlib"),
}


@dataclass(frozen=True)
class Row:
    """One measured value. `ratio` is ours divided by the peer's, `met` whether the target is reached; a peer that is
    not installed, or takes too long, has no value and a note.
    """

    section: str
    case: str
    peer: str
    value: float | None
    unit: str
    ratio: float | None = None
    target: str = ""
    met: bool | None = None
    note: str = ""

    @property
    def version(self) -> str:
        """The version of the peer, empty where it has none."""
        return version_of(self.peer)

    def data(self) -> dict[str, object]:
        """The row as data."""
        return asdict(self) | {"key": f"{self.section}: {self.case}: {self.peer}", "version": self.version}


Section = Callable[["Options"], Iterator[Row]]


@dataclass(frozen=True)
class Options:
    """How much is measured: processor seconds that a single case may take, a folder of curves, all fonts or a sample,
    and how many curves the sample of each kind has.
    """

    limit: int = 60
    curves: str = ""
    full: bool = False


def version_of(peer: str) -> str:
    """The version of a peer's package.

    >>> version_of("Fraction"), version_of("nobody")
    ('', '')
    """
    names = (PEERS.get(peer, ("", ""))[0], "cadquery-ocp" if peer == "Open CASCADE" else "")
    for name in filter(None, names):
        try:
            return version(name)
        except PackageNotFoundError:
            continue
    return ""


def installed(peer: str) -> bool:
    """Whether a peer can be imported."""
    return find_spec(PEERS[peer][1]) is not None


def missing(section: str, case: str, peer: str) -> Row:
    """The row of a peer that is not installed."""
    return Row(section, case, peer, None, "", note="not installed")


#: The call that is timed, and the call that makes its argument, which is not timed.
Timed = tuple[Callable[[object], object], Callable[[], object]]


def best(timed: Mapping[str, Timed]) -> dict[str, float]:
    """The least processor time of a call of each, in milliseconds: in turns, so that the load of the machine affects
    all alike, and without garbage collection.

    >>> took = best({"a": (lambda x: sum(range(1000)), lambda: None), "b": (lambda x: sum(range(9000)), lambda: None)})
    >>> took["a"] < took["b"]
    True
    """
    counts = dict.fromkeys(timed, 1)
    found: dict[str, float] = {}
    for who, (call, prepare) in timed.items():
        while (took := _round(call, prepare, counts[who])) * 1000 < ROUND and counts[who] < 10_000:
            counts[who] *= 4 if took * 4000 < ROUND else 2
    for _ in range(ROUNDS):
        for who, (call, prepare) in timed.items():
            took = 1000 * _round(call, prepare, counts[who]) / counts[who]
            found[who] = min(found.get(who, took), took)
            if took > 1000 * ROUND and len(found) == len(timed):
                return found
    return found


def _round(call: Callable[[object], object], prepare: Callable[[], object], count: int) -> float:
    arguments = [prepare() for _ in range(count)]
    enabled = gc.isenabled()
    gc.disable()
    try:
        start = process_time()
        for argument in arguments:
            call(argument)
        return process_time() - start
    finally:
        if enabled:
            gc.enable()


def compared(
    section: str, case: str, took: Mapping[str, float], targets: Mapping[str, Fraction], unit: str = "ms"
) -> Iterator[Row]:
    """The rows of one case: ours, and each peer with the ratio of ours to it and the target, the most it may be."""
    for who, value in took.items():
        ratio = None if who == OURS else took[OURS] / value
        limit = targets.get(who)
        told = "" if limit is None else f"≤ {limit} of it" if limit >= 1 else f"≤ {limit}"
        met = None if limit is None or ratio is None else ratio <= limit
        yield Row(section, case, who, value, unit, ratio, told, met)


def bounded(
    section: str, case: str, value: float | None, unit: str, most: Fraction | int, note: str = "", peer: str = OURS
) -> Row:
    """A row whose value must not be above a target; none at all is above it."""
    told = f"≤ {most if isinstance(most, int) or most.denominator == 1 else f'{most.numerator / most.denominator:g}'}"
    return Row(section, case, peer, value, unit, None, f"{told} {unit}", value is not None and value <= most, note)
