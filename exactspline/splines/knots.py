"""Knot vectors as a small algebra: multiplicity, continuity, refinement, union.

There are two views of knots. A `KnotVector` is the full list with multiplicities. A `Mesh` is the list of the distinct
breakpoints of a domain; together with the continuity at each interior breakpoint it contains the same information for a
spline of known degree (multiplicity = degree − continuity).
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise

from flint import fmpz

from exactspline.errors import DomainError, KnotError, ShapeError, as_items, counted
from exactspline.numbers.exact import Number, mpq, rational, text, to_fmpz
from exactspline.numbers.intervals import Interval
from exactspline.numbers.once import Immutable, fill
from exactspline.one_line import one_line, short_text
from exactspline.splines.inputs import exact_row

#: Continuity at a breakpoint where the function has no knot.
SMOOTH = 1 << 60


#: The results for this many knot vectors, of at most this many knots each, are shared by all equal knot vectors: most
#: curves of a file have one of a few knot vectors.
KEPT, LONGEST = 64, 64
_kept: dict[tuple[mpq, ...], dict[int, MeshOf | None]] = {}
_set = object.__setattr__


class KnotVector(Immutable):
    """A non-decreasing sequence of exact knots.

    >>> k = KnotVector([0, 0, "1/2", 1, 1])
    >>> k.multiplicity(0), k.breakpoints, k | KnotVector(["1/2", "1/2", "3/4"])
    (2, (mpq(0,1), mpq(1,2), mpq(1,1)), KnotVector(0, 0, 1/2, 1/2, 3/4, 1, 1))

    Raises `KnotError` if knots decrease and `NumberError` if a knot is not an exact number.
    """

    __slots__ = ("_known", "knots")
    knots: tuple[mpq, ...]
    #: The degrees for which these knots are valid, each with its mesh once this has been computed (see `mesh_of`).
    _known: dict[int, MeshOf | None]

    def __init__(self, knots: Iterable[Number]) -> None:
        exact = exact_row(as_items(knots, "knots"), "knots")
        known = _kept.get(exact)
        if known is None:
            _check_order(exact)
            known = _keep(exact)
        _set(self, "knots", exact)
        _set(self, "_known", known)

    def __reduce__(self) -> tuple[object, ...]:
        return KnotVector, (self.knots,)

    def __len__(self) -> int:
        return len(self.knots)

    def __iter__(self) -> Iterator[mpq]:
        return iter(self.knots)

    def __getitem__(self, i: int) -> mpq:
        return self.knots[i]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, KnotVector) and self.knots == other.knots

    def __hash__(self) -> int:
        return hash(self.knots)

    @one_line
    def __repr__(self) -> str:
        return f"KnotVector({', '.join(map(text, self.knots))})"

    def multiplicity(self, t: Number) -> int:
        """Return the multiplicity of t: how often t occurs as a knot."""
        return self.knots.count(rational(t))

    def has_room_at_end(self, degree: int, t: mpq, times: int) -> bool:
        """Return whether this many knots can be inserted at an end of the domain, which must not be clamped.

        >>> uniform = KnotVector(range(6))
        >>> [uniform.has_room_at_end(2, mpq(t), 1) for t in (1, 2, 3)], uniform.has_room_at_end(2, mpq(3), 3)
        ([False, True, True], False)
        """
        at_end = degree >= 0 and t in (self.knots[degree], self.knots[-1 - degree])
        return at_end and type(times) is int and 1 <= times <= degree + 1 - self.multiplicity(t)

    @property
    def breakpoints(self) -> tuple[mpq, ...]:
        """The distinct knots."""
        return tuple(t for t, _ in groupby(self.knots))

    @property
    def multiplicities(self) -> tuple[int, ...]:
        """The multiplicities of the distinct knots."""
        return tuple(len(list(same)) for _, same in groupby(self.knots))

    def __or__(self, other: KnotVector) -> KnotVector:
        """The union: every knot with the higher of its two multiplicities."""
        both = sorted({*self.knots, *other.knots})
        return KnotVector(t for t in both for _ in range(max(self.multiplicity(t), other.multiplicity(t))))

    def insert(self, t: Number, times: int = 1) -> KnotVector:
        """Return the knot vector with t inserted this many more times."""
        t = rational(t)
        place, made = bisect_right(self.knots, t), object.__new__(KnotVector)
        fill(made, knots=(*self.knots[:place], *[t] * times, *self.knots[place:]), _known={})
        return made

    def domain(self, degree: int) -> Interval:
        """Return the domain ``[t_n, t_{N−n}]`` of a spline of degree n with these knots t_0 … t_N."""
        return Interval(self.knots[degree], self.knots[len(self.knots) - 1 - degree])

    def check(self, degree: int) -> None:
        """Raise `KnotError` unless these knots are valid for splines of the given degree (multiplicity ≤ degree+1,
        non-empty domain).
        """
        if degree in self._known:
            return
        need = 2 * degree + 2
        if len(self.knots) < need:
            raise KnotError(
                f"{counted(len(self.knots), 'knot')} for degree {degree}",
                where="knots",
                remedy=f"degree {degree} needs at least {need} knots",
                degree=degree,
            )
        position = 0
        for t, count in zip(self.breakpoints, self.multiplicities, strict=True):
            if count > degree + 1:
                raise KnotError(
                    f"{text(t)} has multiplicity {count}",
                    where=f"knots[{position}]",
                    remedy=f"at most degree + 1 = {degree + 1}",
                    knot=t,
                    multiplicity=count,
                )
            position += count
        a, b = self.domain(degree)
        if not a < b:
            raise KnotError(
                f"the domain [{text(a)}, {text(b)}] is empty",
                where="knots",
                remedy=f"knots[{degree}] must be below knots[{len(self) - 1 - degree}]",
                domain=(a, b),
            )
        self._known[degree] = None

    def check_count(self, degree: int, points: int) -> None:
        """Raise `ShapeError` unless a spline of the given degree has this many control points."""
        needed = len(self.knots) - degree - 1
        if points != needed:
            problem = f"{points} control points for {counted(len(self.knots), 'knot')} of degree {degree}"
            raise ShapeError(problem, where="control_points", remedy=f"there must be {needed} (knots − degree − 1)")


def _check_order(knots: Sequence[mpq]) -> None:
    for i, (a, b) in enumerate(pairwise(knots)):
        if b < a:
            problem = f"{text(b)} after {text(a)}: knots decrease"
            raise KnotError(problem, where=f"knots[{i + 1}]", remedy="knots must not decrease", knot=b)


def _keep(knots: tuple[mpq, ...]) -> dict[int, MeshOf | None]:
    known: dict[int, MeshOf | None] = {}
    if len(knots) <= LONGEST:
        if len(_kept) >= KEPT:
            _kept.clear()
        _kept[knots] = known
    return known


class Mesh(Immutable):
    """Distinct breakpoints of a domain, shared by all splines computed from one another.

    >>> Mesh([mpq(0), mpq(1, 2), mpq(2)]).locate(mpq(1, 2))
    1
    """

    __slots__ = ("breaks", "unit", "widths")
    breaks: tuple[mpq, ...]
    #: The width of each segment, as numerator and denominator.
    widths: tuple[tuple[fmpz, fmpz], ...]
    #: Whether all segments have width one, so that derivatives need no scaling.
    unit: bool

    def __init__(self, breaks: Iterable[mpq]) -> None:
        breaks = tuple(breaks)
        widths = [b - a for a, b in pairwise(breaks)]
        pairs = tuple((to_fmpz(h.numerator), to_fmpz(h.denominator)) for h in widths)
        fill(self, breaks=breaks, widths=pairs, unit=all(h == 1 for h in widths))

    def __reduce__(self) -> tuple[object, ...]:
        return Mesh, (self.breaks,)

    @property
    def domain(self) -> Interval:
        """The interval from the first to the last breakpoint."""
        return Interval(self.breaks[0], self.breaks[-1])

    def __len__(self) -> int:
        """The number of segments."""
        return len(self.breaks) - 1

    def locate(self, t: mpq, *, left: bool = False) -> int:
        """The index of the segment that contains t; at a breakpoint the segment on its right, or with `left` on its
        left.

        Raises `DomainError` outside the domain.
        """
        breaks = self.breaks
        if not breaks[0] <= t <= breaks[-1]:
            a, b = self.domain
            problem = f"the parameter {short_text(t)} is outside the domain [{text(a)}, {text(b)}]"
            raise DomainError(problem, remedy="stay inside", parameter=t, domain=(a, b))
        i = bisect_right(breaks, t) - 1
        if left and i > 0 and breaks[i] == t:
            i -= 1
        return min(i, len(breaks) - 2)

    def local(self, i: int, t: mpq) -> mpq:
        """The local parameter of t on segment i."""
        a = self.breaks[i]
        return (t - a) / (self.breaks[i + 1] - a)

    def refined(self, i: int, t: mpq) -> Mesh:
        """The mesh with a breakpoint inside its i-th segment.

        >>> Mesh([mpq(0), mpq(2)]).refined(0, mpq(1)).breaks
        (mpq(0,1), mpq(1,1), mpq(2,1))
        """
        breaks, widths = self.breaks, self.widths
        both = Mesh((breaks[i], t, breaks[i + 1]))
        made = object.__new__(Mesh)
        breaks = (*breaks[: i + 1], t, *breaks[i + 1 :])
        fill(made, breaks=breaks, widths=(*widths[:i], *both.widths, *widths[i + 1 :]), unit=False)
        return made

    def union(self, other: Mesh) -> Mesh:
        """The mesh with the breakpoints of both; raises `DomainError` if the domains differ."""
        if self.domain != other.domain:
            (a, b), (c, d) = self.domain, other.domain
            problem = f"operands over different domains, [{text(a)}, {text(b)}] and [{text(c)}, {text(d)}]"
            raise DomainError(problem, remedy="restrict or reparametrize one of them first")
        return Mesh(sorted({*self.breaks, *other.breaks}))


#: The mesh of a domain, the continuity at its interior breakpoints, and the index of the left end of each segment.
MeshOf = tuple[Mesh, tuple[int, ...], list[int]]


def mesh_of(knots: KnotVector, degree: int) -> MeshOf:
    """The mesh of the domain, the continuity at its interior breakpoints, and for each segment the index j such that
    t_j is its left end; computed once.
    """
    known = knots._known.get(degree)
    if known is None:
        known = knots._known[degree] = _mesh_of(knots, degree)
    return known


def _mesh_of(knots: KnotVector, degree: int) -> MeshOf:
    first, last = degree, len(knots) - 1 - degree
    t = knots.knots
    spans = [j for j in range(first, last) if t[j] < t[j + 1]]
    breaks = [t[j] for j in spans] + [t[last]]
    # the knots between two spans are equal
    return Mesh(breaks), tuple([degree - (j - i) for i, j in pairwise(spans)]), spans


def clamped(mesh: Mesh, continuity: Sequence[int], degree: int) -> KnotVector:
    """The clamped knot vector of a spline of the given degree with the given continuity at the interior breakpoints;
    it is empty for a degree below 0.
    """
    if degree < 0:
        return KnotVector([])
    a, b = mesh.domain
    inner = (t for t, c in zip(mesh.breaks[1:-1], continuity, strict=True) for _ in range(degree - c))
    return KnotVector([*[a] * (degree + 1), *inner, *[b] * (degree + 1)])


# ---- runs of segments


def runs(holds: Sequence[bool], joined: Sequence[bool]) -> list[tuple[int, int]]:
    """The maximal runs of segments on which something holds, as ``(first, number)``.

    ``joined[i]`` states that a run may continue from segment i − 1 to segment i; ``joined[0]`` concerns the seam, from
    the last segment to the first (False for an open spline). A run across the seam begins before the seam; a run over
    all segments of a closed spline begins at 0.

    >>> runs([True, True, False, True], [True, True, True, True])
    [(3, 3)]
    >>> runs([True, True, True], [True, False, True])
    [(1, 3)]
    """
    count = len(holds)
    maximal: list[tuple[int, int]] = []
    for i, here in enumerate(holds):
        if here and i and holds[i - 1] and joined[i]:
            first, number = maximal[-1]
            maximal[-1] = first, number + 1
        elif here:
            maximal.append((i, 1))
    if len(maximal) > 1 and joined[0] and holds[0] and holds[-1]:
        first, number = maximal.pop()
        maximal[0] = first, number + maximal[0][1]
        maximal.sort()
    assert all(number <= count for _, number in maximal)
    return maximal


def intervals_of(breaks: Sequence[mpq], first: int, number: int) -> tuple[Interval, ...]:
    """A run of segments as intervals of the domain, in the order of traversal: one, or two if it crosses the seam.

    >>> [str(part) for part in intervals_of([mpq(0), mpq(1), mpq(3)], 1, 2)]
    ['[1, 3]', '[0, 1]']
    """
    beyond = first + number - (len(breaks) - 1)
    if beyond <= 0:
        return (Interval(breaks[first], breaks[first + number]),)
    return Interval(breaks[first], breaks[-1]), Interval(breaks[0], breaks[beyond])
