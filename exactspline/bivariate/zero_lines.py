"""Isoparametric lines along which K vanishes: on borders of patches and inside patches, independent of the knots that
cut the lines.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import NamedTuple

from flint import fmpz_poly

from exactspline.bivariate.borders import Edge, Patch, along, line_of, roots_along
from exactspline.numbers.exact import common_divisor, mpq, sign
from exactspline.numbers.intervals import Box, Interval, joined
from exactspline.one_line import OneLine
from exactspline.polynomials.factors import divided_out, factorize, factorize_square_free, greatest_common_divisor
from exactspline.polynomials.patch_forms import PatchForm, of_powers, powers_of
from exactspline.polynomials.two_parameters import CONTEXT, as_form, as_polynomial
from exactspline.roots.of_polynomials import Parameter, exactly
from exactspline.splines.surface import Along

# ---- common factors


def common_factor(forms: Sequence[PatchForm]) -> PatchForm | None:
    """The greatest common divisor of forms that are not zero; None where it is a constant."""
    divisor = greatest_common_divisor(as_polynomial(f) for f in forms)
    return as_form(divisor) if divisor.total_degree() > 0 else None


def line_factor(form: PatchForm, direction: int) -> fmpz_poly:
    """The greatest factor of a form that depends on x (direction 0) or y alone, without a common divisor of its
    coefficients: where it vanishes, the form vanishes on a whole line.

    >>> line_factor(PatchForm.of_net([[1, -1], [-2, 2]]), 0)  # (1 − 3x)(1 − 2y)
    3*x + (-1)
    """
    rows = powers_of(form)
    columns = rows if direction else [list(column) for column in zip(*rows, strict=True)]
    found = greatest_common_divisor(fmpz_poly(column) for column in columns)
    return found // common_divisor(found.coeffs())


def rational_lines(form: PatchForm, direction: int) -> list[mpq]:
    """The rational values of x (direction 0) or y for which a form vanishes on the whole line.

    >>> rational_lines(PatchForm.of_net([[1, -1], [-2, 2]]), 1)
    [mpq(1,2)]
    """
    own = line_factor(form, direction)
    if own.degree() < 1:
        return []
    return sorted(mpq(int(-p[0]), int(p[1])) for p in factorize(own).bases if p.degree() == 1)


def divided(form: PatchForm, factor: PatchForm) -> PatchForm:
    """The quotient of a form by a factor of it."""
    quotient, rest = divmod(as_polynomial(form), as_polynomial(factor))
    assert not rest, "the factor divides"
    return as_form(quotient)


def without_powers(form: PatchForm, factor: PatchForm, *, even: bool = False) -> PatchForm:
    """A form divided by a factor as often as possible; with `even`, by the square of the factor, so that signs are
    preserved.

    >>> square = PatchForm.of_net([[4, -4, 4]])  # 4 (1 − 2y)²
    >>> without_powers(square, PatchForm.of_net([[1, -1]])).degree
    (0, 0)
    """
    q = as_polynomial(factor)
    return as_form(divided_out(as_polynomial(form), q * q if even else q))


def square_free(form: PatchForm) -> PatchForm:
    """The product of the factors that depend on a parameter, each once."""
    factors = factorize_square_free(as_polynomial(form)).powers
    return as_form(reduce(lambda p, q: p * q, [p for p, _ in factors], CONTEXT.from_dict({(0, 0): 1})))


def odd_part(form: PatchForm) -> PatchForm:
    """The form without squares of factors; it has the sign of the form wherever the form is nonzero.

    >>> odd_part(PatchForm.of_net([[-1, 1, -1]])).degree  # −(1 − 2y)²
    (0, 0)
    """
    constant, factors = factorize_square_free(as_polynomial(form))
    own = CONTEXT.from_dict({(0, 0): sign(constant)})
    return as_form(reduce(lambda p, q: p * q, [p for p, times in factors if times % 2], own))


@dataclass(frozen=True, repr=False)
class ZeroLine(OneLine):
    """An isoparametric line along which a form vanishes: the parameter ``along`` runs over the `interval`, the other
    parameter is `value`.

    `one_sided` means that only the limit of the form from one side of the line vanishes.
    """

    along: Along
    value: Parameter
    interval: Interval
    #: Whether the line runs through a whole period of a closed surface.
    closed: bool = False
    one_sided: bool = False

    @property
    def box(self) -> tuple[tuple[Parameter, Parameter], tuple[Parameter, Parameter]]:
        """The ranges of the parameters on the line."""
        across = self.value, self.value
        return (self.interval, across) if self.along is Along.U else (across, self.interval)


class LinesOfPatch(NamedTuple):
    """The edges of a patch and the lines inside along which a form vanishes as a limit from this patch. If `flat`, the
    form vanishes on the whole patch.
    """

    patch: Patch
    sides: Box
    edges: Sequence[Edge]
    inner: Sequence[tuple[Along, Parameter]]
    flat: bool


def without_lines(form: PatchForm, sides: Box) -> tuple[PatchForm, tuple[tuple[Along, Parameter], ...]]:
    """A square-free form on a patch without the factors in a single parameter that vanish inside, and the lines on
    which these vanish, in the parameters of the surface.

    >>> from gmpy2 import mpq
    >>> rest, lines = without_lines(PatchForm.of_net([[-1, -2], [1, 2]]), ((mpq(0), mpq(4)), (mpq(0), mpq(1))))
    >>> rest.degree, lines
    ((0, 1), ((<Along.V: 'v'>, mpq(2,1)),))
    """
    lines: list[tuple[Along, Parameter]] = []
    for direction in (0, 1):
        own = [[x] for x in line_factor(form, direction).coeffs()]
        factor = of_powers(own if direction == 0 else [[x for (x,) in own]])
        across, (low, high) = Edge(1 - direction, 0), sides[direction]
        inside = [t for t in roots_along(along(factor, across, sides), across, sides) if low < t < high]
        if inside:
            form = divided(form, factor)
            lines += [(line_of(Edge(direction, 0)), exactly(t)) for t in inside]
    return form, tuple(lines)


def zero_lines(
    counts: tuple[int, int],
    domain: Box,
    patches: Sequence[LinesOfPatch],
    closed: Sequence[Along] = (),
    *,
    beside_flat: bool = False,
) -> tuple[ZeroLine, ...]:
    """The lines on all patches, with neighbouring lines joined; `counts` are the numbers of patches in each direction.
    Borders of flat patches are included only with `beside_flat`.
    """
    sides: dict[tuple[Along, Parameter, bool], set[Interval]] = {}
    by_place = {one.patch: one for one in patches}
    for one in patches:
        for edge in one.edges:
            behind = by_place.get(_behind(one.patch, edge, counts, closed))
            if behind is not None and behind.flat and not beside_flat:
                continue
            one_sided = behind is not None and not (behind.flat or Edge(edge.direction, 1 - edge.end) in behind.edges)
            key = line_of(edge), edge.value(one.sides), one_sided
            sides.setdefault(key, set()).add(one.sides[1 - edge.direction])
        for line, value in one.inner:
            sides.setdefault((line, value, False), set()).add(one.sides[line.direction])
    lines = []
    for (line, value, one_sided), intervals in sorted(sides.items(), key=lambda item: item[0]):
        whole = domain[line.direction]
        lines += [
            ZeroLine(line, value, side, line in closed and side == whole, one_sided) for side in joined(intervals)
        ]
    return _without_seam(lines, domain, closed)


def _behind(patch: Patch, edge: Edge, counts: tuple[int, int], closed: Sequence[Along]) -> Patch:
    """The patch on the other side of an edge; at the end of a surface that is not closed, the index of a patch that
    does not exist.
    """
    place = list(patch)
    k = edge.direction
    place[k] += 1 if edge.end else -1
    if list(Along)[k] in closed:
        place[k] %= counts[k]
    return place[0], place[1]


def _without_seam(lines: list[ZeroLine], domain: Box, closed: Sequence[Along]) -> tuple[ZeroLine, ...]:
    """The lines; one on the seam of a closed surface is listed once."""
    kept = []
    for line in lines:
        across = Along.V if line.along is Along.U else Along.U
        low, high = domain[across.direction]
        if across in closed and line.value == high and replace(line, value=low) in lines:
            continue
        kept.append(line)
    return tuple(kept)
