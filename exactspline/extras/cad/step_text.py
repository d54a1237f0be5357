"""STEP part 21 files as they are written: header, units, and a part for each shape."""

from __future__ import annotations

from collections.abc import Sequence

from exactspline.extras.cad.names import NAMES
from exactspline.extras.cad.step_records import Value
from exactspline.interchange.numbers import NumberText, with_point
from exactspline.numbers.exact import mpq


class StepText:
    """A file in the making."""

    def __init__(self, numbers: NumberText) -> None:
        self.numbers = numbers
        self._lines: list[str] = []
        self._units = ",".join([self.add(f"({unit})") for unit in NAMES["step units"]])

    def add(self, text: str) -> str:
        """Add an instance; returns the reference to it."""
        self._lines.append(f"#{len(self._lines) + 1}={text};")
        return f"#{len(self._lines)}"

    def point(self, coordinates: Sequence[mpq]) -> str:
        """Add a point."""
        return self.add(f"CARTESIAN_POINT('',{self.reals(coordinates)})")

    def reals(self, values: Sequence[mpq]) -> str:
        """A list of reals."""
        return f"({','.join(with_point(self.numbers(value)) for value in values)})"

    def add_set(self, kind: str, representation: str, items: Sequence[str], dimension: int) -> None:
        """Add a set of curves or surfaces as the shape of a part: other programs show only shapes that belong to a
        part.
        """
        collected = self.add(f"{kind}('',({','.join(items)}))")
        context = self.add(
            f"(GEOMETRIC_REPRESENTATION_CONTEXT({dimension}) GLOBAL_UNIT_ASSIGNED_CONTEXT(({self._units})) "
            "REPRESENTATION_CONTEXT('',''))"
        )
        shape, made = self.add(f"{representation}('',({collected}),{context})"), list[str]()
        for text in NAMES["step part"]:
            made.append(self.add(text.format(*made, shape=shape)))

    def encoded(self) -> bytes:
        """The whole file."""
        return "\n".join([*NAMES["step header"], *self._lines, "ENDSEC;", "END-ISO-10303-21;", ""]).encode()


def string(name: str) -> str:
    """A name as a string; characters that a string cannot hold are left out."""
    return "'" + "".join(c for c in name if " " <= c <= "~" and c != "\\").replace("'", "''") + "'"


def name_of(arguments: list[Value], otherwise: str) -> str:
    """The name among the arguments of an instance: the first, a string."""
    text = arguments[0] if arguments and isinstance(arguments[0], str) else ""
    return text.strip("'").replace("''", "'") or otherwise
