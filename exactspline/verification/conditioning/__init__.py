"""The paper's open question O1: does discarding the denominator make finding zeros better or worse conditioned?

The *condition number* of a zero x of multiplicity m of ``p = Σ b_i B_i`` on its segment (local parameter, degree n) is,
after Farouki and Rajan,

    ``C = (m! Σ |b_i| B_i(x) / |p⁽ᵐ⁾(x)|)^(1/m)``:

relative changes of the b_i by at most ε move x by at most ``C ε^(1/m)``, to first order, and that is attained.

**Theorem.** Let ``F = W f`` with ``W(x) ≠ 0`` and let ``K = Σ |W_i| B_i(x) / |W(x)| ≥ 1``. Then ``C_F ≤ K^(1/m) C_f``.
If no two Bernstein coefficients of W have opposite signs, ``K = 1`` and ``C_F ≤ C_f``; if moreover none of them is
zero, x is inside the segment, and f has two coefficients of opposite signs at most deg W places apart, ``C_F < C_f``.

*Proof.* ``C(N, k) F_k = Σ_{i+j=k} C(r, i) W_i C(n, j) f_j`` gives ``Σ |F_k| B_k(x) ≤ Σ |W_i| B_i(x) · Σ |f_j| B_j(x)``
by the triangle inequality, and ``F⁽ᵐ⁾(x) = W(x) f⁽ᵐ⁾(x)`` as x is a zero of order m: divide. Two products of opposite
signs in one sum make the inequality strict. ∎

With ``W = (u + v)ʳ`` this is their theorem that raising the degree never hurts. A curve of positive weights has a
denominator w whose Bernstein coefficients are positive on every segment, and so have its powers. What f2 and g2 leave
out of f0 and g0 is such a power times one of ``u + v`` (``w³ (u + v)³`` and ``w¹⁷ (u + v)⁶``), and as a rule what the
minimal form leaves out of f2 and g2 too; on special curves that is another divisor of the denominator, so that the
signs of the factor itself are looked at, each time. Hence:

- **With positive weights f2 and g2 are never better conditioned than f0 and g0**, and the minimal form not better than
  they are (but for such special divisors, of which none was met); as a rule the reduced form is the worse one at every
  zero inside a segment, whatever is close to zero. At an end of a segment every form has condition number 0, since
  ``B_i`` vanishes there wherever b_i does not. Double precision can feel it: on the example
  ``conditioning_reduced_worse``, with weights 1, 6, 12, 8, the minimal form of degree 11 is 12.9 times worse than g0 of
  degree 78 at the zero 1/3, and its error is more than eleven times as large.
- **A weight that is negative, w staying positive,** makes K large where w is small, and either happens. Where numerator
  and denominator both come close to zero the reduced form mostly is the better one, by many powers of ten: on
  ``conditioning_reduced_better``, where w is 2/225 at the zero 1/3, by a factor of 10³⁶ against g0, of which double
  precision sees nothing any more. In ``search_witnesses(0, 20)`` it is so against g0 at 64 of the 69 zeros on curves
  with w close to zero, against g2 at 45; at the others it is worse, by a factor of 12.2 at most.
- What the squaring approach leaves out has the factors ``‖D1‖²`` and ``[D1 D2]`` besides, of any signs: either happens,
  also with positive weights.

So neither remark of the paper's §7 holds as a rule. "A better numeric condition" for Fig. 2: the weights of that
ellipse are positive; with its vertices at the knots every form has condition number 0 there, with its vertices inside
the segments (``ellipse_skew``) the minimal form is the worst conditioned of all, squaring included. "The opposite"
where numerator and discarded denominator are both close to zero: with positive weights so it is there and everywhere
else; else it is mostly there that the reduced form is much better.

A smaller condition number is not yet a smaller error: besides the coefficients, which are rounded once, de Casteljau's
algorithm adds up to 2n roundings in degree n, so that the bounds to compare are about ``(2n + 1) C``. What double
precision really does is measured (`double_precision_root`); where C is below 1 all forms mostly end at the same double.
All this is about forms whose exact coefficients are at hand: what floats lose while they compute the coefficients of a
form of degree 78 is another matter, and not measured here.

Source: Farouki and Rajan, On the numerical condition of polynomials in Bernstein form, CAGD 4, 1987; Algorithms for
polynomials in Bernstein form, CAGD 5, 1988.
"""

from exactspline.verification.conditioning.compare import Conditioning, FormAtRoot, RootConditions, conditioning
from exactspline.verification.conditioning.condition_number import condition_number, quotient
from exactspline.verification.conditioning.double_precision import Double, double_precision_root
from exactspline.verification.conditioning.search import Tally, search_witnesses

__all__ = [
    "Conditioning",
    "Double",
    "FormAtRoot",
    "RootConditions",
    "Tally",
    "condition_number",
    "conditioning",
    "double_precision_root",
    "quotient",
    "search_witnesses",
]
