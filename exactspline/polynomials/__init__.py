"""Polynomials over FLINT, safe for coefficients of any size: products of powers, factorizations, resultants, and bounds
on their cost.

A call into FLINT cannot be interrupted. Therefore the cost of a call is estimated beforehand, and a `ReachError` is
raised if the estimate exceeds a bound.
"""
