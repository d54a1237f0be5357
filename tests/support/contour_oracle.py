"""What there is on a closed chain of parabolas and lines, in fractions of Python: no code shared with the toolkit.

A piece is three points of a quadratic Bézier curve over [i, i + 1]; a line has its middle point in the middle.
"""

from fractions import Fraction

from tests.support.vectors import dot, turn


def _minus(a, b):
    return tuple(x - y for x, y in zip(a, b, strict=True))


def _sign(x):
    return (x > 0) - (x < 0)


class Piece:
    """``γ′(t) = first + t bend``: the curvature has one sign, that of [γ′ γ″], and is largest where γ′·γ″ = 0."""

    def __init__(self, points):
        a, b, c = [tuple(Fraction(x) for x in p) for p in points]
        self.first = tuple(2 * x for x in _minus(b, a))
        self.last = tuple(2 * x for x in _minus(c, b))
        self.bend = _minus(self.last, self.first)
        self.turning = turn(self.first, self.bend)

    def slope(self, t):
        """The sign of κ′ at t, just inside where it is 0 at an end: that of −[γ′ γ″] (γ′·γ″)."""
        rate = dot(self.first, self.bend) + t * dot(self.bend, self.bend)
        inwards = rate or dot(self.bend, self.bend) * (1 if t == 0 else -1)
        return -_sign(self.turning) * _sign(inwards)

    def vertex(self):
        """The parameter inside at which |κ| is largest, or None."""
        size = dot(self.bend, self.bend)
        if not self.turning or not size:
            return None
        t = -dot(self.first, self.bend) / size
        return t if 0 < t < 1 else None

    def singular(self):
        """Whether γ′ vanishes somewhere."""
        if not any(self.first) or not any(self.last):
            return True
        return not self.turning and dot(self.first, self.last) < 0


def features(pieces):
    """Corners, inflections, extrema with their kind, and maximal straight runs, split at the seam."""
    count = len(pieces)
    corners, inflections, extrema, smooth = [], [], [], []
    for i, piece in enumerate(pieces):
        before = pieces[i - 1]
        tangent = turn(before.last, piece.first) == 0 and dot(before.last, piece.first) > 0
        if not tangent:
            corners.append(i)
        kappas = [
            (_sign(p.turning), Fraction(p.turning**2) / dot(v, v) ** 3)
            for p, v in ((before, before.last), (piece, piece.first))
        ]
        if tangent and kappas[0] == kappas[1]:
            smooth.append(i)
            left, right = before.slope(1), piece.slope(0)
            if left * right < 0:
                extrema.append((Fraction(i), "maximum" if left > 0 else "minimum"))
        if tangent and kappas[0][0] * kappas[1][0] < 0:
            inflections.append(Fraction(i))
        if (t := piece.vertex()) is not None:
            extrema.append((i + t, "maximum" if piece.turning > 0 else "minimum"))
    straight, run = [], None
    for i in range(count):
        if pieces[i].turning:
            run = None
            continue
        if run is not None and i in smooth:
            straight[-1] = (straight[-1][0], i + 1)
        else:
            straight.append((i, i + 1))
        run = i
    return corners, inflections, sorted(extrema), straight
