"""Why a curve is left to exact arithmetic by the certified filter."""

from itertools import pairwise

from exactspline import formula_of, zeros

#: Per mille of the curves of a family that may be left for no exact reason.
CEILING = 1


def cause(curve):
    """What is exactly true of a curve that no enclosure of numbers can tell; an empty text for none."""
    inflections, critical, speed = (formula_of(name)(curve) for name in ("f2", "g2", "D1_squared"))
    segments = [form.bezier_segments() for form in (inflections, critical, speed)]
    if any(piece.is_zero for form in segments for piece in form):
        return "κ or κ′ vanishes on a segment"
    ends = [[piece(t) == 0 for piece in form for t in piece.domain] for form in segments]
    if any(ends[2]):
        return "γ′ vanishes at a knot or an end"
    if any(ends[0]):
        return "κ vanishes at a knot or an end"
    if any(ends[1]):
        return "κ′ vanishes at a knot or an end"
    if any(root.multiplicity > 1 for form in segments for piece in form for root in zeros(piece)):
        return "a multiple zero"
    changes = [any(a(a.domain[1]) * b(b.domain[0]) < 0 for a, b in pairwise(form)) for form in segments[:2]]
    if curve.closed or any(changes):
        return "κ or κ′ changes its sign at a knot"
    return ""
