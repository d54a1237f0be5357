"""Values with one component."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from exactspline.errors import ClaimError
from exactspline.verification.claim import Claim

V = TypeVar("V")


def only_component(claim: Claim, name: str, components: Sequence[V]) -> V:
    """The one component of a scalar.

    Raises `ClaimError` for a vector.
    """
    if len(components) > 1:
        raise ClaimError(f"{name!r} is a vector", where=claim.key, remedy="name a formula whose value is a scalar")
    return components[0]
