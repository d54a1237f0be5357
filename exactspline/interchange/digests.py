"""Short digests of exact data."""

from __future__ import annotations

from hashlib import blake2b

from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface


def short_digest(text: str) -> str:
    """Sixteen hexadecimal digits that change with the text: a protection against accidents, not against forgery."""
    return blake2b(text.encode("utf-8", "surrogatepass"), digest_size=8).hexdigest()


def curve_digest(curve: Nurbs) -> str:
    """A digest of a curve's exact data, whatever its name."""
    points = [*curve.knots, *curve.weights, *(x for row in curve.control_points for x in row)]
    return short_digest(f"{curve.degree} {curve.dimension} {' '.join(map(str, points))}")


def surface_digest(surface: NurbsSurface) -> str:
    """A digest of a surface's exact data, whatever its name."""
    net = (x for row in surface.control_points for point in row for x in point)
    points = [*surface.knots[0], "|", *surface.knots[1], *(w for row in surface.weights for w in row), *net]
    return short_digest(f"{surface.degree} {surface.dimension} {' '.join(map(str, points))}")
