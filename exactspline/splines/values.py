"""Names for the arguments and values of formulas over splines in one parameter."""

from __future__ import annotations

from exactspline.language.rational import Rational
from exactspline.language.ruled import RuledSurface
from exactspline.language.vector import Vector
from exactspline.splines.bspline import BSpline

#: The vectors of splines: polynomial, and over one denominator.
SplineVector = Vector[BSpline] | Rational[BSpline]
#: Ruled surfaces of such vectors.
SplineSurface = RuledSurface[SplineVector]
#: Quotients of those.
RationalSurface = RuledSurface[Rational[BSpline]]
#: What formulas return.
SplineValue = BSpline | SplineVector | SplineSurface
