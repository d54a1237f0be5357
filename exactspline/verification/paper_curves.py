"""The curves on which the claims of a paper are checked: the examples of the library, and the curves of the paper."""

from __future__ import annotations

from functools import cache

from exactspline.errors import ClaimError, CurveFileError, ExactSplineError, nearest
from exactspline.interchange import curve_files
from exactspline.interchange.examples import example, example_names, example_surface, example_surface_names
from exactspline.interchange.records import Source
from exactspline.numbers.exact import rational
from exactspline.papers import Paper
from exactspline.splines.nurbs import Nurbs
from exactspline.splines.surface import NurbsSurface


@cache
def one_patch_surfaces() -> tuple[NurbsSurface, ...]:
    """The example surfaces and planar maps of one patch, on which claims about surfaces are checked.

    >>> [surface.name for surface in one_patch_surfaces()][:3]
    ['bicubic', 'biquadratic', 'cross_cap']
    """
    return tuple(surface for surface in map(example_surface, example_surface_names()) if surface.patches == (1, 1))


@cache
def _curves(source: Paper) -> tuple[dict[str, Nurbs], dict[str, ExactSplineError]]:
    """The curves in the folder of a paper, and the errors of files that cannot be read."""
    curves, refused = dict[str, Nurbs](), dict[str, ExactSplineError]()
    for file in source.curve_files():
        if file.name.endswith(".json"):
            try:
                curves[file.name.removesuffix(".json")] = curve_files.read(Source(file.read_bytes(), file.name)).curve
            except ExactSplineError as error:
                refused[f"curves/{file.name}"] = error.at(f"{source.name}/curves/{file.name}")
            except OSError as error:
                refused[f"curves/{file.name}"] = CurveFileError(f"cannot be read: {error}")
    return curves, refused


def own_curves(source: Paper) -> dict[str, Nurbs]:
    """The curves in the folder of a paper, by the names of their files without ``.json``."""
    return _curves(source)[0]


def refused_curves(source: Paper) -> dict[str, ExactSplineError]:
    """The files in the folder of a paper that hold no curve, with their errors."""
    return _curves(source)[1]


@cache
def undulations() -> dict[str, Nurbs]:
    """Curves that touch their tangent at the parameter 0 to third order: (t, t⁴) and (t, t⁴, t³), −1 ≤ t ≤ 1, and the
    same over 1 + t². They refute a statement that fails only at such points.
    """
    texts = ("-1 1 -1", "-1/2 -1 1/2", "0 1 0", "1/2 -1 -1/2", "1 1 1")
    weights, knots, found = [rational(x) for x in (2, 1, "2/3", 1, 2)], [*[-1] * 5, *[1] * 5], dict[str, Nurbs]()
    for n in (2, 3):
        points = [[rational(x) for x in text.split()[:n]] for text in texts]
        over = [[x / w for x in point] for point, w in zip(points, weights, strict=True)]
        found[f"undulation_{n}d"] = Nurbs(4, knots, points)
        found[f"rational_undulation_{n}d"] = Nurbs(4, knots, over, weights)
    return found


def curve_names(source: Paper) -> list[str]:
    """The names of the paper's curves, then those of the examples."""
    return [*dict.fromkeys([*own_curves(source), *example_names()])]


def curve_named(source: Paper, name: str) -> Nurbs:
    """A curve of the paper or an example by its name.

    Raises `ClaimError` with the nearest names.
    """
    check_curve_name(source, name)
    own = undulations() | own_curves(source)
    return own[name] if name in own else example(name)


def check_curve_name(source: Paper, name: str) -> None:
    """Raise `ClaimError` for a name that is neither a curve of the paper nor an example. No example is read for this
    check.
    """
    if error := refused_curves(source).get(f"curves/{name}.json"):
        raise ClaimError(f"the curve {name!r} cannot be read", where=error.where, remedy=error.problem)
    if not any(name in known for known in (own_curves(source), example_names(), undulations())):
        raise ClaimError(f"there is no example curve called {name!r}", remedy=nearest(name, curve_names(source)))
