"""All sections, the table, and the picture."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from exactspline.display.sheet import Sheet
from exactspline.errors import FormulaError, nearest
from workshop.bench.features import feature_rows, linear_rows
from workshop.bench.forms import form_rows, growth_rows
from workshop.bench.measures import measure_rows
from workshop.bench.memory import memory_rows
from workshop.bench.pairs import pair_rows
from workshop.bench.roots import root_rows
from workshop.bench.row import OURS, Options, Row, Section
from workshop.bench.splines import spline_rows
from workshop.bench.sweeps import sweep_rows
from workshop.bench.whole import command_rows

#: The sections in the order of the table.
SECTIONS: dict[str, Section] = {
    "features": feature_rows,
    "pairs": pair_rows,
    "forms": form_rows,
    "roots": root_rows,
    "splines": spline_rows,
    "measures": measure_rows,
    "growth": growth_rows,
    "linear": linear_rows,
    "commands": command_rows,
    "sweep": sweep_rows,
    "memory": memory_rows,
}


def chosen_sections(names: Iterable[str]) -> tuple[str, ...]:
    """The requested sections, in the order of the table; all of them if none is named. Raises `FormulaError`."""
    requested = set(names)
    for name in requested:
        if name not in SECTIONS:
            raise FormulaError(f"there is no section of the benchmarks called {name!r}", remedy=nearest(name, SECTIONS))
    return tuple(name for name in SECTIONS if not requested or name in requested)


def rows(sections: Iterable[str], options: Options) -> Iterator[Row]:
    """The rows of these sections, one by one as they are measured; a section that fails ends with the reason."""
    for name in sections:
        try:
            yield from SECTIONS[name](options)
        # a failure here or in another library must not lose an hour of measurements
        except Exception as error:
            yield Row(
                name, "the rest of the section", OURS, None, "", met=False, note=f"{type(error).__name__}: {error}"
            )


def sheet(given: Iterable[Row]) -> Sheet:
    """The table: one row per measured value; a ratio is ours divided by the peer's."""
    columns = ("case", "who", "version", "value", "ours / theirs", "target", "met", "remark")
    made = Sheet(*columns, numbers=("value", "ours / theirs"), prose=("case", "remark"), heads=2)
    for row in given:
        value = "–" if row.value is None else f"{_short(row.value)} {row.unit}"
        ratio = "" if row.ratio is None else _short(row.ratio)
        met = "" if row.met is None else "yes" if row.met else "no"
        made.add_row(row.case, row.peer, row.version, value, ratio, row.target, met, row.note)
    return made


def _short(number: float) -> str:
    """Three significant digits, without an exponent."""
    if number == int(number) and abs(number) < 10**6:
        return str(int(number))
    digits = max(0, 2 - _order(abs(number)))
    return f"{number:,.{digits}f}".replace(",", " ")


def _order(number: float) -> int:
    """The power of ten of the first digit.

    >>> _order(20), _order(1 / 30)
    (1, -2)
    """
    return int(f"{number:e}".partition("e")[2])
