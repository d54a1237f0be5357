"""A spline in two parameters as lines of splines in one, so that every operation of `BSpline` is available in either
direction.
"""

from __future__ import annotations

from flint import fmpz_poly

from exactspline.numbers.exact import lcm, to_fmpz
from exactspline.polynomials import tensor_bernstein
from exactspline.polynomials.bernstein import primitive
from exactspline.splines.bspline import BSpline
from exactspline.splines.tensor_parts import Degrees, Parts, TensorParts
from exactspline.splines.tensor_univariate import replaced


def lines(f: TensorParts) -> list[list[BSpline]]:
    """For each segment of s and each power of its local parameter the coefficients, as splines in t."""
    columns, own = len(f.meshes[1]), f._own
    found = []
    for i in range(len(f.meshes[0])):
        patches = range(i * columns, (i + 1) * columns)
        nets = [tensor_bernstein.rows(own[k], f.stride, f.degree.t) for k in patches]
        lines = []
        for h in range(max(f.degree.s, 0) + 1):  # below degree 0 a line of zeros, so that there is one to change
            forms = [
                primitive((fmpz_poly([row[h] for row in net]), f.denominators[k]))
                for k, net in zip(patches, nets, strict=True)
            ]
            lines.append(BSpline.from_forms(f.degree.t, f.meshes[1], f.continuity[1], forms))
        found.append(lines)
    return found


def joined(found: list[list[BSpline]], old: TensorParts) -> Parts:
    """Degree, meshes, continuity, stride, packed polynomials and denominators of the spline with these lines; along s
    it is as the old one.
    """
    first, stride = found[0][0], tensor_bernstein.stride_for(old.degree.s)
    polynomials, denominators = [], []
    for own in found:
        for j in range(len(first.mesh)):
            common = lcm(*[int(line.denominators[j]) for line in own])
            rows = [line._polynomials[j] * (int(common) // int(line.denominators[j])) for line in own]
            polynomials.append(
                tensor_bernstein.packed([fmpz_poly([row[k] for row in rows]) for k in range(first.degree + 1)], stride)
            )
            denominators.append(to_fmpz(common))
    continuity = (old.continuity[0], first.continuity)
    return (
        Degrees(old.degree.s, first.degree),
        replaced(old.meshes, 1, first.mesh),
        continuity,
        stride,
        tuple(polynomials),
        tuple(denominators),
    )
