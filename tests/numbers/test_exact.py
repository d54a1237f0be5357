"""The gate of exact numbers: what it takes, what it refuses and what it says then."""

import ast
from decimal import Decimal
from enum import IntEnum
from fractions import Fraction
from pathlib import Path

import flint
import gmpy2
import pytest
from gmpy2 import mpfr, mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

import exactspline
from exactspline import from_floats, rational
from exactspline.errors import NumberError
from exactspline.numbers.exact import from_float, ratio, text, to_fmpq, to_fmpz
from tests.support.strategies import numbers

TAKEN = [
    (3, mpq(3)),
    (-(10**400), mpq(-(10**400))),
    (Fraction(-6, 4), mpq(-3, 2)),
    (mpq(2, 3), mpq(2, 3)),
    (mpz(7), mpq(7)),
    (Decimal("0.1"), mpq(1, 10)),
    (Decimal("-1E+3"), mpq(-1000)),
    (Decimal("1E-20"), mpq(1, 10**20)),
    (Decimal("-0"), mpq(0)),
    (flint.fmpz(-5), mpq(-5)),
    (flint.fmpz(2) ** 200, mpq(2**200)),
    (flint.fmpq(6, -4), mpq(-3, 2)),
    ("3/4", mpq(3, 4)),
    (" -6 / 4 ", mpq(-3, 2)),
    ("3/-4", mpq(-3, 4)),
    ("+1/+2", mpq(1, 2)),
    ("0.1", mpq(1, 10)),
    ("-.5", mpq(-1, 2)),
    ("5.", mpq(5)),
    ("+2", mpq(2)),
    ("-0", mpq(0)),
    ("007", mpq(7)),
    ("1e-6", mpq(1, 10**6)),
    ("1.25E+2", mpq(125)),
    ("\t12.50\n", mpq(25, 2)),
    ("0x10", mpq(16)),
    ("0x1.8p-3", mpq(3, 16)),
    ("-0X.8P1", mpq(-1)),
    ("0x1p+4", mpq(16)),
    ("0x1.fffffffffffffp+1023", mpq(*float.fromhex("0x1.fffffffffffffp+1023").as_integer_ratio())),
    ("0x0.0000000000001p-1022", mpq(1, 2**1074)),
]


@pytest.mark.parametrize(("given_value", "exact"), TAKEN, ids=[repr(v)[:24] for v, _ in TAKEN])
def test_taken(given_value, exact):
    found = rational(given_value)
    assert type(found) is type(mpq())
    assert found == exact


class Level(IntEnum):
    ONE = 1


REFUSED = [
    (0.1, "exactspline.from_floats(0.1)"),
    (-0.0, "curve.floats(-0.0)"),
    (float("nan"), "finite"),
    (float("inf"), "finite"),
    (float("-inf"), "finite"),
    (mpfr("0.5"), "exactspline.from_floats(0.5)"),
    (mpfr("nan"), "finite"),
    (gmpy2.mpc(1, 0), "pass an int"),
    (1j, "pass an int"),
    (True, "pass an int"),
    (Level.ONE, "pass an int"),
    (None, "pass an int"),
    ([1], "curve.floats(ts)"),
    (b"1", "pass an int"),
    (Decimal("NaN"), "finite"),
    (Decimal("sNaN"), "finite"),
    (Decimal("-Infinity"), "finite"),
    ("1/0", "non-zero denominator"),
    ("0/0", "non-zero denominator"),
    ("", "write for example"),
    (" ", "write for example"),
    (".", "write for example"),
    ("e5", "write for example"),
    ("-", "write for example"),
    ("nan", "write for example"),
    ("inf", "write for example"),
    ("-Infinity", "write for example"),
    ("1_000", "write for example"),
    ("1,5", "write for example"),
    ("1 2", "write for example"),
    ("--1", "write for example"),
    ("1/2/3", "write for example"),
    ("0.5/2", "write for example"),
    ("1e5.5", "write for example"),
    ("0x", "write for example"),
    ("0xp3", "write for example"),
    ("0x1g", "write for example"),
    ("1p3", "write for example"),
    ("1\x00", "write for example"),
    ("١", "write for example"),
    ("１", "write for example"),
    ("½", "write for example"),
    ("1\u00a0", "write for example"),
    ("−1", "write for example"),
    ("1e999999999", "scale"),
    ("1e-999999999", "scale"),
    ("1e100001", "scale"),
    ("0x1p-999999999", "scale"),
    ("1e9999999999999", ""),
    (Decimal("1E+999999"), "scale"),
]


@pytest.mark.parametrize(("value", "remedy"), REFUSED, ids=[ascii(v)[:24] for v, _ in REFUSED])
def test_refused_with_a_remedy(value, remedy):
    with pytest.raises(NumberError) as caught:
        rational(value)
    assert remedy in caught.value.remedy
    assert caught.value.problem
    assert caught.value.remedy
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 250


def test_a_float_is_told_both_ways_out():
    with pytest.raises(
        NumberError, match=r'0\.1 is a float.*write "0\.1" for the decimal, exactspline\.from_floats\(0\.1\)'
    ):
        rational(0.1)


def test_the_longest_text_is_refused_before_it_is_read():
    with pytest.raises(NumberError, match="4000001 characters"):
        rational("1" * 4_000_001)
    assert rational("1" + "0" * 100_000) == mpq(10) ** 100_000


def test_a_long_number_of_a_wrong_kind_is_refused_too():
    with pytest.raises(NumberError):
        rational([10**5000])


@pytest.mark.parametrize("kind", ["float64", "float32", "float16", "bool_", "str_", "longdouble"])
def test_numpy_scalars_are_refused(kind):
    numpy = pytest.importorskip("numpy")
    with pytest.raises(
        NumberError, match=r"is a float.*from_floats\(1\.0\)" if "floa" in kind or "long" in kind else "numpy"
    ):
        rational(getattr(numpy, kind)(1))
    with pytest.raises(NumberError, match="numpy"):
        rational(numpy.array(1))


@pytest.mark.parametrize("value", [float("nan"), float("inf"), 1, True, "0.1", None, mpq(1, 2), Decimal(1)])
def test_from_float_refuses_the_rest(value):
    with pytest.raises(NumberError):
        from_float(value)


@given(numbers())
def test_round_trips(q):
    assert rational(text(q)) == q
    assert rational(to_fmpq(q)) == q
    assert rational(Fraction(int(q.numerator), int(q.denominator))) == q
    assert ratio(to_fmpz(q.numerator), to_fmpz(q.denominator)) == q
    assert ratio(to_fmpz(-q.numerator), to_fmpz(-q.denominator)) == q
    assert type(to_fmpq(q)) is flint.fmpq
    assert type(to_fmpz(q.numerator)) is flint.fmpz
    assert rational(to_fmpz(q.numerator)) == q.numerator


@given(st.decimals(allow_nan=False, allow_infinity=False, min_value=-(10**30), max_value=10**30))
def test_a_decimal_and_its_text_are_one_number(value):
    assert rational(value) == rational(str(value)) == Fraction(value)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_hex_text_is_the_float(value):
    assert rational(value.hex()) == from_float(value) == Fraction(value)


def test_floats_in_a_sequence():
    assert from_floats([0.5, -0.0, 5e-324]) == [mpq(1, 2), 0, mpq(1, 2**1074)]
    assert from_floats(((0.1, 2.0), (1e300, 3.5))) == [[Fraction(0.1), 2], [Fraction(1e300), mpq(7, 2)]]
    assert from_floats([]) == []
    assert from_floats(7) == 7  # a ShapeError before
    assert from_floats([0, 2**70, 0.5]) == [0, 2**70, mpq(1, 2)]
    with pytest.raises(NumberError) as caught:
        from_floats([[0.5, 1.0], [0.5, float("inf")]])
    assert caught.value.where == "[1][1]"
    for wrong in ([True], ["0.5"], [[0.5], None]):
        with pytest.raises(NumberError):
            from_floats(wrong)


@pytest.mark.parametrize("kind", ["int8", "int32", "int64", "uint8", "uint64"])
def test_integers_of_numpy_are_integers(kind):
    numpy = pytest.importorskip("numpy")
    most = numpy.iinfo(kind).max
    assert rational(getattr(numpy, kind)(most)) == int(most)
    points = numpy.array([[1, 2], [3, 4]], dtype=kind)
    assert exactspline.Nurbs(1, [0, 0, 1, 1], points)(1) == (3, 4)


def test_floats_of_numpy_enter_by_the_door_for_floats():
    numpy = pytest.importorskip("numpy")
    points = numpy.array([[0.5, 2.0], [0.25, 4.0]])
    assert exactspline.Nurbs(1, [0, 0, 1, 1], from_floats(points))(1) == (mpq(1, 4), 4)


ROOT = Path(exactspline.__file__).parent


@pytest.mark.parametrize("room", ["language", "roots", "splines"])
def test_gmpy2_is_imported_through_exact_alone(room):
    for path in (ROOT / room).rglob("*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        named = {a.name for node in ast.walk(tree) if isinstance(node, ast.Import) for a in node.names}
        named |= {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        assert "gmpy2" not in named, path
