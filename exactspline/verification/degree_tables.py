"""Degrees and numbers of control points of formulas and constructions, on one curve and on the generic curve."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache, partial
from random import Random
from time import perf_counter
from typing import Any

from exactspline.errors import (
    FormulaError,
    InapplicableError,
    ReachError,
    ReductionError,
    ShapeError,
    as_instance,
    as_integer,
    as_items,
    counted,
    shown,
)
from exactspline.geometry.derived.constructions import (
    Construction,
    Variant,
    all_constructions,
    construction,
    constructions_for,
)
from exactspline.geometry.derived.derive import derive
from exactspline.language.arguments import Curve, Pair
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import CURVE, PAIR, PLANAR_MAP, PLANE, SPACE, SURFACE, TABLE, Kind
from exactspline.language.operand import Parameter
from exactspline.language.rational import Rational
from exactspline.language.ruled import joined
from exactspline.language.surface_kind import BOTH, Surface
from exactspline.language.vector import Vector
from exactspline.one_line import OneLine, one_line
from exactspline.papers import Paper, all_formulas, find, known_as
from exactspline.polynomials.cost import within_seconds
from exactspline.readings.degree import Degree, DegreeReading, parse_degree
from exactspline.readings.differential_order import is_polynomial
from exactspline.readings.printing import print_text
from exactspline.readings.tree import trace
from exactspline.splines.bspline import BSpline
from exactspline.splines.lowest_terms import control_point_count, lowest_terms, true_degree_or_none
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.tensor_patches import Degrees
from exactspline.splines.type_checks import curve_of
from exactspline.symbolic.covariants import TrueDegree, degree_at, degree_on_patch, graded, true_degree
from exactspline.symbolic.reduction import Part, reduction
from exactspline.symbolic.substitution import substitute
from exactspline.verification.generic_proof import attained, lowest_degree, reduction_of, symbolic_minimum, witness


@dataclass(frozen=True, repr=False)
class Measure:
    """The degrees and the size of one formula on one curve.

    ``nominal`` symbolic in d, ``represented`` and ``true`` as numbers (−1 for a formula that vanishes identically; no
    true degree where a denominator vanishes on a whole segment), ``control_points`` of the representation.
    """

    formula: str
    nominal: Degree
    represented: int
    true: int | None
    control_points: int

    @one_line
    def __repr__(self) -> str:
        degrees = f"degree {self.nominal}, here {self.represented}, true degree {self.true}"
        return f"<Measure {self.formula}: {degrees}, {counted(self.control_points, 'control point')}>"


def measure(formula: Formula, curve: Nurbs) -> Measure:
    """Return the degrees and the number of control points of a formula on a curve.

    >>> from exactspline.interchange.examples import example
    >>> from exactspline.papers import find
    >>> measure(find("f2"), example("ellipse"))
    <Measure f2: degree 3d − 3, here 3, true degree 0, 16 control points>
    """
    formula, curve = expect_formula(formula), curve_of(curve)
    value = joined(formula(curve))
    nominal = DegreeReading().count(formula, curve.dimension, polynomial=curve.polynomial)
    return Measure(known_as(formula), nominal, value.degree, true_degree_or_none(value), control_point_count(value))


def _applies(formula: Formula, dimension: int) -> bool:
    """Whether a formula applies to single curves of this dimension."""
    return formula.kind in {2: (PLANE, CURVE), 3: (SPACE, CURVE)}.get(dimension, (CURVE,))


def measurable(dimension: int) -> list[Formula]:
    """Return the formulas that apply to curves of this dimension."""
    n = as_integer(dimension, "a dimension", 1)
    return [formula for formula in all_formulas().values() if _applies(formula, n)]


@dataclass(frozen=True)
class DegreeRow:
    """One line of a degree table: symbolic in d (``nominal``, ``generic``) and on the given curve, with the computing
    time.

    ``grading`` is ``k, m, j`` of a homogeneous polynomial, or of the numerator of a quotient in lowest terms (see
    `exactspline.symbolic.covariants`).
    """

    formula: str
    variant: str
    nominal: str
    #: None if the object does not exist on any segment; the same holds for the next two fields.
    represented: int | None
    true: int | None
    control_points: int | None
    generic: str
    text: str
    grading: str = "–"
    seconds: float = 0

    def data(self) -> dict[str, object]:
        """The row as data."""
        return vars(self)


@cache
def _minimum(name: str, dimension: int, polynomial: bool) -> Degree:
    """The degree of the minimal variant of a construction on the generic curve, computed once."""
    return symbolic_minimum(construction(name), dimension, polynomial=polynomial)


def construction_table(curve: Nurbs) -> list[Callable[[], DegreeRow]]:
    """The rows for the constructions of a curve in every variant, as calls."""
    return [partial(_row, c, variant, curve) for c in constructions_for(curve.dimension) for variant in c.all_variants]


def _row(c: Construction, variant: Variant, curve: Nurbs) -> DegreeRow:
    formula, minimal, n = c.formula(variant), variant == Variant.MINIMAL, curve.dimension
    lowest = str(_minimum(c.name, n, curve.polynomial)) if minimal else "–"
    nominal = "–" if minimal else str(DegreeReading().count(formula, n, polynomial=curve.polynomial))
    start = perf_counter()
    try:
        value = c.on(curve, variant)
        true = true_degree_or_none(value)
    except ReductionError:
        true = None
    seconds = perf_counter() - start
    if true is None:
        return _in_pieces(c, variant, nominal, lowest, curve, seconds)
    text = print_text(trace(formula, n)) if not minimal else MINIMAL_RULED if c.ruled else MINIMAL
    counts = value.degree, true, control_point_count(value)
    grading = _grading(formula, variant, n, curve.polynomial)
    return DegreeRow(c.name, variant, nominal, *counts, lowest, text, grading, seconds)


#: The descriptions of the minimal variants.
MINIMAL = "the lifted variant in lowest terms"
MINIMAL_RULED = "directrix in lowest terms, the generator without its common factor"


def _in_pieces(c: Construction, variant: Variant, nominal: str, lowest: str, curve: Nurbs, seconds: float) -> DegreeRow:
    """The row of an object that does not exist on every segment: the degrees of its pieces, and the reason for the
    gaps.
    """
    try:
        derived = derive(c.name, curve, variant)
    except ShapeError as error:
        return DegreeRow(c.name, variant, nominal, None, None, None, lowest, str(error), seconds=seconds)
    counts = derived.degree, derived.true_degree, derived.control_points
    return DegreeRow(c.name, variant, nominal, *counts, lowest, derived.existence, seconds=seconds)


def _grading(formula: Formula, variant: str, dimension: int, polynomial: bool) -> str:
    """k, m and j of a polynomial formula or of the numerator of the minimal form."""
    if not (variant == Variant.MINIMAL or is_polynomial(formula, dimension)):
        return "–"
    try:
        degree = true_degree(reduction_of(formula, dimension, polynomial).main.lowest[0])
    except (FormulaError, ReachError):
        return "–"
    return f"{degree.k}, {degree.m}, {degree.j}"


#: Ruled surfaces whose generators are measured: naive, reduced as in the paper, lifted.
GENERATORS = {
    name.replace("_", " ") + ", generator": (name, f"{name}_reduced", f"{name}_lifted")
    for name in ("tangent_developable", "binormal_scroll", "normal_scroll", "rectifying_developable")
}


#: Bisectors, in the parameter of the first curve: naive, polynomial as in §6 of the paper, lifted.
BISECTORS = {
    "bisector of two curves, in s": ("bisector", "bisector_polynomial", "bisector_lifted"),
    "planar bisector of a curve and a point": ("plane_bisector", "plane_bisector_polynomial", "plane_bisector_lifted"),
}


#: The degrees d for which an exact witness is computed.
WITNESSES = range(2, 7)


@dataclass(frozen=True)
class GenericRow:
    """One line of the table for the generic curve of degree d: the count of Table 1 for each variant, and the degree
    that the theorem proves.

    ``k``, ``m``, ``j`` are those of the reduced form; for a quotient in lowest terms, of its numerator or denominator,
    whichever has the larger true degree. A certified witness attains the true degree at the degrees ``attained``, the
    object does not exist or vanishes at the degrees ``absent``, and proof and witness disagree at the degrees
    ``differ``.
    """

    object: str
    naive: str
    paper: str
    k: int
    m: int
    nominal: str
    j: int
    true: str
    attained: tuple[int, ...]
    absent: tuple[int, ...]
    differ: tuple[int, ...]

    def at(self, d: int) -> dict[str, int | None]:
        """The three degrees for curves of degree d ≥ 2; None for an object that does not exist or vanishes.

        >>> row = GenericRow("an object", "6d", "–", 3, 3, "3d − 3", 0, "3d − 6", (3,), (), ())
        >>> row.at(4)
        {'naive': 24, 'paper': None, 'true': 6}
        """
        texts = {"naive": self.naive, "paper": self.paper, "true": "–" if d in self.absent else self.true}
        return {name: None if text == "–" else parse_degree(text).at({"d": d}) for name, text in texts.items()}


def generic_table(*, polynomial: bool = False) -> list[Callable[[], GenericRow]]:
    """The rows for all constructions and for the generators of ruled surfaces, as calls."""
    rows: list[Callable[[], GenericRow]] = []
    rows += [partial(_generic_row, c, polynomial) for c in all_constructions().values() if not c.ruled]
    rows += [partial(_generator_row, title, names, polynomial) for title, names in GENERATORS.items()]
    return rows + [partial(_bisector_row, title, names, polynomial) for title, names in BISECTORS.items()]


#: By d the proved degree and that of a witness, None for an object that does not exist or vanishes.
ByDegree = dict[int, tuple[int | None, int | None]]


def _of_witnesses(title: str, sides: tuple[str, str], found: TrueDegree, true: Degree, degrees: ByDegree) -> GenericRow:
    """The row of an object: the counts of both sides, its degree, and the degrees d at which witnesses attain it."""
    agreed = [d for d, (proved, seen) in degrees.items() if proved == seen]
    absent = tuple(d for d in agreed if degrees[d][1] is None)
    attained_at = tuple(d for d in agreed if d not in absent)
    differ = tuple(d for d in degrees if d not in agreed)
    k, m, nominal = found.k, found.m, str(found.nominal)
    return GenericRow(title, *sides, k, m, nominal, found.j, str(true), attained_at, absent, differ)


def _generic_row(c: Construction, polynomial: bool) -> GenericRow:
    naive = "squaring" if "squaring" in c.unlifted else next(iter(c.variants))
    paper = next((f for f in (Variant.PAPER, Variant.REDUCED) if f in c.unlifted), Variant.MINIMAL)
    counts = [DegreeReading().count(c.formula(v), c.dimension, polynomial=polynomial) for v in (naive, paper)]
    sides = str(counts[0]), str(counts[1]) if c.formula(paper).name != c.lifted else "–"
    numerator, denominator = reduction(c.lifted, c.dimension, polynomial).main.lowest
    found = max([true_degree(numerator), true_degree(denominator)], key=lambda t: t.at(WITNESSES[-1]))
    witnesses = [attained(c.name, d, polynomial=polynomial) for d in WITNESSES]
    true = symbolic_minimum(c, c.dimension, polynomial=polynomial)
    return _of_witnesses(c.title, sides, found, true, {w.d: (w.proved, w.attained) for w in witnesses})


def _generator_row(title: str, names: tuple[str, str, str], polynomial: bool) -> GenericRow:
    naive, paper, lifted = map(find, names)
    main = reduction(lifted.name, 3, polynomial).main
    found = true_degree(main.reduced)
    operands = DegreeReading().argument(CURVE, 3, polynomial=polynomial)
    degrees: ByDegree = {}
    for d in WITNESSES:
        curve: Curve[BSpline] = witness(3, d, polynomial=polynomial)
        value = main.on(curve)
        seen = max(f.true_degree for f in (value if isinstance(value, Vector) else [value]))
        proved = found.at(d)
        degrees[d] = (None if proved < 0 else proved), (None if seen < 0 else seen)
    sides = str(naive(operands).generator.degree), str(paper(operands).generator.degree)
    return _of_witnesses(title, sides, found, found.generic, degrees)


def _bisector_row(title: str, names: tuple[str, str, str], polynomial: bool) -> GenericRow:
    naive, paper, lifted = map(find, names)
    (dimension,) = lifted.kind.dimensions
    numerator, denominator = reduction(lifted.name, dimension, polynomial).main.lowest
    parts = [part for jet in (*numerator, denominator) for part in graded(jet)]
    found = max(map(true_degree, parts), key=lambda t: t.at(WITNESSES[-1]))
    degrees: ByDegree = {}
    for d in WITNESSES:
        handed = bisected_pair(lifted.kind, witness(dimension, d, polynomial=polynomial))
        value = Rational(Vector(*[substitute(jet, handed) for jet in numerator]), substitute(denominator, handed))
        degrees[d] = degree_at(parts, d), max(n for _, n in lowest_terms(value))
    first, second = (str(DegreeReading().count(f, dimension, polynomial=polynomial)) for f in (naive, paper))
    true = lowest_degree(lifted, dimension, polynomial=polynomial)
    return _of_witnesses(title, (first, second), found, true, degrees)


class _Fixed:
    """An operand of the second curve at one parameter: its derivatives there are constants."""

    def __init__(self, values: list[Any]) -> None:
        self.values = values

    def d(self, order: int) -> Any:
        """The derivative of a given order."""
        return self.values[order]


def bisected_pair(kind: Kind, curve: Nurbs) -> Curve[BSpline] | Pair[BSpline]:
    """A curve and its counterpart in a bisector: a point, or the derivatives of a second curve at one parameter; prime
    numbers avoid coincidences.
    """
    primes = iter((2, 3, 5, 7, 11, 13, 17, 19))
    if kind is not PAIR:
        return Curve(
            curve.p, curve.w, polynomial=True, point=Vector(*[curve.w.constant(next(primes)) for _ in curve.p])
        )
    second: Any = [_Fixed([curve.w.constant(next(primes)) for _ in range(2)]) for _ in range(4)]
    return Pair(curve, Curve(Vector(*second[:3]), second[3], polynomial=True))


def formula_table(
    curve: Nurbs, formulas: Iterable[Formula] | None = None, limit: int | None = None
) -> list[Callable[[], DegreeRow]]:
    """The rows for every formula that applies to such a curve, as calls: of some papers, or of the default papers. A
    row says if it takes more than `limit` seconds of processor time.
    """
    known = measurable(curve.dimension) if formulas is None else [f for f in formulas if _applies(f, curve.dimension)]
    return [partial(_formula_row, f, curve, limit) for f in known]


@dataclass(frozen=True)
class FormulaDegrees:
    """A formula on the generic curve of degree d: the count of Table 1 of the paper, the cancelled factors, the degree
    of the reduced form, the degree of the value in lowest terms, and the reason if the degree theorem does not apply.
    """

    formula: str
    curves: str
    nominal: str
    cancelled: str
    reduced: str
    lowest: str


def formula_degrees(formulas: Iterable[Formula], limit: int | None = None) -> list[Callable[[], FormulaDegrees]]:
    """The rows for formulas, rational and polynomial curves one after the other, as calls. A row says if it
    takes more than `limit` seconds of processor time.
    """
    return [
        partial(_degrees_of, f, polynomial, parameter, limit)
        for f in formulas
        if f.kind is not TABLE
        for polynomial in (False, True)
        for parameter in f.kind.counted
    ]


def _degrees_of(formula: Formula, polynomial: bool, parameter: Parameter, limit: int | None) -> FormulaDegrees:
    n, curves = formula.kind.dimensions[0], "polynomial" if polynomial else "rational"
    if len(formula.kind.counted) > 1:
        curves += f", in {parameter}"
    try:
        nominal = str(DegreeReading(parameter=parameter).count(formula, n, polynomial=polynomial))
    except (FormulaError, InapplicableError) as error:
        return FormulaDegrees(formula.name, curves, "–", "–", "–", error.problem)
    try:
        with within_seconds(limit):
            main = reduction_of(formula, n, polynomial, parameter).main
        cancelled, reduced, lowest = str(main.cancelled), str(main.generic), str(main.generic_lowest)
    except (FormulaError, ReachError) as error:
        cancelled, reduced, lowest = "–", "–", error.problem
    return FormulaDegrees(formula.name, curves, nominal, cancelled, reduced, lowest)


def _formula_row(formula: Formula, curve: Nurbs, limit: int | None) -> DegreeRow:
    start = perf_counter()
    try:
        with within_seconds(limit):
            m = measure(formula, curve)
    except ReachError as error:  # the other formulas are not affected
        nominal = str(DegreeReading().count(formula, curve.dimension, polynomial=curve.polynomial))
        return DegreeRow(formula.name, "as written", nominal, None, None, None, "–", str(error))
    seconds = perf_counter() - start
    text = print_text(trace(formula, curve.dimension))
    return DegreeRow(
        m.formula, "as written", str(m.nominal), m.represented, m.true, m.control_points, "–", text, seconds=seconds
    )


# ---- on patches


#: The seed of witnesses, and the size of their control points.
SEED, SIZE = 2007, 99
#: The number of formulas that an error names.
NAMED = 3


@dataclass(frozen=True, repr=False)
class PatchRow(OneLine):
    """A formula on patches of one bidegree: the degrees counted by Table 1, those proved by the degree theorem for its
    reduced form on the generic patch, and those attained by a patch with known control points; each a pair of degrees,
    None for zero. `missing` is the reason why the last two are unknown.
    """

    formula: str
    patches: str
    naive: tuple[int, int]
    true: tuple[int, int] | None
    attained: tuple[int, int] | None
    missing: str = ""

    @property
    def agrees(self) -> bool:
        """Whether the witness attains the proved degrees; None if these are `missing`."""
        return self.true == self.attained


@dataclass(frozen=True)
class _VariantsRow:
    """The degrees in u and v of an object of surfaces: on rational patches as defined, from the numerators of
    derivatives, lifted, and the true ones; on polynomial patches as defined, and the true ones.
    """

    formula: str
    defined: str
    reduced: str
    lifted: str
    true: str
    polynomial: str
    polynomial_true: str


def variants_table(source: Paper) -> list[_VariantsRow]:
    """Return one row of degrees for each formula of surfaces that a paper has in three variants: ``NAME``,
    ``NAME_reduced``, and ``NAME_projective`` or ``NAME_lifted``.

    >>> from exactspline.papers import paper
    >>> row = variants_table(paper("surfaces"))[-2]
    >>> row.formula, row.defined, row.reduced, row.lifted, row.true
    ('line_coefficient_vv', '12d', '11d_u − 2, 11d_v − 4', '8d_u − 2, 8d_v − 4', '8d_u − 4, 8d_v − 8')
    >>> row.polynomial, row.polynomial_true
    ('5d_u − 2, 5d_v − 4', '5d_u − 2, 5d_v − 5')
    """
    source = as_instance(source, Paper, "a paper", "give what exactspline.paper returns")
    rows, known = [], source.formulas
    for name, formula in known.items():
        lifted = known.get(f"{name}_projective") or known.get(f"{name}_lifted")
        if formula.kind is SURFACE and f"{name}_reduced" in known and lifted is not None:
            variants = formula, known[f"{name}_reduced"], lifted
            defined, reduced, short = (_counted(each, polynomial=False) for each in variants)
            true = _proved(lifted, polynomial=False)
            polynomial = _counted(formula, polynomial=True), _proved(lifted, polynomial=True)
            rows.append(_VariantsRow(name, defined, reduced, short, true, *polynomial))
    return rows


def _counted(formula: Formula, *, polynomial: bool) -> str:
    """The degrees in u and in v by Table 1."""
    u, v = (str(DegreeReading(parameter=p).count(formula, 3, polynomial=polynomial)) for p in BOTH)
    return _in_both(u, v)


def _proved(formula: Formula, *, polynomial: bool) -> str:
    """The true degrees in lowest terms on the generic patch."""
    u, v = (str(reduction_of(formula, 3, polynomial, parameter).main.generic_lowest) for parameter in BOTH)
    return _in_both(u, v)


def _in_both(u: str, v: str) -> str:
    """Two degrees as one text, as one degree where they agree."""
    return u.replace("d_u", "d") if u.replace("d_u", "d_v") == v else f"{u}, {v}"


def patch_table(formulas: Iterable[Formula], degrees: tuple[int, int]) -> list[Callable[[], PatchRow]]:
    """Return functions that compute the rows of a table, two for each formula of surfaces or of planar maps: one row
    for rational patches, one row for polynomial patches. Other formulas are left out.

    >>> from exactspline.papers import paper
    >>> parabolic = paper("surfaces").find("parabolic")
    >>> rows = [call() for call in patch_table([parabolic], (2, 2))]
    >>> [(row.patches, row.naive, row.true, row.agrees) for row in rows]
    [('rational', (32, 32), (8, 8), True), ('polynomial', (8, 8), (7, 7), True)]

    Raises `FormulaError` for degrees below 1, and if no formula is about surfaces or planar maps.
    """
    given = [expect_formula(f) for f in as_items(formulas, "formulas")]
    if not isinstance(degrees, tuple) or len(degrees) != 2 or any(type(n) is not int or n < 1 for n in degrees):
        raise FormulaError(f"patches of the degrees {shown(degrees)}", remedy="two integers ≥ 1, as in (2, 3)")
    known = [f for f in given if f.kind in (SURFACE, PLANAR_MAP)]
    if not known:
        given_kinds = ", ".join(f"{f.name} ({f.kind.name})" for f in given[:NAMED]) or "none"
        raise FormulaError(
            f"no formula of surfaces among {given_kinds}", remedy="patches have those of surfaces and planar maps"
        )
    return [partial(_row_of_patch, f, degrees, polynomial) for f in known for polynomial in (False, True)]


def _row_of_patch(formula: Formula, degrees: tuple[int, int], polynomial: bool) -> PatchRow:
    (dimension,) = formula.kind.dimensions
    u, v = (_nominal(formula, dimension, polynomial, parameter, n) for parameter, n in zip(BOTH, degrees, strict=True))
    patches = "polynomial" if polynomial else "rational"
    try:
        part = reduction_of(formula, dimension, polynomial).main
    except (FormulaError, ReachError) as error:  # too many terms to multiply out: the other formulas are not affected
        return PatchRow(formula.name, patches, (u, v), None, None, str(error))
    attained = measured_degrees(part, _witness_patch(dimension, degrees, polynomial=polynomial))
    true = [_degree_of_reduced(part, degrees, parameter) for parameter in BOTH]
    return PatchRow(formula.name, patches, (u, v), _pair(*true), _pair(*attained))


def measured_degrees(part: Part, surface: Surface[TensorSpline]) -> tuple[int, int]:
    """The true degrees of a reduced form on a surface: the sum of those of its factors."""
    factors = [(substitute(jet, surface), e) for jet, e in part.kept]
    core = [substitute(jet, surface) for jet in part.core]
    if any(f.is_zero for f, _ in factors) or all(f.is_zero for f in core):
        return -1, -1
    degrees = [(f.true_degree, e) for f, e in factors]
    largest = Degrees(max(f.true_degree.s for f in core), max(f.true_degree.t for f in core))
    degrees.append((largest, 1))
    return sum(n.s * e for n, e in degrees), sum(n.t * e for n, e in degrees)


def _pair(u: int, v: int) -> tuple[int, int] | None:
    return None if min(u, v) < 0 else (u, v)


def _nominal(formula: Formula, dimension: int, polynomial: bool, parameter: Parameter, degree: int) -> int:
    counted = DegreeReading(parameter=parameter).count(formula, dimension, polynomial=polynomial)
    return int(counted.at(dict.fromkeys(counted.names, degree)))


def _degree_of_reduced(part: Part, degrees: tuple[int, int], parameter: Parameter) -> int:
    """The true degree of a reduced form in a parameter on the generic patch of these degrees; −1 if the form
    vanishes.
    """
    known = dict(zip(BOTH, degrees, strict=True))
    found = [(degree_on_patch([jet], known, parameter), e) for jet, e in part.kept]
    found.append((degree_on_patch([jet for jet in part.core if not jet.is_zero], known, parameter), 1))
    return -1 if any(n < 0 for n, _ in found) else sum(n * e for n, e in found)


def _witness_patch(dimension: int, degrees: tuple[int, int], *, polynomial: bool = False) -> Surface[TensorSpline]:
    """A patch of these degrees with pseudorandom control points and weights, the same every time.

    >>> _witness_patch(3, (1, 2)).w.degree
    Degrees(s=1, t=2)
    """
    random = Random(f"{SEED} {degrees} {dimension}")
    knots_u, knots_v = ([0] * (n + 1) + [1] * (n + 1) for n in degrees)

    def spline(least: int) -> TensorSpline:
        rows = [[random.randint(least, SIZE) for _ in range(degrees[1] + 1)] for _ in range(degrees[0] + 1)]
        return TensorSpline(degrees, knots_u, knots_v, rows)

    p, w = Vector(*[spline(-SIZE) for _ in range(dimension)]), spline(1)
    return Surface(p, w.constant(1) if polynomial else w, polynomial=polynomial)
