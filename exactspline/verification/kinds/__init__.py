"""The kinds of claims, one class each."""

from __future__ import annotations

from exactspline.verification.claim import Claim
from exactspline.verification.kinds.applies import Applies
from exactspline.verification.kinds.coefficients import Coefficients
from exactspline.verification.kinds.condition import Condition
from exactspline.verification.kinds.contact import Contact
from exactspline.verification.kinds.count import Count
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.existence import Existence
from exactspline.verification.kinds.identity import Identity, Vanishing
from exactspline.verification.kinds.invariance import Invariance
from exactspline.verification.kinds.sign import SignClaim
from exactspline.verification.kinds.square_class import SquareClass
from exactspline.verification.kinds.surfaces import IsoCurve, SameSurface
from exactspline.verification.kinds.value_type import TypeClaim
from exactspline.verification.kinds.zero_set import ZeroSet

#: The classes by their word in tables of claims.
KINDS: dict[str, type[Claim]] = {
    kind.kind: kind
    for kind in (
        DegreeClaim,
        Identity,
        Vanishing,
        ZeroSet,
        Coefficients,
        Condition,
        Count,
        SquareClass,
        SameSurface,
        Existence,
        IsoCurve,
        Contact,
        Invariance,
        SignClaim,
        TypeClaim,
        Applies,
    )
}

__all__ = [
    "KINDS",
    "Applies",
    "Coefficients",
    "Condition",
    "Contact",
    "Count",
    "DegreeClaim",
    "Existence",
    "Identity",
    "Invariance",
    "IsoCurve",
    "SameSurface",
    "SignClaim",
    "SquareClass",
    "TypeClaim",
    "Vanishing",
    "ZeroSet",
]
