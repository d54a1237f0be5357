"""XML read as a small tree: no entity is declared or expanded, nothing is fetched, depth and size are bounded."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from exactspline.errors import CurveFileError
from exactspline.interchange.limits import Limits

#: Characters that XML 1.0 leaves out, escaped or not (section 2.2).
NOT_IN_XML = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")


@dataclass
class Element:
    """An element: its name without a namespace prefix, its attributes, its children, its text, the line it begins."""

    tag: str
    attributes: dict[str, str]
    line: int
    children: list[Element] = field(default_factory=list)
    text: str = ""

    def walk(self) -> Iterator[Element]:
        """This element and all below it, in their order."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting += reversed(element.children)

    def first(self, tag: str) -> Element | None:
        """The first child with this name."""
        return next((child for child in self.children if child.tag == tag), None)


def parse(data: bytes, limits: Limits) -> Element:
    """The root element.

    >>> parse(b"<a><b c='1'>x</b></a>", Limits()).children[0].attributes
    {'c': '1'}
    >>> parse(b'<!DOCTYPE a [<!ENTITY x "y">]><a>&x;</a>', Limits())
    Traceback (most recent call last):
    exactspline.errors.CurveFileError: line 1: declares the entity 'x'; entities are not expanded: write the text itself

    Raises `CurveFileError` for what is not well formed, declares entities, or is beyond the limits.
    """
    parser = expat.ParserCreate()
    parser.buffer_text = True
    open_elements: list[Element] = []
    texts: list[list[str]] = []
    roots: list[Element] = []
    counted = 0

    def start(name: str, attributes: dict[str, str]) -> None:
        nonlocal counted
        counted += 1 + len(attributes)
        if counted > limits.objects or len(open_elements) >= limits.depth:
            raise CurveFileError(
                "is nested too deep or has too many elements",
                where=f"line {parser.CurrentLineNumber}",
                remedy="read with larger limits",
            )
        element = Element(name.rpartition(":")[2], attributes, parser.CurrentLineNumber)
        (open_elements[-1].children if open_elements else roots).append(element)
        open_elements.append(element)
        texts.append([])

    def end(_: str) -> None:
        open_elements.pop().text = "".join(texts.pop())

    def characters(data: str) -> None:
        texts[-1].append(data)

    def entity(name: str, *_: object) -> None:
        raise CurveFileError(
            f"declares the entity {name[:40]!r}",
            where=f"line {parser.CurrentLineNumber}",
            remedy="entities are not expanded: write the text itself",
        )

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler, parser.EntityDeclHandler = characters, entity
    try:
        parser.Parse(data, True)
    except (expat.ExpatError, LookupError, ValueError) as error:
        if isinstance(error, CurveFileError):
            raise
        raise CurveFileError(f"is not well-formed XML ({error})", remedy="correct the text there") from None
    return roots[0]


def attribute(value: str) -> str:
    """A value as a quoted attribute, without the characters that no XML file can hold.

    >>> attribute("a < b\\x1b")
    '"a &lt; b"'
    """
    from xml.sax.saxutils import quoteattr  # the network modules come with it

    return quoteattr(NOT_IN_XML.sub("", value))
