"""A row of the table: what was measured, for which library, and the target."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass
from fractions import Fraction
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from time import process_time

#: The name of this library in the column of peers.
OURS = "exactspline"
#: A timing round lasts at least this many milliseconds, and the best of this many rounds counts.
ROUND, ROUNDS = 20, 5
#: Peer → the distribution whose version is shown, and the module that must be importable.
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
    "kurbopy": ("kurbopy", "kurbopy"),
    "fontTools": ("fonttools", "fontTools"),
    "dask": ("distributed", "distributed"),
    "numpy": ("numpy", "numpy"),
    "matplotlib": ("matplotlib", "matplotlib"),
}


@dataclass(frozen=True)
class Row:
    """One measured value. `ratio` is our value divided by the peer's, `met` whether the target is met; a peer that is
    not installed, or takes too long, has a note instead of a value.
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
        """The version of the peer, empty where there is none."""
        return version_of(self.peer)

    def data(self) -> dict[str, object]:
        """The row as data."""
        return asdict(self) | {"key": f"{self.section}: {self.case}: {self.peer}", "version": self.version}


Section = Callable[["Options"], Iterator[Row]]


@dataclass(frozen=True)
class Options:
    """How much is measured: processor seconds that a single case may take, a folder of curves, all fonts or a sample,
    and the size of the sample of curves of each kind.
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
    """The smallest processor time of a call of each, in milliseconds: measured in turns, so that the load of the
    machine affects all equally, and with the garbage collector on, as users have it.

    >>> took = best({"a": (lambda x: sum(range(1000)), lambda: None), "b": (lambda x: sum(range(9000)), lambda: None)})
    >>> took["a"] < took["b"]
    True
    """
    # what this process holds already is traversed by no collection from here on: it is nobody's time
    gc.collect()
    gc.freeze()
    counts = dict.fromkeys(timed, 1)
    fastest: dict[str, float] = {}
    for who, (call, prepare) in timed.items():
        while (took := _round(call, prepare, counts[who])) * 1000 < ROUND and counts[who] < 10_000:
            counts[who] *= 4 if took * 4000 < ROUND else 2
    for _ in range(ROUNDS):
        for who, (call, prepare) in timed.items():
            took = 1000 * _round(call, prepare, counts[who]) / counts[who]
            fastest[who] = min(fastest.get(who, took), took)
            if took > 1000 * ROUND and len(fastest) == len(timed):
                return fastest
    return fastest


def _round(call: Callable[[object], object], prepare: Callable[[], object], count: int) -> float:
    arguments = [prepare() for _ in range(count)]
    gc.collect()
    start = process_time()
    for argument in arguments:
        call(argument)
    return process_time() - start


def compared(
    section: str, case: str, took: Mapping[str, float], targets: Mapping[str, Fraction], unit: str = "ms"
) -> Iterator[Row]:
    """The rows of one case: ours, and one per peer with the ratio of our time to its time and the largest allowed
    ratio.
    """
    for who, value in took.items():
        ratio = None if who == OURS else took[OURS] / value
        limit = targets.get(who)
        target = "" if limit is None else f"≤ {limit} of it" if limit >= 1 else f"≤ {limit}"
        met = None if limit is None or ratio is None else ratio <= limit
        yield Row(section, case, who, value, unit, ratio, target, met)


def bounded(
    section: str, case: str, value: float | None, unit: str, most: Fraction | int, note: str = "", peer: str = OURS
) -> Row:
    """A row whose value must not exceed a target; a missing value does not meet it."""
    target = f"≤ {most if isinstance(most, int) or most.denominator == 1 else f'{most.numerator / most.denominator:g}'}"
    return Row(section, case, peer, value, unit, None, f"{target} {unit}", value is not None and value <= most, note)
