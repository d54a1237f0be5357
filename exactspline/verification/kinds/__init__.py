"""The kinds of claims, one class each."""

from __future__ import annotations

from exactspline.verification.claim import Claim
from exactspline.verification.kinds.contact import Contact
from exactspline.verification.kinds.degree import DegreeClaim
from exactspline.verification.kinds.equality import Identity, IsoCurve, SameSurface, Vanishing
from exactspline.verification.kinds.examples import Condition, Count
from exactspline.verification.kinds.invariance import Invariance
from exactspline.verification.kinds.not_asked import NotAsked
from exactspline.verification.kinds.types import Applies, Existence, TypeClaim
from exactspline.verification.kinds.values import Bound, Coefficients, DistanceClaim, Limit, ValueClaim
from exactspline.verification.kinds.zeros import SignClaim, SquareClass, ZeroSet

#: The classes by their word in tables of claims.
KINDS: dict[str, type[Claim]] = {
    kind.kind: kind
    for kind in (
        *(DegreeClaim, Identity, Vanishing, ZeroSet, Coefficients, Condition, Count, SquareClass, SameSurface),
        *(Existence, IsoCurve, Contact, Invariance, SignClaim, TypeClaim, Applies),
        *(ValueClaim, Limit, Bound, DistanceClaim, NotAsked),
    )
}
