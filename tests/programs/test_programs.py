"""Straight-line programs: what they compute is, number for number, what the spline reading computes."""

import random

import pytest

from exactspline import BSpline, Nurbs, example, formula_of, rational
from exactspline.errors import FormulaError
from exactspline.geometry.derived.derive import part
from exactspline.language import Rational, Vector, det, formula
from exactspline.language.arguments import Curve, Operands
from exactspline.language.kinds import PAIR, PLANE, SPACE, CurveKind, PairKind, TableKind
from exactspline.language.ruled import joined
from exactspline.papers import papers
from exactspline.programs import evaluated, program_for
from exactspline.programs.instructions import Instruction, Instructions, needed
from exactspline.programs.program import operands_of, program_of, values
from exactspline.tables import surface_pair
from tests.support.sampled import sample
from workshop.bench.inputs import curve as bench_curve

FORMULAS = [f for source in papers() for f in source.formulas.values()]
ON_CURVES = [f for f in FORMULAS if type(f.kind) is CurveKind and not f.kind.constants]
#: The forms of the curvature and the torsion, which are computed together.
LOWEST = {
    2: tuple(map(formula_of, ("tangent_lifted", "inflections_lifted", "critical_curvature_lifted"))),
    3: tuple(
        formula_of(f"{name}_lifted") for name in ("tangent", "binormal", "torsion_zeros", "space_critical_curvature")
    ),
}
CURVES = ["rational_cubic_spline", "unclamped", "space_quartic", "rational_space_cubic_spline"]


def scalars(value):
    """The splines of a value, denominators among them."""
    value = joined(value)
    if isinstance(value, Rational):
        return [*scalars(value.numerator), value.denominator]
    return [x for part in value for x in scalars(part)] if isinstance(value, Vector) else [value]


def bits(f):
    return f.degree, f.mesh.breaks, f.continuity, f.numerators, f.denominators


def same_bits(value, other):
    return type(value) is type(other) and list(map(bits, scalars(value))) == list(map(bits, scalars(other)))


def of_odd_widths(dimension):
    """A curve with widths and denominators that have common divisors, but not all."""
    numbers = random.Random(dimension)
    knots = [0, 0, 0, "1/6", "4/9", "4/9", "17/18", 2, 2, 2]
    points = [[f"{numbers.randint(-9, 9)}/{numbers.randint(1, 6)}" for _ in range(dimension)] for _ in range(7)]
    return Nurbs(2, knots, points, [numbers.randint(1, 9) for _ in range(7)])


def arguments(dimension):
    curves = [example(name) for name in CURVES] + [of_odd_widths(2), of_odd_widths(3)]
    curves = [c for c in curves if c.dimension == dimension]
    curves += [Curve(-c.p, -c.w) for c in curves[:1] if not c.polynomial]
    # restricted one by one, its operands have denominators of their own
    return [*curves, part(of_odd_widths(dimension), rational("1/5"), rational("5/3"))]


@pytest.mark.parametrize("f", sample(ON_CURVES, 150), ids=lambda f: f.name)
def test_a_program_computes_number_for_number_what_the_spline_reading_computes(f):
    for dimension in f.kind.dimensions:
        for c in sample(arguments(dimension), 1, seed=f.name):
            given = c.with_point([1, "2/3", 3][:dimension]) if getattr(f.kind, "with_point", False) else c
            assert operands_of(f.kind, given) is not None
            assert same_bits(evaluated(f, given), f(given)), (f, c)


@pytest.mark.parametrize("f", [f for f in FORMULAS if isinstance(f.kind, TableKind)], ids=lambda f: f.name)
def test_so_do_the_programs_of_table_1(f):
    knots, numbers = [0, 0, 0, 1, 3, 3, 3], random.Random(5)
    a, b, t, p, q, w = (BSpline(2, knots, [f"{numbers.randint(-9, 9)}/{k}" for _ in range(4)]) for k in range(1, 7))
    mesh = a.mesh
    a, b, t, p, q, w = (BSpline.from_forms(2, mesh, x.continuity, x.forms) for x in (a, b, t, p, q, w))
    c, d, *e = (BSpline.from_forms(4, mesh, x.continuity, x.forms) for x in (a * a, b * b, a * b, b * t))
    given = Operands(p1=p, w1=q, v1=Vector(a, b, t), p2=w, w2=c, v2=Vector(d, *e))
    assert operands_of(f.kind, given) is not None
    assert same_bits(evaluated(f, given), f(given))


def test_a_program_refuses_what_it_was_not_made_for():
    program = program_for(next(f for f in FORMULAS if f.name == "g2"), example("rational_cubic"))
    with pytest.raises(FormulaError, match="not compiled"):
        program(example("rational_quartic"))
    f = next(f for f in FORMULAS if isinstance(f.kind, PairKind))
    with pytest.raises(FormulaError, match="as a program"):
        program_for(f, example("ellipse_in_space"))


def test_splines_over_different_breakpoints_are_read_as_splines():
    x, y = BSpline.bezier([0, 1, 3]), BSpline(2, [0, 0, 0, "1/2", 1, 1, 1], [0, 2, 1, 1])
    curve = Curve(Vector(x, y), x.constant(1), polynomial=True)
    turning = formula("here", on="plane")(lambda c: det(c.p.d(1), c.p.d(2)))
    assert evaluated(turning, curve) == det(curve.p.d(1), curve.p.d(2))


def test_a_polynomial_curve_over_a_denominator_that_is_not_one_is_read_as_it_is():
    c = example("cubic_s")
    odd = Curve(c.p, c.w.constant(2), polynomial=True)
    weighed = formula("here", on="plane")(lambda c: det(c.p, c.p.d(1)) * c.w)
    assert evaluated(weighed, odd) == 2 * det(c.p, c.p.d(1))


def test_equal_subexpressions_are_computed_once():
    code = Instructions()
    x, y = code.load(0, 3), code.load(1, 3)
    assert code.derived("derive", x) == code.derived("derive", x)
    assert code.times(x, y) == code.times(y, x)
    twice = formula("here", on="plane")(lambda c: (det(c.p.d(1), c.p.d(2)) + 1) * (det(c.p.d(1), c.p.d(2)) + 2))
    once = formula("here", on="plane")(lambda c: det(c.p.d(1), c.p.d(2)) + 1)
    counts = [program_for(f, example("cubic_s")).count("mul") for f in (twice, once)]
    assert counts == [3, 2]


@pytest.mark.parametrize("name", ["rational_cubic_spline", "cubic_s", "circle", "rational_quartic"])
def test_the_lowest_forms_of_a_plane_curve_are_those_of_the_lifts(name):
    """κ and κ′ by one program at their true degree are the Wronskians of the lifts; so are γ′ and D1."""
    c = example(name)
    found = values(LOWEST[2], operands_of(PLANE, c, true_degree=True))
    for own, paper in zip(found, ("D1", "inflections_lifted", "vertices_lifted"), strict=True):
        written_out = formula_of(paper)(c)
        assert found[own] == written_out == own(c)
        assert found[own].degree <= written_out.degree
    assert found[formula_of("critical_curvature_lifted")].degree < formula_of("vertices_lifted")(c).degree


@pytest.mark.parametrize("name", ["rational_space_cubic_spline", "space_quartic", "twisted_cubic"])
def test_the_lowest_forms_of_a_space_curve_are_those_of_the_lifts(name):
    """Passed before: a sign or a factor in one of them."""
    c = example(name)
    found = values(LOWEST[3], operands_of(SPACE, c, true_degree=True))
    for own, value in found.items():
        assert value == own(c)
        assert value.degree <= own(c).degree
    assert found[formula_of("tangent_lifted")] == formula_of("D1")(c)


def pairs_of_curves():
    """Rational space curves with segments of width one, of unequal degrees and numbers of segments."""
    return [
        (bench_curve(3, 1, 3, seed=1), bench_curve(2, 2, 3, seed=2)),
        (bench_curve(2, 3, 3, seed=3), bench_curve(4, 1, 3, seed=4)),
    ]


def bits_of_patches(f):
    return f.degree, f.continuity, f.stride, f.meshes, f.numerators, f.denominators


@pytest.mark.parametrize("f", [f for f in FORMULAS if f.kind is PAIR], ids=lambda f: f.name)
def test_on_two_curves_a_program_computes_number_for_number_what_the_spline_reading_computes(f):
    for one, two in pairs_of_curves():
        pair = surface_pair(one, two)
        given = operands_of(f.kind, pair)
        try:
            program = program_of(f, given.signature)
        except FormulaError:
            continue
        value, other = program.on(given), f(pair)
        assert list(map(bits_of_patches, scalars(value))) == list(map(bits_of_patches, scalars(other)))
        assert type(value) is type(other)


def test_the_forms_of_the_bisector_have_programs():
    one, two = pairs_of_curves()[0]
    given = operands_of(PAIR, surface_pair(one, two))
    names = (
        "bisector_symmetric",
        "bisector_determinant_symmetric",
        "bisector_numerators_symmetric",
        "chen_riesenfeld_cohen_2007:chord",
    )
    assert all(program_of(formula_of(name), given.signature).count("spread") for name in names)


def test_two_curves_without_a_program_are_read_as_splines():
    """The same curve twice, for naive semantics knows its operands again; polynomial curves; widths other than one."""
    curve, odd = bench_curve(2, 1, 3), of_odd_widths(3)
    for one, two in ((curve, curve), (curve, example("twisted_cubic")), (curve, odd)):
        pair = surface_pair(one, two)
        assert operands_of(PAIR, pair) is None
        assert evaluated(formula_of("chen_riesenfeld_cohen_2007:chord"), pair) == formula_of(
            "chen_riesenfeld_cohen_2007:chord"
        )(pair)


def test_what_is_needed_are_instructions_and_their_arguments():
    listed = [
        Instruction("load", (), (0,)),
        Instruction("load", (), (1,)),
        Instruction("mul", (0, -1)),
        Instruction("mul", (0, 1)),
        Instruction("mul", (2, 0)),
        Instruction("mul", (4, 3)),
    ]
    assert needed(listed, [4]) == {0, 2, 4}
    assert needed(listed, [5]) == {0, 1, 2, 3, 4, 5}
    assert needed(listed, [-1, 1]) == {1}
    assert needed(listed, [-2]) == set()


def test_bounds_grow_with_the_roundings():
    np = pytest.importorskip("numpy")
    from exactspline.programs.doubles import bounded_by
    from exactspline.programs.error_bounds import SLACK, Known

    masses = np.array([[1.0, 4.0]])
    for roundings in (1, 8, 64):
        told = bounded_by(masses, masses, Known(roundings, 5, 0))
        assert told.values.tolist() == masses.tolist()
        assert told.errors.tolist() == (masses * (SLACK * roundings * np.finfo(float).eps)).tolist()
    assert bounded_by(masses, masses * 0, Known(1, 5, 3)).errors.tolist() == [
        [SLACK * 3 * np.finfo(float).smallest_normal] * 2
    ]
