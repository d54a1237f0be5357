"""Readings: what the operands of a formula can be. The spline reading is `exactspline.splines.bspline` and
`exactspline.splines.nurbs` themselves.
"""
