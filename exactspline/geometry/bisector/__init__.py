"""Bisectors of two curves and of a curve and a point: surfaces, trimmed curves, and what is beside the surface (lines,
planes, single pairs, poles).

What the complete answer is, and why it is complete, is told in ``docs/bisectors.md``.
"""
