"""Readings: what the operands of a formula can be. The spline reading is `exactspline.spline` and `exactspline.nurbs` themselves."""
