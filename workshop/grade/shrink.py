"""The smallest integer example of a defect: chosen among the cases that show it, then simplified as long as it
persists.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice

from exactspline.errors import ExactSplineError
from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs
from exactspline.testing import Case
from workshop.grade.judge import judged
from workshop.grade.runner import Judged, Truths, Worker, request_data
from workshop.grade.tolerance import tolerated

#: The number of smaller curves tried for one defect.
TRIES = 250


@dataclass(frozen=True)
class Defect:
    """Wrong answers of one library to one question, of one kind, and the smallest example."""

    library: str
    question: str
    outcome: str
    times: int
    example: Judged


def defects_of(library: str, wrong: Sequence[Judged], tries: int = TRIES) -> list[Defect]:
    """The defects behind wrong answers, one per question and kind of mistake."""
    groups: dict[tuple[str, str], list[Judged]] = {}
    for one in wrong:
        groups.setdefault((one.question, one.verdict.outcome), []).append(one)
    if not groups:
        return []
    worker, truths = Worker(library), Truths(None)
    try:
        return [
            Defect(library, question, outcome, len(group), _smallest(worker, truths, min(group, key=size_of), tries))
            for (question, outcome), group in groups.items()
        ]
    finally:
        worker.close()


def size_of(one: Judged) -> tuple[bool, int, int]:
    """The sorting key of examples: integers first, then few and short numbers."""
    curve = one.case.curve
    numbers = [*(x for p in curve.control_points for x in p), *curve.weights]
    whole = all(x.denominator == 1 for x in numbers)
    bits = sum(x.numerator.bit_length() + x.denominator.bit_length() - 1 for x in (*numbers, one.case.parameter))
    return not whole, len(numbers), bits


def _smallest(worker: Worker, truths: Truths, example: Judged, tries: int) -> Judged:
    """The example made smaller, step by step, as long as the library makes the same mistake."""
    remaining = tries
    while remaining > 0:
        for curve, parameter in islice(smaller_cases(example.case), remaining):
            remaining -= 1
            tried = _judged(worker, truths, example, curve, parameter)
            if (
                tried is not None
                and tried.verdict.outcome == example.verdict.outcome
                and size_of(tried) < size_of(example)
            ):
                example = tried
                break
        else:
            break
    return example


def _judged(worker: Worker, truths: Truths, example: Judged, curve: Nurbs, parameter: mpq) -> Judged | None:
    case = Case(example.case.key, example.case.family, curve, parameter, example.case.link, example.case.note)
    answers = truths.of(case, [example.question])
    if example.question not in answers:
        return None
    replies = worker.ask(request_data(case), [example.question])
    if example.question not in replies:
        return None
    answer, reply = answers[example.question], replies[example.question]
    verdict = judged(case, example.question, answer, reply)
    verdict = tolerated(worker.library, case, example.question, verdict, answer, reply.get("answer"))
    return Judged(case, example.question, verdict)


def smaller_cases(case: Case) -> Iterator[tuple[Nurbs, mpq]]:
    """Curves with a simpler parameter, without a segment, or with one simpler coordinate."""
    curve, t = case.curve, case.parameter
    a, b = curve.domain
    middle = (a + b) / 2
    if t != middle and middle not in curve.breakpoints:
        yield curve, middle
    points = [list(p) for p in curve.control_points]
    weights = None if curve.polynomial else list(curve.weights)
    for i, point in enumerate(points):
        for j, x in enumerate(point):
            for simpler in dict.fromkeys((mpq(0), mpq(1), mpq(-1), mpq((x / 2) // 1), mpq(x // 1))):
                if simpler.numerator.bit_length() + simpler.denominator.bit_length() >= (
                    x.numerator.bit_length() + x.denominator.bit_length()
                ):
                    continue
                changed = [[simpler if (k, m) == (i, j) else y for m, y in enumerate(p)] for k, p in enumerate(points)]
                try:
                    yield Nurbs(curve.degree, curve.knots, changed, weights, name=curve.name), t
                except ExactSplineError:
                    continue
