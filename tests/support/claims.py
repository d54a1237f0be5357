"""Claims by their keys, and what is said of them."""

from exactspline.verification.claim import Claim
from exactspline.verification.claims import select


def claim(key: str) -> Claim:
    """The one claim with this key."""
    (found,) = select([key])
    return found
