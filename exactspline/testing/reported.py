"""Cases from public bug reports, each with its link: the reported numbers, or a small curve that shows the same
defect.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Reported:
    """A curve of a bug report: of one segment where no knots are given."""

    key: str
    link: str
    note: str
    degree: int
    points: list[tuple[float, ...]]
    knots: list[float]
    weights: list[float] | None = None
    parameter: float | None = None


def _bezier(
    key: str, link: str, note: str, points: list[tuple[float, ...]], parameter: float | None = None
) -> Reported:
    n = len(points)
    return Reported(key, link, note, n - 1, points, [*[0] * n, *[1] * n], None, parameter)


def _levels(values: list[float]) -> list[tuple[float, ...]]:
    """A function as a curve: its graph."""
    return [(i, y) for i, y in enumerate(values)]


GITHUB = "https://github.com/"
REPORTED: list[Reported] = [
    _bezier(
        "geomdl-135",
        GITHUB + "orbingol/NURBS-Python/issues/135",
        "a knot inserted and removed is another curve",
        [(0, 0, 0), (1, 1, 0), (2, 0, 0)],
        1 / 2,
    ),
    Reported(
        "geomdl-153",
        GITHUB + "orbingol/NURBS-Python/issues/153",
        "a knot inserted and removed is another curve",
        2,
        [(k, k) for k in range(7)],
        [0, 0, 0, 1 / 5, 2 / 5, 3 / 5, 4 / 5, 1, 1, 1],
        None,
        1 / 2,
    ),
    Reported(
        "geomdl-125",
        GITHUB + "orbingol/NURBS-Python/issues/125",
        "raising the degree changes the shape",
        2,
        [
            (821.51962938, -677.395551576, 3.5410634089),
            (873.5806602364927, -682.3571637856359, 88.77621736805291),
            (879.1302220964927, -582.5406209926358, 91.19699162172292),
            (879.1656602459713, -581.9032177447318, 91.21245004565435),
            (879.196849813, -581.265461848, 91.2209560929),
        ],
        [0, 0, 0, 1 / 2, 1 / 2, 1, 1, 1],
        [1, 0.7071067811865476, 1, 0.9999796117372515, 1],
    ),
    _bezier(
        "svgelements-214",
        GITHUB + "meerk40t/svgelements/issues/214",
        "the box of a cubic whose cubic term vanishes",
        [(0, 0), (-2, -3), (-1, -4), (0, -3)],
    ),
    _bezier(
        "bezierjs-7",
        GITHUB + "Pomax/bezierjs/issues/7",
        "roots of a cubic that is almost a quadratic",
        [(52.7256, 7.9124), (51.8071, 10.3271), (50.48, 12.4014), (48.7419, 14.135)],
    ),
    _bezier(
        "fonttools-617",
        GITHUB + "fonttools/fonttools/issues/617",
        "a double root of −10x³ − 9x² + 48x − 29 at 1",
        _levels([-29, -13, 0, 0]),
    ),
    _bezier(
        "fonttools-3742",
        GITHUB + "fonttools/fonttools/issues/3742",
        "a part does not end where the whole does",
        [(-103, -231), (-61, -240), (-31.009, -245), (6, -245)],
        0.386637,
    ),
    _bezier(
        "lyon-57",
        GITHUB + "nical/lyon/issues/57",
        "a cubic thought to have two inflections",
        [(0, 0), (1 / 2, 1), (3 / 2, -1), (2, 0)],
    ),
    _bezier(
        "lyon-328",
        GITHUB + "nical/lyon/issues/328",
        "the box of a short stroke",
        [(75.84375, 239.296875), (75.94140625, 239.5390625), (76.03515625, 239.7734375), (76.171875, 240)],
    ),
    _bezier(
        "bonsai-224",
        GITHUB + "uxebu/bonsai/issues/224",
        "the box of a flat hairpin",
        [
            (185.3, 162.5),
            (30.900000000000002, 228.29999999999998),
            (49.36666666666666, 211.66666666666666),
            (240.7, 112.6),
        ],
    ),
    _bezier(
        "svg-path-bbox-112",
        GITHUB + "mondeja/svg-path-bbox/issues/112",
        "the box of a quadratic with its extremum at an end",
        [(90, 100), (109, 100), (110, 110)],
    ),
    _bezier(
        "svg-path-bbox-112b",
        GITHUB + "mondeja/svg-path-bbox/issues/112",
        "the same, reversed",
        [(90, 100), (90, 110), (110, 110)],
    ),
    _bezier(
        "cubic2quad-1",
        GITHUB + "fontello/cubic2quad/issues/1",
        "an inflection in an almost straight cubic",
        [(858, -113), (739, -68), (624, -31), (533, 0)],
    ),
    _bezier(
        "svgpathtools-45",
        GITHUB + "mathandy/svgpathtools/issues/45",
        "the curvature of a path and of its segment",
        [(300, 100), (100, 100), (200, 200), (200, 300)],
        1 / 2,
    ),
    _bezier(
        "svg-path-properties-169",
        GITHUB + "rveciana/svg-path-properties/pull/169",
        "the tangent where a handle is on the end",
        [(0, 0), (0, 0), (50, 100), (100, 0)],
        0,
    ),
    _bezier(
        "scipy-8376",
        GITHUB + "scipy/scipy/issues/8376",
        "a root at a knot, off by 2⁻⁵¹",
        _levels([-0.01, -0.005, 4.440892e-16, 0.005]),
    ),
    _bezier(
        "scipy-17261", GITHUB + "scipy/scipy/issues/17261", "a double root comes out as three", _levels([1, -1, 1])
    ),
    _bezier(
        "kurbo-99",
        GITHUB + "linebender/kurbo/pull/100",
        "the length of a curve that is a point",
        [(1, 1), (1, 1), (1, 1), (1, 1)],
    ),
    _bezier(
        "floBezier-25",
        GITHUB + "FlorisSteenkamp/FloBezier/issues/25",
        "a cubic that is a quadratic",
        [(0, 0), (1, 1), (2, 1), (3, 0)],
    ),
    _bezier(
        "bezierinfo-50",
        GITHUB + "Pomax/BezierInfo-2/issues/50",
        "a cubic on a line that turns back twice",
        [(1, 1), (0, 0), (3, 3), (2, 2)],
    ),
]
