"""STEP part 21 text: instances ``#12 = NAME(…);`` and ``#12 = (NAME(…) NAME(…));``, parsed on demand."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NoReturn

from exactspline.errors import CurveFileError, counted
from exactspline.extras.cad import NAMES
from exactspline.interchange.collector import Collector
from exactspline.interchange.numbers import Nested, NumberText, decimal, nested, with_point
from exactspline.interchange.records import LARGER, Limits
from exactspline.numbers.exact import mpq

#: A value: the text of a number, a reference, an enumeration value or a string (with its quotes), or a list of values.
Value = Nested

# anything unclosed extends to the end of the text, so that matching takes linear time
_NOISE = re.compile(r"/\*.*?(?:\*/|\Z)|'(?:[^']|'')*(?:'|\Z)|;", re.S)
_INSTANCE = re.compile(r"\s*#\s*(\d{1,12})\s*=\s*(.*)", re.S)
_TOKEN = re.compile(r"'(?:[^']|'')*(?:'|\Z)|[(),]|[^\s(),']+", re.S)
_REFERENCE = re.compile(r"#\d{1,12}", re.ASCII)
_KEYWORD = re.compile(r"[A-Z_][A-Z0-9_]*", re.ASCII)
_FIRST = re.compile(r"(?P<complex>\()|\s*(?P<keyword>[A-Z0-9_]+)", re.ASCII)
_BEGUN = re.compile(r"\s*(#\d+)\s*=", re.ASCII)
#: The last statement of a file.
END = "END-ISO-10303-21"
_STRING = re.compile(r"'(?:[^']|'')*(?:'|\Z)", re.S)
_CALLED = re.compile(r"([A-Z0-9_]+)\s*\(", re.ASCII)


def _instances(text: str, collector: Collector) -> dict[int, str]:
    """The text of every instance in the data sections, by instance number. The collector gets an error for a file that
    is cut off, and for an instance that is defined twice.
    """
    texts: dict[int, str] = {}
    statement, end = "", 0
    for statement, behind in _statements(text):
        end = behind
        match = _INSTANCE.match(statement)
        if match:
            if int(match[1]) in texts:
                collector.skip("instance", f"#{match[1]}", "it is defined twice: the last one is read; remove one")
            texts[int(match[1])] = match[2]
            if len(texts) > collector.limits.objects:
                raise CurveFileError(f"over {collector.limits.objects} instances", remedy=LARGER)
    if rest := _BEGUN.match(text, end):
        collector.skip("instance", rest[1], "the file ends in it; complete the file")
    if END not in statement:
        collector.note(f"{END} is missing: the file may be cut off")
    return texts


def _statements(text: str) -> Iterator[tuple[str, int]]:
    """Each statement with the position after it."""
    begin = 0
    pieces: list[str] = []
    for match in _NOISE.finditer(text):
        if match[0] == ";":
            yield "".join([*pieces, text[begin : match.start()]]), match.end()
            begin, pieces = match.end(), []
        elif match[0][0] == "/":
            pieces.append(text[begin : match.start()] + " ")
            begin = match.end()


def keywords(text: str) -> list[str]:
    """The keywords of an instance, without reading its arguments: one keyword, or those of a complex instance, then
    those of typed values; empty for a text that is not an instance.

    >>> keywords("LINE('A(',#1)"), keywords("(A(1.) B((#2),'C()'))")
    (['LINE'], ['A', 'B'])
    """
    first = _FIRST.match(text)
    if first is None:
        return []
    return _CALLED.findall(_STRING.sub("", text)) if first["complex"] else [first["keyword"]]


def _refuse() -> NoReturn:
    raise CurveFileError("one closing bracket too many", remedy="balance the brackets")


def parts(text: str, limits: Limits) -> dict[str, list[Value]]:
    """The arguments of an instance by keyword; a complex instance has several keywords.

    >>> parts("(A(1.,$) B((#2,#3)))", Limits())
    {'A': ['1.', '$'], 'B': [['#2', '#3']]}
    """
    root = nested((token for token in _TOKEN.findall(text) if token != ","), "()", limits, _refuse)
    if len(root) == 1 and isinstance(root[0], list):
        root = root[0]
    by_keyword: dict[str, list[Value]] = {}
    for keyword, arguments in zip(root[::2], root[1::2], strict=False):
        if not isinstance(keyword, str) or not isinstance(arguments, list) or not _KEYWORD.fullmatch(keyword):
            raise CurveFileError("not a list of keywords with arguments", remedy="write NAME(…)")
        by_keyword[keyword] = arguments
    return by_keyword


class StepFile:
    """The instances of a file, parsed when they are looked up."""

    def __init__(self, text: str, collector: Collector) -> None:
        self.collector, self.limits = collector, collector.limits
        self.instances = _instances(text, collector)
        self.points: dict[str, list[mpq]] = {}

    def point(self, reference: Value) -> list[mpq]:
        """The coordinates of a CARTESIAN_POINT."""
        key = str(reference)
        if key not in self.points:
            self.points[key] = self.numbers(self.named(reference, "CARTESIAN_POINT", 2)[1])
        return self.points[key]

    def named(self, reference: Value, keyword: str, count: int) -> list[Value]:
        """The arguments of the referenced instance, which must have this keyword and this number of arguments."""
        if not isinstance(reference, str) or not _REFERENCE.fullmatch(reference):
            raise CurveFileError(f"not a reference to a {keyword}", remedy="references look like #12")
        arguments = parts(self.instances.get(int(reference[1:]), ""), self.limits).get(keyword, [])
        if len(arguments) != count:
            problem = f"is not a {keyword} with {counted(count, 'attribute')}"
            raise CurveFileError(problem, where=reference, remedy="refer to one")
        return arguments

    def numbers(self, values: Value) -> list[mpq]:
        """A list of decimals."""
        return [decimal(text, self.limits) for text in self.texts(values)]

    def texts(self, values: Value) -> list[str]:
        """A list of plain values."""
        if not isinstance(values, list):
            raise CurveFileError("a list is missing", remedy="write (…)")
        self.collector.count(len(values))
        return [value if isinstance(value, str) else "" for value in values]


# ---- writing


class StepText:
    """A file that is being written."""

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
    """A name as a string; characters that a string cannot hold are omitted."""
    return "'" + "".join(c for c in name if " " <= c <= "~" and c != "\\").replace("'", "''") + "'"


def name_of(arguments: list[Value], otherwise: str) -> str:
    """The name among the arguments of an instance: the first, a string."""
    text = arguments[0] if arguments and isinstance(arguments[0], str) else ""
    return text.strip("'").replace("''", "'") or otherwise
