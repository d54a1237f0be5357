"""Which properties of an SVG element style sheets may set; the values are not evaluated.

CSS overrides the attributes of an element (SVG 2, section 6.6), and `transform`, `d`, `r` and others are properties. A
selector is matched by its last compound only, and a selector with brackets or escapes matches every element. So a rule
may be taken to apply to an element to which it does not, but never the reverse.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from importlib import resources
from typing import Any

from exactspline.interchange.xml_tree import Element
from exactspline.one_line import OneLine

# ---- the names of elements, properties and units


#: The names of each kind.
NAMES: dict[str, Any] = json.loads(resources.files(__package__).joinpath("svg_names.json").read_text(encoding="utf-8"))


#: Properties that move the element they are set on; that determine the origin of a transform; that define the shape of
#: an element; and that hide an element or a part of it.
MOVING, ORIGIN, HIDING = (frozenset(NAMES[kind]) for kind in ("moving", "origin", "hiding"))
SHAPING = {tag: frozenset(properties) for tag, properties in NAMES["shaping"].items()}
ANY_PROPERTY = "all"

_COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.S)
# one part of a sheet, up to its delimiter; strings and brackets are skipped, unclosed ones extend to the end
_PART = re.compile(r"""(?:"(?:[^"\\]|\\.)*+(?:"|\Z)|'(?:[^'\\]|\\.)*+(?:'|\Z)|\\.|\([^()]*\)|[^;{}"'\\])*+""", re.S)
_STATE = re.compile(r"::?[-\w]+")
_NAME = re.compile(r"([.#]?)((?:[-\w]|[^\x00-\x7f])+|\*)")
#: At-rules whose blocks contain rules.
_GROUPS = ("@media", "@supports", "@layer", "@container", "@scope", "@document", "@starting-style")


@dataclass(frozen=True, repr=False)
class Rule(OneLine):
    """A rule: its selectors, given as tag, ids and classes of their last compounds, and the properties that it sets."""

    parts: tuple[tuple[str, frozenset[str], frozenset[str]], ...]
    properties: frozenset[str]

    def applies(self, element: Element) -> bool:
        """Whether it may apply to an element."""
        classes = frozenset(element.attributes.get("class", "").split())
        identifier = element.attributes.get("id", "")
        return any(
            tag in ("", "*", element.tag) and ids <= {identifier} and of_class <= classes
            for tag, ids, of_class in self.parts
        )


@dataclass
class Sheet:
    """The style sheets of a file.

    >>> sheet = Sheet()
    >>> sheet.add("/* a */ g > .moved:hover, #x { fill: red; transform: rotate(3deg) } @import url(more.css);")
    >>> sorted(sheet.may_set(Element("path", {"class": "moved"}, 1))), sheet.imports
    (['fill', 'transform'], True)
    """

    rules: list[Rule] = field(default_factory=list)
    imports: bool = False

    def add(self, text: str) -> None:
        """Add the rules of a style sheet."""
        waiting: list[tuple[str, ...]] = [()]
        collected: list[set[str]] = [set()]
        text, position = _COMMENT.sub(" ", text), 0
        while position < len(text):
            match = _PART.match(text, position)
            part, position = (match[0].strip(), match.end()) if match else ("", position)
            mark, position = text[position : position + 1], position + 1
            if mark == "{":
                waiting.append(_selectors(part, waiting[-1]))
                collected.append(set())
                continue
            self.imports |= part.lower().startswith("@import")
            collected[-1] |= _properties(part)
            if mark == "}" and len(waiting) > 1:
                self._close(waiting.pop(), collected.pop())
        # a block that is not closed ends with the sheet
        for selectors, properties in zip(waiting, collected, strict=True):
            self._close(selectors, properties)

    def _close(self, selectors: tuple[str, ...], properties: set[str]) -> None:
        if selectors and properties:
            self.rules.append(Rule(tuple(map(_last_part, selectors)), frozenset(properties)))

    def may_set(self, element: Element) -> frozenset[str]:
        """The properties that rules may set on an element."""
        return frozenset[str]().union(*(rule.properties for rule in self.rules if rule.applies(element)))


def _selectors(prelude: str, outer: tuple[str, ...]) -> tuple[str, ...]:
    """The selectors of a block; a group of rules nested in a rule has the selectors of that rule."""
    if prelude.startswith("@"):
        return outer if prelude.lower().startswith(_GROUPS) else ()
    return ("*",) if set(prelude) & set("([\\&") else tuple(_STATE.sub("", prelude).split(","))


def _last_part(selector: str) -> tuple[str, frozenset[str], frozenset[str]]:
    last = re.split(r"[\s>+~|]+", selector.strip())[-1]
    names = _NAME.findall(last)
    by_mark = {mark: frozenset(name for sign, name in names if sign == mark) for mark in ("", "#", ".")}
    return next(iter(by_mark[""]), ""), by_mark["#"], by_mark["."]


def _properties(declaration: str) -> set[str]:
    name, colon, _ = declaration.partition(":")
    return {_property(name)} if colon and not declaration.startswith("@") else set()


def _property(name: str) -> str:
    """The name of a property, or `ANY_PROPERTY` if it is written with escapes."""
    return ANY_PROPERTY if "\\" in name else name.strip().lower()


def declarations(text: str) -> dict[str, str]:
    """The properties that a `style` attribute sets, and their values.

    >>> declarations("fill: url(a;b); TRANSFORM : none !important;")
    {'fill': 'url(a;b)', 'transform': 'none'}
    """
    values: dict[str, str] = {}
    text, position = _COMMENT.sub(" ", text), 0
    while position < len(text):
        match = _PART.match(text, position)
        part, position = (match[0], match.end() + 1) if match else ("", position + 1)
        name, colon, value = part.partition(":")
        if colon:
            values[_property(name)] = re.sub(r"\s*!\s*important\s*\Z", "", value.strip(), flags=re.I)
    return values


def in_words(properties: Iterable[str]) -> str:
    """A list of properties as text.

    >>> in_words({"r", "d"})
    'd, r'
    """
    return ", ".join(sorted("any property" if name == ANY_PROPERTY else name for name in properties))
