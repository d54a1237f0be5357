"""Polynomials over FLINT, safe for coefficients of any size: products of powers, factorizations, resultants, and bounds
on their cost.

A call into FLINT cannot be interrupted. Its cost is therefore estimated before it is made, and a `ReachError` is raised
instead if the estimate exceeds a bound.
"""
