"""Bisectors as data: control nets as exact text, ends of pieces as certified roots."""

from __future__ import annotations

from functools import singledispatch
from typing import Any, cast

from flint import arb

from exactspline.display.data import Data, picked, plain
from exactspline.display.pair_data import real_data
from exactspline.display.serialize import decimal_of, piece_data
from exactspline.errors import ReachError
from exactspline.geometry.bisector.components import (
    Branch,
    LineComponent,
    LinePiece,
    PairEquation,
    PlaneComponent,
    PoleCurve,
    RealZeros,
    SinglePair,
    Solutions,
)
from exactspline.geometry.bisector.flats import Flat
from exactspline.geometry.bisector.plane_curves import PlaneBisector
from exactspline.geometry.bisector.point_and_curve import PointBisector
from exactspline.geometry.bisector.root_lines import Coordinate, RootLines
from exactspline.geometry.bisector.trimmed import TrimmedBisector, TrimmedPiece
from exactspline.geometry.bisector.two_curves import BisectorPatch, CurveBisector
from exactspline.geometry.registry import REGISTRY
from exactspline.language.rational import Rational
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq, text
from exactspline.questions.entry import Of
from exactspline.reals.real import Real, real
from exactspline.roots.of_polynomials import Parameter
from exactspline.roots.root import Root, knot_root
from exactspline.splines.common import with_common_knots
from exactspline.splines.lowest_terms import SplineVector
from exactspline.splines.tensor import TensorSpline

NAMES = "st"


# ---- two curves


def curve_bisector_data(bisector: CurveBisector, digits: int) -> Data:
    """The whole bisector of two curves: its surface by homogeneous control nets ``(w x, w y, w z, w)`` with rows along
    s, and lines, planes, single pairs and poles.
    """
    missing = [{"sides": plain(sides), "reason": reason} for sides, reason in bisector.missing]
    answers = {name: entry.answer(bisector) for name, entry in REGISTRY[Of.PAIR].items()}
    return {
        "kind": "bisector of two curves",
        "variant": str(bisector.variant),
        "missing": missing,
        "left_out": list(bisector.left_out),
        "complete": not bisector.left_out,
    } | {name: [_solution_data(each, digits) for each in cast(tuple[object, ...], x)] for name, x in answers.items()}


@singledispatch
def _solution_data(part: object, digits: int) -> Data:
    """A part of the bisector as data."""
    raise AssertionError(f"{type(part).__name__} is not a part of a bisector")


@_solution_data.register
def _patch_data(patch: BisectorPatch, digits: int) -> Data:
    numerator, w = patch.value.elevated()
    assert isinstance(numerator, Vector)  # a surface
    return picked(patch, "sides") | control_net([*numerator, w])


def control_net(splines: list[TensorSpline]) -> Data:
    """The control nets of several splines over their common knots."""
    splines = with_common_knots(splines)
    first = splines[0]
    rows = zip(*[x.control_points for x in splines], strict=True)
    return {
        "degree": list(first.degree),
        "knots": [plain(knots) for knots in first.knots],
        "homogeneous_control_net": [plain(list(zip(*row, strict=True))) for row in rows],
    }


def equation_data(equation: PairEquation) -> Data:
    """An equation between s and t: as text, and its integers ``[power of s, power of t, integer]``."""
    return {"text": f"{equation.text} = 0", "terms": [[i, j, text(x)] for (i, j), x in equation.terms]}


@_solution_data.register
def _line_data(line: LineComponent, digits: int) -> Data:
    return {
        "pairs": str(line.correspondence),
        **picked(line, "cause", "sides"),
        "equation": line.equation and equation_data(line.equation),
        "fixed": line.fixed and parameter_data(line.fixed, digits),
        "over_root": line.over_root and _root_lines_data(line.over_root, digits),
        "pieces": [_line_piece_data(one, digits) for one in line.pieces],
        "branches": [
            _branch_data(branch, digits) | _flat_data(line.line(*branch.sample, digits), digits)
            for branch in line.real.branches
        ],
    } | _limits_data(line.real, digits)


def _line_piece_data(one: LinePiece, digits: int) -> Data:
    """A piece with low, high, and the control points of directrix and generator over the whole segment."""
    interval = one.surface.directrix.denominator.domain
    if isinstance(one.other, Rational):
        other: Any = piece_data(interval, one.other)
    else:
        other = None if one.other is None else parameter_data(one.other, digits)
    return {
        "parameter": NAMES[one.of],
        "low": parameter_data(one.low, digits),
        "high": parameter_data(one.high, digits),
        "other": other,
        "directrix": piece_data(interval, one.surface.directrix),
        "generator": piece_data(interval, one.surface.generator.vector),
        "poles": [parameter_data(root, digits) for root in one.poles],
    }


def _root_lines_data(lines: RootLines, digits: int) -> Data:
    """Control points in the field of an irrational parameter: a coordinate is a list, the coefficients of the powers 0,
    1, 2, … of the parameter.
    """

    def net(part: tuple[Coordinate, ...], field: str) -> Data:
        first = part[0][0]
        rows = zip(*[zip(*[f.control_points for f in coordinate], strict=True) for coordinate in part], strict=True)
        return {"degree": first.degree, "knots": plain(first.knots), field: plain(list(rows))}

    return {
        "parameter": NAMES[lines.of],
        "low": parameter_data(lines.interval[0], digits),
        "high": parameter_data(lines.interval[1], digits),
        "directrix": net(lines.directrix, "homogeneous_control_points"),
        "generator": net(lines.generator, "control_points"),
        "poles": None if lines.poles is None else [parameter_data(root, digits) for root in lines.poles],
    }


def _branch_data(branch: Branch, digits: int) -> Data:
    return {
        "low": parameter_data(branch.low, digits),
        "high": parameter_data(branch.high, digits),
        "index": branch.index,
        "sample": [parameter_data(x, digits) for x in branch.sample],
    }


def _limits_data(real: RealZeros, digits: int) -> Data:
    return {
        "ends": [[parameter_data(x, digits) for x in place] for place in real.ends],
        "nodes": [[parameter_data(x, digits) for x in place] for place in real.nodes],
    }


@_solution_data.register
def _plane_data(plane: PlaneComponent, digits: int) -> Data:
    return {
        **picked(plane, "solutions", "cause", "sides"),
        "equation": plane.equation and equation_data(plane.equation),
        "parameter": NAMES[plane.of],
        "intervals": [[parameter_data(x, digits) for x in interval] for interval in plane.intervals],
        "fixed": None if plane.fixed is None else parameter_data(plane.fixed, digits),
        "branches": [_branch_data(branch, digits) for branch in plane.real.branches],
    } | _limits_data(plane.real, digits)


@_solution_data.register
def _pair_data(pair: SinglePair, digits: int) -> Data:
    head: Data = {
        "s": parameter_data(pair.s, digits),
        "t": parameter_data(pair.t, digits),
        **picked(pair, "solutions", "cause", "sides"),
    }
    if pair.solutions is Solutions.SPACE:
        return head
    return head | _flat_data(pair.exact or pair.enclosed(digits), digits, plane=pair.solutions is Solutions.PLANE)


def _flat_data(flat: Flat[Any], digits: int, *, plane: bool = False) -> Data:
    """A point, and the direction of a line or the normal of a plane: exact text, or decimals with all digits
    correct.
    """
    return {
        "point": [_number(x, digits) for x in flat.point],
        "normal" if plane else "direction": [_number(x, digits) for x in flat.direction],
    }


def _number(x: mpq | arb, digits: int) -> str:
    return str(x.str(digits, radius=False)) if isinstance(x, arb) else text(x)


@_solution_data.register
def _pole_data(pole: PoleCurve, digits: int) -> Data:
    return picked(pole, "sides") | {"equation": equation_data(pole.equation), "certain": pole.certain}


def plane_bisector_data(bisector: PlaneBisector, digits: int) -> Data:
    """The pairs of the bisector of two plane curves: arcs, single pairs, lines, and rectangles all of whose pairs it
    has, each from ``start`` to ``end`` by the parameters of both curves; and the boxes in which they are true feet.
    """
    pairs, trimmed = bisector.pairs, bisector.trimmed
    pieces: list[tuple[str, object, object]] = [
        ("loop of pairs" if arc.closed else "arc of pairs", arc.start, arc.end) for arc in pairs.arcs
    ]
    pieces += [("pair", (x.first, x.second), None) for x in pairs.points]
    rectangles = [("line of pairs", line.box) for line in pairs.lines]
    rectangles += [("rectangle of pairs", (part.sides[0], part.sides[1])) for part in pairs.everywhere]
    pieces += [(kind, (a, c), (b, d)) for kind, ((a, b), (c, d)) in rectangles]
    return {
        "kind": "bisector of two plane curves",
        "pieces": [
            {"piece": kind, "start": _place(start, digits), "end": _place(end, digits)} for kind, start, end in pieces
        ],
        "true_feet": plain(trimmed.kept),
        "undecided": plain(trimmed.undecided),
        "missing": [{"sides": plain(sides), "reason": "the pairs are not decided"} for sides in bisector.missing],
        "complete": not bisector.missing,
    }


def _place(place: Any, digits: int) -> list[Data] | None:
    return None if place is None else [real_data(x if isinstance(x, Real) else real(x), digits) for x in place]


# ---- a point and a curve


def point_bisector_data(bisector: PointBisector, digits: int) -> Data:
    """The pieces of the ruled bisector of a point and a curve: directrix and generator by homogeneous control
    points.
    """
    pieces = [
        {
            **picked(piece, "interval", "moved"),
            "directrix": piece_data(piece.interval, piece.surface.directrix),
            "generator": piece_data(piece.interval, piece.surface.generator),
        }
        for piece in bisector.pieces
    ]
    return {
        "kind": "ruled bisector",
        "variant": bisector.variant,
        "pieces": pieces,
        "singular": [parameter_data(root, digits) for root in bisector.singular],
        "missing": [{"interval": [text(a), text(b)], "reason": reason} for (a, b), reason in bisector.missing],
    }


def trimmed_data(bisector: TrimmedBisector, digits: int) -> Data:
    """The pieces of the true bisector of a point and a plane curve."""
    pieces = [_trimmed_piece_data(piece, digits) for piece in bisector.pieces]
    return {"kind": "trimmed bisector", "pieces": pieces, "missing": list(bisector.missing)} | {
        "left_out": list(bisector.left_out),
        "complete": not bisector.left_out,
    }


def _trimmed_piece_data(piece: TrimmedPiece, digits: int) -> Data:
    """A piece by its control points: over [low, high] where both are rational. Otherwise over the whole segment, and
    ``cut`` means that the piece is only the part from low to high.
    """
    ends = {"low": parameter_data(piece.low, digits), "high": parameter_data(piece.high, digits)}
    head = {"piece": str(piece.kind)} | ({} if piece.foot is None else {"foot": text(piece.foot)}) | ends
    exact = piece.restricted()
    if exact is None:
        return head | {"cut": True} | piece_data(piece.value.denominator.domain, piece.value)
    return head | piece_data(exact.denominator.domain, exact)


def parameter_data(t: Parameter, digits: int) -> Data:
    """A parameter: exact text where it is rational, otherwise its minimal polynomial (constant term first; where
    factoring is out of reach a multiple of it); an interval that isolates it, and its leading digits.
    """
    root = t if isinstance(t, Root) else knot_root(t)
    low, high = root.refine(digits)
    head: Data = {
        "parameter": None if root.exact is None else text(root.exact),
        "interval": [text(low), text(high)],
        "decimal": decimal_of(root, digits),
    }
    if root.exact is not None:
        return head
    try:
        polynomial = root.minimal_polynomial()
    except ReachError:
        polynomial = root.polynomial
    return head | {"polynomial": [text(x) for x in polynomial]}


# ---- as text


def degree_of(value: SplineVector | Rational[TensorSpline]) -> str:
    """The degree of a piece, as text."""
    d = value.degree
    return f"{d[0]} × {d[1]}" if isinstance(d, tuple) else str(d)


def control_points(value: Rational[TensorSpline]) -> int:
    """The number of control points of a patch."""
    top = value.vector[0].elevated_to(value.denominator)
    m, n = top.control_point_counts
    return int(m * n)


def shown(t: Parameter, digits: int) -> str:
    """A parameter as text: exact where it is short, otherwise to a given number of digits."""
    exact = t if not isinstance(t, Root) else t.exact
    if exact is not None and len(text(exact)) <= digits + 2:
        return text(exact)
    return decimal_of(t if isinstance(t, Root) else knot_root(t), digits)
