"""Bisectors of two curves and of a curve and a point: surfaces, trimmed curves, and the exceptional parts that do not
belong to the surface (lines, planes, single pairs, poles). The complete answer, and the proof that it is complete, are
in ``docs/bisectors.md``.
"""
