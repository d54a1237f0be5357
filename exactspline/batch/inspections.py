"""The questions that a sweep asks about every curve, and their answers as data of a line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from exactspline.batch.lines import EVERYWHERE, Found
from exactspline.errors import DomainError, ExactSplineError, ReachError, ShapeError, as_texts
from exactspline.geometry.analysis.ask import read_as
from exactspline.geometry.analysis.curves import QUESTIONS, analyse, questions_about
from exactspline.geometry.curves.joints import Joint
from exactspline.geometry.curves.kinds import Feature
from exactspline.geometry.curves.values import curvature, point_at
from exactspline.geometry.pairs.intersections import Intersections
from exactspline.numbers.exact import mpq, mpz
from exactspline.questions.answers import Described
from exactspline.questions.entry import Answered, Entry, Of
from exactspline.questions.takes import name_of, unknown
from exactspline.reals.real import Real, real
from exactspline.roots.answers import CurvePiece, Places
from exactspline.roots.root import Root
from exactspline.roots.values import exact_place
from exactspline.splines.nurbs import Nurbs

#: The types of answers of the questions that sweeps ask.
LISTED = (Answered.PLACES, Answered.JOINTS, Answered.PIECES, Answered.DESCRIBED, Answered.PAIRS)
#: The control points of a cubic of each kind, with which arguments are tried.
TRIED: dict[Of, list[tuple[int, ...]]] = {
    Of.PLANE_CURVE: [(0, 0), (1, 0), (1, 1), (2, 1)],
    Of.SPACE_CURVE: [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)],
}
#: The default questions.
USUAL = ("inflections", "curvature_extrema", "corners")
#: Digits computed beyond those shown: an interval as wide as the last decimal place rarely lies between two
#: neighbouring decimals.
BEYOND = 4


def asked_by_sweeps() -> dict[str, Entry]:
    """The questions that a sweep can ask: those whose answers are lists. An argument follows after a colon.

    >>> "inflections" in asked_by_sweeps(), "plane" in asked_by_sweeps()
    (True, False)
    """
    return {name: q for name, q in QUESTIONS.items() if q.about.answered in LISTED}


def entry_of(asked: str) -> tuple[Entry, str]:
    """The question and its argument in a text such as ``offset_cusps:1/10``.

    Raises `QuestionError` with the nearest names, and for a missing or superfluous argument.
    """
    known = asked_by_sweeps()
    name = name_of(asked)
    if name not in known:
        raise unknown(name, known)
    return known[name], read_as(known[name], asked)[0]


def checked_names(names: Iterable[str]) -> tuple[str, ...]:
    """The questions, each once; ``all`` stands for all of them without an argument
    that are answered quickly.

    >>> checked_names(["corners", "offset_cusps:1/10", "corners"])
    ('corners', 'offset_cusps:1/10')

    Raises the errors of `entry_of`, and an error for an argument that no curve takes.
    """
    without = [name for name, q in asked_by_sweeps().items() if not (q.about.takes or q.about.on_request)]
    chosen = dict[str, None]()
    for asked in as_texts(names, "names of questions", "the name of a question"):
        if asked != "all":
            _check_argument(*entry_of(asked))
        chosen |= dict.fromkeys(without if asked == "all" else [asked])
    return tuple(chosen)


def _check_argument(entry: Entry, argument: str) -> None:
    """Ask a question with its argument about a curve of each kind, so that an argument that no curve takes is refused
    once, and not on every line of a sweep.
    """
    errors = []
    for of in entry.about.of if argument else ():
        try:
            entry.answer(analyse(Nurbs(3, [0] * 4 + [1] * 4, TRIED[of])), argument)
        except ExactSplineError as error:
            errors.append(error.at(f"{entry.name}:{argument}"))
    if errors and len(errors) == len(entry.about.of):
        raise errors[0]


def inspected(curve: Nurbs, names: Iterable[str], digits: int, values: bool = False) -> dict[str, tuple[Found, ...]]:
    """The answers to questions about a curve, by name; questions that do not apply to curves of its dimension are
    skipped. With `values` points have their coordinates and the curvature.

    >>> from exactspline import example
    >>> for each in inspected(example("six_segment_cubic"), ["inflections"], 3)["inflections"]:
    ...     print(each.kind, each.parameter, each.low, each.high)
    inflection None 2.804 2.805
    inflection None 3.270 3.271
    >>> (whole,) = inspected(example("circle"), ["curvature_extrema"], 3)["curvature_extrema"]
    >>> whole.kind, whole.low, whole.high
    ('everywhere', '0', '4')

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    requested = list(names)
    known = questions_about(curve) if requested else {}
    entries = {asked: entry_of(asked) for asked in requested}
    return {
        asked: tuple(_listed(entry.answer(analyse(curve), argument), digits, curve if values else None))
        for asked, (entry, argument) in entries.items()
        if entry.name in known
    }


def _listed(answer: Any, digits: int, curve: Nurbs | None) -> Iterator[Found]:
    """The points and pieces that were found; points have their values if the curve is given."""
    if isinstance(answer, Intersections):
        yield from _pairs(answer, digits, curve)
        return
    for each in answer:
        found = _found(each, digits)
        if curve is None or isinstance(each, CurvePiece):
            yield found
        elif isinstance(each, Described):
            (low, high), *_ = each.piece.parts
            yield replace(found, **_coordinates(curve, (low + high) / 2))
        else:
            place = each.parameter if isinstance(each, Joint) else exact_place(each.root)
            yield replace(found, **_coordinates(curve, place), curvature=_curvature(curve, place))
    if isinstance(answer, Places):
        for piece in answer.everywhere:
            yield _piece(piece, EVERYWHERE)


def _pairs(answer: Intersections, digits: int, curve: Nurbs | None) -> Iterator[Found]:
    """The pairs of parameters at which one curve meets itself, and of the arcs that it traverses twice."""
    if answer.undecided:
        raise ReachError(f"self-intersections: not decided: {'; '.join(answer.undecided)}", remedy="divide the curve")
    for each in answer:
        (low, high), other = (enclosed(x, digits) for x in (each.first, each.second))
        found = Found(str(each.kind), low if low == high else None, low, high, other_low=other[0], other_high=other[1])
        shown = () if curve is None else map(_double, map(real, each.point))
        point: dict[str, Any] = dict(zip("xyz", shown, strict=False))
        yield replace(found, **point)
    for arc in answer.everywhere:
        (low, high), other = (
            (enclosed(min(ends), digits)[0], enclosed(max(ends), digits)[1]) for ends in (arc.first, arc.second)
        )
        yield Found(EVERYWHERE, None, low, high, other_low=other[0], other_high=other[1])


def _found(each: Feature | Joint | CurvePiece | Described, digits: int) -> Found:
    if isinstance(each, Described):
        possible = each.facts.get("robust") is False
        found = _piece(each.piece, f"possible {each.kind}" if possible else str(each.kind))
        other = [str(x) for x in each.values.get("second", ())]
        return replace(found, other_low=other[0], other_high=other[1]) if other else found
    if isinstance(each, CurvePiece):
        return _piece(each, "piece across the seam" if each.across_seam else "piece")
    if isinstance(each, Joint):
        return Found(str(each.kind), str(each.parameter), str(each.parameter), str(each.parameter))
    low, high = enclosed(each.root, digits)
    return Found(str(each.kind), low if low == high else None, low, high)


def _coordinates(curve: Nurbs, place: mpq | Real) -> dict[str, Any]:
    return dict(zip("xyz", map(_double, point_at(curve, place)), strict=False))


def _curvature(curve: Nurbs, place: mpq | Real) -> float | None:
    """The curvature as a double; None if γ′ = 0, and at a knot at which the two sides have different curvatures."""
    joint = None if isinstance(place, Real) else analyse(curve).joint(place)
    if joint is not None and (not joint.tangent_continuous or joint.curvatures is not None):
        return None
    try:
        return _double(curvature(curve, place))
    except (DomainError, ShapeError):
        return None


def _double(value: Real) -> float | None:
    try:
        return value.double()
    except OverflowError:
        return None


def _piece(piece: CurvePiece, kind: str) -> Found:
    return Found(kind, None, str(piece.start), str(piece.end))


def enclosed(place: Real, digits: int) -> tuple[str, str]:
    """The location of a root, independent of earlier refinements: a rational root exactly, an irrational one between
    two neighbouring decimals.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 1)
    >>> [enclosed(root, 4) for root in zeros((3 * t - 1) * (2 * t * t - 1))]
    [('1/3', '1/3'), ('0.7071', '0.7072')]
    """
    scale = mpz(10) ** digits
    if place.exact is not None:
        return str(place.exact), str(place.exact)
    more = digits + BEYOND
    enclosure = place.refine if isinstance(place, Root) else place.enclosure
    near = (place.low, place.high) if isinstance(place, Root) else enclosure(more)
    while (below := _neighbour(place, *near, scale)) is None:
        near = enclosure(more)
        more += 10
    return _decimal(below, digits), _decimal(below + 1, digits)


def _neighbour(place: Real, low: mpq, high: mpq, scale: mpz) -> int | None:
    """The integer k such that an irrational number between two given numbers lies in [k, k + 1] divided by a scale;
    None if the given numbers are too far apart.
    """
    below, last = (int(end * scale // 1) for end in (low, high))
    if last - below > 2:
        return None
    while below < last and place > mpq(below + 1, scale):
        below += 1
    return below


def _decimal(scaled: int, digits: int) -> str:
    """An integer divided by a power of ten, as a decimal."""
    sign, text = "-" if scaled < 0 else "", str(abs(scaled)).rjust(digits + 1, "0")
    return f"{sign}{text[:-digits]}.{text[-digits:]}" if digits else f"{sign}{text}"
