"""X. Chen, R. F. Riesenfeld, E. Cohen, Complexity Reduction for Symbolic Computation with Rational B-splines, 2007."""
