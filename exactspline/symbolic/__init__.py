"""Algebra in the ring of jet polynomials: factorization, reduction, covariants."""
