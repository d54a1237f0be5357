"""Exact real numbers: one type for rational, quadratic and algebraic numbers.

Higher packages compute with `Real` (`exactspline.reals.real`); a root of a spline is a `Real` with its place on the
spline.
"""
