"""Certificates: proofs as JSON data with exact strings, and their checker, which uses only the standard library and
shares no code with the programs that write them.

A certificate has a `format`, states in `what` what it proves, and contains the data of the proof: of all ``zeros`` of a
spline (written by `exactspline.roots.zero_set`), of all ``intersections`` of two plane curves (written by
`exactspline.geometry.intersection_certificate`), of all ``common zeros`` of functions of two parameters (written by
`exactspline.geometry.common_zeros_certificate`), of the ``zero curves`` of one and their topology (written by
`exactspline.geometry.zero_curve_certificate`), or that the ``degree`` of forms cannot be lowered (written by
`exactspline.verification.minimality`).
"""

from collections.abc import Mapping

from exactspline.certificates.common_zeros import check_common_zeros
from exactspline.certificates.degrees import check_degrees
from exactspline.certificates.intersections import check_intersections
from exactspline.certificates.zero_curves import check_zero_curves
from exactspline.certificates.zeros import check_zeros

FORMAT = "exactspline certificate 1"
ZEROS, DEGREE, INTERSECTIONS, COMMON_ZEROS = "zeros", "degree", "intersections", "common zeros"
ZERO_CURVES = "zero curves"


def certificate(what: str, data: Mapping[str, object]) -> dict[str, object]:
    """A certificate with this data.

    >>> certificate(DEGREE, {"kind": "quotient"})
    {'format': 'exactspline certificate 1', 'what': 'degree', 'kind': 'quotient'}
    """
    return {"format": FORMAT, "what": what, **data}


def check_certificate(certificate: Mapping[str, object], sturm: bool = True) -> dict[str, int]:
    """Check a certificate and return what it proves: the numbers of roots, jumps and intervals, the number of common
    points, common zeros, or curves of zeros of each shape, or the largest degree over the segments.

    With ``sturm=False`` the zeros are not counted again by Sturm sequences (which are slow for degrees above 100).

    >>> from exactspline import BSpline, zeros
    >>> check_certificate(zeros(BSpline.bezier([1, -2, 1])).certificate())
    {'roots': 2, 'jumps': 0, 'intervals': 0}

    Raises `ValueError` with a description of the flaw if the certificate is invalid.
    """
    try:
        if certificate["format"] != FORMAT:
            raise ValueError("unknown format")
        if certificate["what"] == ZEROS:
            return check_zeros(certificate, sturm)
        if certificate["what"] == DEGREE:
            return check_degrees(certificate)
        if certificate["what"] == INTERSECTIONS:
            return check_intersections(certificate)
        if certificate["what"] == COMMON_ZEROS:
            return check_common_zeros(certificate)
        if certificate["what"] == ZERO_CURVES:
            return check_zero_curves(certificate)
        raise ValueError("a proof of something unknown")
    except (TypeError, AttributeError, LookupError, ArithmeticError) as error:  # a field is missing, or another one
        raise ValueError(f"not a certificate: {type(error).__name__}: {error}") from error
