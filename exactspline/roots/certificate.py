"""Certificates of zero sets: JSON data with exact strings, for `exactspline.certificates` or any other checker.

A segment contains the integers ``c_i`` of its form ``Σ c_i (1 − t)ⁿ⁻ⁱ tⁱ`` (t from 0 to 1 on the segment), the leaves
of a subdivision of [0, 1], each with the number, 0 or 1, of sign changes of the Bernstein coefficients on it, and the
midpoints that are zeros themselves. If required by multiple zeros, it also contains factors whose powers multiply to
the form, up to a constant, the zeros at the ends and powers of ``u + v``; the leaves then refer to the product of the
factors, each taken once. The roots, with the intervals computed so far, are those of the whole spline. An interval on
which it vanishes is given by its two ends; if it crosses the seam of a periodic spline, its end is smaller than its
beginning.
"""

from __future__ import annotations

from collections.abc import Iterable

from exactspline.certificates import ZEROS
from exactspline.certificates import certificate as written
from exactspline.numbers.exact import mpq, text
from exactspline.polynomials.isolation import Isolation
from exactspline.roots.root import Root
from exactspline.splines.bspline import BSpline


def certificate(
    f: BSpline,
    isolations: Iterable[Isolation | None],
    roots: Iterable[Root],
    jumps: Iterable[tuple[mpq, int, int]],
    intervals: Iterable[tuple[mpq, mpq]],
    *,
    periodic: bool,
) -> dict[str, object]:
    """The proof of a zero set as JSON data; `jumps` are given by the parameter and the signs on both sides, `intervals`
    by their ends.

    >>> from exactspline import zeros
    >>> zeros(BSpline.bezier([1, -2, 1])).certificate()["segments"][0]["leaves"]
    [['0', '1/2', 1], ['1/2', '1', 1]]
    """
    data: dict[str, object] = {
        "degree": f.degree,
        "periodic": periodic,
        "breakpoints": [text(t) for t in f.mesh.breaks],
        "segments": [
            _segment([str(c[k]) for k in range(f.degree + 1)], i)
            for c, i in zip(f.polynomials, isolations, strict=True)
        ],
        "roots": [
            {
                "low": text(root.low),
                "high": text(root.high),
                "multiplicities": [root.left_multiplicity, root.right_multiplicity],
                "signs": list(root.signs),
            }
            for root in roots
        ],
        "jumps": [{"at": text(t), "signs": [left, right]} for t, left, right in jumps],
        "intervals": [[text(low), text(high)] for low, high in intervals],
    }
    return written(ZEROS, data)


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
