"""The questions that a sweep asks of every curve, and their answers as data of a line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from exactspline.batch.lines import EVERYWHERE, Found
from exactspline.errors import FormulaError, as_texts, nearest
from exactspline.geometry.analysis import QUESTIONS, analyse, questions_about
from exactspline.geometry.joints import Joint
from exactspline.geometry.kinds import Feature
from exactspline.numbers.exact import mpq, mpz
from exactspline.questions.answers import CurvePiece, Places
from exactspline.questions.entry import Answered, Entry
from exactspline.roots.root import Root
from exactspline.splines.nurbs import Nurbs

if TYPE_CHECKING:
    from exactspline.geometry.many_roots import LateRoot, Point, Settled

#: The types of answers of the questions that sweeps ask.
LISTED = (Answered.PLACES, Answered.JOINTS, Answered.PIECES)
#: The default questions.
USUAL = ("inflections", "curvature_extrema", "corners")
#: Digits computed beyond those shown: an interval as wide as the last decimal place rarely lies between two
#: neighbouring decimals.
BEYOND = 4


def asked_by_sweeps() -> dict[str, Entry]:
    """The questions that a sweep can ask: those without an argument whose answers are lists.

    >>> "inflections" in asked_by_sweeps(), "turning_points" in asked_by_sweeps()
    (True, False)
    """
    return {name: q for name, q in QUESTIONS.items() if q.about.answered in LISTED and not q.about.argument}


def checked_names(names: Iterable[str]) -> tuple[str, ...]:
    """The names of questions, each once; ``all`` stands for all of them.

    Raises `FormulaError` with the nearest names.
    """
    known, chosen = asked_by_sweeps(), dict[str, None]()
    for name in as_texts(names, "names of questions", "the name of a question"):
        if name != "all" and name not in known:
            raise FormulaError(f"there is no question called {name!r}", remedy=nearest(name, [*known, "all"]))
        chosen |= dict.fromkeys(known if name == "all" else [name])
    return tuple(chosen)


def inspected(
    curve: Nurbs, names: Iterable[str], digits: int, settled: Settled | None = None
) -> dict[str, tuple[Found, ...]]:
    """The answers to questions about a curve, by name; those that do not apply to curves of its dimension are skipped.
    `settled` is what the certified filter decided about it.

    >>> from exactspline import example
    >>> for each in inspected(example("six_segment_cubic"), ["inflections"], 3)["inflections"]:
    ...     print(each.kind, each.parameter, each.low, each.high)
    inflection None 2.804 2.805
    inflection None 3.270 3.271
    >>> inspected(example("circle"), ["curvature_extrema"], 3)["curvature_extrema"]
    (Found(kind='everywhere', parameter=None, low='0', high='4'),)

    Raises `ShapeError` for a curve that is neither in the plane nor in space.
    """
    requested = list(names)
    known = questions_about(curve) if requested else {}
    return {name: tuple(_listed(_answer(curve, known[name], settled), digits)) for name in requested if name in known}


def _answer(curve: Nurbs, asked: Entry, settled: Settled | None) -> Any:
    if settled is not None and asked.about.known is not None:
        return asked.about.known(settled)
    return asked.answer(analyse(curve))


def _listed(answer: Any, digits: int) -> Iterator[Found]:
    for each in answer:
        yield _found(each, digits)
    if isinstance(answer, Places):
        for piece in answer.everywhere:
            yield _piece(piece, EVERYWHERE)


def _found(each: Point | Feature | Joint | CurvePiece, digits: int) -> Found:
    if isinstance(each, CurvePiece):
        return _piece(each, "piece across the seam" if each.across_seam else "piece")
    if isinstance(each, Joint):
        return Found(str(each.kind), str(each.parameter), str(each.parameter), str(each.parameter))
    low, high = enclosed(each.place if isinstance(each, tuple) else each.root, digits)
    return Found(str(each.kind), low if low == high else None, low, high)


def _piece(piece: CurvePiece, kind: str) -> Found:
    return Found(kind, None, str(piece.start), str(piece.end))


def enclosed(place: Root | LateRoot, digits: int) -> tuple[str, str]:
    """The location of a root, independent of how far it was refined before: a rational root exactly, an irrational one
    between two neighbouring decimals.

    >>> from exactspline import BSpline, zeros
    >>> t = BSpline.identity(0, 1)
    >>> [enclosed(root, 4) for root in zeros((3 * t - 1) * (2 * t * t - 1))]
    [('1/3', '1/3'), ('0.7071', '0.7072')]
    """
    scale = mpz(10) ** digits
    if not isinstance(place, Root):
        if (below := _neighbour(place.low, place.high, scale)) is not None:
            return _decimal(below, digits), _decimal(below + 1, digits)
        place = place.root
    if place.exact is not None:
        return str(place.exact), str(place.exact)
    more = digits + BEYOND
    while (below := _neighbour(*place.refine(more), scale)) is None:
        more += 10
    return _decimal(below, digits), _decimal(below + 1, digits)


def _neighbour(low: mpq, high: mpq, scale: mpz) -> int | None:
    """The integer k for which [low, high] lies in [k, k + 1] divided by a scale; None where there is none."""
    below = low.numerator * scale // low.denominator
    return int(below) if high.numerator * scale <= (below + 1) * high.denominator else None


def _decimal(scaled: int, digits: int) -> str:
    """An integer divided by a power of ten, as a decimal."""
    sign, text = "-" if scaled < 0 else "", str(abs(scaled)).rjust(digits + 1, "0")
    return f"{sign}{text[:-digits]}.{text[-digits:]}" if digits else f"{sign}{text}"
