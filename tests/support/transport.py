"""What an answer says, as rows of words and numbers that do not depend on how the object is written: one function per
type of value. The rows of an answer are moved to where a change of the object puts them (`tests.support.images`); there
they must be those of the answer about the changed object. A type that has no function here fails by its name.
"""

from collections import Counter
from dataclasses import dataclass

from gmpy2 import gcd, lcm, mpq

from exactspline import Nurbs
from exactspline.errors import ReachError
from exactspline.splines.surface import Along
from tests.support.images import Image, Known, Ring, closed_in, known

OPPOSITE = {"maximum": "minimum", "minimum": "maximum"}
OTHER_SIGN = {
    "orientation kept: det > 0": "orientation reversed: det < 0",
    "orientation reversed: det < 0": "orientation kept: det > 0",
}


@dataclass(frozen=True)
class To:
    """Where an answer about an object is moved: by which image, into which parameters, of how many coordinates; which
    question it answers, with what it was asked, and whether the extrema that it tells change their kind.
    """

    asked: object
    image: Image
    rings: tuple[Ring, Ring]
    dimension: int
    name: str = ""
    given: tuple[str, ...] = ()
    flipped: bool = False

    def parameter(self, x, k=0):
        """Where a parameter goes, by its number."""
        place = 1 - k if self.image.exchanged else k
        return self.rings[place].once((x if isinstance(x, Known) else known(x)).mapped(self.image.ways[k].to))

    def both(self, first, second):
        """Where a pair of parameters goes."""
        pair = [self.parameter(first, 0), self.parameter(second, 1)]
        return pair[::-1] if self.image.exchanged else pair

    def interval(self, ends, k=0):
        """Where an interval of rational ends goes, cut at the knots there, and at a seam that is inside of it."""
        way, ring = self.image.ways[k], self.rings[1 - k if self.image.exchanged else k]
        low, high = (mpq(t) for t in ends)
        moved = (way.to(low), way.to(high) if low == high else way.left(high))
        first, last = moved[::-1] if way.backwards else moved
        if low == high or first < last:
            return ring.cut(first, last)
        return [part for part in (*ring.cut(first, ring.high), *ring.cut(ring.low, last)) if part[0] < part[1]]

    def boxes(self, sides):
        """Where a rectangle of rational sides goes, cut at the knots there."""
        parts = [self.interval(side, k) for k, side in enumerate(sides)]
        first, second = parts[::-1] if self.image.exchanged else parts
        return [tuple(map(known, (*a, *b))) for a in first or [()] for b in second or [()]]

    def along(self, along):
        """The name of a parameter of a surface."""
        return str(along) if not self.image.exchanged else "v" if along == "u" else "u"

    @property
    def scale(self):
        """By how much lengths grow."""
        return mpq(self.image.motion.scale)

    @property
    def turn(self):
        """The sign of what is signed by left and right in the plane; the area of a region is not."""
        if type(self.asked).__name__ == "Region" and self.name != "winding_number":
            return 1
        return -1 if self.dimension == 2 and self.image.turns else 1


#: The functions of this file, by the names of the types of their answers.
ROWS = {}


def of(name):
    """What follows gives the rows of the answers whose type, or one above it, has this name."""

    def enter(function):
        ROWS[name] = function
        return function

    return enter


def name_of(kind):
    """Of the names of a type and of those above it the first one that is transported; "" where there is none."""
    return next((each.__name__ for each in kind.__mro__ if each.__name__ in ROWS), "")


def rows(answer, to):
    """The rows of an answer, moved."""
    if name := name_of(type(answer)):
        return ROWS[name](answer, to)
    raise TypeError(f"no transport for {type(answer).__name__}")


@dataclass(frozen=True)
class Refused:
    """A question that was refused: by which kind of error."""

    error: str


@of("Refused")
def _(answer, to):
    return [(("refused", answer.error), ())]


@of("NoneType")
def _(answer, to):
    return [(("none",), ())]


@of("Position")
def _(answer, to):
    return [((str(answer),), ())]


@of("tuple")
def _(answer, to):
    """Several values; a piece with its plane is one, a point is that there is one."""
    if [type(x).__name__ for x in answer] == ["CurvePiece", "Plane"]:
        return [joined(*(rows(x, to)[0] for x in answer))]
    if answer and all(isinstance(x, type(mpq())) for x in answer):
        return [(("a point",), ())]
    return [row for x in answer for row in rows(x, to)]


def joined(first, second):
    """Two rows as one."""
    return (*first[0], *second[0]), (*first[1], *second[1])


def marked(word, found):
    """Rows with a word before them."""
    return [((word, *words), numbers) for words, numbers in found]


# ---- curves


@of("Places")
def _(answer, to):
    """What holds at points, and everywhere on pieces."""
    return [*rows(tuple(answer), to), *marked("everywhere", rows(answer.everywhere, to))]


@of("Feature")
def _(feature, to):
    kind = OPPOSITE.get(feature.kind, feature.kind) if to.flipped else feature.kind
    words = str(kind), f"of |κ|: {feature.of_absolute}", "by a jump" if feature.by_jump else ""
    return [(words, (to.parameter(feature.root),))]


@of("Joint")
def _(joint, to):
    """A knot at which nothing can be seen is none: of the highest order that is told, or inside a rest."""
    if joint.kind == "standing still" or (joint.order is not None and joint.order >= 3):
        return []
    numbers = [to.parameter(joint.parameter)]
    if joint.angle is not None:
        numbers += [known(joint.angle.cosine), known(joint.angle.sine).times(to.turn)]
    if joint.gap is not None:
        numbers.append(known(joint.gap).times(to.scale))
    if joint.curvatures is not None:
        sides = [known(x).times(to.turn / to.scale) for x in joint.curvatures]
        numbers += sides[::-1] if to.image.ways[0].backwards else sides
    return [((str(joint.kind), str(joint.order)), tuple(numbers))]


@of("CurvePiece")
def _(piece, to):
    """A piece by its ends; of a whole closed curve no point is an end."""
    ring, ends = to.rings[0], [to.parameter(t) for t in (piece.start, piece.end)]
    if ring.closed and ends[0] == ends[1]:
        return [(("all around",), ())]
    return [(("piece",), tuple(ends[::-1] if to.image.ways[0].backwards else ends))]


@of("Plane")
def _(plane, to):
    """A plane by a primitive normal and its distance, in the image."""
    if turned_line(to):
        return []
    matrix, scale = to.image.motion.rows(3), to.scale
    normal = [sum((a * x for a, x in zip(row, plane.normal, strict=True)), mpq(0)) / scale for row in matrix]
    square = sum(x * x for x in plane.normal)
    foot = to.image.motion([mpq(plane.offset * x) / square for x in plane.normal])
    return [(("plane",), tuple(map(known, primitive_plane(normal, foot))))]


def turned_line(to):
    """Whether a straight curve is turned: of its planes those of constant coordinates are told."""
    first, *others = to.asked.control_points
    ways = [way for point in others if any(way := [x - y for x, y in zip(point, first, strict=True)])]
    straight = all(primitive(way) == primitive(ways[0]) for way in ways)
    return straight and any(sum(map(bool, row)) > 1 for row in to.image.motion.rows(3))


def primitive_plane(normal, point):
    """Normal and offset of a plane in integers without a common divisor, the first nonzero one positive."""
    normal = primitive(normal)
    return [*normal, sum(a * x for a, x in zip(normal, point, strict=True))]


def primitive(vector):
    """The multiple of a vector with coprime integers whose first nonzero one is positive."""
    exact = [mpq(x) for x in vector]
    whole = [int(x * lcm(1, *[y.denominator for y in exact])) for x in exact]
    sign = 1 if next((x for x in whole if x), 1) > 0 else -1
    divisor = gcd(*whole) or 1
    return [sign * x // divisor for x in whole]


@of("RecognizedPiece")
def _(found, to):
    """A shape where it is exact by its numbers, otherwise, being guessed, by its kind."""
    words = str(found.kind), "whole" if found.whole else "", "exact" if found.exact else "near"
    numbers = of_shape(found.shape, to) if found.exact else ()
    return [joined((words, numbers), rows(found.piece, to)[0])]


def of_shape(shape, to):
    """The numbers of an exact shape in the image, those that do not depend on how it is said."""
    move, scale = to.image.motion, to.scale
    matrix = getattr(shape, "matrix", None)
    if matrix is not None:
        return moved_quadric(matrix, move)
    numbers = []
    axis = next((getattr(shape, name) for name in ("direction", "axis", "normal") if getattr(shape, name, ())), None)
    point = next(getattr(shape, name) for name in ("point", "centre", "apex") if hasattr(shape, name))
    moved = move(point)
    if axis is not None:
        axis = primitive(move.of_vector(axis))
        numbers += axis
    numbers += foot_of(str(shape.kind), moved, axis)
    numbers += [
        getattr(shape, f"{name}_squared") * scale**2
        for name in ("radius", "major", "minor")
        if hasattr(shape, f"{name}_squared")
    ]
    numbers += [shape.tangent_squared] if hasattr(shape, "tangent_squared") else []
    return tuple(map(known, numbers))


def foot_of(kind, point, axis):
    """The point of a shape; of a line, an axis or a plane the one next to the origin."""
    if kind not in ("line", "cylinder", "plane"):
        return point
    along = sum(a * x for a, x in zip(axis, point, strict=True)) / mpq(sum(a * a for a in axis))
    foot = [along * a for a in axis]
    return foot if kind == "plane" else [x - y for x, y in zip(point, foot, strict=True)]


def moved_quadric(matrix, move):
    """The symmetric matrix of a conic in the image, its first nonzero entry 1."""
    n = len(matrix) - 1
    rows_of, scale = move.rows(n), move.scale
    shift = move.shift or [mpq(0)] * n
    # the inverse motion: x ↦ Rᵀ (x − d) / scale²
    back = [[rows_of[j][i] / scale**2 for j in range(n)] for i in range(n)]
    inverse = [[*row, -sum(a * d for a, d in zip(row, shift, strict=True))] for row in back] + [[mpq(0)] * n + [mpq(1)]]
    image = [
        [
            sum(inverse[k][i] * matrix[k][m] * inverse[m][j] for k in range(n + 1) for m in range(n + 1))
            for j in range(n + 1)
        ]
        for i in range(n + 1)
    ]
    first = next(x for row in image for x in row if x)
    return tuple(known(x / first) for row in image for x in row)


@of("Nearest")
def _(answer, to):
    return [*rows(tuple(answer), to), *marked("everywhere", rows(answer.everywhere, to))]


@of("NearestPoint")
def _(found, to):
    place = to.image.motion.of_known([known(x) for x in found.point])
    return [(("nearest",), (to.parameter(found.parameter), known(found.squared).times(to.scale**2), *place))]


@of("int")
def _(number, to):
    return [((), (known(number).times(-1 if to.image.turns else 1),))]


# ---- numbers by their names

#: The power of the scale with which a number goes, and whether it has a sign by left and right.
POWERS = {"length": (1, False), "length_between": (1, False), "at_length": (0, False), "area": (2, True)}


@of("Real")
def _(number, to):
    """A number of the whole curve, or a parameter."""
    if to.name == "at_length":
        return [((), (to.parameter(number),))]
    power, signed = POWERS[to.name]
    return [((), (known(number).times(to.scale**power * (to.turn if signed else 1)),))]


@of("NamedNumbers")
def _(found, to):
    """By the question that it answers."""
    values = {name: known(x) for name, x in found.values.items()}
    place = (to.parameter(values.pop("parameter")),) if "parameter" in values else ()
    words, numbers = NUMBERS[to.name](found, values, to)
    return [((str(found.what) if not words else "", *words), (*place, *numbers))]


def as_point(found, values, to):
    """Coordinates of a point."""
    return (), to.image.motion.of_known(list(values.values()))


def as_derivative(found, values, to):
    """A vector, by the chain rule."""
    orders, places = [int(x) for x in to.given[1].split(",")], to.given[0].split(",")
    vector = [x.exact for x in values.values()]
    slopes = [way.slopes(mpq(t.rstrip("+-"))) for way, t in zip(to.image.ways, places, strict=False)]
    if orders == [2]:
        (first, bend), side = slopes[0], "left" if places[0].endswith("-") else "right"
        lower = to.asked.derivative(1, mpq(places[0].rstrip("+-")), side)
        # γ_uu = γ_tt / φ′² − γ_t φ″ / φ′³
        vector = [x / first**2 - y * bend / first**3 for x, y in zip(vector, lower, strict=True)]
    else:
        for order, (first, _) in zip(orders, slopes, strict=True):
            vector = [x / first**order for x in vector]
    return (), to.image.motion.of_known([known(x) for x in vector], point=False)


def as_curvature(found, values, to):
    """κ with its sign in the plane; K and H, whose sign goes with the normal."""
    if "curvature" in values:
        return (), [values["curvature"].times(to.turn / to.scale)]
    over = -1 if to.image.turns_over else 1
    return (), [values["K"].times(1 / to.scale**2), values["H"].times(over / to.scale)]


def as_torsion(found, values, to):
    """τ, which only a mirror changes."""
    return (), [values["torsion"].times((-1 if to.image.motion.turns else 1) / to.scale)]


def as_frame(found, values, to):
    """T, N and in space B: unit vectors."""
    along = -1 if to.image.ways[0].backwards else 1
    mirrored = -1 if to.image.motion.turns else 1
    signs = {"T": along, "N": to.turn, "B": along * mirrored}
    numbers = []
    for vector, sign in signs.items():
        if own := [x for name, x in values.items() if name[0] == vector]:
            numbers += [x.times(sign / to.scale) for x in to.image.motion.of_known(own, point=False)]
    return (), numbers


def axis_to(axis, to):
    """Which coordinate a coordinate becomes, and the factor; of motions that exchange coordinates."""
    column = [row[axis] for row in to.image.motion.rows(to.dimension)]
    k = next(i for i, x in enumerate(column) if x)
    return k, column[k]


def as_box(found, values, to):
    """The range of one coordinate."""
    k, factor = axis_to("xyz".index(found.what), to)
    ends = [values["low"].times(factor), values["high"].times(factor)]
    return ("xyz"[k],), ends[::-1] if factor < 0 else ends


def as_moment(found, values, to):
    """The integral of xⁱ yʲ, its sign by left and right."""
    powers, factor = [0, 0], to.scale**2 * to.turn
    for axis, power in enumerate((found.facts["x"], found.facts["y"])):
        k, own = axis_to(axis, to)
        powers[k] = power
        factor *= own**power
    return tuple(map(str, powers)), [values["moment"].times(factor)]


def as_parameter(found, values, to):
    """A parameter alone."""
    return (), ()


def side_of(found, to):
    """The side of a knot, which is the other one of a curve that is reversed."""
    side, other = found.facts.get("side", ""), {"left": "right", "right": "left"}
    return other.get(side, "") if to.image.ways[0].backwards else side


def as_piece(values, to):
    """The ends of a piece, in order; of a whole closed curve none."""
    ends = [to.parameter(values[name]) for name in ("start", "end")]
    if to.rings[0].closed and ends[0].agrees(ends[1]):
        return ["all around"], []
    return [], ends[::-1] if to.image.ways[0].backwards else ends


def as_largest(power, name):
    """The largest value of what goes with a power of the scale."""

    def moved(found, values, to):
        value = [values[name].times(to.scale**power)] if name in values else []
        words, ends = as_piece(values, to) if "start" in values else ([], [])
        return (found.what, side_of(found, to), *words), [*value, *ends]

    return moved


def as_bounded(found, values, to):
    """Whether the curvature is at most a number, and where it is not."""
    if found.what == "curvature bound":
        return ("bound", found.facts["holds"]), [values["bound"].times(1 / to.scale)]
    words, ends = as_piece(values, to)
    return ("above", *words), ends


def as_curvature_derivative(found, values, to):
    """dκ/ds: in the plane a mirror changes its sign, and the direction twice; in space the direction does."""
    turn = (-1 if to.image.motion.turns else 1) if to.dimension == 2 else -1 if to.image.ways[0].backwards else 1
    return (), [values["curvature derivative"].times(turn / to.scale**2)]


def as_junction(found, values, to):
    """Two ends; the parametric order goes with the parameters."""
    powers = {"gap": to.scale, "angle": 1, "curvature jump": 1 / to.scale}
    numbers = [values[name].times(power) for name, power in powers.items() if name in values]
    return ("ends", str(found.facts["geometric"])), [*to.both(values["first"], values["second"]), *numbers]


def as_deviation(found, values, to):
    """Bounds of a distance, which meet those of the same one; whether it is at most a number."""
    words = found.what.split()
    what = " ".join(words[::-1] if to.image.exchanged else words)
    if "bound" in values:
        return (what, found.facts["holds"]), [values["bound"].times(to.scale)]
    return (what,), [Known(None, values["low"].low, values["high"].high).times(to.scale)]


def as_offset_part(found, values, to):
    """A part by its ends; an arc about a corner by this and its ends, which a mirror exchanges."""
    if found.what == "part":
        return as_piece(values, to)
    ends = [to.image.motion.of_known([values[f"{end} {axis}"] for axis in "xy"]) for end in ("start", "end")]
    first, last = ends[::-1] if to.image.motion.turns else ends
    return ["corner"], [to.parameter(values["corner"]), *first, *last]


def as_common_border(found, values, to):
    """An arc of two borders, or a point of it, by the parameters of both: the surface that is first then first."""
    borders, numbers = [], []
    for k, name in enumerate(("first", "second")):
        own = to.rings[1 - k if to.image.exchanged else k]
        one = To(to.asked.surfaces[k], to.image.images[k], own, 3)
        letter, value = found.facts[f"{name} border"].split(" = ")
        way = "uv".index(letter)
        moved = [one.parameter(x, 1 - way) for key, x in values.items() if key.split()[0] == name]
        borders.append(f"{one.along(letter)} = {one.image.ways[way].to(mpq(value))}")
        numbers.append(moved)
    if to.image.exchanged:
        borders, numbers = borders[::-1], numbers[::-1]
    pairs = sorted(zip(*numbers, strict=True), key=lambda pair: pair[0].low)
    angle = [values["angle"]] if "angle" in values else []
    return (found.what, *borders, str(found.facts.get("order"))), [*(x for pair in pairs for x in pair), *angle]


#: How the numbers go that answer a question.
NUMBERS = {
    "offset_parts": as_offset_part,
    "deviation": as_deviation,
    "deviation_within": as_deviation,
    "curvature_derivative": as_curvature_derivative,
    "largest_curvature": as_largest(-1, "curvature"),
    "largest_curvature_derivative": as_largest(-2, "curvature derivative"),
    "largest_torsion": as_largest(-1, "torsion"),
    "curvature_at_most": as_bounded,
    "junctions": as_junction,
    "junctions_within": as_junction,
    "common_borders": as_common_border,
    "value": as_point,
    "derivative": as_derivative,
    "curvature": as_curvature,
    "torsion": as_torsion,
    "frame": as_frame,
    "bounding_box": as_box,
    "moments": as_moment,
    "centroid": as_point,
    "equally_spaced": as_parameter,
}


# ---- pairs of parameters


@of("Intersections")
def _(answer, to):
    alone = isinstance(to.asked, Nurbs)
    points = [of_pair(x, to, alone) for x in answer]
    arcs, _ = whole_arcs(answer.everywhere, to, alone)
    return [*points, *arcs, *[(("left out",), ())] * bool(answer.undecided)]


def pair_at(first, second, to, alone):
    """A pair of parameters; of a curve with itself in their order."""
    if not alone:
        return tuple(to.both(first, second))
    return tuple(sorted((to.parameter(first), to.parameter(second)), key=lambda x: x.low))


def of_pair(found, to, alone):
    """A common point."""
    return (str(found.kind), str(found.multiplicity)), pair_at(found.first, found.second, to, alone)


def key_of(pair):
    """What tells a pair of parameters from others."""
    return tuple(round((x.low + x.high) / 2 * 10**20) if x.exact is None else x.exact for x in pair)


def course(arc, to):
    """Whether both curves run along an arc the same way, or one of them stands still."""
    if arc.first[0] == arc.first[1] or arc.second[0] == arc.second[1]:
        return "at rest"
    turned = to.image.ways[0].backwards != to.image.ways[1].backwards
    return "reversed" if arc.reversed != turned else "the same way"


def whole_arcs(arcs, to, alone=False):
    """Arcs are told knot by knot; compared are those that they make together: joined where exactly two of one course
    meet. The rows of these, and the pairs at which they were joined.
    """
    placed = [
        (course(arc, to), [pair_at(*p, to, alone) for p in zip(arc.first, arc.second, strict=True)]) for arc in arcs
    ]
    met = Counter((word, key_of(end)) for word, ends in placed for end in ends)
    groups = [(word, list(ends)) for word, ends in placed]
    joined_at = set()
    for node in [node for node, times in met.items() if times == 2]:
        here = [group for group in groups if node in [(group[0], key_of(end)) for end in group[1]]]
        groups = [group for group in groups if not any(group is x for x in here)]
        ends = [end for _, own in here for end in own if (node[0], key_of(end)) != node]
        groups.append((node[0], ends))
        joined_at.add(node[1])
    found = [((word, f"{len(ends)} ends"), end) for word, ends in groups for end in ends]
    return [*found, *[((word, "loop"), ()) for word, ends in groups if not ends]], joined_at


@of("Intersection")
def _(found, to):
    return [of_pair(found, to, alone=False)]


@of("Overlap")
def _(arc, to):
    return whole_arcs([arc], to)[0]


@of("Distance")
def _(found, to):
    """The pairs but those at which arcs are joined, the arcs, and the distance."""
    arcs, joined_at = whole_arcs(found.everywhere, to)
    pairs = [row for pair in found.pairs for row in rows(pair, to) if key_of(row[1]) not in joined_at]
    value = [(("squared",), (known(found.squared).times(to.scale**2),))] if found.pairs else []
    return [*pairs, *value, *arcs, *[(("left out",), ())] * bool(found.undecided)]


@of("ClosestPair")
def _(found, to):
    return [(("closest",), tuple(to.both(found.first, found.second)))]


# ---- bisectors


@of("Bisector")
def _(found, to):
    raise TypeError(f"no transport for {type(found).__name__}")


@of("PlaneBisector")
def _(found, to):
    """Arcs by the pairs and points of their ends; a box that is not decided."""
    if found.missing:
        return [(("undecided",), ())]
    pairs, told = found.pairs, []
    for arc in pairs.arcs:
        ends = [] if arc.closed else [arc.start, arc.end]
        told += [(("arc",), at_pair(found, *end, to)) for end in ends] or [(("loop",), ())]
    told += [(("pair",), at_pair(found, x.first, x.second, to)) for x in pairs.points]
    told += [(("line", to.along(x.along)), own) for x in pairs.lines for own in on_line(x, x.value, to)]
    return told + [(("rectangle",), box) for part in pairs.everywhere for box in to.boxes(part.sides)]


def at_pair(bisector, first, second, to):
    """A pair of parameters, and its point where it has one."""
    try:
        point = to.image.motion.of_known([known(x) for x in bisector.point(first, second)])
    except ReachError:
        point = ()
    return (*to.both(first, second), *point)


@of("TrimmedBisector")
def _(found, to):
    """The ends of arcs, but those in which two of them meet, and those of straight pieces, by their points."""
    if found.undecided:
        return [(("left out",), ())]
    arcs = [to.parameter(t) for piece in found.arcs for t in (piece.low, piece.high)]
    met = Counter(map(key_of, zip(arcs)))
    told = [(("arc",), (t,)) for t in arcs if met[key_of((t,))] == 1]
    for piece in found.pieces:
        values = {} if piece.kind == "arc" else piece.described.values
        for end in ("start", "end")[: 2 * bool(values)]:
            point = [known(values[f"{end} {axis}"]) for axis in "xy" if f"{end} {axis}" in values]
            told.append((("straight",), tuple(to.image.motion.of_known(point)) if point else ()))
    return told


@of("PointBisector")
def _(found, to):
    """Where there is no ruling, or no one plane; which coordinate is a parameter goes with the axes."""
    parts = [part for interval, _ in found.missing for part in to.interval(interval)]
    missing = [(("missing",), tuple(map(known, part))) for part in parts]
    return [*missing, *[(("singular",), (to.parameter(t),)) for t in found.singular]]


@of("CurveBisector")
def _(found, to):
    """The rectangles of the surface, and of what is beside it the single pairs."""
    if found.undecided:
        return [(("left out",), ())]
    return [*rows(found.patches, to), *rows(found.pairs, to)]


@of("BisectorPatch")
def _(patch, to):
    """A rectangle of the surface, its degree exchanged with the curves."""
    return [(("surface", degrees(patch.value.degree, to)), box) for box in to.boxes(patch.sides)]


@of("SinglePair")
def _(pair, to):
    return [((str(pair.solutions), cause_of(pair, to)), tuple(to.both(pair.s, pair.t)))]


@of("LineComponent")
def _(lines, to):
    return of_pairs("lines", cause_of(lines, to), lines, to)


@of("PlaneComponent")
def _(planes, to):
    return of_pairs("planes", cause_of(planes, to), planes, to)


@of("PoleCurve")
def _(poles, to):
    return of_pairs("poles", "certain" if poles.certain else "", poles, to)


def of_pairs(word, cause, found, to):
    """A curve of pairs by the degree of its equation, on the rectangle of a patch."""
    equation = found.equation
    degree = equation and tuple(max(powers[k] for powers, _ in equation.terms) for k in (0, 1))
    return [((word, cause, degrees(degree or (), to)), box) for box in to.boxes(found.sides)]


def degrees(pair, to):
    """A degree in both parameters."""
    return " × ".join(map(str, pair[::-1] if to.image.exchanged else pair))


def cause_of(found, to):
    """A cause, which names the curves by their numbers."""
    words = str(found.cause).split()
    other = {"first": "second", "second": "first"} if to.image.exchanged else {}
    return " ".join(other.get(each, each) for each in words)


# ---- surfaces


@of("SurfacePlaces")
def _(answer, to):
    undecided = [(("undecided",), ())] * bool(answer.undecided)
    parts = dict.fromkeys(marked("everywhere", rows(answer.everywhere, to)))
    return [*rows(tuple(answer), to), *parts, *undecided]


@of("NearestOnSurface")
def _(found, to):
    """The places, the distance, and the feet, in order where they are rational."""
    feet = [(("foot",), tuple(to.image.motion.of_known([known(x) for x in foot]))) for foot in found.feet]
    return [*ROWS["SurfacePlaces"](found, to), *feet, ((), (known(found.squared).times(to.scale**2),))]


@of("LineMeeting")
def _(found, to):
    """A common point, and the parameter of the line, which is moved with the surface."""
    return [(words, (*numbers, known(found.parameter))) for words, numbers in rows(found.zero, to)]


@of("CommonZero")
def _(zero, to):
    return [((str(zero.kind), str(zero.multiplicity)), tuple(to.both(zero.first, zero.second)))]


@of("ZeroCurves")
def _(found, to):
    parts = dict.fromkeys(marked("everywhere", rows(found.everywhere, to)))
    undecided = [(("undecided",), ())] * bool(found.undecided)
    return [*rows((*found.lines, *found.curves, *found.points), to), *parts, *undecided]


@of("Place")
def _(place, to):
    return [(("place",), tuple(at(place, to)))]


def at(place, to):
    """The parameters of a place."""
    try:
        return to.both(*place.spot)
    except ReachError:
        return []


@of("Umbilic")
def _(found, to):
    words = str(found.kind), "one-sided" if found.one_sided else ""
    return [(words, tuple(at(found.place, to)))]


@of("SurfacePart")
def _(part, to):
    """A rectangle or an edge, patch by patch of the image; curves inside are told elsewhere."""
    if part.along_curve:
        return [(("along a curve",), ())]
    return [(("part",), box) for box in to.boxes(part.sides)]


@of("ZeroComponent")
def _(curve, to):
    """The kind of a curve, its arcs, and the ends of these."""
    closed = [along for along in Along if closed_in(to.asked, along)]
    arcs = curve.arcs(to.asked.domain, closed)
    loops = sum(closed for *_, closed in arcs)
    ends = [end for *pair, closed in arcs if not closed for end in pair]
    words = str(curve.shape), f"{len(arcs)} arcs", f"{loops} loops"
    return [(words, ()), *[((str(curve.shape), "end"), () if x is None else tuple(to.both(*x))) for x in ends]]


@of("ZeroLine")
def _(line, to):
    words = to.along(line.along), "closed" if line.closed else "", "one-sided" if line.one_sided else ""
    return [(words, numbers) for numbers in on_line(line, line.value, to)]


def on_line(line, value, to):
    """The value of an isoparametric line and the ends of its parts between knots."""
    k = line.along.direction
    own = to.parameter(value, 1 - k)
    return [(own, *map(known, part)) for part in to.interval(line.interval, k)]


@of("Pole")
def _(pole, to):
    words = "pole", to.along(pole.along), str(pole.gap)
    point = () if pole.point is None else tuple(map(known, to.image.motion(pole.point)))
    return [(words, (*numbers, *point)) for numbers in on_line(pole, pole.value, to)]


@of("SurfaceJoint")
def _(joint, to):
    """A line along which nothing can be seen is none; one without tangent planes is a pole."""
    if joint.kind in ("continuous curvature", "no tangent plane"):
        return []
    k = 1 - joint.across.direction
    angle = () if joint.angle is None else (known(joint.angle.cosine),)
    value = to.parameter(joint.value, 1 - k)
    words = "joint", to.along(joint.across), str(joint.kind)
    return [(words, (value, *map(known, part), *angle)) for part in to.interval(joint.interval, k)]


@of("RecognizedPart")
def _(found, to):
    """The shape of patches where it is exact by its numbers, each patch by its rectangle."""
    words = str(found.kind), "whole" if found.whole else "", "exact" if found.exact else "near"
    numbers = of_shape(found.shape, to) if found.exact else ()
    boxes = [box for patch in found.patches for box in to.boxes(to.asked.w.patch(*patch))]
    return [(words, (*numbers, *box)) for box in boxes]


@of("PatchInspection")
def _(patch, to):
    """The kind of a patch, and its constant curvature."""
    words = str(patch.kind), "minimal" if patch.minimal else ""
    curvature = () if patch.curvature is None else (known(patch.curvature).times(1 / to.scale**2),)
    return [(words, (*box, *curvature)) for box in to.boxes(patch.sides)]


@of("Ridges")
def _(found, to):
    parts = [
        ((f"stationary {count}", *words), box) for part, count in found.stationary for words, box in rows(part, to)
    ]
    undecided = [(("undecided",), ())] * bool(found.undecided)
    return [*rows(found.curves, to), *rows(found.lines, to), *parts, *undecided]


# ---- maps of the plane


@of("MapKind")
def _(kind, to):
    return [((str(OTHER_SIGN.get(kind, kind) if to.image.turns_over else kind),), ())]


# ---- comparison


def same(found, expected):
    """Whether two lists of rows are the same up to their order."""
    if Counter(words for words, _ in found) != Counter(words for words, _ in expected):
        return False
    left = list(found)
    for row in expected:
        match = next((x for x in left if agree(x, row)), None)
        if match is None:
            return False
        left.remove(match)
    return True


def agree(one, other):
    """Whether two rows say the same."""
    return (
        one[0] == other[0]
        and len(one[1]) == len(other[1])
        and all(x.agrees(y) for x, y in zip(one[1], other[1], strict=True))
    )


def shown(found):
    """Rows as text, in an order."""
    return sorted(f"{' '.join(filter(None, words))} ({', '.join(map(str, numbers))})" for words, numbers in found)
