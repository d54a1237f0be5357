"""Polynomials over FLINT, safe for coefficients of any size: products of powers, factorizations, resultants, and what
their computation costs.

A call into FLINT cannot be interrupted. What it may cost is therefore known before it is made, and beyond a bound a
`ReachError` is raised instead.
"""
