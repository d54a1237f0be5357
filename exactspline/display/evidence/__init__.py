"""Evidence in words: one function per type of evidence. No code parses these words."""

from __future__ import annotations

from exactspline.display.evidence import general, kinds, types
from exactspline.display.evidence.answers import opinion
from exactspline.display.evidence.dispatch import worded, words

__all__ = ["general", "kinds", "opinion", "types", "worded", "words"]
