"""What the pages ask of the library: text in, text out; every answer is computed by the library itself."""

import json
from collections.abc import Callable
from typing import Any

import flint  # noqa: F401  # every answer needs it: loaded before the first question
from mpmath import mp, nstr

import exactspline as xs
from exactspline.splines.control_points import greville_abscissae

DIGITS = 15


def answer(question: str, data: str) -> str:
    """The answer to a question as JSON: ``{"answer": …}``, or ``{"error": …}`` in the library's words."""
    try:
        return json.dumps({"answer": QUESTIONS[question](json.loads(data))})
    except xs.ExactSplineError as problem:
        return json.dumps({"error": str(problem)})
    except RecursionError:
        return json.dumps({"error": "this is nested too deeply"})


def features(data: dict[str, Any]) -> dict[str, Any]:
    """Inflections, extrema of curvature, singular points and corners of a plane curve, each certified."""
    curve = _curve(data)
    found = xs.analyse(curve)
    groups = {"inflection": found.inflections, "extremum": found.critical_points, "singular": found.singular_points}
    listed = [_feature(curve, group, f) for group, members in groups.items() for f in members]
    joints = [
        {"kind": str(joint.kind), "t": str(joint.parameter), "point": _point(curve, joint.parameter)}
        for joint in found.joints
        if not joint.tangent_continuous
    ]
    pieces = {
        "straight": found.straight_pieces,
        "of constant curvature": found.constant_pieces,
        "standing still": found.standing_pieces,
    }
    return {
        "features": sorted(listed, key=lambda f: f["double"]),
        "joints": joints,
        "pieces": [{"kind": kind, "where": str(piece)} for kind, members in pieces.items() for piece in members],
        "degree": curve.degree,
        "segments": curve.segments,
        "polynomial": curve.polynomial,
    }


def digits(data: dict[str, Any]) -> dict[str, str]:
    """One feature's parameter to more digits, and its exact value or its polynomial."""
    curve = _curve(data["curve"])
    found = xs.analyse(curve)
    group = {"inflection": found.inflections, "extremum": found.critical_points, "singular": found.singular_points}
    root = group[data["group"]][data["index"]].root
    exact = root.exact
    return {
        "decimal": _decimal(root, data["digits"]),
        "exact": str(exact) if exact is not None else "",
        "polynomial": "" if exact is not None else str(root.minimal_polynomial()),
    }


def forms(data: dict[str, Any]) -> list[dict[str, Any]]:
    """The forms whose zeros are the extrema of curvature: their degrees, control polygons and zeros."""
    curve = _curve(data["curve"])
    told = []
    for variant in data["variants"]:
        solved = xs.analyse(curve).zero_form("critical_curvature", variant)
        form, found = solved.form, solved.zeros
        largest = max((abs(c) for c in form.control_points), default=0) or 1
        told.append(
            {
                "variant": variant,
                "degree": form.degree,
                "controls": len(form.control_points),
                "knots": [float(u) for u in form.knots],
                "abscissae": [float(u) for u in greville_abscissae(form)],
                "ordinates": [float(c / largest) for c in form.control_points],
                "zeros": [float(root) for root in found.roots],
            }
        )
    return told


def reduce(data: dict[str, Any]) -> dict[str, Any]:
    """What cancels in a formula that was typed, for all curves."""
    from exactspline.papers import formulas_by_module
    from exactspline.papers.formula_check import formulas_of
    from exactspline.readings.printing import TextPrinter

    made = formulas_of(data["text"], "your formula", formulas_by_module(), plain=True)
    if not made:
        raise xs.ExactSplineError("there is no function here", remedy="write def name(c): return …")
    formula = list(made.values())[-1]
    found = xs.reduction(formula, dimension=data["dimension"], polynomial=data["polynomial"])
    return {
        "name": formula.name,
        "text": TextPrinter()(xs.readings.trace(formula, data["dimension"])),
        "parts": [part.data() for part in found.parts],
    }


def bisector(data: dict[str, Any]) -> dict[str, Any]:
    """The trimmed bisector of a curve and a point: its pieces with certified ends, drawn in doubles."""
    curve = _curve(data["curve"])
    found = xs.bisector(curve, data["point"])
    return {"pieces": [_piece(curve, piece) for piece in found.pieces], "missing": list(found.missing)}


def pair(data: dict[str, Any]) -> dict[str, Any]:
    """The common points of two plane curves; the pairs of one abscissa, of one ordinate, and of the bisector if it is
    asked for, drawn in doubles.
    """
    from exactspline.geometry.bisectors.plane_pair import PlanePair

    first, second = _curve(data["first"]), _curve(data["second"])
    found = xs.intersections(first, second)
    runs = [xs.zero_curve(f).sampled() for f in PlanePair.of_curves(first, second).chord]
    pairs = xs.bisector(first, second).pairs.sampled() if data["bisector"] else []
    return {
        "points": [_common_point(point) for point in found],
        "arcs": [str(arc) for arc in found.everywhere],
        "undecided": list(found.undecided),
        "across": _drawn(runs[0]),
        "up": _drawn(runs[1]),
        "bisector": _drawn(pairs),
    }


def _common_point(point: Any) -> dict[str, Any]:
    place = point.first, point.second
    s, t = (str(x.exact) if x.exact is not None else x.decimal(DIGITS) for x in place)
    drawn = [float(x) for x in point.point]
    told = {"kind": str(point.kind), "multiplicity": point.multiplicity, "point": drawn, "place": [*map(float, place)]}
    return told | {"s": s, "t": t}


def _drawn(runs: list[list[Any]]) -> list[list[list[float]]]:
    return [[[float(x) for x in place] for place in run] for run in runs]


def triangle(data: dict[str, Any]) -> dict[str, Any]:
    """De Boor's triangle at a share of the domain: every entry exactly, and in doubles to draw it."""
    curve = _curve(data["curve"])
    low, high = curve.domain
    t = low + (high - low) * xs.rational(data["share"])
    found = xs.teaching.de_boor_triangle(curve, t)
    return {
        "t": str(t),
        "span": [str(u) for u in found.span],
        "first": found.first,
        "weighted": found.rational,
        "columns": [[[str(x) for x in row] for row in column] for column in found.columns],
        "ratios": [[str(s) for s in shares] for shares in found.ratios],
        "drawn": [[[float(x) for x in found.cartesian(row)] for row in column] for column in found.columns],
        "tip": [str(x) for x in found.tip],
        "inside": low < t < high and curve.knots.multiplicity(t) < curve.degree,
    }


def refined(data: dict[str, Any]) -> dict[str, Any]:
    """The same curve by more control points: a knot inserted, or the degree raised."""
    curve = _curve(data["curve"])
    if "knot" in data:
        found = xs.teaching.insertion_triangle(curve, data["knot"])
        rows = [[*found.cartesian(row)] for row in found.made]
        weights = [row[-1] if found.rational else 1 for row in found.made]
        made = xs.Nurbs(curve.degree, found.knots, rows, weights)
    else:
        made = curve.elevate_degree()
    return {
        "same": made == curve,
        "curve": {
            "degree": made.degree,
            "knots": [str(u) for u in made.knots],
            "points": [[str(x) for x in point] for point in made.control_points],
            "weights": [str(w) for w in made.weights],
        },
    }


def product(data: dict[str, Any]) -> dict[str, Any]:
    """The product of two of the functions x, y, w of a curve, over the segment that holds a share of the domain."""
    curve = _curve(data["curve"])
    functions = dict(zip("xy", curve.p, strict=True)) | {"w": curve.w}
    low, high = curve.domain
    t = low + (high - low) * xs.rational(data["share"])
    left, right = (functions[name] for name in data["factors"])
    tables = xs.teaching.product_tables(left, right)
    table = next(one for one in tables if t <= one.span[1])
    f = left * right
    return {
        "span": [str(u) for u in table.span],
        "left": [str(x) for x in table.left],
        "right": [str(x) for x in table.right],
        "table": [[str(x) for x in row] for row in table.table],
        "sums": [str(x) for x in table.sums],
        "points": [str(x) for x in table.points],
        "same": f.restrict(*table.span) == xs.BSpline.bezier(table.points, *table.span),
    }


def _piece(curve: Any, piece: Any, count: int = 48) -> dict[str, Any]:
    low, high = (end.low if isinstance(end, xs.Root) else end for end in (piece.low, piece.high))
    drawn = []
    # the ends themselves may be infinite, or irrational: the picture stays just inside
    for k in range(count):
        t = low + (high - low) * (2 * k + 1) / (2 * count)
        foot = curve(t if piece.foot is None else piece.foot)
        drawn.append([[float(x) for x in piece(t)], [float(x) for x in foot]])
    ends = [_decimal(end, DIGITS) if isinstance(end, xs.Root) else str(end) for end in (piece.low, piece.high)]
    degree = max(piece.value.numerator.degree, piece.value.denominator.degree)
    return {"kind": str(piece.kind), "ends": ends, "degree": degree, "drawn": drawn}


def _decimal(root: Any, count: int) -> str:
    with mp.workdps(count + 10):
        return str(nstr(root.mpf(count + 2), count))


def _feature(curve: Any, group: str, feature: Any) -> dict[str, Any]:
    root = feature.root
    point = xs.floats(xs.evaluate(curve, root))
    told = {
        "group": group,
        "kind": str(feature.kind),
        "t": str(root.exact) if root.exact is not None else _decimal(root, DIGITS),
        "exact": root.exact is not None,
        "double": float(root),
        "point": list(point),
    }
    if group != "singular":
        told["curvature"] = float(xs.curvature(curve, root))
    return told


def _point(curve: Any, t: Any) -> list[float]:
    return [float(x) for x in curve(t)]


def _curve(data: dict[str, Any]) -> Any:
    return xs.Nurbs(data["degree"], data["knots"], data["points"], data["weights"])


QUESTIONS: dict[str, Callable[[Any], Any]] = {
    "features": features,
    "digits": digits,
    "forms": forms,
    "reduce": reduce,
    "bisector": bisector,
    "pair": pair,
    "triangle": triangle,
    "refined": refined,
    "product": product,
}
