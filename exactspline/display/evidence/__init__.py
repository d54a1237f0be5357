"""What checks find, in words: one function for each type of evidence. Nothing reads what they write."""

from __future__ import annotations

from exactspline.display.evidence import general, kinds, types
from exactspline.display.evidence.answers import opinion
from exactspline.display.evidence.dispatch import worded, words

__all__ = ["general", "kinds", "opinion", "types", "worded", "words"]
