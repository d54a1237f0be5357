"""A parameter that the argument lacks is refused by splines, too, when formulas are called by hand."""

import pickle
from operator import add, mul, sub

import pytest

import exactspline as xs
from exactspline.tables import surface_pair

TORUS, CUBIC = xs.example("torus"), xs.example("rational_space_cubic")
PAIR = surface_pair(xs.example("twisted_cubic"), CUBIC)
BOTH = PAIR.first.p[0] * PAIR.second.w
RAW = xs.TensorSpline((1, 1), [0, 0, 1, 1], [0, 0, 1, 1], [[0, 1], [2, 3]])


def made_of(f):
    """What operations make of a spline in two parameters."""
    yield from (
        f,
        f.transposed(),
        pickle.loads(pickle.dumps(f)),
        f.constant(3),
        f.elevate_degree(1, 2),
        f.partial(1, 1),
    )
    yield from (
        operation(f, other) for operation in (add, sub, mul) for other in (f, RAW.restrict((0, 1), (0, 1)), 2)[::2]
    )
    (a, b), (c, d) = f.domain
    yield f.insert_knot(0, (a + b) / 2)
    yield f.insert_knot(1, (c + d) / 3)
    yield f.restrict((a, (a + b) / 2), ((c + d) / 2, d))
    yield f.along(1, lambda g: g.d())


@pytest.mark.parametrize("f", [TORUS.p[0], TORUS.w, TORUS.p[2] * TORUS.w])
def test_surfaces_have_no_s(f):
    """Passed before: ∂S/∂s of a surface was ∂S/∂u, called by hand on splines."""
    for each in made_of(f):
        for letter in ("s", "s̄", "t"):
            with pytest.raises(xs.ExactSplineError, match="a derivative with respect to"):
                each.d(1, by=letter)
        assert {each.d(1, by=letter).domain for letter in "uv"} == {each.domain}
    assert f.d(1, by="u") == f.partial(1, 0)
    assert f.d(2, by="v") == f.partial(0, 2)
    assert f.transposed().d(1, by="u") == f.partial(1, 0).transposed()
    with pytest.raises(xs.ExactSplineError, match=r"d\(1, by='u'\) or d\(1, by='v'\)"):
        f.d()


def test_quotients_and_vectors_of_surfaces_have_no_s():
    for value in (TORUS.S, TORUS.p, TORUS.p[0] / TORUS.w):
        value.d(1, by="u")
        with pytest.raises(xs.ExactSplineError, match="a derivative with respect to 's' of a function of u and v"):
            value.d(1, by="s")


@pytest.mark.parametrize("f", [BOTH, PAIR.first.p[0], PAIR.second.w])
def test_two_curves_have_no_u(f):
    for each in made_of(f):
        for letter in ("u", "v"):
            with pytest.raises(xs.ExactSplineError, match="of a function of s"):
                each.d(1, by=letter)
    assert f.d(1, by="s̄") == f.partial(0, 1)


def test_what_belongs_to_neither_takes_both_names():
    assert RAW.d(1, by="s") == RAW.d(1, by="u") == RAW.partial(1, 0)
    assert RAW.d(1, by="s̄") == RAW.d(1, by="v") == RAW.partial(0, 1)


def test_derivatives_of_quotients_are_bounded():
    """Before: the degree doubled with every derivative, without an end: of order 30 it did not come back."""
    velocity = CUBIC.gamma
    most = 10  # derivatives, each of which doubles the factors of the denominator: 1024 at most
    assert velocity.d(5).denominator.degree == 3 * 2**5
    for order in (most + 1, 30, 1000):
        with pytest.raises(xs.ExactSplineError, match=f"a derivative of order {order} whose denominator"):
            velocity.d(order)
    for _ in range(most):
        velocity = velocity.d()
    with pytest.raises(xs.ExactSplineError, match="take lower orders, or derivatives of its parts"):
        velocity.d()
