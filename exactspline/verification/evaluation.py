"""One curve, evaluated for many claims: the arguments of formulas, and which assumptions hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import pairwise, product
from typing import Any

from exactspline.language.arguments import PARAMETERS, Evaluated, Operands
from exactspline.language.kinds import PairKind, kind_of
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import cached_property
from exactspline.polynomials.isolation import zero_on_segment
from exactspline.splines.bspline import BSpline
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface
from exactspline.splines.tensor import TensorSpline, surface_pair
from exactspline.symbolic.assumptions import Assumption
from exactspline.verification.check_arguments import Given, argument, moved_copy
from exactspline.verification.evidence import AssumptionFails, At, Between, OnAllOf, OnPatch, OnWholePatch, Place
from exactspline.verification.vocabulary import ArgumentKind


class Evaluation:
    """One curve with the values of formulas on it. It belongs to one run of the ledger: curves can be shared between
    threads, evaluations are not.

    >>> from exactspline.interchange.examples import example
    >>> own = Evaluation(example("cusp"))
    >>> own.argument("plane") is own.argument("plane"), own.argument("plane") is own.curve
    (True, False)
    """

    def __init__(self, curve: Nurbs | NurbsSurface | Operands) -> None:
        self.curve: Any = curve
        self._arguments: dict[str, Given] = {}
        self._pair: Evaluated | None = None
        self._failing: dict[tuple[str, Assumption], AssumptionFails | None] = {}

    def given(self, kind: str) -> Given:
        """The argument of formulas of a kind, which memoizes their values, and what it is."""
        if kind == ArgumentKind.TABLE:
            return Given(self.curve)
        if kind not in self._arguments:
            given = argument(kind, self.curve)
            made = self._bare if given.argument is self.curve else given.argument.remembering()
            self._arguments[kind] = given._replace(argument=made)
        return self._arguments[kind]

    @cached_property
    def _bare(self) -> Evaluated:
        """The curve itself, for all kinds without additional operands."""
        bare: Evaluated = self.curve.remembering()
        return bare

    def argument(self, kind: str) -> Evaluated:
        """The argument of formulas of a kind."""
        return self.given(kind).argument

    def _assumed_of(self, kind: str) -> Evaluated:
        """The argument about which assumptions are made: all segments of both curves of a pair."""
        if not isinstance(kind_of(kind), PairKind):
            return self.argument(kind)
        if self._pair is None:
            self._pair = surface_pair(self.curve, moved_copy(self.curve)).remembering()
        return self._pair

    def failing(self, kind: str, assumed: Iterable[Assumption]) -> AssumptionFails | None:
        """The first assumption that fails on this curve, with the place; None when all hold."""
        for each in assumed:
            if (kind, each) not in self._failing:
                on_surface = isinstance(self.curve, NurbsSurface)
                own = self._assumed_of(kind)
                place = fails_on_surface(each, each.polynomial(own)) if on_surface else _fails(each, own)
                self._failing[kind, each] = AssumptionFails(each, place) if place else None
            if failing := self._failing[kind, each]:
                return failing
        return None


#: The evaluations of a context, by the identity of the curve (which they keep alive).
_SHARED: ContextVar[dict[int, Evaluation] | None] = ContextVar("shared evaluations", default=None)


@contextmanager
def sharing_evaluations() -> Iterator[None]:
    """A context in which each curve has one evaluation."""
    token = _SHARED.set({})
    try:
        yield
    finally:
        _SHARED.reset(token)


def evaluation(curve: Nurbs | NurbsSurface | Operands | Evaluation) -> Evaluation:
    """The evaluation of a curve; an evaluation is returned unchanged.

    >>> from exactspline.interchange.examples import example
    >>> with sharing_evaluations():
    ...     evaluation(example("cusp")) is evaluation(example("cusp"))
    True
    """
    if isinstance(curve, Evaluation):
        return curve
    shared = _SHARED.get()
    return Evaluation(curve) if shared is None else shared.setdefault(id(curve), Evaluation(curve))


def _fails(each: Assumption, argument: object) -> Place | None:
    value = each.polynomial(argument)
    if isinstance(value, TensorSpline):
        return _fails_on_pair(each, value)
    if not each.everywhere:
        return next((segment(value, i) for i, p in enumerate(value.numerators) if not p), None)
    return zero_of(value)


def _fails_on_pair(each: Assumption, value: TensorSpline) -> Place | None:
    """The same where the parameters are those of two curves. What depends on one of them is on each segment of the
    other curve the same for all its parameters: one line decides.
    """
    if not each.everywhere:
        return None if all(value.numerators) else OnWholePatch()
    other = PARAMETERS[0 if each.second else 1]
    if not value.d(1, by=other).is_zero:
        return fails_on_surface(each, value)
    line = value.at_s if each.second else value.at_t
    middles = [(a + b) / 2 for a, b in pairwise(value.meshes[0 if each.second else 1].breaks)]
    return next((place for t in middles if (place := zero_of(line(t)))), None)


def fails_on_surface(each: Assumption, value: TensorSpline) -> Place | None:
    """The place where a value in two parameters is not as assumed; what could not be decided counts as a zero."""
    from exactspline.bivariate.signs import Sign, sign_on_patch  # most evaluations are of curves

    patches = product(*[range(len(mesh)) for mesh in value.meshes])
    for form, (i, j) in ((value.patch_form(*patch), patch) for patch in patches):
        if not each.everywhere:
            if form.is_zero:
                return OnWholePatch()
            continue
        sign = Sign.ZERO if form.is_zero else sign_on_patch(form).sign
        if sign not in (Sign.POSITIVE, Sign.NEGATIVE):
            return OnPatch(i, j, possibly=sign is Sign.UNDECIDED)
    return None


def segment(f: BSpline, i: int) -> OnAllOf:
    """A whole segment."""
    return OnAllOf(*f.breakpoints[i : i + 2])


def zero_of(f: BSpline) -> Place | None:
    """Where a spline has a zero, including zeros as one-sided limits; None when it has none.

    >>> str(zero_of(BSpline.identity(0, 1))), zero_of(BSpline.identity(0, 1) + 1)
    ('at the parameter 0', None)
    """
    for i, p in enumerate(f.numerators):
        if not p:
            return segment(f, i)
        a, b = f.breakpoints[i : i + 2]
        if zero := zero_on_segment(p, f.degree):
            return place_between(Interval(a, b).part(zero))
    return None


def place_between(interval: Interval) -> At | Between:
    """The place of a zero."""
    s, t = interval
    return At(s) if s == t else Between(s, t)
