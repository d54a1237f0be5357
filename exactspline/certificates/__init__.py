"""Certificates: proofs as JSON data with exact strings, and their checker, which uses only the standard library and
shares no code with the programs that write them.

A certificate has a `format` with a version, names the proved statement in `what`, and contains the data of the proof:
of all ``zeros`` of a spline (written by `exactspline.roots.zero_set`), of all ``intersections`` of two plane curves
(written by `exactspline.geometry.pairs.intersections`), of all ``common zeros`` of functions of two parameters (written
by `exactspline.bivariate.common_zeros_certificate`), of the ``zero curves`` of one function and their topology (written
by `exactspline.bivariate.common_zeros_certificate`), or that the ``degree`` of forms cannot be lowered (written by
`exactspline.verification.generic_proof`).
"""

from collections.abc import Callable, Mapping

from exactspline.certificates.common_zeros import check_common_zeros, check_intersections
from exactspline.certificates.degrees import check_degrees
from exactspline.certificates.numbers import CertificateError as CertificateError
from exactspline.certificates.numbers import read, require, text
from exactspline.certificates.zero_curves import check_zero_curves
from exactspline.certificates.zeros import check_zeros

ZEROS, DEGREE, INTERSECTIONS, COMMON_ZEROS = "zeros", "degree", "intersections", "common zeros"
ZERO_CURVES = "zero curves"
#: The version of each format.
VERSIONS = {ZEROS: 1, DEGREE: 2, INTERSECTIONS: 2, COMMON_ZEROS: 2, ZERO_CURVES: 2}
FORMAT = "exactspline certificate {}"
CHECKERS: dict[str, Callable[[Mapping[str, object]], dict[str, int]]] = {
    ZEROS: check_zeros,
    DEGREE: check_degrees,
    INTERSECTIONS: check_intersections,
    COMMON_ZEROS: check_common_zeros,
    ZERO_CURVES: check_zero_curves,
}


def certificate(what: str, data: Mapping[str, object]) -> dict[str, object]:
    """A certificate with this data.

    >>> certificate(DEGREE, {"kind": "quotient"})
    {'format': 'exactspline certificate 2', 'what': 'degree', 'kind': 'quotient'}
    """
    return {"format": FORMAT.format(VERSIONS[what]), "what": what, **data}


def check_certificate(certificate: Mapping[str, object], sturm: bool = True) -> dict[str, int]:
    """Check a certificate and return what it proves: the numbers of roots, jumps and intervals, or of common points,
    common zeros or curves of zeros; or the largest degree over the segments, with the labels that were not checked.

    With ``sturm=False`` the zeros are not counted again by Sturm sequences (which are slow for degrees above 100).

    >>> from exactspline import BSpline, zeros
    >>> check_certificate(zeros(BSpline.bezier([1, -2, 1])).certificate())
    {'roots': 2, 'jumps': 0, 'intervals': 0}

    Raises `CertificateError`, a `ValueError`, with the flaw and its place if the certificate is invalid.
    """
    require(isinstance(certificate, Mapping), "not a certificate, which is an object")
    given = read(certificate, {"what": text, "format": text})
    what = given["what"]
    require(what in CHECKERS, "a proof of something unknown")
    version = FORMAT.format(VERSIONS[what])
    require(given["format"] == version, f"unknown format; certificates of {what} have the format {version}")
    return check_zeros(certificate, sturm) if what == ZEROS else CHECKERS[what](certificate)
