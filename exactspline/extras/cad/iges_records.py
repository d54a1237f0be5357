"""The records of an IGES file: lines of 80 columns, directory entries, and parameters in free format with Hollerith
strings.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from exactspline.errors import CurveFileError
from exactspline.extras.cad.names import NAMES
from exactspline.interchange.numbers import whole
from exactspline.interchange.records import Limits


@dataclass
class DirectoryEntry:
    """A directory entry: its number (odd), type, form, matrix (the number of its entry, or 0), use flag, whether it is
    blanked, its label, and its parameters as text.
    """

    number: int
    kind: int
    form: int
    matrix: int
    use: str
    blanked: bool
    label: str
    parameters: list[str]

    @property
    def place(self) -> str:
        """The type, and the number."""
        return f"entity {self.kind} (DE {self.number})"

    @property
    def name(self) -> str:
        """The label, or the type, and the number."""
        return f"{self.label or self.kind} {self.number}"


def _sections(text: str) -> dict[str, list[str]]:
    """The lines of each section by its letter; raises `CurveFileError` for letters other than S, G, D, P, T."""
    by_letter: dict[str, list[str]] = {letter: [] for letter in "SGDPT"}
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip():
            continue
        letter = line[72:73]
        if letter in ("B", "C"):
            raise CurveFileError("is binary or compressed IGES", where=f"line {number}", remedy="save it as IGES text")
        if letter not in by_letter:
            raise CurveFileError(f"{letter!r} in column 73", where=f"line {number}", remedy="S, G, D, P or T is there")
        by_letter[letter].append(line)
    return by_letter


def _delimiters(lines: list[str]) -> tuple[str, str, str]:
    """The parameter delimiter and the record delimiter, from the global section, and what follows them there."""
    text = "".join(line[:72] for line in lines).lstrip()
    separator = text[2:3] if text[:2] == "1H" else ","
    rest = text[4:] if text[:2] == "1H" else text[1:]
    ending = rest[2:3] if rest[:2] == "1H" else ";"
    if not separator.strip() or not ending.strip() or separator == ending:
        raise CurveFileError("unusable delimiters", where="global section", remedy='the usual ones are "," and ";"')
    return separator, ending, rest[4:] if rest[:2] == "1H" else rest[1:]


def _parameters(text: str, separator: str, ending: str, limits: Limits) -> list[str]:
    """The parameters of a record, without blanks, and with strings as their text.

    >>> _parameters("126,3H,;a, 1.D0,;", ",", ";", Limits())
    ['126', ',;a', '1.D0', '']
    """
    values: list[str] = []
    position = 0
    plain = re.compile(f"[^{re.escape(separator + ending)}]*")
    hollerith = re.compile(r"\s*(\d{1,6})H")
    while position < len(text) and len(values) <= limits.objects:
        string = hollerith.match(text, position)
        if string:
            end = string.end() + int(string[1])
            values.append(text[string.end() : end])
            tail = plain.match(text, end)
            position = tail.end() if tail else end
        else:
            match = plain.match(text, position)
            assert match is not None
            values.append("".join(match[0].split()))
            position = match.end()
        if text[position : position + 1] == ending:
            return values
        position += 1
    raise CurveFileError("a record is not terminated", remedy=f"records end with {ending!r}")


def unit_of(text: str) -> str:
    """The unit of length given in the global section, "" if there is none."""
    separator, ending, rest = _delimiters(_sections(text)["G"])
    try:
        values = _parameters(rest, separator, ending, Limits())
    except CurveFileError:
        return ""
    # parameters 14 and 15 of the section, the first two of which are the delimiters
    flag, name = (values[i] if i < len(values) else "" for i in (11, 12))
    return name if flag == "3" else str(NAMES["iges units"].get(flag, ""))


def entries(text: str, limits: Limits) -> list[DirectoryEntry]:
    """All directory entries with their parameters."""
    lines = _sections(text)
    if len(lines["D"]) % 2:
        raise CurveFileError("an odd number of directory lines", remedy="each entry takes two lines")
    separator, ending, _ = _delimiters(lines["G"])
    blocks: dict[int, list[str]] = {}
    for line in lines["P"]:
        pointer = line[64:72].strip() or "0"
        blocks.setdefault(whole(pointer.lstrip("0") or "0"), []).append(line[:64].ljust(64))
    result = []
    for i in range(0, len(lines["D"]), 2):
        first, second = lines["D"][i].ljust(80), lines["D"][i + 1].ljust(80)
        block = "".join(blocks.get(i + 1, []))
        status = first[64:72].replace(" ", "0")
        numbers = _field(first, 0), _field(second, 4), _field(first, 6)
        values = _parameters(block, separator, ending, limits) if block else []
        result.append(DirectoryEntry(i + 1, *numbers, status[4:6], status[:2] == "01", second[56:64].strip(), values))
    return result


def _field(line: str, index: int) -> int:
    text = line[8 * index : 8 * index + 8].strip()
    return whole(text) if text else 0


def formatted(entities: list[tuple[int, int, int, str, list[str]]], title: str) -> bytes:
    """An IGES file with these entities (type, form, use flag, label, parameters)."""
    directory: list[str] = []
    data: list[str] = []
    for number, (kind, form, use, label, values) in enumerate(entities):
        pointer = 2 * number + 1
        lines = _wrapped([str(kind), *values], 64, ",", ";")
        status = f"0000{use:02}00"
        directory.append(f"{kind:8}{len(data) + 1:8}" + f"{0:8}" * 6 + status)
        directory.append(f"{kind:8}{0:8}{0:8}{len(lines):8}{form:8}" + " " * 16 + f"{label[:8]:>8}{0:8}")
        data += [f"{line:<64} {pointer:7}" for line in lines]
    settings = _wrapped(NAMES["iges settings"], 72, ",", ";")
    sheets = {"S": [title[:72]], "G": settings, "D": directory, "P": data}
    sheets["T"] = ["".join(f"{letter}{len(lines):7}" for letter, lines in sheets.items())]
    return "".join(
        f"{line:<72}{letter}{i:7}\n" for letter, lines in sheets.items() for i, line in enumerate(lines, 1)
    ).encode("ascii", "replace")


def _wrapped(values: list[str], width: int, separator: str, ending: str) -> list[str]:
    lines = [""]
    for i, value in enumerate(values):
        piece = value + (ending if i == len(values) - 1 else separator)
        if len(lines[-1]) + len(piece) > width:
            lines.append("")
        lines[-1] += piece
    return lines
