"""Pomax, *A Primer on Bézier Curves*: formulas, claims, and the text that they refer to."""
