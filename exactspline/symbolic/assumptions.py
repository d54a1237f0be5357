"""The assumptions of claims, each represented by the polynomial that it is about.

There is a single table. From it the prover determines which factors have no zero, by comparing polynomials, never their
printed names. `exactspline.verification.evaluation` checks the same objects on a given curve.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from typing import Any

from flint import fmpq_mpoly

from exactspline.errors import ClaimError
from exactspline.language.arguments import Pair
from exactspline.language.formula import Formula
from exactspline.language.kinds import PAIR as PAIR_OF_CURVES
from exactspline.language.kinds import FramedKind, Kind, kind_of
from exactspline.language.ruled import split
from exactspline.language.vector import Vector, norm2
from exactspline.one_line import OneLine
from exactspline.papers import find
from exactspline.polynomials.cost import at_its_cost
from exactspline.readings.differential_order import order_of
from exactspline.readings.jet import Jet, JetReading

#: Kinds of arguments in the plane, in space, and with two curves.
PLANE, SPACE, PAIR = ("plane", "plane point"), ("space", "point"), ("pair",)
ALONE, PAIRS = ("curve", *PLANE, *SPACE), (*PAIR, "plane pair")
#: Kinds of arguments with two parameters.
SURFACES = ("surface", "planar map")


@dataclass(frozen=True, repr=False)
class Assumption(OneLine):
    """The assumption that a polynomial in the curve has no zero (`everywhere`), or that it vanishes on no whole
    segment.

    ``name`` is its notation in claims, ``subject`` the expression that it is about, ``words`` its statement in words,
    ``meaning`` the reason to give for a factor that has no zero because of it. ``polynomial`` returns the polynomial in
    any reading, for an argument of one of the ``kinds``; it depends on the parameter of the second curve if ``second``
    is set. ``formula`` is the name of the formula whose value it is (or whose squared length, for a vector); the
    denominator of a curve has none. ``implies`` are the names of assumptions that follow from it.
    """

    name: str
    subject: str
    words: str
    meaning: str
    polynomial: Callable[[Any], Any]
    kinds: tuple[str, ...]
    everywhere: bool = True
    second: bool = False
    formula: str = ""
    implies: tuple[str, ...] = ()

    def applies_to(self, kind: Kind) -> bool:
        """Whether its polynomial is defined for arguments of a kind."""
        return _one_taken(kind, self.kinds)

    def __str__(self) -> str:
        return self.name

    def __reduce__(self) -> tuple[object, ...]:
        return assumption, (self.name,)


@lru_cache(1024)
def _one_taken(kind: Kind, names: tuple[str, ...]) -> bool:
    return any(kind.takes(kind_of(name), n) for name in names for n in kind.dimensions)


def _first(c: Any) -> Any:
    return c.first if isinstance(c, Pair) else c


def _formula(name: str) -> Callable[[Any], Any]:
    """The formula with this name on the first curve; for a vector its squared length."""

    def value(c: Any) -> Any:
        formula = find(name)
        operand = formula(c if formula.kind is PAIR_OF_CURVES else _first(c))
        return norm2(operand) if isinstance(operand, Vector) else operand

    return value


def _nowhere(name: str, meaning: str, polynomial: Callable[[Any], Any], *kinds: str, **others: Any) -> Assumption:
    return Assumption(name, name, f"{name} has no zero", meaning, polynomial, kinds, **others)


def _regular(name: str, meaning: str, formula: str, *kinds: str, **others: Any) -> Assumption:
    return _nowhere(name, meaning, _formula(formula), *kinds, formula=formula, **others)


_EVERYWHERE = (
    _nowhere("w", "the weight function, without zeros", lambda c: _first(c).w, *ALONE, *PAIRS, *SURFACES),
    _nowhere("w̄", "the weight function of the second curve, without zeros", lambda c: c.second.w, *PAIRS, second=True),
    _regular("γ′", "positive where the curve is regular", "D1_squared", *ALONE, *PAIRS),
    _nowhere(
        "γ̄′",
        "positive where the second curve is regular",
        lambda c: find("D1_squared")(c.second),
        *PAIRS,
        second=True,
        formula="D1_squared",
    ),
    _regular(
        "γ′×γ″",
        "positive where the curve is regular and its curvature is not zero",
        "binormal_form_squared",
        *SPACE,
        implies=("γ′",),
    ),
    _regular("S_u×S_v", "positive where the surface is regular", "surfaces:area_squared_lifted", "surface"),
)


def _somewhere(name: str, formula: str, kinds: tuple[str, ...], *implies: str) -> Assumption:
    return Assumption(
        f"{name} ≢ 0",
        name,
        f"{name} vanishes on no whole segment",
        "",
        _formula(formula),
        kinds,
        everywhere=False,
        formula=formula,
        implies=implies,
    )


_SOMEWHERE = (
    _somewhere("γ′", "D1_squared", (*ALONE, *PAIRS)),
    _somewhere("[γ′ γ″]", "f2", (*PLANE, "plane pair"), "γ′"),
    _somewhere("γ′×γ″", "binormal_form_squared", (*SPACE, *PAIR), "γ′"),
    _somewhere("[γ′ γ″ γ‴]", "D1_D2_D3", (*SPACE, *PAIR), "γ′", "γ′×γ″"),
    _somewhere("[γ′ γ−Q]", "plane_bisector_determinant", ("plane point",), "γ′"),
    _somewhere("γ′×(γ−Q)", "point_bisector_generator_polynomial", ("point",), "γ′"),
    _somewhere("(γ′×(γ−Q))₁", "direct_determinant_x", ("point",), "γ′"),
    _somewhere("(γ′×(γ−Q))₂", "direct_determinant_y", ("point",), "γ′"),
    _somewhere("(γ′×(γ−Q))₃", "direct_determinant_z", ("point",), "γ′"),
    _somewhere("[γ′ γ̄′ γ−γ̄]", "bisector_determinant_symmetric", PAIR, "γ′", "γ̄′"),
)


def stated_assumption(name: str, what: Formula | str, kind: Kind, everywhere: bool) -> Assumption:
    """An assumption stated by an author: that a constant, or a formula, has no zero, or that it vanishes on no whole
    segment. For a quotient the assumption says that the numerator and the denominator, as written, have no zeros (so w,
    which is in the denominator, has no zeros either).

    Raises `ClaimError` for a formula that vanishes on every curve, depends on a second curve, or has roots.
    """
    shown = what if isinstance(what, str) else what.name
    if kind.parts or (isinstance(what, Formula) and what.kind.adjoins_roots):
        raise ClaimError(f"{shown!r} is not a function of one curve alone", where="assumes", remedy="name one")
    kind = kind.without_roots if isinstance(kind, FramedKind) else kind

    def polynomial(c: Any) -> Any:
        if isinstance(what, str):
            return c.operands()[what]
        parts, below = split(what(c))
        value = norm2(Vector(*parts)) if len(parts) > 1 else parts[0]
        return value if below is None else value * below

    for n in kind.dimensions:
        order = 0 if isinstance(what, str) else order_of(what, n)
        if polynomial(JetReading(order).argument(kind, n)).is_zero:
            raise ClaimError(
                f"{shown!r} vanishes on every curve", where="assumes", remedy="no assumption about it can hold"
            )
    words = f"{shown} has no zero" if everywhere else f"{shown} vanishes on no whole segment"
    about = kind if isinstance(what, str) else what.kind
    return Assumption(name, shown, words, "not zero by assumption", polynomial, (about.name,), everywhere)


#: All assumptions by name.
ASSUMPTIONS = {each.name: each for each in (*_EVERYWHERE, *_SOMEWHERE)}


def assumption(name: str) -> Assumption:
    """The assumption with this name.

    >>> assumption("γ′×γ″").words
    'γ′×γ″ has no zero'

    Raises `ClaimError`, with the nearest names, for an unknown one.
    """
    if name not in ASSUMPTIONS:
        near = get_close_matches(name, ASSUMPTIONS, 3, 0) or list(ASSUMPTIONS)
        raise ClaimError(f"the assumption {name!r} is unknown", remedy=f"the nearest are {', '.join(map(repr, near))}")
    return ASSUMPTIONS[name]


def zero_free(jet: Jet, assumed: Iterable[Assumption] = _EVERYWHERE) -> Assumption | None:
    """The assumption by which an irreducible jet polynomial has no zero, because it divides the polynomial of the
    assumption; or None.

    By default all assumptions of this type are used: those of a regular curve without points of zero curvature.
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(2).argument(CURVE, 2)
    >>> zero_free(c.w).name, zero_free(norm2(find("D1")(c))).name, zero_free(find("f2")(c))
    ('w', 'γ′', None)
    """
    everywhere = tuple(each for each in assumed if each.everywhere)
    ring = jet.ring
    for each, polynomial in _polynomials(everywhere, ring.kind, ring.dimension, ring.order, ring.polynomial):
        if not divmod(polynomial, jet.polynomial)[1]:
            return each
    return None


@at_its_cost
def _polynomials(
    assumed: tuple[Assumption, ...], kind: Kind, dimension: int, order: int, polynomial: bool
) -> list[tuple[Assumption, fmpq_mpoly]]:
    """The polynomials of the assumptions that hold everywhere, in the ring of this kind, dimension and order."""
    argument, polynomials = JetReading(order).argument(kind, dimension, polynomial=polynomial), []
    for each in assumed:
        spoken_of = any(kind.takes(kind_of(name), dimension) for name in each.kinds)
        if spoken_of and order_of(Formula(each.polynomial, each.name, kind, ""), dimension) <= order:
            value = each.polynomial(argument)
            if value.polynomial.total_degree() > 0:
                polynomials.append((each, value.polynomial))
    return polynomials
