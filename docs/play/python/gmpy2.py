"""What exactspline uses of gmpy2, over the standard library: for the page, where no gmpy2 is built for WebAssembly.

Numbers are those of Python, so results are the same; only the speed differs (`tests/journeys/test_play_stand_in.py`
runs both).
"""

from fractions import Fraction
from math import gcd, isqrt, lcm
from numbers import Rational

__all__ = ["gcd", "iroot", "is_square", "isqrt", "lcm", "mpq", "mpz"]


class mpz(int):  # noqa: N801  # gmpy2's name
    """Integers that stay of this type under the ring's operations."""

    def __repr__(self) -> str:
        return f"mpz({int(self)})"

    def __str__(self) -> str:
        return int.__repr__(self)


class mpq(Fraction):  # noqa: N801  # gmpy2's name
    """Fractions that stay of this type under the field's operations."""

    def __new__(cls, numerator=0, denominator=None):
        """From numbers or text, like `Fraction`."""
        value = super().__new__(cls, _plain(numerator), None if denominator is None else _plain(denominator))
        value._numerator, value._denominator = mpz(value._numerator), mpz(value._denominator)
        return value

    def __repr__(self) -> str:
        return f"mpq({int(self.numerator)},{int(self.denominator)})"

    def __reduce__(self):
        return mpq, (int(self.numerator), int(self.denominator))


def _plain(value):
    if isinstance(value, str):
        return Fraction(value)
    return value if isinstance(value, (Rational, float)) else Fraction(int(value.numerator), int(value.denominator))


def _closed(kind, plain, name):
    operation = getattr(plain, name)

    def method(self, *others):
        value = operation(self, *others)
        return kind(value) if isinstance(value, plain) else mpz(value) if isinstance(value, int) else value

    return method


_BOTH = (
    "add",
    "radd",
    "sub",
    "rsub",
    "mul",
    "rmul",
    "floordiv",
    "rfloordiv",
    "mod",
    "rmod",
    "neg",
    "pos",
    "abs",
    "pow",
)
for _kind, _plain_kind, _more in (
    (mpz, int, ("lshift", "rshift", "floor", "ceil")),
    (mpq, Fraction, ("truediv", "rtruediv", "floor", "ceil")),
):
    for _name in (*_BOTH, *_more):
        setattr(_kind, f"__{_name}__", _closed(_kind, _plain_kind, f"__{_name}__"))


def iroot(x, n):
    """The integer part of the n-th root and whether it is exact."""
    if n == 2:
        root = isqrt(x)
    else:
        root = 1 << -(-int(x).bit_length() // n)
        while (better := ((n - 1) * root + x // root ** (n - 1)) // n) < root:
            root = better
    return mpz(root if x else 0), root**n == x


def is_square(x) -> bool:
    """Whether x is the square of an integer."""
    return x >= 0 and isqrt(x) ** 2 == x
