"""Bisectors of two curves and of a curve and a point: surfaces, trimmed curves, and the exceptional parts outside the
surface.
"""
