"""Bisectors of two curves and of a curve and a point: surfaces, trimmed curves, and the exceptional parts that do
not belong to them.
"""
