"""Readings: the possible interpretations of the operands of a formula. The spline reading is provided directly by
`exactspline.splines.bspline` and `exactspline.splines.nurbs`.
"""
