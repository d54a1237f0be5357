"""The matrix: every question of the registry against every way to write its object otherwise. A case is a word of
changes; what the question answers about the changed object must be the moved answer about the object itself.
"""

import typing
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache, lru_cache
from itertools import pairwise
from random import Random
from types import UnionType

from gmpy2 import mpq

from exactspline import ExactSplineError, Nurbs, NurbsSurface, analyse
from exactspline.geometry.analysis.ask import REGISTRY, asked_of
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.surface_pairs import SurfacePair
from exactspline.geometry.bisectors.two_curves import CurveBisector
from exactspline.geometry.pairs.regions import Region
from exactspline.questions import takes
from exactspline.questions.entry import Answered, Entry, Of
from tests.support.changes import CHANGES
from tests.support.drawn import DRAWN
from tests.support.exemptions import DEAR, EXEMPTIONS, NOT_TRANSPORTED, WHERE_DECIDED
from tests.support.images import BothImages, Image, rings
from tests.support.transport import NUMBERS, POWERS, Refused, To, name_of, rows, same, shown, turned_line

#: Several curves that are asked together.
WITH_CURVES = (CurvePair, CurveBisector, Region)

# ---- asking


def kind_of(thing):
    """What questions a thing is asked."""
    if isinstance(thing, Nurbs):
        return Of.PLANE_CURVE if thing.dimension == 2 else Of.SPACE_CURVE
    if isinstance(thing, NurbsSurface):
        return Of.PLANAR_MAP if thing.dimension == 2 else Of.SURFACE
    kinds = {CurveBisector: Of.PAIR, Region: Of.REGION, CurvePair: Of.TWO_CURVES, SurfacePair: Of.TWO_SURFACES}
    return kinds[type(thing)]


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
    return itself.thing if isinstance(itself.thing, (*WITH_CURVES, SurfacePair)) else analyse(itself.thing)


def ask(thing, name, given=()):
    """What a question answers; the kind of error where it is refused. Nothing else asks."""
    entry = REGISTRY[kind_of(thing)][name]
    try:
        return asked_of(facts_of(Itself(thing)), text_of(entry, given)).answer
    except ExactSplineError as error:
        return Refused(type(error).__name__)


def text_of(entry, given=()):
    """A question as text, with what it is asked with."""
    placed = [text for takes, text in zip(entry.about.takes, given, strict=True) if takes.placed]
    others = [text for takes, text in zip(entry.about.takes, given, strict=True) if not takes.placed]
    return entry.name + "".join(f":{text}" for text in others) + "".join(f"@{text}" for text in placed)


# ---- what a question takes


def listed(numbers):
    """Numbers as text."""
    return ",".join(map(str, numbers))


def exact(text):
    """The numbers of a text."""
    return [mpq(x) for x in text.split(",")]


def some_point(thing, random):
    """A point near a curve, on it, or at the centre of a circle that it has."""
    if isinstance(thing, Region):
        return some_point(random.choice(thing.curves), random)
    where = random.random()
    if where < 0.2:
        a, b = thing.domain
        return listed(thing(a + (b - a) * mpq(random.randint(0, 4), 4)))
    centres = [x.shape.centre for x in analyse(thing).shapes if getattr(x.shape, "centre", None)]
    if where < 0.5 and centres:
        return listed(random.choice(centres))
    return listed(mpq(random.randint(-9, 9), random.choice([1, 2, 3])) for _ in range(thing.dimension))


def inside(low, high, random):
    """A parameter inside an interval, at none of the usual knots."""
    return low + (high - low) * mpq(random.randint(1, 96), 97)


def some_parameter(curve, random):
    """A parameter that is not a knot, or one side of a knot."""
    knots = curve.breakpoints[1:-1]
    if knots and random.random() < 0.5:
        return f"{random.choice(knots)}{random.choice('-+')}"
    return str(inside(*random.choice(list(pairwise(curve.breakpoints))), random))


def moved_parameter(text, image, _):
    """Where a parameter goes, or a side of one."""
    way, side = image.ways[0], text[-1] if text[-1] in "-+" else ""
    t = mpq(text.removesuffix(side))
    moved = way.left(t) if side == "-" else way.to(t)
    return f"{moved}{'+-'['-+'.index(side)] if side and way.backwards else side}"


def some_place(surface, random):
    """A point of a surface."""
    return listed(inside(*side, random) for side in surface.domain)


def moved_place(text, image, _):
    """Where a point of a surface goes."""
    moved = [way.to(x) for way, x in zip(image.ways, exact(text), strict=True)]
    return listed(moved[::-1] if image.exchanged else moved)


@dataclass(frozen=True)
class Drawn:
    """How something that a question takes is drawn, and where a change puts it; whether by the change extrema become
    those of the other kind (None: as those of the curvature do).
    """

    drawn: Callable[[object, Random], str]
    moved: Callable[[str, Image, int], str] = lambda text, image, dimension: text
    flipped: Callable[[str, Image], bool] | None = None


def axis_of(text, image, dimension):
    """The coordinate that a coordinate becomes."""
    column = [row[int(text)] for row in image.motion.rows(dimension)]
    return str(next(i for i, x in enumerate(column) if x))


def axis_turns(text, image):
    """Whether a coordinate becomes the negative of one."""
    matrix = image.motion.matrix
    return bool(matrix) and next(row[int(text)] for row in matrix if row[int(text)]) < 0


def moved_distances(text, image, _):
    """Signed distances of two curves: left and right change places for each curve that is reversed."""
    flips = [way.backwards != image.motion.turns for way in image.ways]
    moved = [x * image.motion.scale * (-1 if flip else 1) for x, flip in zip(exact(text), flips, strict=True)]
    return listed(moved[::-1] if image.exchanged else moved)


def two_parameters(curve, random):
    """Two parameters, neither of them a knot."""
    return listed(inside(*curve.domain, random) for _ in range(2))


def some_length(curve, random):
    """A length that the curve has."""
    return str(analyse(curve).length.rational_near(6) * mpq(random.randint(1, 96), 97))


def some_coordinate(curve, random):
    """A coordinate, and a value that it has somewhere, or may have."""
    axis = random.randrange(curve.dimension)
    a, b = curve.domain
    value = curve(a + (b - a) * mpq(random.randint(0, 8), 8))[axis] if random.random() < 0.7 else random.randint(-2, 2)
    return listed((axis, value))


def moved_coordinate(text, image, dimension):
    """The coordinate that a coordinate becomes, and its value."""
    axis, value = text.split(",")
    point = [mpq(value) if i == int(axis) else mpq(0) for i in range(dimension)]
    moved = axis_of(axis, image, dimension)
    return listed((moved, image.motion(point)[int(moved)]))


def point_by_surface(surface, random):
    """A point near a surface, on it, or at a simple place where centres of examples are."""
    if random.random() < 0.3:
        return surface(*exact(some_place(surface, random)))
    return tuple(mpq(random.randint(-6, 6), random.choice([1, 1, 3])) for _ in range(3))


def two_by_surface(surface, random):
    """Two different points near a surface."""
    points = [point_by_surface(surface, random) for _ in range(2)]
    return points if points[0] != points[1] else two_by_surface(surface, random)


def some_line(surface, random):
    """A point and a direction, of an axis or through another point."""
    first, second = two_by_surface(surface, random)
    axis = random.randrange(3)
    way = (
        [mpq(i == axis) for i in range(3)]
        if random.random() < 0.4
        else [y - x for x, y in zip(first, second, strict=True)]
    )
    return listed((*first, *way))


def moved_line(text, image, _):
    """The line moved with its parameter."""
    numbers = exact(text)
    return listed((*image.motion(numbers[:3]), *image.motion.of_vector(numbers[3:])))


def moved_plane(text, image, _):
    """The plane of the moved points."""
    *normal, offset = exact(text)
    turned, foot = image.motion.of_vector(normal), [offset * x / sum(y * y for y in normal) for x in normal]
    return listed((*turned, sum(x * y for x, y in zip(turned, image.motion(foot), strict=True))))


#: What questions take.
TAKEN = {
    takes.POINT_IN_SPACE: Drawn(
        lambda surface, random: listed(point_by_surface(surface, random)),
        lambda text, image, _: listed(image.motion(exact(text))),
    ),
    takes.LINE: Drawn(some_line, moved_line),
    takes.ENDS: Drawn(
        lambda surface, random: ",".join(map(listed, two_by_surface(surface, random))),
        lambda text, image, _: listed(x for k in (0, 3) for x in image.motion(exact(text)[k : k + 3])),
    ),
    takes.PLANE: Drawn(
        lambda surface, random: listed((*random.choice([(0, 0, 1), (1, 0, 0), (1, 2, -1)]), random.randint(-2, 2))),
        moved_plane,
    ),
    takes.POINT: Drawn(some_point, lambda text, image, _: listed(image.motion(exact(text)))),
    takes.COORDINATE: Drawn(lambda curve, random: str(random.randrange(curve.dimension)), axis_of, axis_turns),
    takes.DISTANCE: Drawn(
        lambda curve, random: str(mpq(random.choice([-1, 1]) * random.randint(1, 9), random.choice([1, 4, 20]))),
        lambda text, image, _: str(exact(text)[0] * image.motion.scale * (-1 if image.turns else 1)),
    ),
    takes.OFFSETS: Drawn(
        lambda pair, random: listed(mpq(random.randint(-4, 4), random.choice([4, 20])) for _ in range(2)),
        moved_distances,
    ),
    takes.BOUND: Drawn(
        lambda curve, random: str(mpq(random.randint(1, 9), random.choice([1, 4, 20]))),
        lambda text, image, _: str(exact(text)[0] / image.motion.scale),
    ),
    takes.TOLERANCE: Drawn(
        lambda pair, random: str(mpq(random.randint(1, 40), random.choice([4, 20]))),
        lambda text, image, _: str(exact(text)[0] * image.motion.scale),
    ),
    takes.WITHIN: Drawn(lambda pair, random: str(mpq(random.randint(1, 40), random.choice([4, 20])))),
    takes.INTEGER: Drawn(lambda curve, random: str(random.randint(1, 2))),
    takes.TWO_ORDERS: Drawn(
        lambda surface, random: random.choice(["1,0", "0,1", "1,1"]),
        lambda text, image, _: ",".join(text.split(",")[:: -1 if image.exchanged else 1]),
    ),
    takes.PLACES: Drawn(some_parameter, moved_parameter),
    takes.TWO_PLACES: Drawn(two_parameters, lambda text, image, _: listed(image.ways[0].to(t) for t in exact(text))),
    takes.LENGTH: Drawn(some_length, lambda text, image, _: str(exact(text)[0] * image.motion.scale)),
    takes.COORDINATE_VALUE: Drawn(some_coordinate, moved_coordinate),
    takes.PLACE_ON_SURFACE: Drawn(some_place, moved_place),
}
#: The questions whose answer exchanges with another one where a map changes its orientation.
TURNED_OVER = {"positive": "negative", "negative": "positive"}


def given_to(entry, thing, random):
    """What a question is asked with."""
    return tuple(TAKEN[each].drawn(thing, random) for each in entry.about.takes)


# ---- what is asked


def transported(entry):
    """Whether the answer is one that goes where a change puts it."""
    return not (entry.about.nearby or entry.about.answered is Answered.SPLINES or entry.name in NOT_TRANSPORTED)


def questions(of, *, dear=False, registry=REGISTRY):
    """The questions of an object whose answers are transported; the dear ones where they are asked for."""
    return [x for x in registry[of].values() if transported(x) and (dear or (of, x.name) not in DEAR)]


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
            types = [x for x in types_of(entry) if x is not type(mpq()) and not name_of(x)]
            lacking += [f"{entry.name} of a {of}: {x.__name__}" for x in types]
            lacking += [f"{entry.name} of a {of}: takes {x.example}" for x in entry.about.takes if x not in TAKEN]
            own = {kind.__name__ for kind in types_of(entry)}
            for kind, names in (("NamedNumbers", NUMBERS), ("Real", POWERS)):
                lacking += [f"{entry.name} of a {of}: numbers"] * (kind in own and entry.name not in names)
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
    image, made = BothImages() if isinstance(thing, SurfacePair) else Image(), ()
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
    if isinstance(thing, WITH_CURVES):
        return " and ".join(map(described, thing.curves))
    if isinstance(thing, SurfacePair):
        return " and ".join(map(described, thing.surfaces))
    if isinstance(thing, Nurbs):
        data = [list(map(str, thing.knots)), [[*map(str, p)] for p in thing.control_points], [*map(str, thing.weights)]]
        return f"Nurbs({thing.degree}, {', '.join(map(str, data))})"
    points = [[[*map(str, p)] for p in row] for row in thing.control_points]
    kn = [list(map(str, own)) for own in thing.knots]
    return f"NurbsSurface({thing.degree}, {kn[0]}, {kn[1]}, {points}, {[[*map(str, w)] for w in thing.weights]})"


def dimension_of(thing):
    """The number of coordinates."""
    if isinstance(thing, SurfacePair):
        return 3
    return thing.curves[0].dimension if isinstance(thing, WITH_CURVES) else thing.dimension


def differing(thing, entry, given, letters, asking=ask):
    """The rows that are found and those that are expected, where they differ; None where they do not."""
    changed, image, _ = applied(thing, letters)
    dimension, name, taken = dimension_of(thing), entry.name, [TAKEN[each] for each in entry.about.takes]
    other_name = TURNED_OVER.get(name, name) if image.turns_over else name
    others = tuple(each.moved(text, image, dimension) for each, text in zip(taken, given, strict=True))
    turned = [each.flipped(text, image) for each, text in zip(taken, given, strict=True) if each.flipped]
    flipped = turned[0] if turned else dimension == 2 and image.turns
    to = To(thing, image, rings(changed), dimension, name, given, flipped)
    if name == "plane" and turned_line(to):
        return None
    expected = rows(asking(thing, name, given), to)
    same_place = type(image)()
    found = rows(asking(changed, other_name, others), To(changed, same_place, rings(changed), dimension, name, others))
    if same(found, expected) or (name in WHERE_DECIDED and any(map(undecided, (found, expected)))):
        return None
    return shown(found), shown(expected)


def undecided(told):
    """Whether something is left out of an answer, or all of it as out of reach."""
    return any(word in ("left out", "undecided", "ReachError") for words, _ in told for word in words)


def compared(thing, entry, letters, random, counts, asking=ask):
    """One question about one thing and the changed one, without the changes that are exempt; a failure is shrunk."""
    of = kind_of(thing)
    letters = tuple(x for x in letters if not exempt(of, entry.name, x.name))
    if not letters:
        counts.left_out += 1
        return
    counts.asked += 1
    given = given_to(entry, thing, random)
    counts.compared.update((of, entry.name, each.name) for each in applied(thing, letters)[2])
    if first := differing(thing, entry, given, letters, asking):
        shorter = shrunk(thing, entry, given, letters, asking)
        # it differs no more where an answer goes with what was asked before
        found, expected = differing(thing, entry, given, shorter, asking) or first
        counts.failures.append(Failure(thing, text_of(entry, given), shorter, found, expected))


def shrunk(thing, entry, given, letters, asking):
    """The first letter of a word that fails alone, or the first two that do, or the word."""
    shorter = [(x,) for x in letters] + [letters[:k] + letters[k + 1 :] for k in range(len(letters))]
    return next((x for x in shorter if differing(thing, entry, given, x, asking)), letters)


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
