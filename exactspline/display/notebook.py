"""Objects as HTML: facts, tables, small pictures."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import singledispatch
from html import escape
from io import BytesIO
from itertools import groupby, pairwise
from typing import Any, cast

from exactspline.display.answer_forms import answer_table
from exactspline.display.evidence import worded
from exactspline.display.latex import fraction, mathematics
from exactspline.display.latex_prose import quoted
from exactspline.display.ledger import fields
from exactspline.display.numbers import Numbers
from exactspline.display.plot.canvas import BLUE, GREY, SILVER, Point, in_words, polygons, settle
from exactspline.display.tables import Grid, Verdicts, breakable, found_text, true_text
from exactspline.display.theorem import ReadingAlong, along_html
from exactspline.errors import ExactSplineError, counted
from exactspline.geometry.analysis.ask import kind_of
from exactspline.geometry.analysis.curves import Analysis
from exactspline.geometry.analysis.planar_maps import MapInspection
from exactspline.geometry.analysis.surfaces import SurfaceInspection
from exactspline.geometry.derived.derive import Derived
from exactspline.hooks import Written, named
from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Side
from exactspline.questions.entry import questions_of
from exactspline.reals.real import Real
from exactspline.roots.answers import Answer
from exactspline.roots.root import Root
from exactspline.roots.zero_set import ZeroSet
from exactspline.splines.bspline import BSpline
from exactspline.splines.control_points import greville_abscissae
from exactspline.splines.lowest_terms import control_point_count
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.claim import Claim
from exactspline.verification.ledger import Row
from exactspline.verification.statement import Erratum, Statement, sides
from exactspline.verification.statement import Side as ClaimSide

#: The number of entries of a list that are written out, and the number of control points above which a vector is only
#: described.
SHOWN, LONG = 8, 6
#: The most things of an answer in a table.
LISTED = 100
#: The fields of a statement that follow its formulas.
SAID = ("claimed", "found", "factor", "witness", "verdict")
#: The printers for objects of packages that are imported only when they are used, by the class: the printer, whose name
#: ends in the form.
BESIDE = {
    "exactspline.extras.teaching.topics.Exercise": "exactspline.extras.teaching.display.exercises:task_html",
    "exactspline.extras.teaching.triangles.Triangle": "exactspline.extras.teaching.display.exercises:scheme_latex",
    "exactspline.extras.teaching.triangles.ProductTable": "exactspline.extras.teaching.display.exercises:scheme_latex",
}
#: Dots per inch of pictures in a notebook.
RESOLUTION = 80
#: A long number as a decimal.
_short = Numbers()


@singledispatch
def html(x: object) -> str | None:
    """Return HTML for a notebook, or None for an object that is shown as LaTeX or text."""
    return None


def _facts(title: str, lines: list[tuple[str, str]], picture: str = "") -> str:
    """Lines of HTML next to a picture."""
    rows = "".join(
        f'<tr><td style="text-align:left;white-space:nowrap">{escape(name)}</td>'
        f'<td style="text-align:left;width:100%">{value}</td></tr>'
        for name, value in lines
    )
    table = f'<div style="flex:1;min-width:15em"><b>{escape(title)}</b><table>{rows}</table></div>'
    return f'<div style="display:flex;flex-wrap:wrap;gap:1em;align-items:center;margin:.8em 0">{picture}{table}</div>'


def _numbers(values: Iterable[mpq]) -> str:
    """The first exact numbers of a list, long ones shortened."""
    values = list(values)
    parts = [_short(x) for x in values[:SHOWN]]
    return escape(", ".join(parts)) + (f", … ({len(values)})" if len(values) > SHOWN else "")


@html.register
def _(f: BSpline) -> str:
    points = f"{len(f.control_points)}: {_numbers(f.control_points)}"
    inner = f", smallest continuity {min(f.continuity)}" if f.continuity else ""
    lines = [
        ("domain", str(f.domain)),
        ("control points", points),
        ("knots", _numbers(f.knots.knots)),
        ("segments", f"{len(f.mesh)}{inner}"),
    ]
    return _facts(f"B-spline function of degree {f.degree}", lines, _graph_picture(f))


@html.register
def _(c: Nurbs) -> str:
    kind = "polynomial" if c.polynomial else "rational"
    points = escape("; ".join("(" + ", ".join(_short(x) for x in p) + ")" for p in c.control_points[:SHOWN]))
    more = " …" if len(c.control_points) > SHOWN else ""
    lines = [
        ("domain", f"{c.domain}, {counted(c.segments, 'segment')}"),
        ("control points", f"{len(c.control_points)}: {points}{more}"),
    ]
    lines += [] if c.polynomial else [("weights", _numbers(c.weights))]
    lines += [("knots", _numbers(c.knots.knots))] + ([("note", escape(c.note))] if c.note else [])
    return _facts(f"{c.name or 'curve'}: {kind} curve of degree {c.degree} in R{c.dimension}", lines, _curve_picture(c))


def _described(value: Any) -> str:
    """A short description of a vector or quotient of splines; empty for other values of a formula."""
    if isinstance(value, RuledSurface):
        return f"ruled surface; {_described(value.joined)}" if _described(value.joined) else ""
    scalars = [*_parts(value.numerator), value.denominator] if isinstance(value, Rational) else _parts(value)
    if not all(isinstance(s, BSpline) for s in scalars):
        return ""
    what = "quotient of B-splines" if isinstance(value, Rational) else "vector of B-splines"
    where = f"on {scalars[0].domain}, {counted(len(scalars[0].mesh), 'segment')}"
    return f"{what}, degree {value.degree}, {control_point_count(value)} control points, {where}"


def _parts(value: Any) -> list[Any]:
    return list(value) if isinstance(value, Vector) else [value]


@html.register(Vector)
@html.register(Rational)
@html.register(RuledSurface)
def _(value: Any) -> str | None:
    described = _described(value)
    return _facts(described, []) if described and mathematics(value) is None else None


def _isolating(root: Root) -> str:
    """The ends of an isolating interval; if it is so narrow that they look alike, one end and a bound on the width."""
    low, high = _short(root.low), _short(root.high)
    return f"{low} … {high}" if low != high else f"{low}, narrower than {10 * float(root.high - root.low):.0e}"


@html.register
def _(zero_set: ZeroSet) -> str:
    rows = []
    for root in zero_set:
        left, right = ({None: "end", 1: "+", -1: "−", 0: "0"}[s] for s in root.signs)
        interval, where = _isolating(root) if root.exact is None else "", "knot" if root.at_knot else ""
        rows.append((f"${mathematics(root)}$", root.multiplicity, f"{left} to {right}", interval, where))
    jumps = [
        f"jump at {_short(x.parameter)}: from {_short(x.left.value)} to {_short(x.right.value)}" for x in zero_set.jumps
    ]
    zero = [f"zero on {' and '.join(f'[{_short(a)}, {_short(b)}]' for a, b in x.parts)}" for x in zero_set.intervals]
    extra = "".join(f"<div>{escape(text)}</div>" for text in (*jumps, *zero))
    title = repr(zero_set)[1:-1]
    columns = ["root", "multiplicity", "sign", "isolating interval", "where"]
    return (Grid(columns, rows, title).html() if rows else f"<b>{escape(title)}</b>") + extra


@html.register
def _(g: Grid) -> str:
    return g.html()


@html.register
def _(answer: Written) -> str | None:
    if isinstance(answer, Real) or (isinstance(answer, Answer) and len(answer) > LISTED):
        return None
    try:
        sheet = answer_table(answer)
    except ExactSplineError:
        return None
    return Grid(sheet.columns, sheet.rows, sheet.title).html()


@html.register
def _(r: Row) -> str:
    return Verdicts([r]).html()


@html.register
def _(d: Derived) -> str:
    lines = [(f"on {p.interval}", escape(short(p.value))) for p in d.pieces]
    return _facts(
        f"{d.name}, {d.variant}",
        lines
        + [(f"missing on {interval}", escape(reason.words)) for interval, reason in d.missing]
        + [(f"at {pole.shortly()}", "a pole") for pole in d.poles],
    )


@html.register(Analysis)
@html.register(SurfaceInspection)
@html.register(MapInspection)
def _(found: Any) -> str:
    of = found.curve if isinstance(found, Analysis) else found.surface
    lines = [
        (name.replace("_", " "), escape(repr(entry.answer(found))))
        for name, entry in questions_of(type(found)).items()
        if entry.about.reported and kind_of(found) in entry.about.of
    ]
    return _facts(repr(of)[1:-1], lines, _curve_picture(of) if isinstance(found, Analysis) else "")


def _side_lines(sides: tuple[ClaimSide, ...]) -> list[tuple[str, str]]:
    return [
        (side.role, f"$${escape(side.latex)}$${escape(side.source)}, degree {escape(side.degrees)}") for side in sides
    ]


@html.register
def _(c: Claim) -> str:
    return _facts(f"{c.id}, {c.source}", [*_claim_lines(c, c.latex), *_side_lines(sides(c)), ("recorded", c.expected)])


def _claim_lines(c: Claim, statement_latex: str) -> list[tuple[str, str]]:
    return [("statement", escape(c.statement)), ("", f"$${escape(statement_latex)}$$"), ("assumes", escape(c.assumed))]


@html.register
def _(e: Erratum) -> str:
    lines: list[tuple[str, str]] = []
    for each in e.statements:
        lines += [
            ("printed", escape(each.place) + (f": “{escape(quoted(each.words))}”" if each.words else "")),
            ("which says", escape(each.statement)),
            ("found", escape(found_text(each))),
            ("witness", breakable(worded(each.witness, Numbers()))),
            ("check", f"<code>{'<br>'.join(map(breakable, each.check))}</code>"),
        ]
    lines += [("true", escape(true_text(each))) for each in e.truth] + [("why", escape(line)) for line in e.why]
    return _facts(f"{e.id}: {e.title}", [line for line in lines if line[1]])


@html.register
def _(read: ReadingAlong) -> str:
    return along_html(read)


@html.register
def _(s: Statement) -> str:
    said = [(name, breakable(value)) for name, value in fields(s) if name in SAID]
    lines = [*_claim_lines(s.claim, s.latex), *_side_lines(s.sides), *said]
    return _facts(f"{s.claim.id}, {s.claim.source}", lines)


def short(x: object) -> str:
    """Return one line for IPython: the `repr`, or the description of a long vector.

    >>> short(BSpline.bezier([0, 1])), short(BSpline.bezier([0] * 50))
    ('BSpline(1, [0, 0, 1, 1], [0, 1])', '<BSpline: degree 49, 50 control points on [0, 1], 1 segment>')
    """
    described = _described(x) if isinstance(x, (Vector, Rational, RuledSurface)) else ""
    if described and (isinstance(x, RuledSurface) or control_point_count(cast(Any, x)) > LONG):
        return f"<{described}>"
    return repr(x)


def load_ipython_extension(shell: object) -> None:
    """Make ``%load_ext exactspline.display`` show exact numbers as fractions, tuples of exact numbers as points,
    figures as pictures, triangles of the teaching package as formulas, and exercises as HTML.
    """
    formatters = cast(Any, shell).display_formatter.formatters
    for module, name in (("matplotlib.figure", "Figure"), ("matplotlib.axes._axes", "Axes")):
        formatters["image/png"].for_type_by_name(module, name, _png)
    for shown, printer in BESIDE.items():
        (module, _, name), form = shown.rpartition("."), printer.rpartition("_")[2]
        formatters[f"text/{form}"].for_type_by_name(module, name, lambda x, printer=printer: named(printer)(x))
    formatter = formatters["text/latex"]
    formatter.for_type(type(mpq()), lambda x: f"${fraction(x)}$")
    formatter.for_type(
        tuple,
        lambda t: (
            "$(" + r",\ ".join(fraction(x) for x in t) + ")$" if t and all(type(x) is type(mpq()) for x in t) else None
        ),
    )


def _png(figure_or_axes: Any) -> tuple[bytes, dict[str, str]]:
    """The picture with a description in words for blind readers, both next to it and inside the file."""
    figure = getattr(figure_or_axes, "figure", figure_or_axes)
    stream = BytesIO()
    settle(figure)
    alt = in_words(figure)
    figure.savefig(stream, format="png", dpi=RESOLUTION, metadata={"Description": alt})
    return stream.getvalue(), {"alt": alt}


# ---- small pictures
#
# Exact numbers become decimals only when they are written.


#: The size in pixels, the margin, and the numbers of samples: in total, and at least per segment.
WIDTH, HEIGHT, MARGIN, SAMPLES, LEAST = 240, 150, 8, 160, 6
#: A graph this many times lower than its control polygon is shown without the polygon.
POLYGON_ABOVE_GRAPH = 20
#: The colour of the letters around the picture: dark on a light page, light on a dark one.
INK = "currentColor"
#: The projection of a point in space: the coefficients of x, y, z for the two coordinates of the picture.
VIEW = ((mpq(4, 5), mpq(-3, 5), mpq(0)), (mpq(-1, 4), mpq(-1, 3), mpq(9, 10)))


def _curve_picture(curve: Nurbs) -> str:
    """A curve in the plane or (in a fixed view) in space, with its control polygon; empty for other dimensions.

    >>> from exactspline.interchange.examples import example
    >>> _curve_picture(example("circle")).count("<polyline")
    5
    """
    if curve.dimension not in (2, 3):
        return ""
    runs = [[_seen(curve(t, side)) for t, side in part] for part in _parameters(curve.breakpoints)]
    control = [_seen(p) if w else None for p, w in zip(curve.control_points, curve.weights, strict=True)]
    return _svg(runs, polygons(curve.knots.knots, curve.degree, control), "a curve and its control polygon", equal=True)


def _graph_picture(f: BSpline) -> str:
    """The graph of a scalar spline with its control polygon, unless the polygon is far larger than the graph; empty for
    a degree below 0.
    """
    if f.degree < 0:
        return ""
    runs: list[list[Point]] = [[(t, f(t, side)) for t, side in part] for part in _parameters(f.breakpoints)]
    points: list[Point | None] = list(zip(greville_abscissae(f), f.control_points, strict=True))
    top = max(abs(y) for run in runs for _, y in run)
    highest = max(map(abs, f.control_points))
    legs = polygons(f.knots.knots, f.degree, points) if highest <= POLYGON_ABOVE_GRAPH * top else []
    a, b = f.domain
    shown = "the graph of a function and its control polygon" if legs else "the graph of a function"
    return _svg(runs, legs, shown, equal=False, axis=[(a, mpq(0)), (b, mpq(0))])


def _parameters(breaks: Sequence[mpq]) -> Iterator[list[tuple[mpq, str]]]:
    count = max(LEAST, SAMPLES // (len(breaks) - 1))
    for a, b in pairwise(breaks):
        yield [*[(a + (b - a) * mpq(k, count), Side.RIGHT) for k in range(count)], (b, Side.LEFT)]


def _seen(point: Sequence[mpq]) -> Point:
    if len(point) == 2:
        return tuple(point)
    return tuple(sum((c * x for c, x in zip(row, point, strict=True)), mpq(0)) for row in VIEW)


def _svg(
    runs: list[list[Point]], legs: list[list[Point]], shown: str, *, equal: bool, axis: Sequence[Point] = ()
) -> str:
    columns = list(zip(*[p for run in (*runs, *legs, axis) for p in run], strict=True))
    low, high = [min(c) for c in columns], [max(c) for c in columns]
    sizes = [b - a or mpq(1) for a, b in zip(low, high, strict=True)]
    scales = [mpq(WIDTH - 2 * MARGIN) / sizes[0], mpq(HEIGHT - 2 * MARGIN) / sizes[1]]
    if equal:
        scales = [min(scales)] * 2

    def at(p: Point) -> tuple[str, str]:
        x, y = (MARGIN + s * (v - a) for s, v, a in zip(scales, p, low, strict=True))
        return _decimal(x), _decimal(HEIGHT - y)

    parts = [_line([at(p) for p in axis], GREY, "0.5")] if axis else []
    for run in legs:
        parts.append(_line([at(p) for p in run], SILVER, "1"))
    for i, run in enumerate(runs):
        parts.append(_line([at(p) for p, _ in groupby(run)], GREY if i % 2 else INK, "1.8"))
    for x, y in (at(p) for run in legs for p in run):
        parts.append(f'<circle cx="{x}" cy="{y}" r="2" fill="{BLUE}"/>')
    size = f'width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}"'
    label = f'role="img" aria-label="{shown}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size} {label} style="max-width:100%">{"".join(parts)}</svg>'


def _line(points: Sequence[tuple[str, str]], color: str, width: str) -> str:
    path = " ".join(f"{x},{y}" for x, y in points)
    return f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}"/>'


def _decimal(x: mpq) -> str:
    tenths = int(x * 10 + mpq(1, 2))
    return f"{tenths // 10}.{tenths % 10}"
