"""Piecewise polynomials with exact rational coefficients: one segment, B-splines, NURBS, two parameters."""
