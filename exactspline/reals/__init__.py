"""Real numbers, exactly: rational, quadratic and algebraic ones of one type, and what is needed to compute with them.

Higher packages compute with `Real` (`exactspline.reals.real`); a root of a spline is one that knows where it was found.
"""
