"""What the matrix does not compare, and why: the one table of it."""

from exactspline.questions.entry import Of

CURVES = (Of.PLANE_CURVE, Of.SPACE_CURVE)
IN_THE_PLANE = (Of.PLANE_CURVE, Of.REGION)
SINGULAR = "knot on a singular point"
KNOTS = ("knot far away", "knot on what was found", SINGULAR, "knot near what was found")
OF_SURFACES = ("knot far away", "knot on what was found", "knot near what was found")
#: What changes the forms of a surface.
FORMS = ("degree", "common factor", "moebius")
#: What tells pieces.
PIECES = ("inflections", "critical_points", "curvature_extrema", "straight_pieces", "constant_pieces")
#: Answers about control points, speeds, or all objects near by depend on how the object is written.
NOT_TRANSPORTED = {
    "stability": "it tells how far control points may move",
    "largest_speed": "the speed goes with the parameter",
}
#: What is asked in campaigns alone.
DEAR = {
    (Of.SURFACE, "ridges"),
    (Of.PLANE_CURVE, "offset_self_intersections"),
    (Of.PLANE_CURVE, "offset_parts"),
    (Of.TWO_CURVES, "bisector"),
    (Of.TWO_CURVES, "offset_intersections"),
}
#: What is compared where it is decided: whether it is goes with boxes along the axes, and with the lengths of numbers.
WHERE_DECIDED = {
    "bisector",
    "offset_intersections",
    "offset_self_intersections",
    "offset_parts",
    "largest_curvature_derivative",
    "largest_torsion",
}
#: Of what, questions, changes, reason.
EXEMPTIONS = [
    (CURVES, ("shapes",), KNOTS, "pieces begin and end at knots, and conics of degree 2 are told of one segment alone"),
    (CURVES, ("shapes",), ("degree", "common factor"), "conics of degree 2 are told of one segment alone"),
    (CURVES, ("shapes",), ("other seam",), "pieces begin where the curve does"),
    (
        CURVES,
        ("joints", "corners"),
        (SINGULAR,),
        "a cusp at a knot is a joint, and a corner of 180°; inside it is none",
    ),
    (CURVES, PIECES, (SINGULAR,), "a cusp inside a segment, which may be irrational, cuts no piece"),
    ((Of.SPACE_CURVE,), ("torsion_zeros", "planar_pieces"), (SINGULAR,), "a cusp inside a segment cuts no piece"),
    ((Of.SPACE_CURVE,), ("torsion_zeros",), ("split",), "a part of a planar piece may be straight"),
    (CURVES, ("at_length",), ("reversed", "other seam"), "lengths are those from the start"),
    (CURVES, ("equally_spaced",), ("other seam",), "the first point is the start"),
    (CURVES, ("length_between",), ("other seam",), "what is between two parameters goes with the seam"),
    (CURVES, ("turning_points", "bounding_box", "at_coordinate"), ("rotated",), "a turned coordinate is none"),
    ((Of.TWO_CURVES,), ("junctions_within",), ("scaled",), "one number bounds lengths, angles and curvatures"),
    (
        (Of.TWO_SURFACES,),
        ("common_borders",),
        ("moebius of one",),
        "of borders whose parameters are no linear functions of each other the order is not told",
    ),
    (IN_THE_PLANE, ("moments",), ("rotated",), "a turned coordinate is none"),
    ((Of.SURFACE,), ("bounding_box",), ("rotated",), "a turned coordinate is none"),
    ((Of.SURFACE,), ("patches",), OF_SURFACES, "a part of a patch may be of one kind"),
    ((Of.SURFACE,), ("shapes",), OF_SURFACES, "a small part may be nearer to a shape than the whole"),
    ((Of.SURFACE,), ("ridges",), (*OF_SURFACES, *FORMS), "what is resolved goes with the degree of the forms"),
]
