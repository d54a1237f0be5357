"""Values that behave: immutable, copied, pickled, hashed, shared by threads and processes; equal as functions."""

import copy
import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress

import pytest
from flint import fmpz_poly
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

import exactspline as xs
from exactspline import ExactSplineError, Real, formula_of, square_root
from exactspline.hooks import LENT, QUESTIONS, first_guesses
from tests.support.strategies import nurbs, splines

T = xs.BSpline.identity(-2, 2)
CURVE = xs.example("rational_cubic_spline")
ZEROS = xs.zeros((T**2 - 2) * (3 * T - 1) * (T**3 - T - 1) ** 2)
JUMPY = xs.zeros(xs.BSpline(1, [0, 0, 1, 1, 2, 3, 3], [1, 2, -1, 0, 0]))

VALUES = {
    "BSpline": T**2 - 2,
    "unclamped BSpline": xs.BSpline(2, [0, 1, 2, 3, 4, 5], [1, 2, "1/3"]),
    "KnotVector": xs.KnotVector([0, 0, "1/2", 1, 1]),
    "Nurbs": CURVE,
    "Nurbs with a direction": xs.Nurbs(2, [0, 0, 0, 1, 1, 1], [(1, 0), xs.Direction(0, 1), (-1, 0)]),
    "Direction": xs.Direction(0, "1/3"),
    "TensorSpline": xs.TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [2, 3]]),
    "TensorSpline in one parameter": xs.TensorSpline((1, 0), [0, 0, 1, 1], [0, 1], [[0], [1]]).constant(2),
    "Vector": CURVE.p,
    "Rational": CURVE.gamma,
    "scalar Rational": T / (T + 5),
    "rational root": ZEROS.roots[-2],
    "irrational root": ZEROS.roots[0],
    "ZeroSet": ZEROS,
    "ZeroSet with jumps and intervals": JUMPY,
    "Jump": JUMPY.jumps[0],
    "ZeroInterval": JUMPY.intervals[0],
    "rational": Real("2/3"),
    "square root": square_root(mpq(1, 8)),
    "value at a root": xs.evaluate(CURVE, ZEROS.roots[-1])[0],
    "sum": square_root(2) + square_root(3),
    "curvature": xs.curvature(CURVE, ZEROS.roots[-1]),
}


@pytest.mark.parametrize("name", VALUES)
def test_a_value_cannot_be_changed(name):
    value = VALUES[name]
    for cls in type(value).__mro__:  # also what is computed when it is asked for
        for field, member in vars(cls).items():
            if type(member).__name__ == "cached_property" and not field.startswith("_"):
                getattr(value, field)
    fields = [
        field
        for cls in type(value).__mro__
        for field in (*getattr(cls, "__slots__", ()), *getattr(cls, "__annotations__", {}))
        if not field.startswith("_")
    ]
    for field in [*fields, *vars(value)] if hasattr(value, "__dict__") else fields:
        if field == "kept_analysis":
            continue
        before = getattr(value, field, None)
        with pytest.raises((AttributeError, TypeError)):
            setattr(value, field, before)
        with pytest.raises((AttributeError, TypeError)):
            delattr(value, field)
        assert not isinstance(before, (list, dict, set)), f"{field} can be changed in place"


def test_what_a_spline_shows_is_no_list():
    f = xs.BSpline(1, [0, 0, 1, 2, 2], [1, 2, 0])
    shown = (f.bezier_points, f.bezier_points[0], f.denominators, f.control_points, f.breakpoints)
    assert all(type(x) is tuple for x in (*shown, f.mesh.widths, f.knots.knots))
    assert all(type(x) is tuple for x in (ZEROS.roots, ZEROS.jumps, ZEROS.intervals, ZEROS.isolations))
    for copies in (f.forms, f.polynomials):
        with pytest.raises(TypeError):
            copies[0] = copies[1]


def test_representations_survive_too():
    f = VALUES["unclamped BSpline"]
    back = pickle.loads(pickle.dumps(f))
    assert back.same_representation(f)
    assert back.knots == f.knots
    curve = pickle.loads(pickle.dumps(CURVE))
    assert (curve.weights, curve.control_points, curve.name) == (CURVE.weights, CURVE.control_points, CURVE.name)
    assert curve.p[0].mesh is curve.w.mesh


def test_pickled_operands_are_never_taken_for_others():
    """Provenance numbers mean nothing in another process: a loaded spline shares a denominator with itself alone."""
    w = T + 5
    other = pickle.loads(pickle.dumps(w))
    assert (1 / w + 1 / w).degree == 1
    assert (1 / other + 1 / other).degree == 1
    assert (1 / w + 1 / other).degree == 2


def test_refinement_survives_and_stays_out_of_the_value():
    (root,) = (r for r in xs.zeros(T**2 - 2) if r > 0)
    fresh = pickle.loads(pickle.dumps(root))
    low, high = root.refine(50)
    refined = pickle.loads(pickle.dumps(root))
    assert (refined.low, refined.high) == (low, high)
    assert fresh.high - fresh.low > refined.high - refined.low
    assert fresh == refined == root
    assert len({hash(fresh), hash(refined), hash(root)}) == 1
    assert copy.deepcopy(root) is root


# ---- equality and hashes


@given(nurbs(most=2), st.sampled_from([mpq(-1), mpq(3), mpq(1, 10**9)]), st.sampled_from([mpq(1, 3), mpq(2, 7)]))
def test_equal_curves_have_equal_hashes(curve, factor, place):
    a, b = curve.domain
    others = [
        curve.elevate_degree(2),
        xs.Nurbs(curve.degree, curve.knots, curve.control_points, [factor * w for w in curve.weights], name="other"),
        curve.reverse().reverse(),
        xs.Nurbs.from_splines(curve.p, curve.w),
        xs.Nurbs.from_splines([x * (curve.w * curve.w) for x in curve.p], curve.w * curve.w * curve.w),
    ]
    t = a + (b - a) * place
    if t not in curve.breakpoints:
        others.append(curve.insert_knot(t))
    for other in others:
        assert other == curve
        assert hash(other) == hash(curve)
    moved = [(x + 1, *rest) for x, *rest in curve.control_points]
    assert curve != xs.Nurbs(curve.degree, curve.knots, moved, curve.weights)


def test_curves_that_differ_in_one_point_or_in_the_domain_differ():
    line = xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 0)])
    assert line != xs.Nurbs(1, [0, 0, 2, 2], [(0, 0), (1, 0)])
    assert line != xs.Nurbs(1, [0, 0, 1, 1], [(0, 0, 0), (1, 0, 0)])
    assert line != xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, 0)], [1, 2]), "the same points at other parameters"
    assert line != xs.Nurbs(1, [0, 0, 1, 1], [(0, 0), (1, mpq(1, 10**300))])
    assert line != line.p
    assert len({line, line.elevate_degree(), line.reverse()}) == 2


@given(splines(high=3), splines(high=2, domain=(mpq(0), mpq(1))))
def test_equal_splines_and_quotients_have_equal_hashes(f, common):
    a, b = f.domain
    assert hash(f) == hash(f.elevate_degree(2)) == hash(f + 0 * f)
    t = xs.BSpline.identity(a, b)
    common = common.reparametrize(a, b)
    if common.vanishes_somewhere:
        return
    plain, lifted = f / (t - a + 1), (f * common) / ((t - a + 1) * common)
    assert plain == lifted
    assert hash(plain) == hash(lifted)
    assert plain != (f + 1) / (t - a + 1)


def test_nothing_is_equal_to_zero_over_zero():
    zero = T - T
    nothing = zero / zero
    for other in (T / (T + 3), T / (T + 4), zero / (T + 3), nothing, T / zero):
        assert nothing != other
        assert not nothing == other  # noqa: SIM201
        assert not other == nothing  # noqa: SIM201
    half = xs.BSpline(0, [0, 1, 2], [0, 1])
    partly = (half * half) / half
    assert partly != half / half.constant(1), "0/0 on one segment is not a function"
    assert hash(nothing) == hash(zero / zero)


# ---- roots are numbers


def test_hashing_a_root_factors_nothing(monkeypatch):
    """The product of cyclotomic-like factors of high degree is hashed at once; a factorization would be seen."""
    t = xs.BSpline.identity(0, 3)
    (root,) = (r for r in xs.zeros((t**9 - 3 * t - 7) * (t**8 + t + 1)) if r > 0)
    monkeypatch.setattr(type(root), "_computed_minimal", None)
    assert hash(root) == hash(root)
    assert root.exact is None


@given(st.integers(-50, 50), st.integers(1, 40), st.integers(2, 9), st.integers(-30, 30))
def test_exact_agrees_with_factoring(p, q, degree, c):
    t = xs.BSpline.identity(-60, 60)
    for root in xs.zeros((q * t - p) * (t**degree + c)):
        linear = len(root.minimal_polynomial()) == 2
        assert (root.exact is not None) == linear
        if linear:
            assert root.exact == mpq(-root.minimal_polynomial()[0], root.minimal_polynomial()[1])


def test_roots_are_no_truth_values_of_strings_and_floats():
    root = ZEROS.roots[0]
    assert root != "−√2"
    assert root != float(root)
    assert (xs.zeros(T - 1).roots[0] == True) is True  # noqa: E712  # True is 1


# ---- threads and processes

FORMULAS = ("f2", "curvature_squared", "evolute", "f1", "D1_squared")


def everything_of(curve):
    found = [formula_of(name)(curve) for name in FORMULAS]
    kinks = xs.zeros(found[0])
    return (
        [hash(f) for f in found],
        [r.refine(30) and float(r) for r in kinks],
        [xs.curvature(curve, r) for r in kinks],
        hash(curve),
    )


def test_eight_threads_over_one_curve():
    curve = pickle.loads(pickle.dumps(CURVE))
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(everything_of, [curve] * 16))
    assert all(x == found[0] for x in found)
    assert found[0] == everything_of(CURVE)
    assert "_values" not in vars(curve), "an evaluation leaves nothing behind on its curve"


def test_eight_threads_refine_one_root():
    (root,) = (r for r in xs.zeros(T**3 - T - 1) if r > 0)
    digits = [3, 400, 17, 90, 5, 200, 31, 60] * 4
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(root.refine, digits))
    for (low, high), n in zip(found, digits, strict=True):
        assert high - low <= mpq(1, 10**n)
        assert (low**3 - low - 1) < 0 < (high**3 - high - 1)


#: A process is forked while another thread computes; its child computes the same of another curve, or more of this one.
FORKED = """
import os, sys
from threading import Event, Thread, current_thread
import exactspline as xs
from exactspline.splines.nurbs import Nurbs

entered, go, own = Event(), Event(), current_thread()
one, other = (xs.example(name) for name in ("cubic_s", "rational_cubic"))

def waiting(compute):
    def computed(*of):
        if current_thread() is not own:
            entered.set()
            go.wait()
        return compute(*of)
    return computed

if sys.argv[1] == "property":
    vars(Nurbs)["p"].func = waiting(vars(Nurbs)["p"].func)
    held, asked = lambda: one.p, lambda: other.p
else:
    held, asked = lambda: xs.analyse(one).once("this", waiting(int)), lambda: xs.analyse(one).inflections
thread = Thread(target=held)
thread.start()
entered.wait()
child = os.fork()
if not child:
    asked()
    os._exit(7)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
go.set()
thread.join()
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes are not forked here")
@pytest.mark.parametrize("kept", ["property", "analysis"])
def test_a_forked_child_does_not_wait_for_a_thread_that_it_does_not_have(kept):
    """On Python 3.11 one lock of `functools.cached_property` was held for all curves while one was computed, and on
    every Python the lock of an analysis: the child waited for ever.
    """
    command = [sys.executable, "-W", "ignore", "-c", FORKED, kept]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, start_new_session=True) as process:
        try:
            assert process.communicate(timeout=20)[0] == "7\n"
        finally:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)


# ---- what is pickled, and what is handed out


def test_a_curve_that_is_wrong_is_not_unpickled():
    make, (degree, knots, points, weights, *rest) = CURVE.__reduce__()
    with pytest.raises(ExactSplineError):
        make(degree, knots, points, [-w if i else w for i, w in enumerate(weights)], *rest)


#: What the engines of the package share without a copy; its documentation says so. What is found elsewhere of a value
#: is no part of it.
SHARED = {"numerators", "kept_analysis", *first_guesses()[LENT], *first_guesses()[QUESTIONS]} - {"floats"}


def polynomials_within(value, depth=7):
    """FLINT's polynomials that can be reached from a value through what is public and not said to be shared."""
    if isinstance(value, fmpz_poly):
        yield value
    elif isinstance(value, (str, int)) or depth == 0:
        return
    elif isinstance(value, Iterable):
        for part in list(value)[:3]:
            yield from polynomials_within(part, depth - 1)
    if type(value).__module__.startswith("exactspline.") and not isinstance(value, type):
        for name in sorted(n for n in dir(value) if not n.startswith("_") and n not in SHARED):
            try:
                part = getattr(value, name)
            except ExactSplineError:
                continue
            if not callable(part):
                yield from polynomials_within(part, depth - 1)


@pytest.mark.parametrize("name", VALUES)
def test_nothing_that_is_changed_in_place_changes_a_value(name):
    value = VALUES[name]
    kept = pickle.loads(pickle.dumps(value))
    found = list(polynomials_within(value))
    for p in found:
        p[0] = p[0] + 1
    again = pickle.loads(pickle.dumps(value))
    for other in (value, again):
        assert (other, hash(other), repr(other)) == (kept, hash(kept), repr(kept))
    if isinstance(value, xs.Root):
        assert value.mpf(80) == kept.mpf(80)
    if isinstance(value, xs.ZeroSet):
        assert xs.check_certificate(value.certificate()) == xs.check_certificate(kept.certificate())
    assert bool(found) or not isinstance(value, xs.BSpline)
