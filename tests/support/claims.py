"""Claims by their keys, and what is said of them."""

from exactspline.papers import load_paper
from exactspline.verification.claim import Claim
from exactspline.verification.claims import claims_of, select
from exactspline.verification.kinds.not_asked import NotAsked


def claim(key: str) -> Claim:
    """The one claim with this key."""
    (found,) = select([key])
    return found


def refusal(folder) -> str:
    """Why the one entry of a user's folder that is refused is not asked."""
    (found,) = (each for each in claims_of(load_paper(folder)) if isinstance(each, NotAsked))
    return found.why
