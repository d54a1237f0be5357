"""Degrees of formulas of surfaces on patches of given degrees: counted, proved, and attained by a witness."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from random import Random

from exactspline.errors import FormulaError, ReachError, as_instance, as_items, shown
from exactspline.language.formula import Formula, expect_formula
from exactspline.language.kinds import PLANAR_MAP, SURFACE
from exactspline.language.operand import Parameter
from exactspline.language.surface_kind import BOTH, Surface
from exactspline.language.vector import Vector
from exactspline.one_line import OneLine
from exactspline.papers import Paper
from exactspline.readings.degree import DegreeReading
from exactspline.splines.tensor import TensorSpline
from exactspline.splines.tensor_patches import Degrees
from exactspline.symbolic.covariants import degree_on_patch
from exactspline.symbolic.reduction import Part
from exactspline.symbolic.substitution import substitute
from exactspline.verification.generic_proof import reduction_of

#: The seed of witnesses, and the size of their control points.
SEED, SIZE = 2007, 99
#: How many formulas an error names.
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
        """Whether the witness attains the proved degrees; None where these are `missing`."""
        return self.true == self.attained


@dataclass(frozen=True)
class _VariantsRow:
    """An object of surfaces, its degrees in u and v on rational patches: as defined, from the numerators of
    derivatives, lifted, and the true one; and as defined and true on polynomial ones.
    """

    formula: str
    defined: str
    reduced: str
    lifted: str
    true: str
    polynomial: str
    polynomial_true: str


def variants_table(source: Paper) -> list[_VariantsRow]:
    """The formulas of surfaces that a paper has in three variants: ``NAME``, ``NAME_reduced``, and ``NAME_projective``
    or else ``NAME_lifted``.

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
            reduced = known[f"{name}_reduced"]
            rows.append(
                _VariantsRow(
                    name,
                    _counted(formula, polynomial=False),
                    _counted(reduced, polynomial=False),
                    _counted(lifted, polynomial=False),
                    _proved(lifted, polynomial=False),
                    _counted(formula, polynomial=True),
                    _proved(lifted, polynomial=True),
                )
            )
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
    """The rows for the formulas of surfaces and of planar maps among these, rational and polynomial patches one after
    the other, as calls.

    >>> from exactspline.papers import paper
    >>> parabolic = paper("surfaces").find("parabolic")
    >>> rows = [call() for call in patch_table([parabolic], (2, 2))]
    >>> [(row.patches, row.naive, row.true, row.agrees) for row in rows]
    [('rational', (32, 32), (8, 8), True), ('polynomial', (8, 8), (7, 7), True)]

    Raises `FormulaError` for degrees below 1, and where none of the formulas is one of surfaces or planar maps.
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
    return [partial(_row, f, degrees, polynomial) for f in known for polynomial in (False, True)]


def _row(formula: Formula, degrees: tuple[int, int], polynomial: bool) -> PatchRow:
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
    """The true degree in a parameter of a reduced form on the generic patch of these degrees; −1 where it vanishes."""
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
