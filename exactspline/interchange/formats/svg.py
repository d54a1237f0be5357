"""SVG: paths and basic shapes, one curve per subpath, in the coordinates of the outermost ``<svg>``.

Lines, quadratics and cubics are exact. Elliptic arcs are exact if the centre is rational and the axes are parallel to
the coordinate axes (or the arc is circular); any other arc is skipped and divides its subpath or, with `approximate`,
is replaced by an arc within that distance. Transforms are applied exactly, about their origin; elements under a
transform with an irrational sine, cosine or tangent are skipped. Path data with an error are read up to the error, as
the standard requires. An element that is used again (`use`) is copied to every such place. The first child of a
`switch` that requires no extension and no language is drawn. Elements that style sheets may move or reshape are
skipped; a note names those that style sheets may hide. Elements of other namespaces inside the drawing, and their
children, are not drawn. Definitions (`defs`, `marker`, …) are not drawn. svgelements and svgpathtools store floats, so
the text is parsed here.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import resources
from itertools import pairwise
from typing import Any

from exactspline.errors import ExactSplineError, NumberError, ShapeError, counted
from exactspline.interchange.collector import Collector
from exactspline.interchange.format import Format, Spline, pen_segments
from exactspline.interchange.numbers import NumberText, decimal
from exactspline.interchange.records import Limits, Reading, Source
from exactspline.interchange.segments import DEGREES, RIGHT, Affine, Segment, ellipse, mapped, polynomial, quarter_turns
from exactspline.interchange.svg_paths import Subpath, least_size, subpaths
from exactspline.interchange.xml_tree import Element, attribute, parse
from exactspline.numbers.exact import mpq, text
from exactspline.one_line import OneLine

# ---- styles
#
# CSS overrides the attributes of an element (SVG 2, section 6.6), and `transform`, `d`, `r` and others are properties.
# A selector is matched by its last compound only, and a selector with brackets or escapes matches every element. So a
# rule may be applied to more elements than it matches, but never to fewer.


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
        """Whether the rule may apply to an element."""
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


def _declarations(text: str) -> dict[str, str]:
    """The properties that a `style` attribute sets, and their values.

    >>> _declarations("fill: url(a;b); TRANSFORM : none !important;")
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


def _in_words(properties: Iterable[str]) -> str:
    """A list of properties as text.

    >>> _in_words({"r", "d"})
    'd, r'
    """
    return ", ".join(sorted("any property" if name == ANY_PROPERTY else name for name in properties))


# ---- transforms and lengths


_CALL = re.compile(r"[\s,]*([A-Za-z]+)\s*\(([^()]*)\)")


#: CSS pixels per unit of length (CSS Values and Units, absolute lengths).
UNITS = {unit: mpq(pixels) for unit, pixels in NAMES["units"].items()}
#: The remedy for a transform without rational numbers.
APPLY = "write it as matrix(…), whose decimals are read exactly, or apply it to the shape"
_SIDES = {"left": "0", "top": "0"}
_LENGTH = re.compile(r"(.*?)(px|in|cm|mm|q|pt|pc)?", re.ASCII | re.IGNORECASE | re.DOTALL)


def length(text: str, limits: Limits) -> mpq:
    """A length in user units.

    >>> length("2.5", Limits()), length("1in", Limits()), length("25.4mm", Limits())
    (mpq(5,2), mpq(96,1), mpq(96,1))

    Raises `NumberError` for anything else, such as percentages and lengths relative to a font size.
    """
    match = _LENGTH.fullmatch(text.strip())
    assert match is not None
    return decimal(match[1], limits) * UNITS[(match[2] or "px").lower()]


def about(matrix: Affine, attributes: Mapping[str, str], style: Mapping[str, str], limits: Limits) -> Affine:
    """A transform about the point that `transform-origin` names, in the coordinates of the nearest viewport.

    >>> about(transform("scale(2)", Limits()), {"transform-origin": "5 1in"}, {}, Limits())((5, 0))
    (mpq(5,1), mpq(-96,1))

    Raises `ShapeError` if the point depends on a box: that of the viewport (percentages) or of the shape.
    """
    given = style.get("transform-origin", attributes.get("transform-origin", "")).lower()
    box = style.get("transform-box", attributes.get("transform-box", "view-box")).strip().lower()
    words = [_SIDES.get(word, word) for word in given.split()]
    if not words:
        return matrix
    try:
        if box != "view-box" or not 2 <= len(words) <= 3:
            raise NumberError("a box is required")
        if "transform-origin" in style and any(word.strip("+-.0") and not word[-1].isalpha() for word in words):
            raise NumberError("CSS has no lengths without a unit")
        x, y = (length(word, limits) for word in words[:2])
    except NumberError:
        problem = f"the transform-origin {given[:40]!r} in the transform-box {box[:20]!r}"
        raise ShapeError(problem, remedy="give two lengths in the view-box") from None
    there, back = (Affine([[1, 0, sign * x], [0, 1, sign * y]]) for sign in (1, -1))
    return there @ matrix @ back


def transform(text: str, limits: Limits) -> Affine:
    """The map described by a transform attribute; the leftmost transform is applied last.

    >>> transform("translate(1) rotate(90)", Limits())((2, 0))
    (mpq(1,1), mpq(2,1))

    Raises `NumberError` for angles with an irrational sine, cosine or tangent, and `ShapeError` for text that is not a
    transform.
    """
    whole = Affine.identity(2)
    position, calls = 0, 0
    while match := _CALL.match(text, position):
        position, calls = match.end(), calls + 1
        if calls > limits.depth:
            raise ShapeError("too many transforms", remedy="combine them into one matrix")
        numbers = [decimal(word, limits) for word in re.sub(r"\s*,\s*|\s+", " ", match[2]).split()]
        whole = whole @ _one(match[1], numbers)
    if text[position:].strip(" \t\r\n,"):
        raise ShapeError(f"{text[position : position + 20]!r} is not a transform", remedy="write translate(…), …")
    return whole


def _one(name: str, n: list[mpq]) -> Affine:
    if name == "matrix" and len(n) == 6:
        return Affine([n[0::2], n[1::2]])
    if name == "translate" and len(n) in (1, 2):
        return Affine([[1, 0, n[0]], [0, 1, n[1] if n[1:] else 0]])
    if name == "scale" and len(n) in (1, 2):
        return Affine([[n[0], 0, 0], [0, n[-1], 0]])
    if name == "rotate" and len(n) in (1, 3):
        turns = quarter_turns(n[0], DEGREES)
        if turns is None:
            raise NumberError("an angle that is not a multiple of 90°", remedy=APPLY)
        cosine, sine = RIGHT[turns % 4]
        turn = Affine([[cosine, -sine, 0], [sine, cosine, 0]])
        there, back = (Affine([[1, 0, s * x], [0, 1, s * y]]) for s in (1, -1) for x, y in [n[1:] or (0, 0)])
        return there @ turn @ back
    if name in ("skewX", "skewY") and len(n) == 1:
        slope = _tangent(n[0])
        return Affine([[1, slope, 0], [0, 1, 0]] if name == "skewX" else [[1, 0, 0], [slope, 1, 0]])
    remedy = "matrix, translate, scale, rotate, skewX, skewY are read"
    raise ShapeError(f"{name[:20]} of {counted(len(n), 'number')}", remedy=remedy)


def _tangent(degrees: mpq) -> int:
    """The tangent of a multiple of 45 degrees: of rational angles in degrees, only these have a rational tangent."""
    eighths = degrees / 45
    if eighths.denominator != 1 or eighths % 4 == 2:
        raise NumberError("a skew whose tangent is not rational", remedy=APPLY)
    return (0, 1, 0, -1)[int(eighths % 4)]


DEFINITIONS, SKIPPED, SHAPES, CONTAINERS, SILENT, ANIMATIONS = (
    NAMES[kind] for kind in ("definitions", "skipped", "shapes", "containers", "silent", "animations")
)
IDENTITY = Affine.identity(2)
SVG = "http://www.w3.org/2000/svg"
FOREIGN = "not drawn: it is, or is inside, an element of another namespace than SVG"

#: The note on an arc that replaces another arc.
REPLACED = "an arc without rational control points is replaced by an arc with the same ends, within a distance of"
LOSES = "SVG stores no knots: segments are kept, their parameter intervals are not"


class _NotDrawnError(ShapeError):
    """The shape is not drawn at all, so that no curve is missing."""


@dataclass(frozen=True)
class _Place:
    """The place where an element is drawn: the map from its coordinates, the notes for all curves in it, the path by
    which it is reached, and the ids of the elements being copied.
    """

    placed: Affine = IDENTITY
    notes: tuple[str, ...] = ()
    reached: str = ""
    copies: frozenset[str] = frozenset()
    #: Whether the element is the copied element of a `use`.
    copied: bool = False
    #: Whether the element is inside an `svg`.
    inside: bool = False


def _looks_like(head: bytes) -> bool:
    """Whether an element svg begins near the start of the file."""
    return bool(re.search(rb"<(\w+:)?svg[\s>]", head))


def read(source: Source) -> Reading:
    """The curves of a file in the order of drawing."""
    collector = Collector("svg", source)
    _Drawing(collector, parse(source.data, source.limits)).draw()
    if b"<?xml-stylesheet" in source.data:
        collector.note("a style sheet in another file is not read: it may move, shape or hide curves")
    return collector.reading()


class _Drawing:
    """The traversal of the elements of a file."""

    def __init__(self, collector: Collector, root: Element) -> None:
        self.collector, self.root, self.sheet = collector, root, Sheet()
        # a drawing that declares no namespace is read as SVG
        self.namespaces = {SVG, next((each.namespace for each in root.walk() if each.tag == "svg"), SVG)}
        self.by_id: dict[str, Element] = {}
        for element in root.walk():
            self.by_id.setdefault(element.attributes.get("id", ""), element)
            if element.tag == "style":
                self.sheet.add(element.text)
            if element.tag in ANIMATIONS:
                collector.note("animations are not applied: curves are read in their initial state")
            if element.tag == "script":
                collector.note("scripts are not run: they may change any curve")
        if part := collector.source.part:
            collector.see_that_part_exists(self.by_id)
            self._leave_out_all_but(self.by_id[part])
        if self.sheet.imports:
            collector.note("a style sheet in another file is not read: it may move, shape or hide curves")
        if "viewBox" in root.attributes:
            collector.note("coordinates are those of the viewBox: its placement on the page is not applied")

    def _leave_out_all_but(self, part: Element) -> None:
        """Omit the elements that are neither in an element nor around it; its copies are still found."""
        for element in [*self.root.walk()]:
            towards = [child for child in element.children if any(below is part for below in child.walk())]
            element.children = towards or element.children

    def draw(self) -> None:
        """Collect the curves."""
        waiting: list[tuple[Element, _Place]] = [(self.root, _Place())]
        while waiting:
            element, place = waiting.pop()
            self.collector.count(1)
            where = f"{element.tag} at line {element.line}{place.reached}"
            try:
                below = self._entered(element, where, place)
            except _NotDrawnError as error:
                self._not_drawn(element, where, str(error))
            except ExactSplineError as error:
                self.collector.skip(element.tag, where, str(error))
            else:
                waiting += reversed(below)

    def _entered(self, element: Element, where: str, place: _Place) -> list[tuple[Element, _Place]]:
        """Collect the curves of an element; return the elements drawn inside it, each with its place."""
        tag = element.tag
        if place.inside and element.namespace not in self.namespaces:
            self._not_drawn(element, where, FOREIGN)
            return []
        if tag in SILENT or tag in ANIMATIONS:
            return []
        if tag in DEFINITIONS and not (tag == "symbol" and place.copied):
            self._not_drawn(element, where, f"not drawn: inside {tag}")
            return []
        if tag in SKIPPED:
            self.collector.skip(tag, where, SKIPPED[tag], curve=False)
            return []
        if why := _condition(element):
            raise _NotDrawnError(why)
        place = replace(self._placed(element, place), inside=place.inside or tag == "svg")
        if tag in SHAPES:
            _shape(self.collector, element, where, place)
            return []
        if tag == "use":
            return [self._copied(element, place)]
        if tag not in CONTAINERS:
            place = replace(place, notes=(*place.notes, f"inside <{tag[:40]}>, which SVG does not define"))
        return [(child, place) for child in (self._chosen(element) if tag == "switch" else element.children)]

    def _not_drawn(self, element: Element, where: str, why: str) -> None:
        """Record the shapes of an element that is not drawn."""
        for below in element.walk():
            if below.tag in (*SHAPES, "use"):
                place = where if below is element else f"{below.tag} at line {below.line}"
                self.collector.skip(below.tag, place, why, curve=False)

    def _chosen(self, switch: Element) -> list[Element]:
        """The first child of a `switch` that can be drawn, in a list; empty if there is none."""
        children = [each for each in switch.children if each.tag not in SILENT and each.namespace in self.namespaces]
        chosen = next((child for child in children if not _condition(child)), None)
        for child in children:
            if child is not chosen:
                why = _condition(child) or "not drawn: an earlier child of the switch is drawn"
                self._not_drawn(child, f"{child.tag} at line {child.line}", why)
        return [] if chosen is None else [chosen]

    def _placed(self, element: Element, place: _Place) -> _Place:
        """The place where the content of an element is drawn."""
        style, sheet = _declarations(element.attributes.get("style", "")), self.sheet.may_set(element)
        is_root = element is self.root
        if element.tag == "svg" and not is_root and {"x", "y", "viewBox"} & element.attributes.keys():
            raise ShapeError("an inner svg with a viewBox", remedy="flatten the drawing")
        if element.tag == "symbol" and {"x", "y", "viewBox", "refX", "refY"} & element.attributes.keys():
            raise ShapeError("a symbol with a viewBox", remedy="flatten the drawing")
        if is_root:
            # size and position of the outermost svg describe the page
            if element.attributes.get("transform", "").strip() or MOVING & {*style, *sheet}:
                self.collector.note("the outermost svg is moved on the page: not applied")
            return replace(place, notes=self._hidden(element, style, sheet))
        if given := (SHAPING.get(element.tag, frozenset()) | {"all"}) & {*style, *sheet}:
            raise ShapeError(f"CSS sets {_in_words(given)}", remedy="write attributes")
        moving = {name for name in MOVING & style.keys() if style[name].lower() != "none"} | MOVING & sheet
        if moving or ORIGIN & sheet:
            raise ShapeError(f"a transform in CSS ({_in_words(moving | ORIGIN & sheet)})", remedy="write an attribute")
        local = IDENTITY
        if "transform" not in style:
            local = transform(element.attributes.get("transform", ""), self.collector.limits)
        if not local.is_identity:
            local = about(local, element.attributes, style, self.collector.limits)
        clips = element.tag in ("svg", "symbol") and ({"width", "height"} & element.attributes.keys())
        cut = ("an inner svg may show only a part of it",) if clips else ()
        notes = tuple(dict.fromkeys((*place.notes, *self._hidden(element, style, sheet), *cut)))
        return replace(place, placed=place.placed @ local, notes=notes, copied=False)

    def _hidden(self, element: Element, style: dict[str, str], sheet: frozenset[str]) -> tuple[str, ...]:
        """Notes on curves that are, or may be, partly or fully hidden; raises `_NotDrawnError` if nothing is drawn."""
        given = {name: element.attributes[name] for name in NAMES["hiding"] if name in element.attributes}
        given |= {name: style[name] for name in NAMES["hiding"] if name in style}
        given = {name: value.strip() for name, value in given.items()}
        may = sheet & HIDING
        if given.get("display") == "none" and not may:
            raise _NotDrawnError("not drawn: display is none")
        remarks = [
            f"{name} is {value[:40]}, on it or an element around it: the whole curve is read"
            for name, value in given.items()
            if value not in ("", "none", "visible", "inline", "block", "auto", "inherit")
        ]
        remarks += [f"a style sheet may hide it ({_in_words(may)})"] if may else []
        return tuple(remarks)

    def _copied(self, use: Element, place: _Place) -> tuple[Element, _Place]:
        """The element that a `use` copies, and its place; its x and y are a translation inside its transform."""
        links = [value for key, value in use.attributes.items() if key.rpartition(":")[2] == "href"]
        # the attribute without a prefix takes precedence
        link = use.attributes.get("href", links[0] if links else "").strip()
        if not link.startswith("#"):
            what = "an element of another file" if link else "nothing"
            raise ShapeError(f"a copy of {what}", remedy="write the element here")
        target = self.by_id.get(link[1:])
        if target is None or not link[1:]:
            raise ShapeError(f"a copy of {link[:40]!r}, which is not in the file", remedy="correct the link")
        if link in place.copies or len(place.copies) >= self.collector.limits.depth:
            raise ShapeError("a copy of itself", remedy="correct the link")
        if target.tag == "svg":
            raise ShapeError("a copy of an svg with a viewBox", remedy="flatten the drawing")
        shift = [length(use.attributes.get(axis, "0"), self.collector.limits) for axis in "xy"]
        moved = place.placed @ Affine([[1, 0, shift[0]], [0, 1, shift[1]]])
        reached, copies = f"{place.reached}, copied at line {use.line}", place.copies | {link}
        return target, _Place(moved, place.notes, reached, copies, copied=True)


def _condition(element: Element) -> str:
    """The reason why a reader that supports no extension and prefers no language does not draw an element; "" if it
    does.
    """
    if "requiredExtensions" in element.attributes:
        return "not drawn: it requires an extension"
    if "systemLanguage" in element.attributes:
        return f"not drawn: it is for the language {element.attributes['systemLanguage'][:40]!r}"
    return ""


def _shape(collector: Collector, element: Element, where: str, place: _Place) -> None:
    name = element.attributes.get("id") or f"{element.tag} {element.line}"
    notes = list(place.notes)
    if element.tag == "path":
        data = element.attributes.get("d", "")
        collector.room(least_size(data))
        within = collector.source.within
        parsed, problem = subpaths(data, collector.limits, within and within / max(place.placed.stretch, mpq(1)))
        if not parsed:
            raise ShapeError(problem, remedy="correct the path data") if problem else _NotDrawnError("no segments")
        notes += [f"{problem}: read up to there"] if problem else []
    else:
        segments, remarks = _basic(collector, element)
        parsed, notes = [Subpath(segments)], notes + remarks
    several = len(parsed) > 1
    for i, part in enumerate(parsed, 1):
        at = f"{where}, subpath {i}" if several else where
        if part.problem:
            collector.skip("subpath", at, part.problem)
            continue
        placed = mapped(part.segments, place.placed)
        own = f"{name}.{i}" if several else name
        collector.add_segments(element.tag, at, placed, own, [*notes, *_of_arcs(part, collector.source.within)])


def _of_arcs(part: Subpath, within: mpq | None) -> list[str]:
    """Notes on arcs that have no exact representation."""
    divided = ["a part of a subpath: an arc next to it is left out"] if part.divided else []
    return divided + ([f"{REPLACED} {text(within)}"] if part.approximated and within is not None else [])


def _basic(collector: Collector, element: Element) -> tuple[list[Segment], list[str]]:
    """The segments of a basic shape, in the order in which the standard draws them, and notes on them."""

    def size(key: str) -> mpq:
        return length(element.attributes.get(key, "0"), collector.limits)

    notes: list[str] = []
    if element.tag == "line":
        return [polynomial((size("x1"), size("y1")), (size("x2"), size("y2")))], notes
    if element.tag in ("circle", "ellipse"):
        return _round(element, size), notes
    if element.tag == "rect":
        radii = [element.attributes[key].strip() for key in ("rx", "ry") if key in element.attributes]
        if any(radius != "auto" and length(radius, collector.limits) for radius in radii):
            raise ShapeError("a rectangle with round corners", remedy="write it as a path")
        x, y, width, height = (size(key) for key in ("x", "y", "width", "height"))
        if width <= 0 or height <= 0:
            raise _NotDrawnError("no width or no height", remedy="nothing is drawn")
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
    else:
        texts = element.attributes.get("points", "").replace(",", " ").split()
        collector.room(len(texts))
        numbers = [decimal(text, collector.limits) for text in texts]
        corners = list(zip(numbers[::2], numbers[1::2], strict=False))
        notes += ["an odd number of coordinates: the last one is dropped"] if len(numbers) % 2 else []
        corners += corners[:1] if element.tag == "polygon" and corners[:1] != corners[-1:] else []
    if len(corners) < 2:
        raise _NotDrawnError("fewer than two points", remedy="nothing is drawn")
    return [polynomial(a, b) for a, b in pairwise(corners)], notes


def _round(element: Element, size: Callable[[str], mpq]) -> list[Segment]:
    """A full circle or ellipse; a missing radius equals the other one."""
    given = ["r"] if element.tag == "circle" else [
        key for key in ("rx", "ry") if element.attributes.get(key, "auto").strip() != "auto"
    ]  # fmt: skip
    rx, ry = (size(given[0]), size(given[-1])) if given else (mpq(0), mpq(0))
    if rx <= 0 or ry <= 0:
        raise _NotDrawnError("no radius is positive", remedy="nothing is drawn")
    return ellipse(Affine([[rx, 0, size("cx")], [0, ry, size("cy")]]))


def write(splines: Sequence[Spline], numbers: NumberText) -> bytes:
    """Polynomial plane curves of degree 1 to 3 as paths. SVG stores no knots: the segments are kept, their parameter
    intervals are not.
    """
    paths = []
    for spline in splines:
        segments = pen_segments(spline.curve)
        letter = " LQC"[spline.curve.degree]
        data = [f"M{_pair(numbers, segments[0][0])}"]
        data += [letter + " ".join(_pair(numbers, point) for point in points[1:]) for points in segments]
        paths.append(f'<path id={attribute(spline.name)} d="{" ".join(data)}" fill="none" stroke="black"/>')
    return "\n".join(['<svg xmlns="http://www.w3.org/2000/svg">', *paths, "</svg>", ""]).encode()


def _pair(numbers: NumberText, point: Sequence[mpq]) -> str:
    return ",".join(map(numbers, point))


FORMAT = Format("svg", "SVG paths and shapes", (".svg",), _looks_like, read, write, LOSES, parts=True)
