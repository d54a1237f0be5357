"""The knots of B-spline curves and surfaces of a STEP file: listed, or those that the standard defines for a kind."""

from __future__ import annotations

from exactspline.errors import CurveFileError, counted
from exactspline.interchange.numbers import whole
from exactspline.interchange.step_records import StepFile, Value
from exactspline.numbers.exact import mpq


def listed_knots(file: StepFile, multiplicities: Value, values: Value) -> list[mpq]:
    """Knots that are listed with their multiplicities."""
    counts, knots = [whole(text) for text in file.texts(multiplicities)], file.numbers(values)
    if len(counts) != len(knots) or any(count < 0 for count in counts):
        raise CurveFileError(
            f"{counted(len(counts), 'multiplicity')} for {counted(len(knots), 'knot')}", remedy="give one per knot"
        )
    file.collector.count(sum(counts))
    return [knot for knot, times in zip(knots, counts, strict=True) for _ in range(times)]


def standard_knots(kind: str, degree: int, count: int) -> list[mpq]:
    """The knots that ISO 10303-42 defines for the kinds of splines that do not list them: their keywords begin with
    UNIFORM, QUASI_UNIFORM or BEZIER.
    """
    if kind.startswith("UNIFORM"):
        return [mpq(i - degree) for i in range(count + degree + 1)]
    times = degree if kind.startswith("BEZIER") else 1
    if degree < 1 or count <= degree or (count - 1 - degree) % times:
        raise CurveFileError(
            f"{counted(count, 'point')} for degree {degree}",
            remedy="this kind of spline needs a different number of points",
        )
    inner = [mpq(i // times + 1) for i in range(count - 1 - degree)]
    return [mpq(0)] * (degree + 1) + inner + [mpq((count - 1 - degree) // times + 1)] * (degree + 1)
