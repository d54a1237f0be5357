"""Zero sets written out as proofs: JSON data with exact strings, for `exactspline.roots.checker` or any other reader.

A segment carries the integers ``c_i`` of its form ``Σ c_i (1 − t)ⁿ⁻ⁱ tⁱ`` (t from 0 to 1 on the segment), the leaves of
a subdivision of [0, 1] with the number, 0 or 1, of sign changes that the Bernstein coefficients have there, the
midpoints that are zeros themselves, and, where multiple zeros asked for it, factors whose powers multiply to the form
up to a constant, the zeros at the ends and powers of ``u + v``; the leaves then belong to the product of the factors,
each taken once. The roots, with the intervals reached so far, are those of the whole spline. An interval on which it
vanishes is given by its two ends, the end before the beginning where it crosses the seam of a periodic spline.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactspline.exact import mpq, text

if TYPE_CHECKING:
    from exactspline.roots.isolation import Isolation
    from exactspline.roots.zero_set import ZeroSet

FORMAT = "exactspline zeros 1"


def certificate(found: ZeroSet) -> dict[str, object]:
    """The proof of a zero set as JSON data.

    >>> from exactspline import BSpline
    >>> from exactspline.roots.zero_set import zeros
    >>> certificate(zeros(BSpline.bezier([1, -2, 1])))["segments"][0]["leaves"]
    [['0', '1/2', 1], ['1/2', '1', 1]]
    """
    f = found.spline
    return {
        "format": FORMAT,
        "degree": f.degree,
        "periodic": found.periodic,
        "breakpoints": [text(t) for t in f.mesh.breaks],
        "segments": [
            _segment([str(c[k]) for k in range(f.degree + 1)], i)
            for c, i in zip(f.polynomials, found.isolations, strict=True)
        ],
        "roots": [
            {
                "low": text(root.low),
                "high": text(root.high),
                "multiplicities": [root.left_multiplicity, root.right_multiplicity],
                "signs": list(root.signs),
            }
            for root in found.roots
        ],
        "jumps": [{"at": text(jump.parameter), "signs": [jump.left.sign, jump.right.sign]} for jump in found.jumps],
        "intervals": [[text(interval.low), text(interval.high)] for interval in found.intervals],
    }


def _segment(coefficients: list[str], isolation: Isolation | None) -> dict[str, object]:
    if isolation is None:
        return {"coefficients": coefficients, "factors": [], "points": [], "leaves": []}
    leaves = sorted((mpq(k, 1 << level), mpq(k + 1, 1 << level), changes) for level, k, changes in isolation.leaves)
    return {
        "coefficients": coefficients,
        "factors": [[[str(x) for x in g.polynomial.coeffs()], k] for g, k in isolation.factors or []],
        "points": [text(t) for t in sorted(mpq(k, 1 << level) for level, k in isolation.points)],
        "leaves": [[text(a), text(b), changes] for a, b, changes in leaves],
    }
