"""Pomax, *A Primer on Bézier Curves*: formulas, claims, and the words they rest on."""
