"""The matrix: every question of the registry against every way to write its object otherwise. A case is a word of
changes; what the question answers about the changed object must be the moved answer about the object itself.
"""

import typing
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache, lru_cache
from random import Random
from types import UnionType

from gmpy2 import mpq

from exactspline import Nurbs
from exactspline.errors import ExactSplineError
from exactspline.geometry.analysis.curves import analyse
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.registry import REGISTRY
from exactspline.questions.entry import Entry, Of
from exactspline.splines.surface import NurbsSurface
from tests.support.changes import CHANGES
from tests.support.drawn import DRAWN
from tests.support.exemptions import EXEMPTIONS, NOT_TRANSPORTED
from tests.support.images import Image, rings
from tests.support.transport import Refused, To, rows, same, shown

# ---- asking


def kind_of(thing):
    """What questions a thing is asked."""
    if isinstance(thing, Nurbs):
        return Of.PLANE_CURVE if thing.dimension == 2 else Of.SPACE_CURVE
    if isinstance(thing, NurbsSurface):
        return Of.PLANAR_MAP if thing.dimension == 2 else Of.SURFACE
    return Of.TWO_CURVES


class Itself:
    """A thing as a key: equal functions that are written otherwise are different ones."""

    def __init__(self, thing):
        self.thing = thing

    def __eq__(self, other):
        return self.thing is other.thing

    def __hash__(self):
        return id(self.thing)


@lru_cache(maxsize=64)
def facts_of(itself):
    """What is known of a thing, kept between its questions."""
    return itself.thing if isinstance(itself.thing, CurvePair) else analyse(itself.thing)


def ask(thing, name, argument=""):
    """What a question answers; the kind of error where it is refused. Nothing else asks."""
    try:
        return REGISTRY[kind_of(thing)][name].answer(facts_of(Itself(thing)), argument)
    except ExactSplineError as error:
        return Refused(type(error).__name__)


# ---- arguments


def text_of(numbers):
    """Numbers as an argument."""
    return ",".join(map(str, numbers))


def exact(argument):
    """The numbers of an argument."""
    return [mpq(x) for x in argument.split(",")]


def some_point(thing, random):
    """A point near a curve, or on it."""
    where = random.random()
    if where < 0.2:
        a, b = thing.domain
        return text_of(thing(a + (b - a) * mpq(random.randint(0, 4), 4)))
    centres = [x.shape.centre for x in analyse(thing).shapes if getattr(x.shape, "centre", None)]
    if where < 0.5 and centres:
        return text_of(random.choice(centres))
    return text_of(mpq(random.randint(-9, 9), random.choice([1, 2, 3])) for _ in range(thing.dimension))


@dataclass(frozen=True)
class Asked:
    """How an argument is drawn, and where a change puts it; whether by the change extrema become those of the other
    kind.
    """

    drawn: Callable[[object, Random], str]
    moved: Callable[[str, Image, int], str]
    flipped: Callable[[str, Image], bool] = lambda argument, image: False


def axis_of(argument, image, dimension):
    """The coordinate that a coordinate becomes."""
    column = [row[int(argument)] for row in image.motion.rows(dimension)]
    return str(next(i for i, x in enumerate(column) if x))


def axis_turns(argument, image):
    """Whether a coordinate becomes the negative of one."""
    matrix = image.motion.matrix
    return bool(matrix) and next(row[int(argument)] for row in matrix if row[int(argument)]) < 0


#: The arguments of questions, by their names.
ARGUMENTS = {
    "nearest": Asked(some_point, lambda argument, image, _: text_of(image.motion(exact(argument)))),
    "winding_number": Asked(some_point, lambda argument, image, _: text_of(image.motion(exact(argument)))),
    "turning_points": Asked(lambda curve, random: str(random.randrange(curve.dimension)), axis_of, axis_turns),
    "offset_cusps": Asked(
        lambda curve, random: str(mpq(random.choice([-1, 1]) * random.randint(1, 9), random.choice([1, 4, 20]))),
        lambda argument, image, _: str(exact(argument)[0] * image.motion.scale * (-1 if image.turns else 1)),
    ),
}
#: The questions whose answer exchanges with another one where a map changes its orientation.
TURNED_OVER = {"positive": "negative", "negative": "positive"}


def argument_of(entry, thing, random):
    """An argument for a question; a question with an argument that is not in the table fails by its name."""
    if not entry.about.argument:
        return ""
    if entry.name not in ARGUMENTS:
        raise KeyError(f"no argument is known for {entry.name}")
    return ARGUMENTS[entry.name].drawn(thing, random)


# ---- what is asked


def transported(entry):
    """Whether the answer is one that goes where a change puts it."""
    return not (entry.about.nearby or entry.name in NOT_TRANSPORTED)


def questions(of, *, dear=False, registry=REGISTRY):
    """The questions of an object whose answers are transported; the dear ones where they are asked for."""
    return [x for x in registry[of].values() if transported(x) and (dear or not x.about.on_request)]


def types_of(entry: Entry) -> set[type]:
    """The types of the values of which an answer consists."""
    return set(_types(typing.get_type_hints(entry.compute)["return"]))


def _types(hint):
    if arguments := [x for x in typing.get_args(hint) if x is not Ellipsis]:
        outer = typing.get_origin(hint)
        outer = None if outer is UnionType else outer
        return [x for y in arguments for x in _types(y)] + ([outer] if isinstance(outer, type) else [])
    return [hint]


def without_transport(registry=REGISTRY):
    """The questions whose answers have a type that is not transported, by name and type."""
    lacking = []
    for of in CHANGES:
        for entry in questions(of, dear=True, registry=registry):
            known = rows.registry.keys() - {object}
            types = [x for x in types_of(entry) if x is not type(mpq()) and not any(issubclass(x, k) for k in known)]
            lacking += [f"{entry.name} of a {of}: {x.__name__}" for x in types]
            if entry.about.argument and entry.name not in ARGUMENTS:
                lacking.append(f"{entry.name} of a {of}: argument {entry.about.argument}")
    return lacking


@cache
def exempt(of, name, change):
    """The reason why a question is not compared after a change, "" where it is."""
    for kinds, names, changes, reason in EXEMPTIONS:
        if of in kinds and name in names and change in changes:
            return reason
    return ""


def cells(*, dear=True):
    """All pairs of questions and changes: of what, question, change."""
    return [(of, entry.name, change) for of in CHANGES for entry in questions(of, dear=dear) for change in CHANGES[of]]


def exempt_cells():
    """The pairs of questions and changes that are not compared."""
    return [cell for cell in cells() if exempt(*cell)]


# ---- words


@dataclass(frozen=True)
class Letter:
    """One change, with the seed of what is chosen in it."""

    name: str
    seed: int

    def __str__(self):
        return f"{self.name} ({self.seed})"


def letter(of, random):
    """One change at random."""
    return Letter(random.choice(list(CHANGES[of])), random.randrange(1 << 30))


def word(of, random, first=""):
    """One to three changes at random, the first of them this one."""
    letters = [letter(of, random) for _ in range(random.randint(1, 3))]
    return (Letter(first, letters[0].seed), *letters[1:]) if first else tuple(letters)


def applied(thing, letters):
    """The thing after all changes that can be made, their image, and those that were made."""
    return _applied(Itself(thing), letters)


@lru_cache(maxsize=64)
def _applied(itself, letters):
    thing = itself.thing
    image, made = Image(), ()
    for each in letters:
        found = CHANGES[kind_of(thing)][each.name](thing, Random(each.seed))
        if found:
            thing, image, made = found[0], image.then(found[1]), (*made, each)
    return thing, image, made


# ---- cases


@dataclass
class Counts:
    """What was run: words, the questions asked after them, by cells; and what differed."""

    words: int = 0
    asked: int = 0
    compared: Counter = field(default_factory=Counter)
    left_out: int = 0
    failures: list = field(default_factory=list)


@dataclass(frozen=True)
class Failure:
    """A question whose answer is not the moved one, with the shortest word for which that is so."""

    thing: object
    question: str
    letters: list
    found: list
    expected: list

    def __str__(self):
        words = " · ".join(map(str, self.letters))
        lines = [f"of {described(self.thing)}", f"found {self.found}", f"moved {self.expected}"]
        return "\n  ".join([f"{self.question} after {words}", *lines])


def described(thing):
    """A thing as it can be written down again."""
    if isinstance(thing, CurvePair):
        return " and ".join(map(described, thing.curves))
    if isinstance(thing, Nurbs):
        data = [list(map(str, thing.knots)), [[*map(str, p)] for p in thing.control_points], [*map(str, thing.weights)]]
        return f"Nurbs({thing.degree}, {', '.join(map(str, data))})"
    points = [[[*map(str, p)] for p in row] for row in thing.control_points]
    kn = [list(map(str, own)) for own in thing.knots]
    return f"NurbsSurface({thing.degree}, {kn[0]}, {kn[1]}, {points}, {[[*map(str, w)] for w in thing.weights]})"


def dimension_of(thing):
    """The number of coordinates."""
    return thing.curves[0].dimension if isinstance(thing, CurvePair) else thing.dimension


def differing(thing, entry, argument, letters, asking=ask):
    """The rows that are found and those that are expected, where they differ; None where they do not."""
    changed, image, _ = applied(thing, letters)
    dimension, name = dimension_of(thing), entry.name
    other_name, other_argument, flipped = name, argument, dimension == 2 and image.turns
    if name in TURNED_OVER and image.turns_over:
        other_name = TURNED_OVER[name]
    if argument:
        about = ARGUMENTS[name]
        other_argument = about.moved(argument, image, dimension)
        flipped = about.flipped(argument, image)
    expected = rows(asking(thing, name, argument), To(thing, image, rings(changed), dimension, flipped))
    found = rows(asking(changed, other_name, other_argument), To(changed, Image(), rings(changed), dimension))
    return None if same(found, expected) else (shown(found), shown(expected))


def compared(thing, entry, letters, random, counts, asking=ask):
    """One question about one thing and the changed one, without the changes that are exempt; a failure is shrunk."""
    of = kind_of(thing)
    letters = tuple(x for x in letters if not exempt(of, entry.name, x.name))
    if not letters:
        counts.left_out += 1
        return
    counts.asked += 1
    argument = argument_of(entry, thing, random)
    counts.compared.update((of, entry.name, each.name) for each in applied(thing, letters)[2])
    if differing(thing, entry, argument, letters, asking):
        shorter = shrunk(thing, entry, argument, letters, asking)
        found, expected = differing(thing, entry, argument, shorter, asking)
        counts.failures.append(Failure(thing, f"{entry.name}:{argument}".rstrip(":"), shorter, found, expected))


def shrunk(thing, entry, argument, letters, asking):
    """The first letter of a word that fails alone, or the first two that do, or the word."""
    shorter = [(x,) for x in letters] + [letters[:k] + letters[k + 1 :] for k in range(len(letters))]
    return next((x for x in shorter if differing(thing, entry, argument, x, asking)), letters)


def drawn(of, random, first="", drawing=None):
    """A thing and a word that begins with this change; until it can be made."""
    while True:
        thing = (drawing or DRAWN[of])(random)
        letters = word(of, random, first)
        if not first or applied(thing, letters[:1])[2]:
            return thing, letters


def run_word(of, random, counts, *, first="", drawing=None, dear=False, asking=ask):
    """One word, and all questions after it."""
    thing, letters = drawn(of, random, first, drawing)
    counts.words += 1
    for entry in questions(of, dear=dear):
        compared(thing, entry, letters, random, counts, asking)
