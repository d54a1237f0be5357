"""Whether ``left = factor · right``: decided in one place, whatever the two sides are made of (differential
polynomials, splines, expressions of sympy). Two sides that vanish say nothing, and neither does what is divided by
zero.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, auto
from typing import Any

from exactspline.language.parts import Value, split
from exactspline.verification.verdict import PROVED, REFUTED, VACUOUS
from exactspline.verification.vocabulary import Verdict


class Outcome(Enum):
    """How two sides compare."""

    EQUAL = auto()
    #: They differ; the component in which they do is known, and the difference there.
    DIFFERENT = auto()
    #: They are vectors of different numbers of components.
    UNLIKE = auto()
    #: Both vanish: 0 = 0.
    NOTHING = auto()
    #: A side does not exist (on a whole segment, or anywhere): it is divided by zero.
    NO_SIDE = auto()
    #: The factor does not exist (on a whole segment, or anywhere): it is divided by zero.
    NO_FACTOR = auto()


@dataclass(frozen=True)
class Decision:
    """How two sides compare, and the component in which they differ, with a multiple of the difference."""

    outcome: Outcome
    component: int = 0
    difference: Any = None

    def verdict(self, equal: Verdict) -> Verdict:
        """The verdict, PROVED or VERIFIED where the sides are equal. A factor that exists for no curve makes a
        statement false; one that does not exist on one curve says nothing there.
        """
        if self.outcome is Outcome.EQUAL:
            return equal
        silent = self.outcome in (Outcome.NOTHING, Outcome.NO_SIDE)
        return VACUOUS if silent or (self.outcome is Outcome.NO_FACTOR and equal is not PROVED) else REFUTED


def decide_identity(left: Value, right: Value, factor: tuple[Value, Value] | None = None) -> Decision:
    """Whether one value is another one times a factor, given as numerator and denominator (None: 1).

    >>> from exactspline.papers import find
    >>> from exactspline.symbolic.factorization import jets_for
    >>> c = jets_for(("f1", "f2"), 2)
    >>> f1, f2 = find("f1")(c), find("f2")(c)
    >>> [decide_identity(f1, f2, each).outcome.name for each in ((c.w, c.w / c.w), (c.w, f1 - f1), None)]
    ['EQUAL', 'NO_FACTOR', 'DIFFERENT']
    >>> decide_identity(f1 - f1, f2 - f2).outcome.name
    'NOTHING'
    """
    (ps, k), (qs, m) = _parts(left), _parts(right)
    parts = [(None, None)] * 2 if factor is None else [_parts(each) for each in factor]
    (top, above), (bottom, below) = parts
    if any(each is not None and _vanishes(each) for each in (k, m)):
        return Decision(Outcome.NO_SIDE)
    nothing = top is not None and top[0].is_zero
    if all(x.is_zero for x in ps) and (nothing or all(x.is_zero for x in qs)):
        return Decision(Outcome.NOTHING)
    if any(each is not None and _vanishes(each) for each in (above, below, bottom and bottom[0])):
        return Decision(Outcome.NO_FACTOR)
    if len(ps) != len(qs):
        return Decision(Outcome.UNLIKE)
    for i, (p, q) in enumerate(zip(ps, qs, strict=True)):
        ours = _product(p, m, bottom and bottom[0], above)
        theirs = _product(q, k, top and top[0], below)
        if not (difference := ours - theirs).is_zero:
            return Decision(Outcome.DIFFERENT, i, difference)
    return Decision(Outcome.EQUAL)


def _parts(value: Any) -> tuple[Any, Any]:
    return split(value)


def _product(value: Any, *others: Any) -> Any:
    for other in others:
        value = value if other is None else value * other
    return value


def _vanishes(value: Any) -> bool:
    """Whether a denominator vanishes identically, a spline on a whole segment."""
    return value.is_zero or not all(getattr(value, "polynomials", ()))
