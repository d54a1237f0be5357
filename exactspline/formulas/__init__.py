"""Formulas that do not come from a single paper: curves and surfaces from their lifts, fundamental forms, invariants.

This package contains only code. Each formula has a claim in a folder of `exactspline.papers`, under which it is listed
and proved.
"""
