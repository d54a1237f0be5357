"""One segment of a curve as explicit polynomials in its parameter, with indeterminates for all free operands: the
second curve of a pair, a point, constants, a change of parameter.

What holds for these holds on the whole segment for all values of the free operands: nothing is tried at single values.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from flint import fmpq_poly

from exactspline.errors import VanishingDivisorError
from exactspline.language.arguments import BARRED, COORDINATES, PARAMETERS, Evaluated, T
from exactspline.language.kind import Kind, Rule, Symbol
from exactspline.language.kinds import HodographKind, PairKind
from exactspline.numbers.exact import mpq, to_fmpq
from exactspline.readings.jet import JetFraction, JetRing
from exactspline.splines.bspline import BSpline, in_powers
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.evaluation import with_hodograph
from exactspline.verification.evidence import At, On

#: The parameters minus those at which a segment begins; names that no operand has.
OWN, BAR = "_s", "_s_bar"
#: The number of values tried for a witness.
TRIES = 40


class _OnSegment(Kind):
    """A kind some of whose functions are polynomials in their parameters: instead of these functions the parameters are
    operands, with derivative 1.
    """

    def __init__(self, kind: Kind, *, both: bool) -> None:
        self.whole, self.name, self.dimensions = kind, f"{kind.name}, on a segment", kind.dimensions
        self.both = both

    def __reduce__(self) -> tuple[object, ...]:
        return with_explicit_curve, (self.whole, self.both)

    def explicit(self, dimension: int) -> set[str]:
        """The names of the operands that are polynomials."""
        if isinstance(self.whole, HodographKind):
            return {"x", "y", "u", "v", "h"}
        return {*COORDINATES[:dimension], "w"} | ({*BARRED[:dimension], "W"} if self.both else set())

    def symbols(self, dimension: int, *, polynomial: bool = False) -> tuple[Symbol, ...]:
        """The parameters, and the operands that are free."""
        given = self.explicit(dimension)
        parameters = [Symbol(OWN, "s", PARAMETERS[:1]), *([Symbol(BAR, "s̄", PARAMETERS[1:])] if self.both else [])]
        rest = self.whole.symbols(dimension, polynomial=polynomial)
        return (*parameters, *[symbol for symbol in rest if symbol.name not in given])

    def names(self, dimension: int) -> dict[str, bool]:
        """The names of the kind's operands."""
        return self.whole.names(dimension)

    def rules(self, dimension: int) -> dict[str, Rule]:
        """The derivative of a parameter with respect to itself."""
        return {name: lambda named: named[OWN].constant(1) for name in (OWN, *([BAR] if self.both else []))}

    def argument(
        self, dimension: int, operand: Callable[[Symbol], T], one: T, *, polynomial: bool = False
    ) -> Evaluated:
        """The argument of the kind, its polynomials included."""
        return self.whole.argument(dimension, operand, one, polynomial=polynomial)

    def of_operands(self, named: Mapping[str, T], dimension: int, one: T) -> Evaluated:
        """The argument of the kind."""
        return self.whole.of_operands(named, dimension, one)


@cache
def with_explicit_curve(kind: Kind, both: bool) -> Kind:
    """A kind whose curve, or both of whose curves, are polynomials in the parameter."""
    return _OnSegment(kind, both=both)


class OnSegment(NamedTuple):
    """An argument on the segment [low, high]."""

    argument: Any
    low: mpq
    high: mpq

    @property
    def interval(self) -> On:
        """The segment as a place."""
        return On(self.low, self.high)

    def place(self, value: JetFraction) -> At | On:
        """A parameter at which a nonzero value does not vanish (for some values of the free operands); where none is
        found quickly, the interval.
        """
        variables = value.ring.variables
        for k in range(2, 2 + TRIES):
            step = (self.high - self.low) / k
            at = [
                to_fmpq(step if name in (OWN, BAR) else mpq(3 * i + k, k + 1)) for i, (name, _) in enumerate(variables)
            ]
            if value.top(*at) and value.bottom(*at):
                return At(self.low + step)
        return self.interval


def on_segments(kind: Kind, curve: Nurbs, order: int, *, same: bool = False) -> Iterator[OnSegment]:
    """The argument of a kind on each segment of a curve: the curve (of a pair the first one, or with `same` both) by
    explicit polynomials, everything else indeterminate with derivatives up to `order`. Of a hodograph u, v and h are
    explicit, too: those that the curve gives.

    >>> from exactspline.language.kinds import kind_of
    >>> from exactspline.interchange.examples import example
    >>> [segment] = on_segments(kind_of("plane with delta"), example("parabola"), 2)
    >>> str(segment.interval), segment.argument.p[0].d(2) * segment.argument.delta
    ('on [0, 1]', (0) / (1))
    """
    both = same and isinstance(kind, PairKind)
    ring = JetRing(with_explicit_curve(kind, both), curve.dimension, order, polynomial=curve.polynomial)
    one = JetFraction(ring, ring.context.constant(1), ring.context.constant(1))
    own = with_hodograph(curve, {}) if isinstance(kind, HodographKind) else curve
    splines: dict[str, BSpline] = dict(own.operands())
    for i, (a, b) in enumerate(zip(curve.breakpoints, curve.breakpoints[1:], strict=False)):

        def operand(symbol: Symbol, i: int = i) -> JetFraction:
            if symbol.name not in ring.symbols:
                spline, parameter = splines[symbol.name.lower()], BAR if symbol.name.isupper() else OWN
                return _polynomial(spline, i, ring, parameter)
            return JetFraction(ring, ring[symbol.name].polynomial, ring.context.constant(1))

        made = kind.argument(curve.dimension, operand, one, polynomial=curve.polynomial)
        yield OnSegment(made.remembering(), a, b)


def _polynomial(f: BSpline, i: int, ring: JetRing, parameter: str) -> JetFraction:
    """A segment of a spline as a polynomial in the parameter minus its value at the start of the segment."""
    local = in_powers(f, i)(fmpq_poly([to_fmpq(f.breakpoints[i]), 1]))
    t, polynomial = ring[parameter].polynomial, ring.context.constant(0)
    for c in reversed(local.coeffs()):
        polynomial = polynomial * t + c
    return JetFraction(ring, polynomial, ring.context.constant(1))


def at_equal_parameters(value: JetFraction) -> JetFraction:
    """A value in both parameters of `on_segments(…, same=True)` where these are equal.

    Raises `VanishingDivisorError` where its denominator vanishes there.
    """
    return equated(value, {BAR: OWN})


def equated(value: JetFraction, images: Mapping[str, str]) -> JetFraction:
    """A quotient with some of its operands replaced by others, and their derivatives by theirs.

    Raises `VanishingDivisorError` where its denominator then vanishes.
    """
    ring = value.ring
    places = [ring.gens[ring.index[images.get(name, name), order]] for name, order in ring.variables]
    top, bottom = (p.compose(*places, ctx=ring.context) for p in (value.top, value.bottom))
    if not bottom:
        raise VanishingDivisorError("a denominator vanishes where the points meet", remedy="multiply the formula by it")
    return JetFraction(ring, top, bottom)
