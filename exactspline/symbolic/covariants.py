"""The height of a differential polynomial above the covariants of binary forms, and its true degree.

Let F be homogeneous of degree k in the curve and of weight m, and L the derivation with ``L f⁽ⁱ⁾ = i (d − i + 1)
f⁽ⁱ⁻¹⁾``: the effect of an infinitesimal projective change of parameter on the derivatives of polynomials of degree d.
The height of F is the j with ``Lʲ F ≠ 0 = Lʲ⁺¹ F``; F is a covariant exactly when j = 0. On the generic curve of degree
d, the polynomial F has degree exactly ``k d − 2 m + j`` in the parameter, and on no curve is the degree larger. The
proof is in ``docs/degree-theorem.md``.

For a surface all this holds in each parameter: along a line of constant v its derivatives by v are independent curves
of degree d_u. Weight and height then count only derivatives by u.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial, reduce
from typing import Any

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpz

from exactspline.errors import FormulaError, InapplicableError, counted
from exactspline.language.operand import Parameter
from exactspline.polynomials.cost import LONGEST_LOOP, Budget, check_reach, drawing_on
from exactspline.polynomials.factors import greatest_common_divisor
from exactspline.readings.degree import Degree
from exactspline.readings.jet import Jet, JetRing, only_grading
from exactspline.readings.leading_terms import common_roots

#: Nanoseconds of L for a term and a variable in it (measured: 100 to 340), and for the square of the number of
#: variables of the ring (measured: 100).
LOWERED_TERM, LOWERED_RING = 400, 100
#: The largest sum of these estimates for one true degree.
LONGEST_HEIGHT = LONGEST_LOOP


@dataclass(frozen=True)
class TrueDegree:
    """Degree k, weight m and height j for symbolic degree d; `name` is the name of d.

    `lower` lists the d ≥ 1 for which the true degree is below ``k d − 2 m + j``, each with its true degree, where −1
    means that the polynomial vanishes on all curves of this degree.
    """

    k: int
    m: int
    j: int
    lower: tuple[tuple[int, int], ...]
    name: str = "d"

    @property
    def nominal(self) -> Degree:
        """``k d − m``, the degree by Table 1."""
        return _affine(self.name, self.k, -self.m)

    @property
    def generic(self) -> Degree:
        """``k d − 2 m + j``, the degree on the generic curve."""
        return _affine(self.name, self.k, self.j - 2 * self.m)

    @property
    def surplus(self) -> int:
        """``m − j``: the amount by which the nominal degree exceeds the true degree on every curve."""
        return self.m - self.j

    def at(self, d: int) -> int:
        """The true degree on the generic curve of degree d."""
        return dict(self.lower).get(d, self.k * d - 2 * self.m + self.j)


def _affine(name: str, k: int, constant: int) -> Degree:
    return Degree([(((name, k),) if k else (), constant)])


def true_degree(jets: Jet | Iterable[Jet], parameter: Parameter = Parameter.FIRST) -> TrueDegree:
    """k, m, j and the true degree, with respect to a parameter, of a differential polynomial or a vector of them (for a
    vector, the maximum over the components).

    >>> from exactspline.papers.chen_riesenfeld_cohen_2007.plane import f2
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import JetReading
    >>> t = true_degree(f2(JetReading(2).argument(CURVE, 2)))
    >>> (t.k, t.m, t.j), t.nominal, t.generic, t.lower
    ((3, 3, 0), 3d − 3, 3d − 6, ((1, -1),))

    >>> from exactspline.language.kinds import SURFACE
    >>> from exactspline.papers import paper
    >>> second = paper("surfaces").find("L_lifted")(JetReading(2).argument(SURFACE, 3))
    >>> [true_degree(second, parameter).generic for parameter in (Parameter.U, Parameter.V)]
    [4d_u − 6, 4d_v − 2]

    Raises `FormulaError` if it is zero, or not homogeneous in degree and weight (see `graded`), and `ReachError` if it
    may take too long.
    """
    parts = [jet for jet in ([jets] if isinstance(jets, Jet) else jets) if not jet.is_zero]
    if not parts:
        raise FormulaError("the zero polynomial has no degree", remedy="give a nonzero polynomial")
    gradings = {_grading(jet, parameter) for jet in parts}
    if len(gradings) > 1:
        problem = f"components with the gradings {sorted(gradings)}"
        raise FormulaError(problem, remedy="a vector has degree and weight only if those of all components agree")
    return _true_degree(parts, gradings.pop(), parameter)


def _true_degree(parts: list[Jet], known: tuple[int, int], parameter: Parameter) -> TrueDegree:
    """The true degree of polynomials with a known common degree and weight."""
    (k, m), ring = known, parts[0].ring
    with drawing_on(Budget(LONGEST_HEIGHT)):
        images = [with_degree(ring, jet.polynomial) for jet in parts]
        j, lowest = _height(images, lambda p: lowered(ring, p, parameter))
        suspects = {*range(1, ring.order), *set.intersection(*[set(common_roots(p)) for p in lowest])}
        lower = [(d, _at(parts, k, m, {parameter: d})) for d in sorted(suspects)]
    special = tuple((d, n) for d, n in lower if n != k * d - 2 * m + j)
    return TrueDegree(k, m, j, special, _degree_name(ring, parameter))


def _height(images: list[fmpq_mpoly], image_of: Callable[[fmpq_mpoly], fmpq_mpoly]) -> tuple[int, list[fmpq_mpoly]]:
    """The height, that is the number of applications of L until all images vanish, less one, and the last nonzero
    images.

    Raises `ReachError` if that may take too long: the images of a product of high derivatives have very many terms.
    """
    j, lowest = -1, images
    while images:
        lowest, j = images, j + 1
        check_reach(sum(map(_cost_of_lowering, images)), partial(_named_height, images), LONGEST_HEIGHT)
        images = [image for p in images if (image := image_of(p))]
    return j, lowest


def _cost_of_lowering(p: fmpq_mpoly) -> int:
    """An estimate in nanoseconds of the cost of one image under L."""
    used = sum(map(bool, p.degrees()))
    return LOWERED_TERM * len(p) * used + LOWERED_RING * p.context().nvars() ** 2


def _named_height(images: list[fmpq_mpoly]) -> str:
    terms = counted(max(map(len, images)), "term")
    return f"the height of a polynomial ({terms} in {counted(images[0].context().nvars(), 'variable')})"


def degree_of_product(factors: Sequence[tuple[TrueDegree, int]]) -> TrueDegree:
    """k, m, j and the true degree of a product, from its factors and their exponents: all of them are additive."""
    k, m, j = (sum(getattr(f, name) * e for f, e in factors) for name in ("k", "m", "j"))
    lower = []
    for d in sorted({d for f, _ in factors for d, _ in f.lower}):
        degrees = [(f.at(d), e) for f, e in factors]
        lower.append((d, -1 if any(n < 0 for n, _ in degrees) else sum(n * e for n, e in degrees)))
    special = tuple((d, n) for d, n in lower if n != k * d - 2 * m + j)
    return TrueDegree(k, m, j, special, factors[0][0].name)


def _degree_name(ring: JetRing, parameter: Parameter) -> str:
    """The name of the degree, with respect to a parameter, of the functions of a ring."""
    return next(s.degree_in(parameter) for s in ring.symbols.values() if parameter in s.parameters)


def graded(jet: Jet, parameter: Parameter = Parameter.FIRST) -> list[Jet]:
    """The homogeneous parts of a differential polynomial. On the generic curve their leading terms do not cancel.
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import JetReading
    >>> x = JetReading(1).argument(CURVE, 2).p[0]
    >>> graded(x * x + 3 * x.d() * x + x.d())
    [x′, x², 3·x·x′]
    """
    return [part for _, part in _graded(jet, parameter)]


def _graded(jet: Jet, parameter: Parameter) -> list[tuple[tuple[int, int], Jet]]:
    """The homogeneous parts with their degrees and weights."""
    if (known := _homogeneous(jet, parameter)) is not None:
        return [(known, jet)]
    moving = _moving(jet.ring, parameter)
    parts: dict[tuple[int, int], dict[tuple[int, ...], Any]] = {}
    for exponents, c in jet.polynomial.terms():
        e = tuple(map(int, exponents))
        parts.setdefault((sum(e[n] for n, _ in moving), sum(e[n] * i for n, i in moving)), {})[e] = c
    return [(known, Jet(jet.ring, jet.ring.context.from_dict(terms))) for known, terms in sorted(parts.items())]


def _grading(jet: Jet, parameter: Parameter = Parameter.FIRST) -> tuple[int, int]:
    """Degree k and weight m in the functions of a parameter; raises `FormulaError` if it is not homogeneous in both."""
    if (known := _homogeneous(jet, parameter)) is not None:
        return known
    moving = _moving(jet.ring, parameter)
    exponents = ([int(x) for x in m] for m in jet.polynomial.monoms())
    gradings = {(sum(e[n] for n, _ in moving), sum(e[n] * i for n, i in moving)) for e in exponents}
    return only_grading(gradings)


def _homogeneous(jet: Jet, parameter: Parameter) -> tuple[int, int] | None:
    """Degree and weight of a polynomial that is homogeneous in both, read from one monomial (Euler); None for
    others.
    """
    p, gens, moving = jet.polynomial, jet.ring.gens, _moving(jet.ring, parameter)
    if not p:
        return None
    exponents, used = p.monomial(0), p.degrees()
    k, m = sum(int(exponents[n]) for n, _ in moving), sum(int(exponents[n]) * i for n, i in moving)
    by_degree = by_weight = jet.ring.context.constant(0)
    for n, i in moving:
        if used[n]:
            slope = p.derivative(n) * gens[n]
            by_degree, by_weight = by_degree + slope, by_weight + slope * i
    return (k, m) if by_degree == p * k and by_weight == p * m else None


def _moving(ring: JetRing, parameter: Parameter) -> list[tuple[int, int]]:
    """The indices of the variables that depend on a parameter, with their orders of differentiation in it.

    Raises `InapplicableError` if operands depend on each other: the degree theorem requires independent operands.
    """
    if ring.rules or ring.kind.composed:
        raise InapplicableError(
            f"the degree theorem does not apply to the kind {ring.kind.name!r}", remedy="use the nominal degree"
        )
    dependent = [(n, orders, ring.symbols[name].parameters) for n, (name, orders) in enumerate(ring.variables)]
    return [(n, orders[parameters.index(parameter)]) for n, orders, parameters in dependent if parameter in parameters]


def _beyond(ring: JetRing, degrees: Mapping[Parameter, int]) -> list[int]:
    """The indices of the derivatives that vanish because the functions have these degrees."""
    return [n for parameter, d in degrees.items() for n, i in _moving(ring, parameter) if i > d]


def generic_degree(jets: Sequence[Jet], parameter: Parameter = Parameter.FIRST) -> Degree:
    """The true degree of a vector, homogeneous or not, on the generic curve for symbolic d.
    >>> from exactspline.language.kinds import CURVE
    >>> from exactspline.readings.jet import JetReading
    >>> c = JetReading(1).argument(CURVE, 2)
    >>> generic_degree([c.p[0] * c.w.d(1) - c.p[0].d(1) * c.w, c.w])
    max(2d − 2, d)
    """
    parts = (part for jet in jets for part in _graded(jet, parameter))
    return reduce(Degree.max, (_true_degree([part], known, parameter).generic for known, part in parts))


def truncated(jets: Iterable[Jet], d: int, parameter: Parameter = Parameter.FIRST) -> list[Jet]:
    """The polynomials on curves of degree d, on which derivatives of higher order are zero."""
    return [Jet(jet.ring, _truncated(jet.ring, jet.polynomial, {parameter: d})) for jet in jets]


def without_content(jets: Sequence[Jet]) -> list[Jet]:
    """The polynomials divided by their greatest common divisor."""
    common = greatest_common_divisor(jet.polynomial for jet in jets)
    return [Jet(jet.ring, jet.polynomial / common) for jet in jets]


def degree_at(jets: Sequence[Jet], d: int, parameter: Parameter = Parameter.FIRST) -> int:
    """The true degree of a vector, homogeneous or not, on the generic curve of a given degree d; −1 if it vanishes."""
    parts = [part for jet in jets for part in graded(jet, parameter)]
    return max((true_degree(part, parameter).at(d) for part in parts), default=-1)


def degree_on_patch(jets: Sequence[Jet], degrees: Mapping[Parameter, int], parameter: Parameter) -> int:
    """The true degree in one parameter of a vector on the generic patch of the given degrees; −1 if it vanishes.

    >>> from exactspline.language.kinds import SURFACE
    >>> from exactspline.papers import paper
    >>> from exactspline.readings.jet import JetReading
    >>> parabolic = paper("surfaces").find("parabolic_lifted")(JetReading(2).argument(SURFACE, 3))
    >>> [degree_on_patch([parabolic], {Parameter.U: n, Parameter.V: n}, Parameter.U) for n in (1, 2)]
    [0, 8]
    """
    with drawing_on(Budget(LONGEST_HEIGHT)):
        parts = [(known, part) for jet in jets for known, part in _graded(jet, parameter)]
        return max((_at([part], *known, degrees, parameter) for known, part in parts), default=-1)


def with_degree(ring: JetRing, polynomial: fmpq_mpoly) -> fmpq_mpoly:
    """The polynomial in the ring with the additional variable d."""
    context = fmpq_mpoly_ctx.get(["d", *ring.context.names()], Ordering.degrevlex)
    return polynomial.project_to_context(context)


def lowered(ring: JetRing, polynomial: fmpq_mpoly, parameter: Parameter) -> fmpq_mpoly:
    """The image under the derivation L, over the polynomials in d."""
    gens = polynomial.context().gens()
    d, total = gens[0], polynomial.context().constant(0)
    used = polynomial.degrees()
    for n, i in _moving(ring, parameter):
        if i and used[n + 1]:
            total += polynomial.derivative(n + 1) * (i * (d - i + 1)) * gens[ring.lowered(n, parameter) + 1]
    return total


def _at(
    jets: Sequence[Jet], k: int, m: int, degrees: Mapping[Parameter, int], parameter: Parameter | None = None
) -> int:
    """The true degree for given degrees: derivatives of higher order are zero, and L has numerical coefficients. If
    several degrees are given, it is the degree in `parameter`.
    """
    counted_in = parameter or next(iter(degrees))
    ring, d = jets[0].ring, degrees[counted_in]
    images = [p for jet in jets if (p := _truncated(ring, jet.polynomial, degrees))]
    j, _ = _height(images, lambda p: lowered_at(ring, p, d, counted_in))
    return k * d - 2 * m + j if j >= 0 else -1


def _truncated(ring: JetRing, polynomial: fmpq_mpoly, degrees: Mapping[Parameter, int]) -> fmpq_mpoly:
    names, used = ring.context.names(), polynomial.degrees()
    vanishing: dict[str | int, int | fmpz | fmpq] = {names[n]: 0 for n in _beyond(ring, degrees) if used[n]}
    return polynomial.subs(vanishing) if vanishing else polynomial


def lowered_at(ring: JetRing, polynomial: fmpq_mpoly, d: int, parameter: Parameter = Parameter.FIRST) -> fmpq_mpoly:
    """The image under the derivation L for one degree d."""
    total, used = ring.context.constant(0), polynomial.degrees()
    for n, i in _moving(ring, parameter):
        if i and used[n]:
            total += polynomial.derivative(n) * (i * (d - i + 1)) * ring.gens[ring.lowered(n, parameter)]
    return total
