"""The ways by which one question about one curve is answered: alone, after all other questions, without the extension,
by the command, in a sweep, in a batch. All of them must say the same: what is found, exact numbers, doubles bit for
bit; intervals must contain what is found.
"""

import json
from contextlib import contextmanager
from unittest import mock

import numpy as np
from gmpy2 import mpq

from exactspline import ExactSplineError, Nurbs, NurbsSurface, features_of_curves, sweep, write
from exactspline.batch.inspections import LISTED
from exactspline.errors import OpenError, ReachError
from exactspline.geometry.analysis.ask import REGISTRY, asked_of
from exactspline.geometry.analysis.pairs import CurvePair
from exactspline.geometry.analysis.surface_pairs import SurfacePair
from exactspline.geometry.pairs.regions import Region
from exactspline.programs import accelerator, certain_pairs
from exactspline.questions.entry import Of
from exactspline.tables import to_dict
from tests.support.changes import moved_curve
from tests.support.command import run
from tests.support.images import Image, rings
from tests.support.matrix import TAKEN, Itself, ask, facts_of, kind_of, questions, text_of
from tests.support.transport import Refused, To, rows
from workshop.vectors.items import items


def again(thing):
    """The same curve, pair of curves, or surface, of which nothing is known."""
    if isinstance(thing, CurvePair):
        return CurvePair(*map(again, thing.curves))
    if isinstance(thing, SurfacePair):
        return SurfacePair(*map(again, thing.surfaces))
    if isinstance(thing, Region):
        return Region(map(again, thing.curves), thing.rule)
    if isinstance(thing, NurbsSurface):
        return NurbsSurface(thing.degree, *map(list, thing.knots), thing.control_points, thing.weights)
    curve = thing
    return Nurbs(curve.degree, list(curve.knots), list(curve.control_points), list(curve.weights))


def said(curve, text):
    """What is said: what was found, exact numbers and doubles by their names, facts."""
    try:
        found = items(curve, text)
    except ExactSplineError as error:
        return type(error).__name__
    return [[x.what, {name: number(value) for name, value in x.values.items()}, plain(x.facts)] for x in found]


def number(value):
    """The exact value as text where it has one, and the double."""
    return [closed(value), repr(value.double())]


def closed(value):
    """A rational number, or one with a square root, as text; None where it is neither, or out of reach."""
    try:
        return value.closed_form
    except (ReachError, OpenError):
        return None


def plain(facts):
    """Facts as JSON has them."""
    return json.loads(json.dumps(dict(facts), default=str))


def after_others(curve, asking):
    """The answers to several questions, with their givens, after all of them and all others were asked."""
    other = again(curve)
    for question in questions(kind_of(other)):
        if not question.about.takes:
            said(other, question.name)
    return [said(other, text_of(entry, given)) for entry, given in [*asking, *asking]][len(asking) :]


@contextmanager
def plain_python():
    """By exact arithmetic and what is written in Python alone."""
    with mock.patch.object(accelerator, "filter_curve", None), mock.patch.object(certain_pairs, "filter_pair", None):
        yield


def without_extension(curve, entry, given):
    """By exact arithmetic and what is written in Python alone."""
    with plain_python():
        return said(again(curve), text_of(entry, given))


def same_by_command(curve, entry, given, folder):
    """Whether the command says, as JSON, what Python says; a refusal has its words elsewhere."""
    write(curve, folder / "curve.json")
    asked = text_of(entry, given)
    return as_data(curve, asked) == commanded("inspect", folder / "curve.json", "--ask", asked)


def pair_by_commands(pair, entry, given, folder):
    """What Python and both commands say of two curves: `between`, and `inspect` of the first one."""
    files = [folder / "first.json", folder / "second.json"]
    for curve, file in zip(pair.curves, files, strict=True):
        write(curve, file)
    asked = text_of(entry, given)
    found = [as_data(pair, asked), commanded("between", *files, "--ask", asked)]
    if entry.name not in REGISTRY[Of.PLANE_CURVE]:
        of_one = ",".join([f"{entry.name}:{files[1]}", *asked.partition(":")[2:]]).rstrip(",")
        found.append(commanded("inspect", files[0], "--ask", of_one))
    return found


def commanded(*arguments):
    """The answer that a command gives as JSON; that it was refused."""
    done = run(*arguments, "--json")
    assert done.returncode in (0, 2), done.stderr
    return "refused" if done.returncode else without_bounds(json.loads(done.stdout)["rows"][0]["answer"])


def as_data(thing, asked):
    """The answer by Python, asked alone, as JSON has it; that it was refused."""
    return asked_as_data(again(thing), asked)


def asked_as_data(thing, asked):
    """The same of a thing of which more may be known."""
    about = facts_of(Itself(thing))
    try:
        return without_bounds(json.loads(json.dumps(to_dict(about, asked, 12)["answer"])))
    except ExactSplineError:
        return "refused"


def after_all_others(thing, asking):
    """The answers to several questions, with their givens, in another order, after all of them were asked."""
    other = again(thing)
    for _ in range(2):
        found = {text_of(*each): asked_as_data(other, text_of(*each)) for each in reversed(asking)}
    return [found[text_of(*each)] for each in asking]


def without_bounds(data):
    """Data without the bounds of numbers, which may be narrower for who has asked before."""
    if isinstance(data, dict):
        return {name: without_bounds(each) for name, each in data.items() if name not in ("low", "high")}
    return [without_bounds(each) for each in data] if isinstance(data, list) else data


def swept(curve, entry, given):
    """What a sweep finds: kinds and intervals of parameters; None for questions that it does not ask."""
    if entry.about.answered not in LISTED:
        return None
    (line,) = sweep([again(curve)], find=[text_of(entry, given)])
    return [(x.kind, mpq(x.low), mpq(x.high)) for x in line.found[text_of(entry, given)]]


def same_by_sweep(by_python, found):
    """Whether a sweep finds the same, in the same order: its kinds, and each parameter in its interval; of a piece a
    sweep says in its kind that it runs over the seam.
    """
    if isinstance(by_python, str) or len(by_python) != len(found):
        return False
    pairs = zip(by_python, found, strict=True)
    return all(
        what == kind.removesuffix(" across the seam") and within(values, low, high)
        for (what, values, _), (kind, low, high) in pairs
    )


def within(values, low, high):
    """Whether a parameter, exact or as a double, is in an interval, up to the rounding of the double."""
    if "parameter" not in values:
        return True
    exact, double = values["parameter"]
    x = mpq(float(double)) if exact is None or "√" in exact else mpq(exact)
    slack = 0 if x == low else abs(x) / 2**52 + mpq(1, 2**1000)
    return low - slack <= x <= high + slack


def batch_rows(curve):
    """Inflections and extrema by `analyse`, as batches tell them: kinds, and the roots."""
    facts = facts_of(Itself(curve))
    return [(str(f.kind), f.root) for own in (facts.inflections, facts.curvature_extrema) for f in own]


def same_by_batch(curve):
    """Whether `features_of_curves`, of curves and of arrays of doubles, tells what `analyse` tells."""
    batches = [features_of_curves([curve, again(curve)])]
    if doubles := as_doubles(curve):
        batches.append(features_of_curves(*doubles))
    return all(batch_agrees(batch, curve) for batch in batches)


def batch_agrees(batch, curve):
    """Whether every row of a batch about the curve, twice, has its root inside."""
    expected = batch_rows(curve)
    for i in range(2):
        rows = np.flatnonzero(batch.curve == i)
        if [str(batch.kind[k]) for k in rows] != [kind for kind, _ in expected]:
            return False
        ends = [(mpq(float(batch.low[k])), mpq(float(batch.high[k]))) for k in rows]
        if not all(low <= root <= high for (low, high), (_, root) in zip(ends, expected, strict=True)):
            return False
    return True


def as_doubles(curve):
    """Points and weights of a Bézier curve over [0, 1] twice, as arrays; None for other curves."""
    numbers = [x for p in curve.control_points for x in p] + list(curve.weights)
    if (
        curve.segments > 1
        or tuple(curve.domain) != (0, 1)
        or len(curve.knots) != 2 * curve.degree + 2
        or curve.degree < 1
    ):
        return None
    if any(mpq(float(x)) != x for x in numbers):
        return None
    points = [[tuple(map(float, p)) for p in curve.control_points]] * 2
    return points, [list(map(float, curve.weights))] * 2


def in_space(curve):
    """A plane curve as one in the plane z = 0."""
    points = [(*p, mpq(0)) for p in curve.control_points]
    return Nurbs(curve.degree, list(curve.knots), points, list(curve.weights))


#: What is asked of a curve in another plane and does not go with the dimension; frames, joints with signed angles and
#: extrema of κ do.
IN_ANY_PLANE = (
    "self_intersections",
    "winding_number",
    "inflections",
    "singular_points",
    "straight_pieces",
    "nearest",
    "length",
    "length_between",
    "at_length",
    "value",
)


def in_another_plane(curve, entry, given, motion):
    """What is said of a plane curve that was moved into another plane of space, and what should be; as rows."""
    moved, image = moved_curve(curve, motion), Image(motion=motion)
    others = tuple(TAKEN[each].moved(text, image, 2) for each, text in zip(entry.about.takes, given, strict=True))
    expected = rows(ask(curve, entry.name, given), To(curve, image, rings(curve), 2, entry.name, given))
    try:
        answer = asked_of(moved, text_of(entry, others)).answer
    except ExactSplineError as error:
        answer = Refused(type(error).__name__)
    found = rows(answer, To(moved, Image(), rings(moved), 3, entry.name, others))
    return [[(without_extrema(words), numbers) for words, numbers in told] for told in (found, expected)]


def without_extrema(words):
    """Without what is said of |κ|, which in space is κ."""
    return tuple(word for word in words if not word.startswith("of |κ|"))


def pair_in_another_plane(pair, motion):
    """The same of the common points of two curves."""
    moved = CurvePair(*(moved_curve(curve, motion) for curve in pair.curves))
    expected = rows(pair.intersections, To(pair, Image(motion=motion), rings(pair), 2, "intersections"))
    return rows(moved.intersections, To(moved, Image(), rings(moved), 3, "intersections")), expected


def in_the_plane_z_0(curve, entry, given):
    """The question about a plane curve, asked of the same curve in the plane z = 0."""
    return said(in_space(curve), text_of(entry, given))
