"""The curve of a witness written out, and what the formulas of a claim are there: enough to check it by hand."""

from __future__ import annotations

from exactspline.errors import ExactSplineError
from exactspline.language.ruled import split
from exactspline.numbers.exact import mpq, point_text
from exactspline.splines.nurbs import Nurbs
from exactspline.verification.claim import Claim
from exactspline.verification.evaluation import Evaluation
from exactspline.verification.evidence import At, Found, OnExample
from exactspline.verification.verdict import Finding


def curve_of_witness(claim: Claim, finding: Finding) -> Nurbs | None:
    """The curve that a witness names, or that the claim is about."""
    witness = finding.witness
    name = witness.name if isinstance(witness, OnExample) and not witness.surface else claim.example
    return claim.curve_named(name) if name else None


def written_out(curve: Nurbs) -> dict[str, str]:
    """The knots, control points and weights of a curve.

    >>> from exactspline import example
    >>> written_out(example("parabola"))["control points"]
    '(-1, 1), (0, -1), (1, 1)'
    """
    points = ", ".join(map(point_text, curve.control_points))
    knots, weights = (", ".join(map(str, numbers)) for numbers in (curve.knots, curve.weights))
    return {"knots": knots, "control points": points, "weights": weights}


def values_there(claim: Claim, finding: Finding) -> list[str]:
    """The values of the formulas of a claim at the parameter of its witness."""
    curve, t = curve_of_witness(claim, finding), _parameter(finding.witness)
    if curve is None or t is None:
        return []
    values = []
    for name in claim.named:
        try:
            parts, below = split(claim.find(name)(Evaluation(curve).argument(claim.curve)))
            divisor = mpq(1) if below is None else below(t)
            values.append(f"{name}({t}) = {point_text([x(t) / divisor for x in parts])}")
        except (ExactSplineError, ZeroDivisionError):  # a surface, or no value there
            continue
    return values


def _parameter(evidence: Found | None) -> mpq | None:
    """The parameter at which it is; None for another place."""
    inner = next(filter(None, (getattr(evidence, name, None) for name in ("witness", "at", "place"))), None)
    return evidence.parameter if isinstance(evidence, At) else inner and _parameter(inner)
