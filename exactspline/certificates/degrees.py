"""Checks, with only the standard library, a certificate that the degree of forms cannot be lowered. Polynomials modulo
a prime are lists of integers here.
"""

from collections.abc import Mapping
from typing import Any

from exactspline.certificates.numbers import CertificateError, count, each, integer, one_of, optional, read, require
from exactspline.certificates.zeros import product_of

Polynomial = list[int]
QUOTIENT, ZERO_SET = "quotient", "zero set"
SEGMENT = {"degree": count, "prime": count, "forms": [[integer]], "cofactors": [[integer]]}
OF_ZEROS = {**SEGMENT, "weight": [integer], "irreducible modulo": optional(count)}
FORM = one_of("kind", {QUOTIENT: {"segments": [SEGMENT]}, ZERO_SET: {"segments": [OF_ZEROS]}})
#: The labels that a certificate has in addition to its proof.
LABELS = "not checked"


def check_degrees(certificate: Mapping[str, object]) -> dict[str, int]:
    """The largest degree over the segments, after checking the proof that it cannot be lowered (see
    `exactspline.verification.generic_proof`). For a zero set this means that its form is square-free and has no common
    factor with w; and, if every segment is ``irreducible``, that no polynomial over ℚ of a lower degree vanishes at a
    zero of the form.

    The proof is about the forms in the certificate. The certificate does not show that these belong to the
    construction, the curve and the intervals named: the answer says that each of these labels was not checked.

    A common factor over ℚ would also be a common factor modulo the prime, of the same degree, because the prime does
    not divide the leading coefficient of some form; but the cofactors combine the forms to 1. A common zero at the
    right end (u = 0) would make all leading coefficients vanish.
    """
    data, labels = read(certificate, FORM), read(certificate, {LABELS: _names})[LABELS]
    require(bool(data["segments"]), "no segments")
    found = each("segments", lambda segment: _segment(segment, data["kind"]), data["segments"])
    shown = {"degree": max(n for n, _ in found), **{f"{name} checked": False for name in labels}}
    return shown if data["kind"] == QUOTIENT else shown | {"irreducible": all(proved for _, proved in found)}


def _names(given: object) -> list[str]:
    """The names of the fields of an object, with any contents."""
    if not isinstance(given, Mapping):
        raise CertificateError("not an object")
    return [*given]


def _segment(segment: dict[str, Any], kind: str) -> tuple[int, bool]:
    """The degree of a segment, and whether its form is proved to be irreducible."""
    n, p, forms = segment["degree"], segment["prime"], segment["forms"]
    require(all(len(form) == n + 1 for form in forms) and any(any(form) for form in forms), "a form of another degree")
    require(is_prime(p), "no prime")
    others = [] if kind == QUOTIENT else [segment["weight"]]
    require(kind == QUOTIENT or (len(forms) == 1 and bool(segment["weight"])), "a zero set has one form, and a weight")
    require(any(form[-1] % p for form in [*forms, *others]), "the prime divides every highest coefficient")
    cofactors = segment["cofactors"]
    require(len(cofactors) == len(forms) + len(others), "cofactors are missing")
    total: Polynomial = []
    for a, form in zip(cofactors, [*forms, *others], strict=True):
        total = _add(total, _times(a, form, p), p)
    require(total == [1], "the cofactors do not combine the forms to 1")
    if kind == QUOTIENT:
        require(any(form[-1] for form in forms), "a common zero at the right end")
        q = None
    else:
        require(is_square_free(forms[0], p), "not square-free modulo the prime named")
        require(sum(x * (-1) ** i for i, x in enumerate(forms[0])) != 0, "the degree in the parameter is lower")
        q = segment["irreducible modulo"]
        require(
            q is None or (is_prime(q) and forms[0][-1] % q != 0 and is_irreducible(forms[0], q)),
            "not irreducible modulo the prime named",
        )
    return int(n), q is not None or n < 2


#: The first primes: with them as bases, the Miller–Rabin test is correct for all n below 3·10²⁴.
BASES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41)


def is_prime(n: int) -> bool:
    """The Miller–Rabin test.

    >>> is_prime(91), is_prime(97)
    (False, True)
    """
    if n < 2 or any(n % q == 0 and n != q for q in BASES):
        return False
    odd, twos = n - 1, 0
    while odd % 2 == 0:
        odd, twos = odd // 2, twos + 1
    for base in BASES:
        x = pow(base, odd, n)
        if base % n and x not in (1, n - 1) and all((x := x * x % n) != n - 1 for _ in range(twos - 1)):
            return False
    return n < 3 * 10**24


def _trimmed(a: Polynomial) -> Polynomial:
    while a and a[-1] == 0:
        a.pop()
    return a


def _add(a: Polynomial, b: Polynomial, p: int) -> Polynomial:
    size = max(len(a), len(b))
    return _trimmed([((a[i] if i < len(a) else 0) + (b[i] if i < len(b) else 0)) % p for i in range(size)])


def _times(a: Polynomial, b: Polynomial, p: int) -> Polynomial:
    return _trimmed([x % p for x in product_of(a, b)]) if a and b else []


def _remainder(a: Polynomial, f: Polynomial, p: int) -> Polynomial:
    a, inverse = _trimmed([x % p for x in a]), pow(f[-1], -1, p)
    while len(a) >= len(f):
        factor, shift = a[-1] * inverse % p, len(a) - len(f)
        a = _trimmed([(x - factor * f[i - shift]) % p if i >= shift else x for i, x in enumerate(a)])
    return a


def _gcd(a: Polynomial, b: Polynomial, p: int) -> Polynomial:
    while b:
        a, b = b, _remainder(a, b, p)
    return a


def is_square_free(form: Polynomial, p: int) -> bool:
    """Whether a form has no multiple factor modulo a prime and does not have a lower degree modulo the prime. Then the
    form has no multiple factor over ℚ. A zero as last coefficient means a zero at the right end.

    >>> is_square_free([1, 0, 1], 3), is_square_free([1, -2, 1], 3), is_square_free([1, 1, 0, 0], 3)
    (True, False, False)
    """
    f = [x % p for x in (form if form[-1] else form[:-1])]
    derivative = _trimmed([i * x % p for i, x in enumerate(f)][1:])
    return len(form) < 3 or (f[-1] != 0 and len(_gcd(f, derivative, p)) == 1)


def is_irreducible(form: Polynomial, p: int) -> bool:
    """Rabin's test: x^(pⁿ) ≡ x modulo f, and x^(p^(n/q)) − x is coprime to f for every prime q that divides n.

    >>> is_irreducible([1, 0, 1], 3), is_irreducible([1, 0, 1], 5)
    (True, False)
    """
    f, n = [x % p for x in form], len(form) - 1
    if n < 2:
        return n == 1  # a constant is not irreducible
    powers, x = [[0, 1]], [0, 1]
    for _ in range(n):
        x = _power(x, p, f, p)
        powers.append(x)
    if _add(powers[n], [0, p - 1], p):
        return False
    divisors = [n // q for q in range(2, n + 1) if n % q == 0 and all(q % r for r in range(2, q))]
    return all(len(_gcd(f, _add(powers[m], [0, p - 1], p), p)) == 1 for m in divisors)


def _power(a: Polynomial, exponent: int, f: Polynomial, p: int) -> Polynomial:
    result = [1]
    while exponent:
        if exponent % 2:
            result = _remainder(_times(result, a, p), f, p)
        a, exponent = _remainder(_times(a, a, p), f, p), exponent // 2
    return result
