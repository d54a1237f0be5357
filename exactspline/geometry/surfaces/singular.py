"""Points at which a surface has no tangent plane: isolated and certified inside patches, listed along their borders."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial, reduce
from typing import NamedTuple

from exactspline.bivariate.across_borders import Place
from exactspline.bivariate.borders import EDGES, Edge, Patch, along, roots_along
from exactspline.bivariate.common_zeros import CommonZero, zeros_of
from exactspline.bivariate.signs import Sign, sign_on_patch
from exactspline.bivariate.zero_curve import ZeroCurve
from exactspline.bivariate.zero_lines import common_factor, divided, rational_lines, square_free, without_powers
from exactspline.errors import ReachError
from exactspline.geometry.surfaces.forms import SurfaceForms, on_patch, sides_of
from exactspline.numbers.exact import mpq
from exactspline.numbers.intervals import Box
from exactspline.one_line import OneLine
from exactspline.polynomials.patch_forms import PatchForm

#: The bits of a box around an undecided point.
FAR = 64


class Line(NamedTuple):
    """An isoparametric line on a patch: the parameter of this direction (0: u) has this value."""

    direction: int
    value: mpq


@dataclass(frozen=True, repr=False)
class ZerosOfFactor(OneLine):
    """The zeros of a common factor on a patch, if it has any: `whole` are all zeros, `lines` the isoparametric lines
    among them at rational parameters, and `curve` the other zeros, if they are more than single points; `factors` are
    the factors that vanish on lines and curve.
    """

    whole: ZeroCurve | None = None
    lines: tuple[Line, ...] = ()
    curve: ZeroCurve | None = None
    factors: tuple[PatchForm, ...] = ()

    @classmethod
    def of(cls, factor: PatchForm | None, sides: Box) -> ZerosOfFactor:
        """The zeros of a factor."""
        whole, rest = _curve_of(factor)
        if whole is None:
            return cls()
        found = [(k, x) for k in (0, 1) for x in rational_lines(whole.form, k) if 0 < x < 1]
        factors = [whole.form]
        for k, x in found:
            ends = int(-x.numerator), int(x.denominator - x.numerator)
            factors.append(PatchForm.of_net([ends] if k else [[end] for end in ends]))
            factors[0] = divided(factors[0], factors[-1])
        rest = _curve_of(factors[0])[1] if found else rest
        lines = tuple(Line(k, sides[k].at(x)) for k, x in found)
        return cls(whole, lines, rest, tuple(f for f in factors if any(f.degree)))

    @property
    def along_curve(self) -> bool:
        """Whether there are lines or a curve."""
        return bool(self.lines or self.curve)

    def without(self, form: PatchForm, *, even: bool = False) -> PatchForm:
        """A form divided by the factors as often as possible; with `even`, by their squares."""
        return reduce(partial(without_powers, even=even), self.factors, form)

    def with_single_points(
        self, found: Sequence[CommonZero], known: Sequence[CommonZero] = ()
    ) -> tuple[list[CommonZero], list[Box]]:
        """The points found inside that are not zeros of the factor, and the single zeros of the factor that are not
        `known` already; and the undecided boxes.
        """
        if (curve := self.whole) is None:
            return list(found), []
        kept, undecided = list[CommonZero](), list(curve.undecided)
        for zero in (*found, *curve.single_points):
            try:
                if not (zero.is_zero_of(curve.form) if zero in found else any(zero.is_at(other) for other in known)):
                    kept.append(zero)
            except ReachError:
                undecided.append(zero.refine(FAR))
        return kept, undecided


#: The zeros of a constant.
NONE = ZerosOfFactor()


def _curve_of(factor: PatchForm | None) -> tuple[ZeroCurve | None, ZeroCurve | None]:
    """The zeros of a factor, if it has any; and the same zeros again if they are more than single points, otherwise
    None.
    """
    sign = Sign.POSITIVE if factor is None else sign_on_patch(factor).sign
    if factor is None or sign in (Sign.POSITIVE, Sign.NEGATIVE):
        return None, None
    curve = ZeroCurve(square_free(factor))
    return curve, curve if curve.has_branches or sign is Sign.BOTH else None


@dataclass(frozen=True, repr=False)
class SingularPoints(OneLine):
    """The zeros of the normal of a patch. The normal vanishes everywhere if `degenerate`, and along whole `edges`.
    `places` are single zeros inside, and zeros on the border, at which curves of this or another patch may end.
    `of_factor` are the zeros of a common factor of the coordinates, which form lines and curves; `undecided` are boxes
    of parameters.
    """

    degenerate: bool = False
    edges: tuple[Edge, ...] = ()
    places: tuple[Place, ...] = ()
    undecided: tuple[Box, ...] = ()
    of_factor: ZerosOfFactor = NONE

    @property
    def inside(self) -> list[CommonZero]:
        """The places inside the patch."""
        return [place.zero for place in self.places if place.is_inside]

    @property
    def regular(self) -> bool:
        """Whether there are no singular points except along edges."""
        return not (self.degenerate or self.places or self.undecided or self.of_factor.along_curve)


def singular_points(forms: SurfaceForms, patch: Patch) -> SingularPoints:
    """The singular points of a patch."""
    sides = sides_of(forms.surface, patch)
    area = on_patch(forms.area, patch)
    if area is None:
        return SingularPoints(degenerate=True)
    edges = tuple(edge for edge in EDGES if not any(area.whole.edge(*edge)))
    places = [
        Place((patch,), CommonZero.at(sides, edge.place(sides, root)))
        for edge in EDGES
        if edge not in edges
        for root in roots_along(along(area.whole, edge, sides), edge, sides)
        if not any(root == other.value(sides) for other in edges if other.direction != edge.direction)
    ]
    if sign_on_patch(area.form).sign is Sign.POSITIVE:
        return SingularPoints(edges=edges, places=tuple(places))
    normal = [None if own is None else own.form for own in (on_patch(f, patch) for f in forms.normal)]
    factor = common_factor([f for f in normal if f is not None])
    if factor is not None:
        normal = [None if f is None else divided(f, factor) for f in normal]
    of_factor = ZerosOfFactor.of(factor, sides)
    # the scalar products of the normal with both tangents are zero
    tangents = [[f.patch_form(*patch) for f in pair] for pair in zip(*forms.tangents, strict=True)]
    given = [(f, e) for f, e in zip(normal, tangents, strict=True) if f is not None]
    found = zeros_of([f for f, _ in given], sides, cofactors=[e for _, e in given])
    inside, rest = of_factor.with_single_points([zero for zero in found.zeros if zero.is_inside])
    places += [Place((patch,), zero.on(sides)) for zero in inside]
    undecided = tuple(map(sides.part, (*found.undecided, *rest)))
    return SingularPoints(False, edges, tuple(places), undecided, of_factor)
