"""Laws that hold for every kind of spline."""


def check_ring_axioms(a, b, c):
    """Sums, products and multiples of three splines of one kind."""
    assert a + b == b + a
    assert a * b == b * a
    assert (a + b) + c == a + (b + c)
    assert (a * b) * c == a * (b * c)
    assert a * (b + c) == a * b + a * c
    assert a - b == -(b - a)
    assert a + 0 == a
    assert a * 1 == a
    assert 2 * a - a == a
    assert (1 - a) + a == a.constant(1)
    assert (a - a).is_zero
    assert (a * 0).is_zero
    assert a**3 == a * a * a
