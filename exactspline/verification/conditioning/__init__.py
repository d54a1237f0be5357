"""The paper's open question O1: is the computation of zeros better or worse conditioned when the denominator is
discarded?

The *condition number* of a zero x of multiplicity m of ``p = Σ b_i B_i`` on its segment (local parameter, degree n) is,
after Farouki and Rajan, ``C = (m! Σ |b_i| B_i(x) / |p⁽ᵐ⁾(x)|)^(1/m)``. The results about the forms, with proofs, are in
docs/conditioning.md.

Source: Farouki and Rajan, On the numerical condition of polynomials in Bernstein form, CAGD 4, 1987.
"""
