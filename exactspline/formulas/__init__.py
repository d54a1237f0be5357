"""The formulas that belong to no single paper: curves and surfaces from their lifts, fundamental forms, invariants.

Code only. Each has a claim in a folder of `exactspline.papers`, by which it is found and proved; here it is below
everything that computes with it.
"""
