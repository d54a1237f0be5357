"""Pictures of bisectors and of two curves: which curve is which, what is cut off, and what they are called."""

import pytest

pytest.importorskip("matplotlib")

from exactspline import Nurbs, bisector, example
from exactspline.display.plot.curves import pair_figure
from exactspline.extras.pictures3d.bisectors import plot_curve_bisector, plot_plane_bisector, plot_trimmed_bisector
from exactspline.geometry.analysis.pairs import CurvePair


def named(ax):
    """The lines of a picture that its legend names."""
    return {line.get_label(): line for line in ax.lines if not line.get_label().startswith("_")}


def ends_at_the_frame(ax):
    """The ends of thin lines that are outside of what is shown, of all their ends."""
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    thin = [line.get_xydata() for line in ax.lines if line.get_linewidth() == 1.5 and len(line.get_xdata()) > 1]
    ends = [end for points in thin for end in (points[0], points[-1])]
    return sum(not (left <= x <= right and low <= y <= high) for x, y in ends), len(ends)


def test_the_curves_of_a_bisector_in_space_have_two_colours_and_their_names():
    """Both were black, and called "curve of s" and "curve of t"."""
    ax = plot_curve_bisector(bisector(example("twisted_cubic"), example("rational_space_cubic")))
    lines = named(ax)
    colors = [lines[name].get_color() for name in ("twisted cubic (s)", "rational space cubic (t)")]
    assert len({*colors, lines["surface"].get_color()}) == 3
    assert ax.get_title() == "bisector of twisted cubic (s) and rational space cubic (t)"


def test_what_goes_on_leaves_the_frame():
    """It ended inside of the frame, as an arc does that ends."""
    plane = plot_plane_bisector(bisector(example("cubic_s"), example("ellipse")))
    outside, ends = ends_at_the_frame(plane)
    assert 2 <= outside < ends
    point = ("7/4", "3/2")
    trimmed = plot_trimmed_bisector(bisector(example("cubic_s"), point), example("cubic_s"), point)
    assert ends_at_the_frame(trimmed) == (2, 4)
    assert {"arc", "line (foot: end point)", "point"} <= set(named(trimmed))
    assert trimmed.get_title() == "bisector of cubic s and a point"


@pytest.mark.parametrize(
    ("second", "shown"), [([(0, 0), (2, 0)], "common points"), ([(3, -1), (3, 1)], "nearest points")]
)
def test_two_curves_have_a_legend_for_what_they_have_in_common(second, shown):
    """Points were marked, hidden by the curves, and not explained."""
    line = Nurbs(1, [0, 0, 1, 1], second, name="line")
    place, rectangle = pair_figure(CurvePair(example("circle"), line)).axes
    assert {"circle (s)", "line (t)", shown} == set(named(place))
    assert set(named(rectangle)) == {shown}
    marks = named(place)
    assert marks[shown].get_zorder() > max(line.get_zorder() for name, line in marks.items() if name != shown)
    assert place.get_title() == "circle (s) and line (t)"
