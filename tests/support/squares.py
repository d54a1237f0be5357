"""Functions and surfaces over a square by formulas in both parameters, for tests."""

from exactspline import NurbsSurface, TensorSpline


def parameters(low=0, high=1):
    """Both parameters as functions on a square."""
    knots, ends = [low, low, high, high], [low, high]
    return TensorSpline((1, 0), knots, ends, [[low], [high]]), TensorSpline((0, 1), ends, knots, [[low, high]])


def graph(height, low=0, high=1):
    """The surface (u, v, height(u, v)) over a square."""
    u, v = parameters(low, high)
    return NurbsSurface.from_splines([u, v, height(u, v)])


def function(p, low=0, high=1):
    """A polynomial in both parameters on a square."""
    return p(*parameters(low, high))
