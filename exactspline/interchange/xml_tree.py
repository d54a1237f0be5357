"""XML read as a small tree: nothing is fetched, and depth and size are limited. The only entities expanded are those
that the file itself declares as text without further entities, and only while the text stays within the limits.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from exactspline.errors import CurveFileError
from exactspline.interchange.records import LARGER, Limits

#: Characters that XML 1.0 does not allow, escaped or not (section 2.2).
NOT_IN_XML = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]")

#: The entities predefined by XML.
PREDEFINED = frozenset(("lt", "gt", "amp", "apos", "quot"))
_REFERENCE = re.compile(r"&([^\s#&;<>'\"]{1,200});")
_NOT_MARKUP = re.compile(r"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:\]\]>|\Z)|<\?.*?(?:\?>|\Z)", re.S)


@dataclass
class Element:
    """An element: its name without a namespace prefix, attributes, children, text, the line where it begins, and its
    namespace ("" for none; the prefix itself where it is not declared).
    """

    tag: str
    attributes: dict[str, str]
    line: int
    children: list[Element] = field(default_factory=list)
    text: str = ""
    namespace: str = ""

    def walk(self) -> Iterator[Element]:
        """This element and all its descendants, in document order."""
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
    >>> parse(b'<!DOCTYPE a [<!ENTITY x "y">]><a>&x;</a>', Limits()).text
    'y'
    >>> parse(b'<!DOCTYPE a [<!ENTITY x SYSTEM "y.txt">]><a>&x;</a>', Limits())
    Traceback (most recent call last):
    exactspline.errors.CurveFileError: line 1: the entity 'x' refers to another file; write the text itself

    Raises `CurveFileError` if the text is not well formed or exceeds the limits, and for entities that are in other
    files, nested, not declared, or too long.
    """
    parser = expat.ParserCreate()
    entities = _Entities(parser, data, limits)
    parser.buffer_text = True
    open_elements: list[Element] = []
    texts: list[list[str]] = []
    declared: list[dict[str, str]] = [{}]
    roots: list[Element] = []
    counted = 0

    def start(name: str, attributes: dict[str, str]) -> None:
        nonlocal counted
        counted += 1 + len(attributes)
        if counted > limits.objects or len(open_elements) >= limits.depth:
            place, problem = f"line {parser.CurrentLineNumber}", "is nested too deeply or has too many elements"
            raise CurveFileError(problem, where=place, remedy=LARGER)
        own = {key.partition(":")[2]: value for key, value in attributes.items() if key.split(":")[0] == "xmlns"}
        declared.append({**declared[-1], **own} if own else declared[-1])
        prefix, _, tag = name.rpartition(":")
        namespace = declared[-1].get(prefix, prefix)
        element = Element(tag, attributes, parser.CurrentLineNumber, namespace=namespace)
        (open_elements[-1].children if open_elements else roots).append(element)
        open_elements.append(element)
        texts.append([])

    def end(_: str) -> None:
        open_elements.pop().text = "".join(texts.pop())
        declared.pop()

    def characters(data: str) -> None:
        texts[-1].append(data)

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler, parser.EntityDeclHandler = characters, entities.declared
    parser.EndDoctypeDeclHandler = entities.all_known
    try:
        parser.Parse(data, True)
    except (expat.ExpatError, LookupError, ValueError) as error:
        if isinstance(error, CurveFileError):
            raise
        raise CurveFileError(f"is not well-formed XML ({error})", remedy="correct the text there") from None
    return roots[0]


class _Entities:
    """The entities that a file declares, checked before any is expanded."""

    def __init__(self, parser: expat.XMLParserType, data: bytes, limits: Limits) -> None:
        self.parser, self.data, self.limits = parser, data, limits
        self.names = set(PREDEFINED)
        self.longest = 0

    def declared(
        self,
        name: str,
        is_parameter: bool,
        value: str | None,
        _base: object,
        system: object,
        public: object,
        *_: object,
    ) -> None:
        """Check that a declaration is harmless."""
        if is_parameter:
            self._refuse(f"the parameter entity {name[:40]!r}")
        if value is None or system or public:
            self._refuse(f"the entity {name[:40]!r} refers to another file")
        elif set(_REFERENCE.findall(value)) - PREDEFINED:
            self._refuse(f"the entity {name[:40]!r} contains entities")
        self.names.add(name)
        self.longest = max(self.longest, len(value or ""))

    def all_known(self) -> None:
        """Check that every reference in the file is to a declared entity, because expat silently omits references to
        entities whose declaration it did not read. Raises `CurveFileError` otherwise, and if the expanded text would be
        too long.
        """
        wide = self.data[:2] in (b"\xff\xfe", b"\xfe\xff")
        text = self.data.decode("utf-16" if wide else "utf-8", "replace")
        references = _REFERENCE.findall(_NOT_MARKUP.sub("", text))
        if unknown := [name for name in references if name not in self.names]:
            self._refuse(f"the entity {unknown[0][:40]!r} is not declared in the file")
        if len(references) * self.longest > self.limits.megabytes << 20:
            self._refuse(f"entities of {self.longest} characters, {len(references)} times")

    def _refuse(self, problem: str) -> None:
        raise CurveFileError(problem, where=f"line {self.parser.CurrentLineNumber}", remedy="write the text itself")


def attribute(value: str) -> str:
    """A value as a quoted attribute, without the characters that are not allowed in XML.

    >>> attribute("a < b\\x1b")
    '"a &lt; b"'
    """
    from xml.sax.saxutils import quoteattr  # imported here because it loads network modules

    return quoteattr(NOT_IN_XML.sub("", value))
