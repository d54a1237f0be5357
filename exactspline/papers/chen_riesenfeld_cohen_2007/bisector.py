"""§6: bisectors, in the sense of equal critical distances, before trimming.

A bisector point lies in three planes (in the plane: on two lines). Each is a row of a linear system: a normal and a
height, as in ``normal · B = height``.
"""

from exactspline.language.formula import formula
from exactspline.language.rational import cramer, level
from exactspline.language.ruled import ruled
from exactspline.language.vector import cross, det, dot, norm2
from exactspline.papers.chen_riesenfeld_cohen_2007.derivatives import D1


def _normal_plane(c):
    """``γ′ | γ·γ′``: the normal plane."""
    return c.gamma.d(1), normal_height(c)


def _middle_plane(a, b):
    """``a − b | ½(‖a‖² − ‖b‖²)``: the plane of equal distance from two points."""
    return a - b, (norm2(a) - norm2(b)) / 2


def _normal_plane_polynomial(c):
    """``D1 | p·D1``: the normal plane, in the unknown wB."""
    return D1(c), dot(c.p, D1(c))


@formula("eq. (22)")
def normal_height(c):
    """``γ·γ′``: the height of the normal plane, naive."""
    return dot(c.gamma, c.gamma.d(1))


@formula("eq. (26)")
def normal_levelled(c):
    """``γ′``, brought to one denominator with ``γ·γ′``."""
    return level(*_normal_plane(c))[0]


@formula("eq. (26)")
def normal_height_levelled(c):
    """``γ·γ′``, brought to one denominator with ``γ′``."""
    return level(*_normal_plane(c))[1]


@formula("eq. (27)")
def normal_height_polynomial(c):
    """``p·D1``: the height of the normal plane in the unknown wB."""
    return _normal_plane_polynomial(c)[1]


@formula("eq. (22)", on="pair")
def second_normal(c):
    """``γ̄′``: the normal of the second plane."""
    return c.second.gamma.d(1)


@formula("eq. (22)", on="pair")
def second_height(c):
    """``γ̄·γ̄′``: the height of the second plane."""
    return normal_height(c.second)


@formula("eq. (27)", on="pair")
def second_height_polynomial(c):
    """``w γ̄·γ̄′``: the height of the second plane in the unknown wB."""
    return normal_height(c.second) * c.first.w


@formula("eq. (22)", on="pair")
def middle_normal(c):
    """``γ − γ̄``: the normal of the middle plane."""
    return _middle_plane(c.first.gamma, c.second.gamma)[0]


@formula("eq. (22)", on="pair")
def middle_height(c):
    """``½(‖γ‖² − ‖γ̄‖²)``: the height of the middle plane."""
    return _middle_plane(c.first.gamma, c.second.gamma)[1]


@formula("eq. (26)", on="pair")
def middle_normal_levelled(c):
    """``γ − γ̄``, brought to one denominator with the height."""
    return level(*_middle_plane(c.first.gamma, c.second.gamma))[0]


@formula("eq. (26)", on="pair")
def middle_height_levelled(c):
    """``½(‖γ‖² − ‖γ̄‖²)``, brought to one denominator with the normal."""
    return level(*_middle_plane(c.first.gamma, c.second.gamma))[1]


@formula("eq. (27)", on="pair")
def middle_normal_polynomial(c):
    """``p − wγ̄``: the normal of the middle plane in the unknown wB."""
    return c.first.p - c.second.gamma * c.first.w


@formula("eq. (27)", on="pair")
def middle_height_polynomial(c):
    """``½(‖p‖² − ‖γ̄‖²w²)``: the height of the middle plane in the unknown wB."""
    return (norm2(c.first.p) - norm2(c.second.gamma) * c.first.w**2) / 2


@formula("eqs. (22), (23)", on="pair", symbol="D")
def bisector_determinant(c):
    """``[γ′ γ̄′ γ − γ̄]``: the determinant of the system (22), naive."""
    return det(c.first.gamma.d(1), c.second.gamma.d(1), c.first.gamma - c.second.gamma)


@formula("eqs. (22), (23)", on="pair")
def bisector_numerators(c):
    """The numerators of Cramer's rule for (22), added by the rules of Table 1."""
    return cramer(_normal_plane(c.first), _normal_plane(c.second), _middle_plane(c.first.gamma, c.second.gamma))


@formula("eqs. (22), (23), (26)", on="pair")
def bisector_numerators_levelled(c):
    """The numerators of Cramer's rule for (22), each row first brought to a common denominator."""
    return cramer(
        level(*_normal_plane(c.first)),
        level(*_normal_plane(c.second)),
        level(*_middle_plane(c.first.gamma, c.second.gamma)),
    )


@formula("eqs. (22), (23)", on="pair", symbol="B")
def bisector(c):
    """Bisector of two space curves, naive: (22) by Cramer's rule."""
    return bisector_numerators(c) / bisector_determinant(c)


@formula("eqs. (22), (23), (26)", on="pair", symbol="B")
def bisector_levelled(c):
    """Bisector of two space curves: (22) by Cramer's rule, each row first brought to a common denominator."""
    return bisector_numerators_levelled(c) / bisector_determinant(c)


@formula("eq. (27)", on="pair", symbol="D")
def bisector_determinant_polynomial(c):
    """``[D1 γ̄′ p − wγ̄]``: the determinant of the system (27)."""
    return det(D1(c.first), c.second.gamma.d(1), middle_normal_polynomial(c))


@formula("eq. (27)", on="pair")
def bisector_numerators_polynomial(c):
    """The numerators of Cramer's rule for (27), in the unknown wB."""
    second = second_normal(c), second_height_polynomial(c)
    middle = middle_normal_polynomial(c), middle_height_polynomial(c)
    return cramer(_normal_plane_polynomial(c.first), second, middle)


@formula("eqs. (27), (28)", on="pair", symbol="B")
def bisector_polynomial(c):
    """Bisector of two space curves by the system (27), polynomial in the first curve."""
    return bisector_numerators_polynomial(c) / (bisector_determinant_polynomial(c) * c.first.w)


@formula("eq. (27), for both curves", on="pair", symbol="C")
def chord(c):
    """``w̄p − wp̄``: the direction from one foot point to the other."""
    return c.first.p * c.second.w - c.second.p * c.first.w


@formula("eq. (27), for both curves", on="pair", symbol="D")
def bisector_determinant_symmetric(c):
    """``[D1 D̄1 w̄p − wp̄]``."""
    return det(D1(c.first), D1(c.second), chord(c))


@formula("eq. (27), for both curves", on="pair")
def bisector_numerators_symmetric(c):
    """The numerators of Cramer's rule for (27) polynomial in both curves, in the unknown ww̄B."""
    (p, w), (q, v) = (c.first.p, c.first.w), (c.second.p, c.second.w)
    (a, h), (b, k) = _normal_plane_polynomial(c.first), _normal_plane_polynomial(c.second)
    return cramer((a, h * v), (b, k * w), (chord(c), (norm2(p) * v**2 - norm2(q) * w**2) / 2))


@formula("eqs. (27), (28), for both curves", on="pair", symbol="B")
def bisector_symmetric(c):
    """Bisector of two space curves, polynomial in both."""
    return bisector_numerators_symmetric(c) / (bisector_determinant_symmetric(c) * (c.first.w * c.second.w))


@formula("definition of the bisector", on="pair")
def bisector_in_first_normal_plane(c):
    """``(B − γ)·γ′``: zero when γ(s) is a critical point of the distance from B."""
    return dot(bisector_symmetric(c) - c.first.gamma, c.first.gamma.d(1))


@formula("definition of the bisector", on="pair")
def bisector_in_second_normal_plane(c):
    """``(B − γ̄)·γ̄′``: zero when γ̄(s̄) is a critical point of the distance from B."""
    return dot(bisector_symmetric(c) - c.second.gamma, c.second.gamma.d(1))


@formula("definition of the bisector", on="pair")
def bisector_equidistance(c):
    """``‖B − γ‖² − ‖B − γ̄‖²``: zero if B is equidistant from the two foot points."""
    return norm2(bisector_symmetric(c) - c.first.gamma) - norm2(bisector_symmetric(c) - c.second.gamma)


@formula("display below eq. (34)", on="point")
def point_middle_normal_polynomial(c):
    """``p − wQ``."""
    return c.p - c.point * c.w


@formula("eq. (34)", on="point")
def point_middle_height_polynomial(c):
    """``½(‖p‖² − w²‖Q‖²)``: the corrected last height of (34)."""
    return (norm2(c.p) - c.w**2 * norm2(c.point)) / 2


def _point_middle(c):
    """``p − wQ | ½(‖p‖² − w²‖Q‖²)``: the plane of equal distance from γ and Q, in the unknown wB."""
    return point_middle_normal_polynomial(c), point_middle_height_polynomial(c)


@formula("eq. (31)", on="point", symbol="G")
def point_bisector_generator(c):
    """``γ′ × (γ − Q)``: the direction of the generators, naive."""
    return cross(c.gamma.d(1), c.gamma - c.point)


def _through_point(c):
    """``γ′ × (γ − Q) | Q·(γ′ × (γ − Q))``: the third plane of (31)."""
    return point_bisector_generator(c), dot(c.point, point_bisector_generator(c))


@formula("eq. (31)", on="point")
def through_point_height(c):
    """``Q·(γ′ × (γ − Q))``: the height of the third plane of (31)."""
    return _through_point(c)[1]


@formula("eq. (30)", on="point")
def point_middle_normal(c):
    """``γ − Q``: the normal of the middle plane."""
    return _middle_plane(c.gamma, c.point)[0]


@formula("eq. (30)", on="point")
def point_middle_height(c):
    """``½(‖γ‖² − ‖Q‖²)``: the height of the middle plane."""
    return _middle_plane(c.gamma, c.point)[1]


@formula("eq. (31)", on="point")
def point_bisector_determinant(c):
    """``[γ′ γ′×(γ − Q) γ − Q]``: the determinant of the system (31), naive."""
    return det(c.gamma.d(1), point_bisector_generator(c), c.gamma - c.point)


@formula("eq. (31)", on="point", symbol=r"\delta")
def point_bisector_directrix(c):
    """Directrix of the point/curve bisector by (31), added by the rules of Table 1."""
    return cramer(_normal_plane(c), _through_point(c), _middle_plane(c.gamma, c.point)) / point_bisector_determinant(c)


@formula("eqs. (31), (32)", on="point", symbol=r"\delta")
def point_bisector_directrix_levelled(c):
    """Directrix of the point/curve bisector by (31), each row first brought to a common denominator."""
    rows = level(*_normal_plane(c)), level(*_through_point(c)), level(*_middle_plane(c.gamma, c.point))
    return cramer(rows[0], rows[1], rows[2]) / point_bisector_determinant(c)


@formula("eq. (31)", on="point")
def point_bisector_naive(c):
    """Point/curve bisector with the explicit directrix, added by the rules of Table 1."""
    return ruled(point_bisector_directrix(c), point_bisector_generator(c))


@formula("eqs. (31), (32)", on="point")
def point_bisector(c):
    """Point/curve bisector with the explicit directrix, each row first brought to a common denominator."""
    return ruled(point_bisector_directrix_levelled(c), point_bisector_generator(c))


@formula("eq. (34)", on="point")
def point_bisector_generator_polynomial(c):
    """``D1 × (p − wQ)``: the direction of the generators, polynomial."""
    return cross(D1(c), point_middle_normal_polynomial(c))


@formula("display below eq. (34)", on="point")
def through_point_height_polynomial(c):
    """``wQ·(D1 × (p − wQ))``."""
    return dot(c.point * c.w, point_bisector_generator_polynomial(c))


def _polynomial_rows(c):
    """The first two rows of (34), in the unknown wδ."""
    second = point_bisector_generator_polynomial(c), through_point_height_polynomial(c)
    return _normal_plane_polynomial(c), second


@formula("eq. (34)", on="point")
def point_bisector_determinant_polynomial(c):
    """The determinant of the system (34)."""
    return det(D1(c), point_bisector_generator_polynomial(c), point_middle_normal_polynomial(c))


@formula("eq. (34), as printed", on="point")
def point_middle_height_printed(c):
    """``½(‖p‖² − w‖Q‖²)``."""
    return (norm2(c.p) - c.w * norm2(c.point)) / 2


@formula("eq. (34), as printed", on="point")
def directrix_numerators_printed(c):
    """The numerators of Cramer's rule for (34), with the last height as it is printed."""
    first, second = _polynomial_rows(c)
    return cramer(first, second, (point_middle_normal_polynomial(c), point_middle_height_printed(c)))


@formula("eq. (34), as printed", on="point", symbol=r"\delta")
def point_bisector_directrix_printed(c):
    """Directrix by (34) with the last height as printed, ``½(p² − wQ²)``."""
    return directrix_numerators_printed(c) / (point_bisector_determinant_polynomial(c) * c.w)


@formula("eq. (34)", on="point", symbol=r"\delta")
def point_bisector_directrix_polynomial(c):
    """Directrix by (34) with the corrected last height, ``½(‖p‖² − w²‖Q‖²)``."""
    first, second = _polynomial_rows(c)
    return cramer(first, second, _point_middle(c)) / (point_bisector_determinant_polynomial(c) * c.w)


@formula("eq. (34)", on="point")
def point_bisector_polynomial(c):
    """Point/curve bisector with the explicit directrix, polynomial; the generator is ``D1 × (γ − Q)``."""
    return ruled(point_bisector_directrix_polynomial(c), cross(D1(c), c.gamma - c.point))


def _direct(c, axis):
    """The surface with one coordinate as the ruling parameter: its plane is the third row, ``e | wζ``."""
    normal, middle = _normal_plane_polynomial(c), _point_middle(c)
    below = det(normal[0], middle[0], axis) * c.w
    return ruled(cramer(normal, middle, (axis, 0)) / below, cross(normal[0], middle[0]) * c.w / below)


@formula("§6.2, direct approach", on="point")
def point_bisector_direct_x(c):
    """Point/curve bisector by the 2×2 system with the first component moved to the right-hand side, where it is the
    ruling parameter.
    """
    return _direct(c, c.axis_x)


@formula("§6.2, direct approach", on="point")
def point_bisector_direct_y(c):
    """Point/curve bisector by the 2×2 system with the second component moved to the right-hand side, where it is the
    ruling parameter.
    """
    return _direct(c, c.axis_y)


@formula("§6.2, direct approach", on="point")
def point_bisector_direct_z(c):
    """Point/curve bisector by the 2×2 system with the third component moved to the right-hand side, where it is the
    ruling parameter.
    """
    return _direct(c, c.axis_z)


@formula("eq. (35)", on="point")
def point_bisector_direct_naive(c):
    """Point/curve bisector by the naive 2×2 system, each row brought to a common denominator, with the third component
    moved to the right-hand side.
    """
    normal, middle = level(*_normal_plane(c)), level(*_middle_plane(c.gamma, c.point))
    below = det(normal[0], middle[0], c.axis_z)
    return ruled(cramer(normal, middle, (c.axis_z, 0)) / below, cross(normal[0], middle[0]) / below)


@formula("§6.2, direct approach", on="point")
def direct_directrix(c):
    """The directrix of the direct form: the bisector in the plane of height 0."""
    return point_bisector_direct_z(c).directrix


@formula("§6.2, direct approach", on="point")
def direct_height_of_directrix(c):
    """The third component of the directrix of the direct form."""
    return dot(c.axis_z, point_bisector_direct_z(c).directrix)


@formula("§6.2, direct approach", on="point")
def direct_height_of_generator(c):
    """The third component of the generator of the direct form, minus 1."""
    return dot(c.axis_z, point_bisector_direct_z(c).generator) - 1


@formula("§6.2, direct approach", on="point")
def direct_determinant_x(c):
    """The determinant of the 2×2 system with the first component moved."""
    return det(D1(c), point_middle_normal_polynomial(c), c.axis_x)


@formula("§6.2, direct approach", on="point")
def direct_determinant_y(c):
    """The determinant of the 2×2 system with the second component moved."""
    return det(D1(c), point_middle_normal_polynomial(c), c.axis_y)


@formula("§6.2, direct approach", on="point")
def direct_determinant_z(c):
    """The determinant of the 2×2 system with the third component moved."""
    return det(D1(c), point_middle_normal_polynomial(c), c.axis_z)


@formula("§6.2, direct approach", on="point")
def generator_z(c):
    """The third component of ``D1 × (p − wQ)``."""
    return point_bisector_generator_polynomial(c)[2]


@formula("definition of the bisector", on="point")
def point_bisector_in_normal_plane(c):
    """``(δ − γ)·γ′``: zero when γ(s) is a critical point of the distance from δ."""
    return dot(point_bisector_directrix_polynomial(c) - c.gamma, c.gamma.d(1))


@formula("definition of the bisector", on="point")
def point_bisector_equidistance(c):
    """``‖δ − γ‖² − ‖δ − Q‖²``: zero if δ is equidistant from its foot point and Q."""
    directrix = point_bisector_directrix_polynomial(c)
    return norm2(directrix - c.gamma) - norm2(directrix - c.point)


@formula("eq. (30) in the plane", on="plane point")
def plane_bisector_numerators(c):
    """The numerators of the planar point/curve bisector, polynomial, in the unknown wB."""
    return cramer(_normal_plane_polynomial(c), _point_middle(c))


@formula("eq. (30) in the plane", on="plane point", symbol="D")
def plane_bisector_determinant(c):
    """``[D1 p − wQ]``."""
    return det(D1(c), c.p - c.point * c.w)


@formula("eq. (30) in the plane", on="plane point", symbol="B")
def plane_bisector(c):
    """Bisector of a plane curve and a point, naive, each row brought to a common denominator."""
    rows = level(*_normal_plane(c)), level(*_middle_plane(c.gamma, c.point))
    return cramer(rows[0], rows[1]) / det(c.gamma.d(1), c.gamma - c.point)


@formula("eq. (30) in the plane", on="plane point", symbol="B")
def plane_bisector_polynomial(c):
    """Bisector of a plane curve and a point, polynomial."""
    return plane_bisector_numerators(c) / (plane_bisector_determinant(c) * c.w)


@formula("definition of the bisector", on="plane point")
def plane_bisector_in_normal(c):
    """``(B − γ)·γ′``: zero if B lies on the normal at its foot point."""
    return dot(plane_bisector_polynomial(c) - c.gamma, c.gamma.d(1))


@formula("definition of the bisector", on="plane point")
def plane_bisector_equidistance(c):
    """``‖B − γ‖² − ‖B − Q‖²``: zero if B is equidistant from its foot point and Q."""
    return norm2(plane_bisector_polynomial(c) - c.gamma) - norm2(plane_bisector_polynomial(c) - c.point)
