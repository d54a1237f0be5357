"""Curves as explicit functions of t, for statements that fail: quotients of polynomials in one variable."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from flint import fmpq_mpoly

from exactspline.errors import ClaimError
from exactspline.extras.coq.terms import integer, sum_of_products
from exactspline.language.arguments import COORDINATES, POINT, Accompanied, Curve
from exactspline.language.implicit_kinds import ImplicitKind
from exactspline.language.kinds import CURVE, CurveKind, FramedKind, Kind, Symbol
from exactspline.readings.jet import JetRing
from exactspline.readings.rational_jet import JetFraction
from exactspline.verification.segments import with_explicit_curve

#: A polynomial in t by its coefficients.
Coefficients = tuple[int, ...]


#: Polynomials in t: the functions of a curve that is explicit.
RING = JetRing(with_explicit_curve(CURVE, both=False), 2, 0)


def function(coefficients: Coefficients) -> JetFraction:
    """A polynomial in t.

    >>> t = function((0, 1))
    >>> (1 / t).d() == -1 / (t * t)
    True
    """
    polynomial = RING.of_terms(tuple(((k,), c, 1) for k, c in enumerate(coefficients) if c))
    return JetFraction(RING, polynomial, RING.context.constant(1))


def coefficients_of(polynomial: fmpq_mpoly | int) -> Coefficients:
    """The integer coefficients of a polynomial in t."""
    if isinstance(polynomial, int):
        return (polynomial,)
    return tuple(int(polynomial[k,]) for k in range(polynomial.total_degree() + 1))


@dataclass(frozen=True)
class ExplicitCurve:
    """Numerators, denominator and additional operands by their coefficients, constants first."""

    numerators: tuple[Coefficients, ...]
    denominator: Coefficients = (1,)
    point: tuple[int, ...] = ()
    beside: Mapping[str, Coefficients] = field(default_factory=dict)

    def argument(self, kind: Kind) -> Curve[JetFraction]:
        """The argument of formulas."""
        dimension = len(self.numerators)
        functions = dict(zip(COORDINATES, self.numerators, strict=False)) | {"w": self.denominator, **self.beside}
        functions |= {name: (value,) for name, value in zip(POINT, self.point, strict=False)}

        def operand(symbol: Symbol) -> JetFraction:
            return function(functions.get(symbol.name, ()))

        if isinstance(kind, FramedKind):
            plain = CURVE.argument(dimension, operand, function((1,)))
            assert isinstance(plain, Curve)
            return Accompanied(plain, {name: function(value) for name, value in self.beside.items()})
        made = kind.argument(dimension, operand, function((1,)))
        assert isinstance(made, Curve)  # explicit curves exist only for kinds of one curve
        return made

    def term(self, kind: Kind, t: str, number: str) -> str:
        """The argument as a term of Coq in t, with this function symbol for numbers."""

        def beside(*names: str) -> str:
            return f"[{'; '.join(polynomial_term(self.beside.get(name, (0,)), t, number) for name in names)}]"

        parts = "; ".join(polynomial_term(key, t, number) for key in self.numerators)
        point = "; ".join(f"number {integer(value)}" for value in self.point)
        curve = f"rational_curve s [{parts}] ({polynomial_term(self.denominator, t, number)}) [{point}]"
        if isinstance(kind, FramedKind):
            roots = (polynomial_term(self.beside.get(root, (0,)), t, number) for root in ("sigma", "rho"))
            return f"Framed ({curve}) ({') ('.join(roots)})"
        if isinstance(kind, ImplicitKind):
            axes = COORDINATES[: len(self.numerators)]
            rows = (beside(*["f" + "".join(sorted(x + y)) for y in axes]) for x in axes)
            return f"Implicit ({curve}) {beside(*kind.free)} {beside(*['f' + x for x in axes])} [{'; '.join(rows)}]"
        if isinstance(kind, CurveKind) and kind.constants:
            return f"Accompanied ({curve}) {beside(*kind.constants)}"
        return curve


def polynomial_term(coefficients: Coefficients, t: str, number: str) -> str:
    """A polynomial in t as a term.

    >>> polynomial_term((1, 0, -2), "t", "number")
    'number 1 - number 2 * t ^ 2'
    """
    return sum_of_products(((c, [(t, k)] if k else []) for k, c in enumerate(coefficients) if c), number)


#: The numerators, denominators, points and constants to try, the simplest first.
_NUMERATORS = ((0, 1), (0, 0, 1), (1, 0, 0, 1), (0, 1, 0, 0, 1))
_DENOMINATORS = ((1, 1), (1, 0, 1))
_POINT = (1, 2, 5)
_CONSTANTS = (2, 3, 5, 7, 11)
#: Curves for which the roots of the frame are polynomials: γ′ = 3(1 − t², 2t), and γ′ = 3(1, 2t, 2t²).
_FRAMED = {
    2: ExplicitCurve(((0, 3, 0, -1), (0, 0, 3)), beside={"sigma": (3, 0, 3)}),
    3: ExplicitCurve(((0, 3), (0, 0, 3), (0, 0, 0, 2)), beside={"sigma": (3, 0, 6), "rho": (18, 0, 36)}),
}
#: The parabola y = x², along which F = y − x² is constant.
_PARABOLA = ExplicitCurve(
    ((0, 1), (0, 0, 1)), beside={"pace": (-1,), "fx": (0, -2), "fy": (1,), "fxx": (-2,), "fxy": (0,), "fyy": (0,)}
)


def candidates(kind: Kind, dimension: int, *, polynomial: bool) -> Iterator[ExplicitCurve]:
    """Explicit arguments of a kind; only polynomial ones where a claim is about these alone.

    Raises `ClaimError` for a kind without explicit arguments.
    """
    if isinstance(kind, FramedKind):
        yield _FRAMED[dimension]
    elif isinstance(kind, ImplicitKind) and kind.dimensions == (2,):
        yield _PARABOLA
    elif type(kind) is CurveKind:
        point = _POINT[:dimension] if kind.with_point else ()
        beside = {name: (value,) for name, value in zip(kind.constants, _CONSTANTS, strict=False)}
        for w in ((1,),) if polynomial else _DENOMINATORS:
            for i in range(len(_NUMERATORS) - dimension + 1):
                yield ExplicitCurve(_NUMERATORS[i : i + dimension], w, point, beside)
    else:
        raise ClaimError(f"no explicit curves of the kind {kind.name!r}", remedy="state claims about one curve")
