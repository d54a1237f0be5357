"""mpmath: a curve as a function of an `mpf`, accurate to the working precision."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from exactspline.numbers.exact import mpq
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.type_checks import curve_of

if TYPE_CHECKING:
    import mpmath


def to_mpmath(curve: Nurbs) -> Callable[[object], list[mpmath.mpf]]:
    """The function that maps a parameter to a point. Every coordinate is rounded once, to the working precision at the
    time of the call.

    >>> from mpmath import mpf, workdps
    >>> from exactspline.interchange.examples import example
    >>> with workdps(30):
    ...     print(to_mpmath(example("circle"))(mpf("0.25"))[0])
    0.882352941176470588235294117647
    """
    curve = curve_of(curve)

    def value(parameter: object) -> list[mpmath.mpf]:
        import mpmath
        from mpmath.libmp import from_rational, round_nearest, to_rational

        numerator, denominator = to_rational(mpmath.mpmathify(parameter)._mpf_)
        point = curve(mpq(int(numerator), int(denominator)))
        return [
            mpmath.mpf(from_rational(int(x.numerator), int(x.denominator), mpmath.mp.prec, round_nearest))
            for x in point
        ]

    return value
