"""Identical up to a factor: the factor is found in the jet ring by exact division, factored, and named."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import Any

from flint import fmpq_mpoly
from gmpy2 import mpq

from exactspline.displayed import Displayed
from exactspline.errors import ClaimError
from exactspline.exact import rational
from exactspline.formulas import all_formulas, find
from exactspline.language import DIMENSIONS, RuledSurface, Vector, operands
from exactspline.printers.text import print_text, symbol_text
from exactspline.quotients import Rational
from exactspline.readings.fraction import fraction_argument
from exactspline.readings.jet import SUPERSCRIPTS, Jet, JetRing, jet_argument, polynomial_text
from exactspline.readings.order import is_polynomial, order_of
from exactspline.readings.tree import trace


def split(value: Any) -> tuple[list[Any], Any]:
    """The components of the numerator, and the denominator or None."""
    denominator = None
    if isinstance(value, RuledSurface):
        value = value.joined
    if isinstance(value, Rational):
        value, denominator = value.numerator, value.denominator
    return list(value) if isinstance(value, Vector) else [value], denominator


@dataclass(frozen=True)
class Factor(Displayed):
    """A quotient of jet polynomials, as a constant and powers of irreducible ones with names where they have one."""

    constant: mpq
    powers: tuple[tuple[str, fmpq_mpoly, int], ...]
    ring: JetRing

    def __str__(self) -> str:
        parts = [_power(name, e) for name, _, e in self.powers]
        if self.constant != 1 or not parts:
            parts.insert(0, str(self.constant))
        return "·".join(parts)

    @property
    def names(self) -> frozenset[str]:
        """The names in it."""
        return frozenset(name for name, _, _ in self.powers)

    def fraction(self) -> tuple[fmpq_mpoly, fmpq_mpoly]:
        """Numerator and denominator as jet polynomials."""
        one = self.ring.context.constant(1)
        top, bottom = one * int(self.constant.numerator), one * int(self.constant.denominator)
        for _, p, e in self.powers:
            top, bottom = (top * p**e, bottom) if e > 0 else (top, bottom * p ** (-e))
        return top, bottom

    def on(self, curve: Any) -> tuple[Any, Any]:
        """Numerator and denominator in the reading of a concrete curve."""
        top, bottom = self.fraction()
        return substitute(Jet(self.ring, top), curve), substitute(Jet(self.ring, bottom), curve)


def _power(name: str, exponent: int) -> str:
    base = f"({name})" if name[-1] in "⁰¹²³⁴⁵⁶⁷⁸⁹" else name
    return name if exponent == 1 else base + str(exponent).translate(SUPERSCRIPTS)


def substitute(jet: Jet, curve: Any) -> Any:
    """A jet polynomial on a concrete curve: the variables replaced by the derivatives of p and w.

    >>> from exactspline.curves import example
    >>> from exactspline.readings.jet import jet_curve
    >>> substitute(jet_curve(2, 1).w.d(1), example("rational_cubic")) == example("rational_cubic").w.d(1)
    True
    """
    known = operands(curve)
    one = known["w"]
    total = one.constant(0)
    for exponents, c in jet.polynomial.terms():
        term = one.constant(mpq(int(c.p), int(c.q)))
        for (name, order), e in zip(jet.ring.variables, exponents, strict=True):
            if e:
                term = term * known[name].d(order) ** int(e)
        total = total + term
    return total


def jets_for(names: tuple[str, ...], dimension: int) -> Any:
    """The indeterminate rational curve (and point, or two curves) with as many derivatives as the named formulas need, in the fraction reading."""
    kind = next((find(name).curve for name in names if find(name).curve in ("pair", "point", "plane point")), "curve")
    return fraction_argument(kind, dimension, max((order_of(find(name), dimension) for name in names), default=0))


def find_factor(left: Any, right: Any) -> Factor | None:
    """The quotient left/right of two formulas in the fraction reading, or None when they are not proportional.

    >>> from exactspline.formulas.plane import f1, f2
    >>> c = jets_for(("f1", "f2"), 2)
    >>> str(find_factor(f1(c), f2(c)))
    'w'

    Raises `ClaimError` when the right side vanishes identically.
    """
    (ps, _), (qs, _) = split(left), split(right)
    pivot = next((i for i, q in enumerate(qs) if not q.is_zero), None)
    if pivot is None:
        raise ClaimError("the right side vanishes identically", remedy="a factor needs something to multiply")
    if len(ps) != len(qs):
        return None
    quotient = ps[pivot] / qs[pivot]
    if any(p != quotient * q for p, q in zip(ps, qs, strict=True)):
        return None
    return factored(quotient.ring, quotient.top, quotient.bottom)


def factored(ring: JetRing, top: fmpq_mpoly, bottom: fmpq_mpoly) -> Factor:
    """A quotient of jet polynomials as a product of named irreducible ones."""
    a, tops = top.factor()
    b, bottoms = bottom.factor()
    constant, powers = mpq(int(a.p), int(a.q)) / mpq(int(b.p), int(b.q)), []
    for sign, factors in ((1, tops), (-1, bottoms)):
        for p, e in factors:
            name, unit = name_of(Jet(ring, p))
            constant *= unit ** (sign * int(e))
            powers.append((name, p / int(unit.numerator) * int(unit.denominator), sign * int(e)))
    return Factor(constant, tuple(sorted(powers, key=lambda item: (item[0] != "w", item[0]))), ring)


def name_of(jet: Jet) -> tuple[str, mpq]:
    """The name of an irreducible jet polynomial and its quotient by what the name stands for; its text where it has none."""
    for name, other in named_parts(jet.ring):
        if len(other.polynomial) == len(jet.polynomial):
            quotient = jet.polynomial.leading_coefficient() / other.polynomial.leading_coefficient()
            if jet.polynomial == other.polynomial * quotient:
                return name, mpq(int(quotient.p), int(quotient.q))
    return f"({polynomial_text(jet)})", mpq(1)


def named_parts(ring: JetRing) -> list[tuple[str, Jet]]:
    """The denominators and the scalar polynomial formulas of the library that this ring can express."""
    return _named_parts(ring.kind, ring.dimension, ring.order, "w" not in ring.names)


@cache
def _named_parts(kind: str, dimension: int, order: int, polynomial: bool) -> list[tuple[str, Jet]]:
    c = jet_argument(kind, dimension, order, polynomial=polynomial)
    known = operands(c)
    parts = [] if polynomial else [(known[name].ring.primes(known[name].ring.index[name, 0]), known[name]) for name in ("w", "W") if name in known]
    kinds = {"pair": ("pair",), "point": ("curve", "plane", "plane point") if dimension == 2 else ("curve", "space", "point")}
    for formula in all_formulas().values():
        if (
            formula.curve in kinds.get(kind, ("curve", "plane", "space"))
            and dimension in DIMENSIONS[formula.curve]
            and is_polynomial(formula, dimension)
            and order_of(formula, dimension) <= order
        ):
            value = formula(c)
            if isinstance(value, Jet) and not value.is_zero:
                parts.append((symbol_text(formula.symbol) or print_text(trace(formula, dimension)), value))
    return parts


def factor_of_text(text: str, curve: Any) -> tuple[Any, Any]:
    """A factor as a claim states it, ``"2 w^29 f2"`` or ``"w^-4"``, as numerator and denominator in the reading of the curve.

    Raises `ClaimError` when it cannot be read.
    """
    known = operands(curve)
    one = known["w"]
    top = bottom = one.constant(1)
    for part in text.split():
        match = re.fullmatch(r"([A-Za-z]\w*|-?\d+(?:/\d+)?)(?:\^(-?\d+))?", part)
        if not match:
            raise ClaimError(f"the factor {text!r} cannot be read", where=part, remedy='write for example "2 w^29 f2"')
        name, exponent = match[1], int(match[2] or 1)
        value = known[name] if name in ("w", "W") else find(name)(curve) if name[0].isalpha() else one.constant(rational(name))
        if exponent > 0:
            top = top * value**exponent
        else:
            bottom = bottom * value ** (-exponent)
    return top, bottom
