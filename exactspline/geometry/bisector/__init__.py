"""Bisectors of two curves and of a curve and a point: surfaces, trimmed curves, and the exceptional parts beside the
surface (lines, planes, single pairs, poles). The complete answer, and the proof that it is complete, are in
``docs/bisectors.md``.
"""
