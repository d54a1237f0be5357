"""Why the certified filter leaves curves to exact arithmetic: counted by cause, with a ceiling for each family.

Run as a program it prints the table of docs/certified-filter.md: ``python -m tests.geometry.test_filter_causes``.
"""

from collections import Counter

import pytest

from exactspline.batch.corpus import Family
from tests.support.filter_causes import CEILING, cause
from tests.support.sampled import FULL

np = pytest.importorskip("numpy")

from exactspline.geometry.analysis.many_curves import features_of_curves  # noqa: E402  # needs numpy
from exactspline.polynomials.doubles import Bounded, without_zeros  # noqa: E402

#: Families of integers of that many bits: what is left of 3000 curves of each, of which tests look at a third.
BITS = (10, 6, 4, 2)
WORDS = "degree=2-5 segments=1-4 rational=half seed=1"
COUNT = 3000 if FULL else 1000


def left(words):
    """How many curves of a family are decided by exact arithmetic, by cause, and the numbers of those without one."""
    family = Family.parsed(words)
    curves = [family.curve(i) for i in range(family.count)]
    counted, unexplained = Counter(), []
    for i in features_of_curves(curves).exact.tolist():
        counted[cause(curves[i])] += 1
        if not cause(curves[i]):
            unexplained.append(i)
    return counted, unexplained


@pytest.mark.parametrize("words", [f"{WORDS} bits={bits}" for bits in BITS[:3]] + ["degree=3 bits=10"])
def test_what_is_left_has_a_reason(words):
    """Before: 13 of 3000 curves of ten bits (16 of 3000 cubics), all for a speed that is small and not zero."""
    counted, unexplained = left(f"{words} count={COUNT}")
    assert 1000 * len(unexplained) <= CEILING * COUNT, (counted, unexplained)
    if "bits=10" in words:
        assert 1000 * sum(counted.values()) <= CEILING * COUNT, counted


def test_a_form_that_is_all_but_zero_is_told_from_one_that_is():
    """t ↦ (t − 1/3)² + ε²: certain for ε = 10⁻⁶, as far as bounds of errors allow, and never with a zero."""

    def row(epsilon):
        return [1 / 9 + epsilon**2, -2 / 9 + epsilon**2, 4 / 9 + epsilon**2]

    values = np.array([row(10.0**-k) for k in range(1, 7)] + [row(0), [1, 1, -1], [0, 1, 1], [1, -9, 1]])
    assert without_zeros(Bounded(values, np.full(values.shape, 1e-15))).tolist() == [True] * 6 + [False] * 4
    assert not without_zeros(Bounded(values, np.full(values.shape, 1e-2)))[2:].any()


if __name__ == "__main__":
    tables = {bits: left(f"{WORDS} count=3000 bits={bits}")[0] for bits in BITS}
    print("| | " + " | ".join(f"{bits} bits" for bits in BITS) + " |\n|---|" + "---|" * len(BITS))
    for reason in dict.fromkeys(reason for table in tables.values() for reason, _ in table.most_common()):
        print(f"| {reason or 'none of these'} | " + " | ".join(str(tables[bits][reason]) for bits in BITS) + " |")
    print("| all | " + " | ".join(str(sum(tables[bits].values())) for bits in BITS) + " |")
