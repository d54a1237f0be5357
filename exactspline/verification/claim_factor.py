"""The factor that a claim states, read from its text."""

from __future__ import annotations

import re
from typing import Any

from exactspline.errors import ClaimError
from exactspline.exact import rational
from exactspline.language.arguments import operands
from exactspline.papers import find


def factor_of_text(text: str, curve: Any) -> tuple[Any, Any]:
    """A factor as a claim states it, ``"2 w^29 f2"`` or ``"w^-4"``, as numerator and denominator in the reading of the
    curve.

    Raises `ClaimError` when it cannot be read.
    """
    known = operands(curve)
    one = known["w"]
    top = bottom = one.constant(1)
    for part in text.split():
        match = re.fullmatch(r"([A-Za-z]\w*|-?\d+(?:/\d+)?)(?:\^(-?\d+))?", part)
        if not match:
            raise ClaimError(f"the factor {text!r} cannot be read", where=part, remedy='write for example "2 w^29 f2"')
        name, exponent = match[1], int(match[2] or 1)
        value = (
            known[name]
            if name in ("w", "W")
            else find(name)(curve)
            if name[0].isalpha()
            else one.constant(rational(name))
        )
        if exponent > 0:
            top = top * value**exponent
        else:
            bottom = bottom * value ** (-exponent)
    return top, bottom
