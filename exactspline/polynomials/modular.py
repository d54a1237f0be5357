"""Proofs that integer forms have no rational zero, for many forms in one operation: their residues are evaluated at all
points of projective lines over small prime fields. Derivation: docs/certified-filter.md.

This module and `exactspline.polynomials.doubles` are the only ones of `polynomials` that load numpy.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import prod

import numpy as np

from exactspline.polynomials.doubles import Flags, Floats

#: The primes, tried in turn on the forms not yet decided.
PRIMES = (11, 13, 17, 19, 23, 29, 31, 37, 41, 43)
#: Longer numbers are replaced by their residues modulo the product of the primes, which has fewer bits.
BITS, PRODUCT = 62, prod(PRIMES)


def without_rational_zero(forms: Sequence[Sequence[int]]) -> Flags:
    """A mask of the forms (of the same degree, given by rows of integer coefficients of ``uⁿ⁻ⁱvⁱ``) that certainly have
    no rational zero; False decides nothing.

    >>> without_rational_zero([[-2, 0, 1], [-4, 0, 1], [0, 0, 0], [-2 * 10**40, 0, 10**40]]).tolist()
    [True, False, False, True]

    (x² − 2)(x² − 3)(x² − 6) has zeros modulo every prime, but no rational zeros:

    >>> without_rational_zero([[-36, 0, 36, 0, -11, 0, 1]]).tolist()
    [False]
    """
    rows = np.array([_short(form) for form in forms], dtype=np.int64)
    certain = np.zeros(len(rows), dtype=bool)
    left = np.arange(len(rows))
    for p in PRIMES:
        if not len(left):
            break
        values = (rows[left] % p).astype(float) @ _monomials(p, rows.shape[1] - 1)
        here = (np.fmod(values, p) != 0).all(axis=1)
        certain[left[here]] = True
        left = left[~here]
    return certain


def _short(form: Sequence[int]) -> Sequence[int]:
    return [x % PRODUCT for x in form] if any(x.bit_length() > BITS for x in form) else form


@cache
def _monomials(p: int, degree: int) -> Floats:
    """The monomials of a degree at all points of a projective line, (1 : t) and (0 : 1). Products with residues are
    integers below ``p² (degree + 1)``, which are exact in doubles.
    """
    rows = [[pow(t, i, p) for t in range(p)] + [int(i == degree)] for i in range(degree + 1)]
    return np.array(rows, dtype=float)
