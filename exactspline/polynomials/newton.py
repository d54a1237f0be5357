"""Where a zero may be: Newton's method in doubles. Nothing is proved here; exact signs prove what is proposed."""

from __future__ import annotations

from flint import fmpz_poly

from exactspline.numbers.exact import mpq

#: The bits of the largest coefficient, the greatest number of steps, and the length of the last one.
LARGEST, STEPS, CLOSE = 60, 30, 2.0**-24
#: Multiples of the reciprocal of this number are not proposed: ball arithmetic recognizes them as rational zeros.
SHORT = 1 << 16


def proposed(g: fmpz_poly, low: mpq, high: mpq, sign: int, units: int) -> int | None:
    """The local parameter of the only zero in one half of the segment, possibly, in units of ``1/units``, rounded down;
    `sign` is that of the form just right of `low`.

    >>> proposed(fmpz_poly([1, -3, 1]), mpq(0), mpq(1, 2), 1, 1000)  # (5 − √5)/10
    276
    """
    shift = max(int(g.height_bits()) - LARGEST, 0)
    doubles = [float(int(x >> shift)) for x in g.coeffs()]
    first, last = float(low), float(high)
    # at most 1, as in a chart of the refinement
    flipped = first + last > 1
    if flipped:
        first, last = (1 - last) / last, (1 - first) / first
    else:
        doubles.reverse()
        first, last = first / (1 - first), last / (1 - last)
    x, positive = (first + last) / 2, (sign > 0) != flipped
    for _ in range(STEPS):
        value = slope = 0.0
        for c in doubles:
            slope = slope * x + value
            value = value * x + c
        first, last = (x, last) if (value > 0) is positive else (first, x)
        before, x = x, x - value / slope if slope else first
        if not first < x < last:
            x = (first + last) / 2
        if -CLOSE < x - before < CLOSE:
            break
    if abs(x * SHORT - round(x * SHORT)) < CLOSE:
        return None
    return int((1 if flipped else x) / (1 + x) * units)
