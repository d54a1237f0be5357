"""Factors of polynomials in jets: quotients, names of vectors, and what is irreducible."""

from gmpy2 import mpq

from exactspline import formula_of
from exactspline.language import Vector, det, norm2
from exactspline.language.kinds import SPACE
from exactspline.readings import JetReading
from exactspline.symbolic import factorization
from exactspline.symbolic.factorization import Factor, factors_of, find_factor, irreducible_on_a_line, name_of_vector
from exactspline.tables import jets_for


def test_vectors_are_named_by_what_they_are_multiples_of():
    c = JetReading(2).argument(SPACE, 3)
    first = list(formula_of("D1")(c))
    assert name_of_vector(first) == ("D1", 1)
    assert name_of_vector([-3 * x for x in first]) == ("D1", -3)
    assert name_of_vector([x * 0 for x in first]) == ("0", 1)
    assert name_of_vector([first[0], first[1], first[0]])[0].startswith("(")
    x, w = c.p[0], c.w
    name, unit = name_of_vector([(-4 * x * w.d(1)), 6 * w * w])
    assert unit == -2
    assert name == "(2·x·w′, −3·w²)"
    name, unit = name_of_vector([x * mpq(2, 3), w * w * mpq(4, 9)])
    assert (name, unit) == ("(3·x, 2·w²)", mpq(2, 9))
    assert name_of_vector([first[2], x * w])[0].startswith("(")
    assert name_of_vector([x * 0, first[1], first[2] * 2])[0].startswith("(")


def test_factors_are_quotients():
    c = jets_for(("f1", "f2"), 2)
    f1, f2 = formula_of("f1")(c), formula_of("f2")(c)
    assert str(find_factor(f1, f2)) == "w"
    assert str(find_factor(f2, f1)) == "w⁻¹"
    zero = find_factor(f1 * 0, f2)
    assert zero.is_zero
    assert not zero.is_one
    assert find_factor(-f2, f2).constant == -1
    assert not find_factor(-f2, f2).is_zero
    assert not find_factor(-f2, f2).is_one
    assert find_factor(f2, f2).is_one
    assert str(find_factor(f2 * mpq(3, 2), f2)) == "3/2"
    assert find_factor(Vector(f1, f2), Vector(f2, f1)) is None
    assert str(find_factor(Vector(f1, f1), Vector(f2, f2))) == "w"
    assert isinstance(zero, Factor)


def test_values_on_a_line_show_what_has_no_factors_and_never_what_has():
    c = JetReading(2).argument(SPACE, 3)
    form = norm2(c.p.d(1)) * c.w + det(c.p, c.p.d(1), c.p.d(2))
    plain, product = form.polynomial, (form * c.w).polynomial
    assert irreducible_on_a_line(plain)
    assert not irreducible_on_a_line(product)
    assert not irreducible_on_a_line((form * form).polynomial)


def test_long_polynomials_are_factored_as_short_ones_are(monkeypatch):
    c = JetReading(2).argument(SPACE, 3)
    p = det(c.p, c.p.d(1), c.p.d(2)).polynomial
    for q in (p * -3 / 7, p * c.w.polynomial * 2, p * p):
        monkeypatch.setattr(factorization, "LONG", 10**9)
        expected = factors_of(q)
        monkeypatch.setattr(factorization, "LONG", 1)
        assert factors_of(q) == expected
