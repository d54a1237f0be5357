(** Complexity Reduction for Symbolic Computation with Rational B-splines: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** Table 1, T1. Sum of two polynomials. *)
Definition T1 (c : table A) : A :=
  p1 c + p2 c.

(** Table 1, T2. Product of two polynomials. *)
Definition T2 (c : table A) : A :=
  p1 c * p2 c.

(** Table 1, T3. Quotient of two polynomials. *)
Definition T3 (c : table A) : A :=
  p1 c / p2 c.

(** Table 1, T4. Sum of a rational and a polynomial. *)
Definition T4 (c : table A) : A :=
  p1 c / w1 c + p2 c.

(** Table 1, T5. Sum of two rationals. *)
Definition T5 (c : table A) : A :=
  p1 c / w1 c + p2 c / w2 c.

(** Table 1, T6. Product of a rational and a polynomial. *)
Definition T6 (c : table A) : A :=
  p1 c / w1 c * p2 c.

(** Table 1, T7. Product of two rationals. *)
Definition T7 (c : table A) : A :=
  p1 c / w1 c * (p2 c / w2 c).

(** Table 1, T8. A rational divided by a polynomial. *)
Definition T8 (c : table A) : A :=
  p1 c / w1 c / p2 c.

(** Table 1, T9. Quotient of two rationals. *)
Definition T9 (c : table A) : A :=
  p1 c / w1 c / (p2 c / w2 c).

(** Table 1, T10. Cross product of two polynomial vectors. *)
Definition T10 (c : table A) : list A :=
  cross (v1 c) (v2 c).

(** Table 1, T11. Dot product of two polynomial vectors. *)
Definition T11 (c : table A) : A :=
  dot (v1 c) (v2 c).

(** Table 1, T12. Cross product of a rational and a polynomial vector. *)
Definition T12 (c : table A) : list A :=
  cross (vdiv (v1 c) (w1 c)) (v2 c).

(** Table 1, T13. Cross product of two rational vectors. *)
Definition T13 (c : table A) : list A :=
  cross (vdiv (v1 c) (w1 c)) (vdiv (v2 c) (w2 c)).

(** Table 1, T14. Dot product of a rational and a polynomial vector. *)
Definition T14 (c : table A) : A :=
  dot (vdiv (v1 c) (w1 c)) (v2 c).

(** Table 1, T15. Dot product of two rational vectors. *)
Definition T15 (c : table A) : A :=
  dot (vdiv (v1 c) (w1 c)) (vdiv (v2 c) (w2 c)).

(** Table 1, T16. Derivative of a polynomial. *)
Definition T16 (c : table A) : A :=
  der s (p1 c).

(** Table 1, T17. Derivative of a rational. *)
Definition T17 (c : table A) : A :=
  der s (p1 c / w1 c).

(** Table 1, T1. Row T1 over one denominator. *)
Definition T1_carried_out (c : table A) : A :=
  p2 c + p1 c.

(** Table 1, T4. Row T4 over one denominator. *)
Definition T4_carried_out (c : table A) : A :=
  (p1 c + p2 c * w1 c) / w1 c.

(** Table 1, T5. Row T5 over one denominator. *)
Definition T5_carried_out (c : table A) : A :=
  (p1 c * w2 c + p2 c * w1 c) / (w1 c * w2 c).

(** Table 1, T6. Row T6 over one denominator. *)
Definition T6_carried_out (c : table A) : A :=
  p1 c * p2 c / w1 c.

(** Table 1, T7. Row T7 over one denominator. *)
Definition T7_carried_out (c : table A) : A :=
  p1 c * p2 c / (w1 c * w2 c).

(** Table 1, T8. Row T8 over one denominator. *)
Definition T8_carried_out (c : table A) : A :=
  p1 c / (w1 c * p2 c).

(** Table 1, T9. Row T9 over one denominator. *)
Definition T9_carried_out (c : table A) : A :=
  p1 c * w2 c / (w1 c * p2 c).

(** Table 1, T12. Row T12 over one denominator. *)
Definition T12_carried_out (c : table A) : list A :=
  vdiv (cross (v1 c) (v2 c)) (w1 c).

(** Table 1, T13. Row T13 over one denominator. *)
Definition T13_carried_out (c : table A) : list A :=
  vdiv (cross (v1 c) (v2 c)) (w1 c * w2 c).

(** Table 1, T14. Row T14 over one denominator. *)
Definition T14_carried_out (c : table A) : A :=
  dot (v1 c) (v2 c) / w1 c.

(** Table 1, T15. Row T15 over one denominator. *)
Definition T15_carried_out (c : table A) : A :=
  dot (v1 c) (v2 c) / (w1 c * w2 c).

(** Table 1, T10. Row T10 over one denominator. *)
Definition T10_carried_out (c : table A) : list A :=
  vneg (cross (v2 c) (v1 c)).

(** Table 1, T17. Row T17 over one denominator. *)
Definition T17_carried_out (c : table A) : A :=
  (der s (p1 c) * w1 c - p1 c * der s (w1 c)) / w1 c ^ 2.

(** eq. (4). `p′w − pw′`. *)
Definition D1 (c : curve A) : list A :=
  vsub (vmul (w c) (vder (along c) (p c))) (vmul (der (along c) (w c)) (p c)).

(** eq. (4). `p″w − pw″`. *)
Definition D2 (c : curve A) : list A :=
  vsub (vmul (w c) (vders (along c) 2 (p c))) (vmul (ders (along c) 2 (w c)) (p c)).

(** eq. (4). `p‴w − pw‴`. *)
Definition D3 (c : curve A) : list A :=
  vsub (vmul (w c) (vders (along c) 3 (p c))) (vmul (ders (along c) 3 (w c)) (p c)).

(** eq. (4). `p″w′ − p′w″`. *)
Definition D21 (c : curve A) : list A :=
  vsub (vmul (der (along c) (w c)) (vders (along c) 2 (p c))) (vmul (ders (along c) 2 (w c)) (vder (along c) (p c))).

(** §3. First derivative by the quotient rule. *)
Definition velocity (c : curve A) : list A :=
  vder (along c) (gamma c).

(** §3. Second derivative by the quotient rule, twice. *)
Definition acceleration (c : curve A) : list A :=
  vders (along c) 2 (gamma c).

(** §3. Third derivative by the quotient rule, three times. *)
Definition jerk (c : curve A) : list A :=
  vders (along c) 3 (gamma c).

(** §4.2, §5. `‖γ′‖²`. *)
Definition speed_squared (c : curve A) : A :=
  dot (vder (along c) (gamma c)) (vder (along c) (gamma c)).

(** §4.2, §5. `‖D1‖²`: without a zero where the curve is regular. *)
Definition D1_squared (c : curve A) : A :=
  dot (D1 c) (D1 c).

(** eq. (1). First derivative over w². *)
Definition velocity_shared (c : curve A) : list A :=
  vdiv (D1 c) (w c ^ 2).

(** Remark 3.2. `D2/w²`, the first term of γ″. *)
Definition acceleration_first_term (c : curve A) : list A :=
  vdiv (D2 c) (w c ^ 2).

(** Remark 3.2. `D3/w²`, the first term of γ‴. *)
Definition jerk_first_term (c : curve A) : list A :=
  vdiv (D3 c) (w c ^ 2).

(** eq. (2). Second derivative, its terms over w³. *)
Definition acceleration_shared (c : curve A) : list A :=
  vdiv (vsub (vmul (w c) (D2 c)) (vmul (number 2 * der (along c) (w c)) (D1 c))) (w c ^ 3).

(** eq. (3). Third derivative, its terms over w⁴. *)
Definition jerk_shared (c : curve A) : list A :=
  vdiv (vadd (vsub (vmul (w c ^ 2) (vadd (D3 c) (D21 c))) (vmul (number 4 * der (along c) (w c) * w c) (D2 c))) (vmul (number 6 * der (along c) (w c) ^ 2 - number 2 * w c * ders (along c) 2 (w c)) (D1 c))) (w c ^ 4).

(** Remark 3.1. `[D1 D2 D3]` in space. *)
Definition D1_D2_D3 (c : curve A) : A :=
  det [D1 c; D2 c; D3 c].

(** §3. `[D1 D2 D21]`: zero when D21 lies in the span of D1 and D2. *)
Definition D1_D2_D21 (c : curve A) : A :=
  det [D1 c; D2 c; D21 c].

(** §3. D21 by D1 and D2. *)
Definition D21_in_span (c : curve A) : list A :=
  vdiv (vsub (vmul (der (along c) (w c)) (D2 c)) (vmul (ders (along c) 2 (w c)) (D1 c))) (w c).

(** eq. (5). The term of D1 in γ″. *)
Definition acceleration_term_1 (c : curve A) : list A :=
  vmul (number 2 * der (along c) (w c) / w c ^ 3) (D1 c).

(** eq. (5). The term of D21 in γ‴. *)
Definition jerk_term_21 (c : curve A) : list A :=
  vdiv (D21 c) (w c ^ 2).

(** eq. (5). The part of D21/w² along D1. *)
Definition jerk_term_21_1 (c : curve A) : list A :=
  vmul (ders (along c) 2 (w c) / w c ^ 3) (D1 c).

(** eq. (5). The part of D21/w² along D2. *)
Definition jerk_term_21_2 (c : curve A) : list A :=
  vmul (der (along c) (w c) / w c ^ 3) (D2 c).

(** eq. (5). The term of D2 in γ‴. *)
Definition jerk_term_2 (c : curve A) : list A :=
  vmul (number 4 * der (along c) (w c) / w c ^ 3) (D2 c).

(** eq. (5). The term of D1 in γ‴. *)
Definition jerk_term_1 (c : curve A) : list A :=
  vmul ((number 6 * der (along c) (w c) ^ 2 - number 2 * w c * ders (along c) 2 (w c)) / w c ^ 4) (D1 c).

(** eq. (5). Second derivative as the paper prints it: a sum of terms over powers of w. *)
Definition acceleration_terms (c : curve A) : list A :=
  vsub (acceleration_first_term c) (acceleration_term_1 c).

(** eq. (5). Third derivative as the paper prints it: a sum of terms over powers of w. *)
Definition jerk_terms (c : curve A) : list A :=
  vadd (vsub (vadd (jerk_first_term c) (jerk_term_21 c)) (jerk_term_2 c)) (jerk_term_1 c).

(** Remark 3.2. `[γ′ γ″ − D2/w²]`: zero when the rest of γ″ is along γ′, in the plane. *)
Definition acceleration_rest_plane (c : curve A) : A :=
  det [vder (along c) (gamma c); vsub (vders (along c) 2 (gamma c)) (acceleration_first_term c)].

(** Remark 3.2. `γ′ × (γ″ − D2/w²)`: zero when the rest of γ″ is along γ′, in space. *)
Definition acceleration_rest_space (c : curve A) : list A :=
  cross (vder (along c) (gamma c)) (vsub (vders (along c) 2 (gamma c)) (acceleration_first_term c)).

(** Remark 3.2. `[γ′ γ″ γ‴ − D3/w²]`: zero when the rest of γ‴ is in the span of γ′ and γ″. *)
Definition jerk_rest (c : curve A) : A :=
  det [vder (along c) (gamma c); vders (along c) 2 (gamma c); vsub (vders (along c) 3 (gamma c)) (jerk_first_term c)].

(** §3. `[γ′ γ‴]`, naive. *)
Definition velocity_jerk (c : curve A) : A :=
  det [vder (along c) (gamma c); vders (along c) 3 (gamma c)].

(** §3. `[D1 D3]` in the plane. *)
Definition D1_D3 (c : curve A) : A :=
  det [D1 c; D3 c].

(** Remark 3.2. `[γ′ γ″ γ‴]`, naive. *)
Definition velocity_acceleration_jerk (c : curve A) : A :=
  det [vder (along c) (gamma c); vders (along c) 2 (gamma c); vders (along c) 3 (gamma c)].

(** §4.1. Numerator of the curvature: `[γ′ γ″]`, naive. *)
Definition f0 (c : curve A) : A :=
  det [vder (along c) (gamma c); vders (along c) 2 (gamma c)].

(** §4.1, Remark 3.1. `[D1 D2]`, which vanishes with the curvature. *)
Definition f1 (c : curve A) : A :=
  det [D1 c; D2 c].

(** eq. (8). `[D1 D2]` multiplied out, as eq. (8) prints it. *)
Definition f1_expanded (c : curve A) : A :=
  det [vder (along c) (p c); vders (along c) 2 (p c)] * w c ^ 2 - det [p c; vders (along c) 2 (p c)] * (der (along c) (w c) * w c) - det [vder (along c) (p c); p c] * (w c * ders (along c) 2 (w c)).

(** eq. (8). Zero-curvature form of a rational plane curve: eq. (8) without its common factor w. *)
Definition f2 (c : curve A) : A :=
  det [vder (along c) (p c); vders (along c) 2 (p c)] * w c - det [p c; vders (along c) 2 (p c)] * der (along c) (w c) - det [vder (along c) (p c); p c] * ders (along c) 2 (w c).

(** eq. (9). Squared curvature `[γ′ γ″]² / ‖γ′‖⁶`, naive. *)
Definition curvature_squared (c : curve A) : A :=
  f0 c ^ 2 / speed_squared c ^ 3.

(** §4.2, squaring approach. Derivative of the squared curvature by the quotient rule. *)
Definition curvature_squared_derivative (c : curve A) : A :=
  der (along c) (curvature_squared c).

(** §4.2. `κ′ ‖γ′‖⁵` from `κ = f0 (‖γ′‖²)^(−3/2)` by the chain rule. *)
Definition curvature_derivative_numerator (c : curve A) : A :=
  der (along c) (f0 c) * speed_squared c - f0 c * der (along c) (speed_squared c) * number 3 / number 2.

(** eq. (10). First term of g0. *)
Definition g0_term_1 (c : curve A) : A :=
  speed_squared c * det [vder (along c) (gamma c); vders (along c) 3 (gamma c)].

(** eq. (10). Second term of g0. *)
Definition g0_term_2 (c : curve A) : A :=
  number 3 * dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)) * f0 c.

(** eq. (10). Numerator of κ′ over ‖γ′‖⁵, the direct approach, naive. *)
Definition g0 (c : curve A) : A :=
  g0_term_1 c - g0_term_2 c.

(** §4.2. g0 with the derivatives replaced by eq. (5), as the paper prints it. *)
Definition g1 (c : curve A) : A :=
  det [D1 c; D3 c] * D1_squared c + det [D1 c; D21 c] * D1_squared c + number 2 * der (along c) (w c) / w c * f1 c * D1_squared c - number 3 * dot (D1 c) (D2 c) * f1 c.

(** eq. (11). First term of g2. *)
Definition g2_term_1 (c : curve A) : A :=
  det [D1 c; D3 c] * D1_squared c * w c.

(** eq. (11). Second term of g2. *)
Definition g2_term_2 (c : curve A) : A :=
  det [D1 c; D21 c] * D1_squared c * w c.

(** eq. (11). Third term of g2. *)
Definition g2_term_3 (c : curve A) : A :=
  number 2 * der (along c) (w c) * f1 c * D1_squared c.

(** eq. (11). Fourth term of g2. *)
Definition g2_term_4 (c : curve A) : A :=
  number 3 * dot (D1 c) (D2 c) * f1 c * w c.

(** eq. (11). Critical-curvature form of a rational plane curve. *)
Definition g2 (c : curve A) : A :=
  g2_term_1 c + g2_term_2 c + g2_term_3 c - g2_term_4 c.

(** §4.2. `f0 g0`: vanishes where the curvature or its derivative does. *)
Definition f0_g0 (c : curve A) : A :=
  f0 c * g0 c.

(** §4.3, beside eq. (12). `‖γ′‖⁶ / [γ′ γ″]²`: the square of what is printed as κ beside eq. (12). *)
Definition curvature_squared_inverted (c : curve A) : A :=
  speed_squared c ^ 3 / f0 c ^ 2.

(** §4.3, beside eq. (12). `1/κ²`. *)
Definition curvature_radius_squared (c : curve A) : A :=
  number 1 / curvature_squared c.

(** eq. (12). Evolute `γ + (‖γ′‖²/[γ′ γ″]) γ′⊥`, naive. *)
Definition evolute (c : curve A) : list A :=
  vadd (gamma c) (vmul (speed_squared c / f0 c) (perp (vder (along c) (gamma c)))).

(** §4.3, below eq. (12). Evolute as one quotient of polynomials in D1 and D2. *)
Definition evolute_reduced (c : curve A) : list A :=
  vdiv (vadd (vmul (f1 c * w c) (p c)) (vmul (D1_squared c) (perp (D1 c)))) (f1 c * w c ^ 2).

(** §4.3, footnote b. `γ + (1/κ)N` with the normal of the Frenet frame and its κ: `γ + κN/κ²`, κN the derivative of the unit tangent by arc length. *)
Definition evolute_by_frenet (c : curve A) : list A :=
  vadd (gamma c) (vdiv (vsub (vdiv (vders (along c) 2 (gamma c)) (speed_squared c)) (vmul (dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)) / speed_squared c ^ 2) (vder (along c) (gamma c)))) (curvature_squared c)).

(** definition of the evolute. `(E − γ)·γ′`: zero when the circle around E touches to first order. *)
Definition evolute_contact_1 (c : curve A) : A :=
  dot (vsub (evolute c) (gamma c)) (vder (along c) (gamma c)).

(** definition of the evolute. `(E − γ)·γ″ − ‖γ′‖²`: zero when the circle around E touches to second order. *)
Definition evolute_contact_2 (c : curve A) : A :=
  dot (vsub (evolute c) (gamma c)) (vders (along c) 2 (gamma c)) - speed_squared c.

(** eq. (7). `κ² ‖E − γ‖² − 1`: zero when |κ| is the reciprocal of the radius of the osculating circle. *)
Definition curvature_of_osculating_circle (c : curve A) : A :=
  curvature_squared c * dot (vsub (evolute c) (gamma c)) (vsub (evolute c) (gamma c)) - number 1.

(** eq. (14). `γ′ × γ″`: the binormal direction, rational. *)
Definition binormal (c : curve A) : list A :=
  cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)).

(** eq. (14). `(γ′ × γ″) × γ′`: the principal normal direction, rational. *)
Definition normal (c : curve A) : list A :=
  cross (binormal c) (vder (along c) (gamma c)).

(** §5. `‖γ′ × γ″‖²`. *)
Definition binormal_squared (c : curve A) : A :=
  dot (binormal c) (binormal c).

(** §5. `D1 × D2`. *)
Definition D1_x_D2 (c : curve A) : list A :=
  cross (D1 c) (D2 c).

(** §5, as eq. (8). `D1 × D2` without its common factor w, as eq. (8) is in the plane. *)
Definition binormal_form (c : curve A) : list A :=
  vsub (vsub (vmul (w c) (cross (vder (along c) (p c)) (vders (along c) 2 (p c)))) (vmul (der (along c) (w c)) (cross (p c) (vders (along c) 2 (p c))))) (vmul (ders (along c) 2 (w c)) (cross (vder (along c) (p c)) (p c))).

(** §5. `‖D1 × D2‖² / w²`: without a zero where the curvature has none. *)
Definition binormal_form_squared (c : curve A) : A :=
  dot (binormal_form c) (binormal_form c).

(** §5. `(D1 × D2) × D1`. *)
Definition D1_x_D2_x_D1 (c : curve A) : list A :=
  cross (D1_x_D2 c) (D1 c).

(** §5. `‖D1 × D2‖²`: without a zero where the curvature has none. *)
Definition D1_x_D2_squared (c : curve A) : A :=
  dot (D1_x_D2 c) (D1_x_D2 c).

(** eq. (15). Squared curvature `‖γ′ × γ″‖² / ‖γ′‖⁶`, naive. *)
Definition space_curvature_squared (c : curve A) : A :=
  binormal_squared c / speed_squared c ^ 3.

(** §5.1, before eq. (16). `κN = (γ′ × γ″) × γ′ / ‖γ′‖⁴`. *)
Definition curvature_vector (c : curve A) : list A :=
  vdiv (normal c) (speed_squared c ^ 2).

(** definition of the curvature. `γ″/‖γ′‖² − γ′ (γ′·γ″)/‖γ′‖⁴`: the derivative of the unit tangent by arc length. *)
Definition curvature_vector_by_definition (c : curve A) : list A :=
  vsub (vdiv (vders (along c) 2 (gamma c)) (speed_squared c)) (vmul (dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)) / speed_squared c ^ 2) (vder (along c) (gamma c))).

(** §5.1. `‖κN‖²`. *)
Definition curvature_vector_squared (c : curve A) : A :=
  dot (curvature_vector c) (curvature_vector c).

(** eq. (16). `κ⁻¹N = (‖γ′‖² / ‖γ′ × γ″‖²) (γ′ × γ″) × γ′`. *)
Definition radius_vector (c : curve A) : list A :=
  vmul (speed_squared c / binormal_squared c) (normal c).

(** eq. (17). Torsion `[γ′ γ″ γ‴] / ‖γ′ × γ″‖²`, naive. *)
Definition torsion (c : curve A) : A :=
  velocity_acceleration_jerk c / binormal_squared c.

(** eq. (18). Torsion `w² [D1 D2 D3] / ‖D1 × D2‖²`, polynomials multiplied before dividing. *)
Definition torsion_reduced (c : curve A) : A :=
  w c ^ 2 * D1_D2_D3 c / D1_x_D2_squared c.

(** §5.3. `γ + ζ γ′`, naive. *)
Definition tangent_developable (c : curve A) : surface A :=
  ruled (gamma c) (vder (along c) (gamma c)).

(** §5.3. `(p + λ D1) / w`. *)
Definition tangent_developable_reduced (c : curve A) : surface A :=
  ruled (vdiv (p c) (w c)) (vdiv (D1 c) (w c)).

(** §5.3. `γ + ζ (γ′ × γ″)`, naive. *)
Definition binormal_scroll (c : curve A) : surface A :=
  ruled (gamma c) (binormal c).

(** §5.3. `(p + λ D1 × D2) / w`. *)
Definition binormal_scroll_reduced (c : curve A) : surface A :=
  ruled (vdiv (p c) (w c)) (vdiv (D1_x_D2 c) (w c)).

(** §5.3. `γ + ζ (γ′ × γ″) × γ′`, naive. *)
Definition normal_scroll (c : curve A) : surface A :=
  ruled (gamma c) (normal c).

(** §5.3. `(p + λ (D1 × D2) × D1) / w`. *)
Definition normal_scroll_reduced (c : curve A) : surface A :=
  ruled (vdiv (p c) (w c)) (vdiv (D1_x_D2_x_D1 c) (w c)).

(** §5.4. `γ + λ (τ γ′ + γ′ × γ″ / ‖γ′‖²)`, naive. *)
Definition rectifying_developable (c : curve A) : surface A :=
  ruled (gamma c) (vadd (vmul (torsion c) (vder (along c) (gamma c))) (vdiv (binormal c) (speed_squared c))).

(** §5.4. `γ + λ ([D1 D2 D3] D1 / ‖D1 × D2‖² + D1 × D2 / ‖D1‖²)`, polynomials multiplied before dividing. *)
Definition rectifying_developable_reduced (c : curve A) : surface A :=
  ruled (gamma c) (vadd (vdiv (vmul (D1_D2_D3 c) (D1 c)) (D1_x_D2_squared c)) (vdiv (D1_x_D2 c) (D1_squared c))).

(** §5.4. `(τ γ′ + γ′ × γ″/‖γ′‖²)·γ′`: ‖γ′‖² τ when λ = ζ/‖γ′‖ (the component of ζ(τT + κB) along T is ζτ). *)
Definition rectifying_along_tangent (c : curve A) : A :=
  dot (generator (rectifying_developable c)) (vder (along c) (gamma c)).

(** §5.4. `(τ γ′ + γ′ × γ″/‖γ′‖²)·(γ′ × γ″)`: ‖γ′‖ κ ‖γ′ × γ″‖ when λ = ζ/‖γ′‖ (the component of ζ(τT + κB) along B is ζκ). *)
Definition rectifying_along_binormal (c : curve A) : A :=
  dot (generator (rectifying_developable c)) (binormal c).

(** §5.4. `(τ γ′ + γ′ × γ″/‖γ′‖²) · N`: zero when the generator lies in the rectifying plane. *)
Definition rectifying_plane (c : curve A) : A :=
  dot (generator (rectifying_developable c)) (normal c).

(** §5.5. `3 (γ′·γ″) ‖γ′×γ″‖² − (γ′×γ″)·(γ′×γ‴) ‖γ′‖²`. *)
Definition psi_numerator (c : curve A) : A :=
  number 3 * dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)) * binormal_squared c - dot (binormal c) (cross (vder (along c) (gamma c)) (vders (along c) 3 (gamma c))) * speed_squared c.

(** §5.5. Ψ, with `(1/κ)′ B = ‖γ′‖ Ψ` for the derivative by the parameter and the unit binormal B. *)
Definition psi (c : curve A) : list A :=
  vmul (psi_numerator c / binormal_squared c ^ 2) (binormal c).

(** §5.5. `‖γ′‖² ‖γ′×γ″‖² (1/κ)′ κ` from `1/κ = ‖γ′‖³ / ‖γ′×γ″‖` by the chain rule. *)
Definition radius_logarithmic_derivative (c : curve A) : A :=
  (number 3 * der (along c) (speed_squared c) * binormal_squared c - speed_squared c * der (along c) (binormal_squared c)) / number 2.

(** §5.5. `γ + κ⁻¹N`: the evolute of a space curve in the sense of §5.5. *)
Definition osculating_circle_centre (c : curve A) : list A :=
  vadd (gamma c) (radius_vector c).

(** definition of the osculating circle. `(E − γ)·γ′`: zero when the centre lies in the normal plane. *)
Definition circle_contact_1 (c : curve A) : A :=
  dot (vsub (osculating_circle_centre c) (gamma c)) (vder (along c) (gamma c)).

(** definition of the osculating circle. `(E − γ)·γ″ − ‖γ′‖²`: zero when the circle touches to second order. *)
Definition circle_contact_2 (c : curve A) : A :=
  dot (vsub (osculating_circle_centre c) (gamma c)) (vders (along c) 2 (gamma c)) - speed_squared c.

(** definition of the osculating circle. `(E − γ)·(γ′ × γ″)`: zero when the centre lies in the osculating plane. *)
Definition circle_contact_3 (c : curve A) : A :=
  dot (vsub (osculating_circle_centre c) (gamma c)) (binormal c).

(** §5.5, by definition. `F − γ`: the solution of the three equations by Cramer's rule. *)
Definition focal_offset (c : curve A) : list A :=
  vdiv (vadd (vmul (speed_squared c) (cross (vders (along c) 3 (gamma c)) (vder (along c) (gamma c)))) (vmul (number 3 * dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))))) (velocity_acceleration_jerk c).

(** §5.5, by definition. The centre of the osculating sphere: the solution of `(F − γ)·γ′ = 0` and its first two derivatives, by Cramer's rule. *)
Definition focal_curve (c : curve A) : list A :=
  vadd (gamma c) (focal_offset c).

(** eq. (19), derivative by arc length. `γ + κ⁻¹N + (1/τ) Ψ`: eq. (19) with `(1/κ)′` taken by arc length. *)
Definition focal_curve_by_arc_length (c : curve A) : list A :=
  vadd (vadd (gamma c) (radius_vector c)) (vdiv (psi c) (torsion c)).

(** §5.5, reduced. The centre of the osculating sphere over D1, D2, D3. *)
Definition focal_curve_reduced (c : curve A) : list A :=
  vdiv (vadd (vmul (w c ^ 2 * D1_D2_D3 c) (p c)) (vadd (vadd (vmul (D1_squared c * w c) (cross (D3 c) (D1 c))) (vmul (D1_squared c * w c) (cross (D21 c) (D1 c)))) (vmul (number 3 * dot (D1 c) (D2 c) * w c - number 2 * der (along c) (w c) * D1_squared c) (D1_x_D2 c)))) (w c ^ 3 * D1_D2_D3 c).

(** definition of the focal curve. `(F − γ)·(γ′ × γ″)`. *)
Definition focal_binormal (c : curve A) : A :=
  dot (focal_offset c) (binormal c).

(** eq. (19), derivative by arc length. `Ψ·(γ′ × γ″)/τ`: the component of (1/τ)(1/κ)′B along γ′ × γ″; ‖γ′ × γ″‖² is in the denominator of Ψ as in that of τ. *)
Definition focal_binormal_by_arc_length (c : curve A) : A :=
  psi_numerator c / velocity_acceleration_jerk c.

(** eq. (19), derivative by arc length. The square of this component. *)
Definition focal_binormal_squared_by_arc_length (c : curve A) : A :=
  focal_binormal_by_arc_length c ^ 2.

(** eq. (19), derivative by the parameter. The same with the derivative by the parameter, `(1/κ)′B = ‖γ′‖ Ψ`; squared, so that it is rational. *)
Definition focal_binormal_squared_by_parameter (c : curve A) : A :=
  speed_squared c * focal_binormal_squared_by_arc_length c.

(** definition of the focal curve. `(F − γ)·γ′`: zero when the sphere around F touches to first order. *)
Definition focal_contact_1 (c : curve A) : A :=
  dot (vsub (focal_curve c) (gamma c)) (vder (along c) (gamma c)).

(** definition of the focal curve. `(F − γ)·γ″ − ‖γ′‖²`: zero when it touches to second order. *)
Definition focal_contact_2 (c : curve A) : A :=
  dot (vsub (focal_curve c) (gamma c)) (vders (along c) 2 (gamma c)) - speed_squared c.

(** definition of the focal curve. `(F − γ)·γ‴ − 3 γ′·γ″`: zero when it touches to third order. *)
Definition focal_contact_3 (c : curve A) : A :=
  dot (vsub (focal_curve c) (gamma c)) (vders (along c) 3 (gamma c)) - number 3 * dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)).

(** eqs. (20), (21). `γ + κ⁻¹N + μ γ′ × γ″`, naive. *)
Definition focal_surface (c : curve A) : surface A :=
  ruled (osculating_circle_centre c) (binormal c).

(** §5.6. `p/w + ‖D1‖² (D1 × D2) × D1 / (w² ‖D1 × D2‖²) + (μ/w⁴) D1 × D2`. *)
Definition focal_surface_reduced (c : curve A) : surface A :=
  ruled (vadd (vdiv (p c) (w c)) (vdiv (vmul (D1_squared c) (D1_x_D2_x_D1 c)) (w c ^ 2 * D1_x_D2_squared c))) (vdiv (D1_x_D2 c) (w c ^ 4)).

(** §5.2, squaring. Derivative of the squared curvature by the quotient rule. *)
Definition space_curvature_squared_derivative (c : curve A) : A :=
  der (along c) (space_curvature_squared c).

(** analogue of eq. (10). `(γ′×γ″)·(γ′×γ‴) ‖γ′‖² − 3 ‖γ′×γ″‖² (γ′·γ″)`: half of `(κ²)′ ‖γ′‖⁸`, the direct approach in space. *)
Definition space_critical_curvature (c : curve A) : A :=
  dot (binormal c) (cross (vder (along c) (gamma c)) (vders (along c) 3 (gamma c))) * speed_squared c - number 3 * binormal_squared c * dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)).

(** analogue of eq. (11). The direct approach in space over D1, D2, D3. *)
Definition space_critical_curvature_reduced (c : curve A) : A :=
  (dot (D1_x_D2 c) (cross (D1 c) (D3 c)) + dot (D1_x_D2 c) (cross (D1 c) (D21 c))) * D1_squared c * w c + number 2 * der (along c) (w c) * D1_x_D2_squared c * D1_squared c - number 3 * D1_x_D2_squared c * dot (D1 c) (D2 c) * w c.

(** Frenet equations. `−B′·N / ‖γ′‖` for the unit vectors B and N, written with `γ′ × γ″` and `(γ′ × γ″) × γ′`. *)
Definition torsion_by_frenet (c : curve A) : A :=
  - dot (vder (along c) (binormal c)) (normal c) / (binormal_squared c * speed_squared c).

(** definition of a geodesic. `[γ′ γ″ γ′ × G]`: zero when γ is a geodesic of the rectifying developable with generator G. *)
Definition rectifying_geodesic (c : curve A) : A :=
  det [vder (along c) (gamma c); vders (along c) 2 (gamma c); cross (vder (along c) (gamma c)) (generator (rectifying_developable c))].

(** definition of a developable. `[δ′ B B′]`: zero when the focal surface is developable. *)
Definition focal_development (c : curve A) : A :=
  det [vder (along c) (directrix (focal_surface_reduced c)); generator (focal_surface_reduced c); vder (along c) (generator (focal_surface_reduced c))].

(** eq. (7). `‖γ′‖`. *)
Definition speed (c : framed A) : A :=
  sigma c.

(** eq. (13). `‖γ′ × γ″‖`. *)
Definition binormal_length (c : framed A) : A :=
  rho c.

(** eq. (13). `γ′ / ‖γ′‖`. *)
Definition unit_tangent (c : framed A) : list A :=
  vdiv (vder (along c) (gamma c)) (sigma c).

(** eq. (13). `γ′ × γ″ / ‖γ′ × γ″‖`. *)
Definition unit_binormal (c : framed A) : list A :=
  vdiv (binormal c) (rho c).

(** eq. (13). `(γ′ × γ″) × γ′ / (‖γ′ × γ″‖ ‖γ′‖)`. *)
Definition unit_normal (c : framed A) : list A :=
  vdiv (normal c) (rho c * sigma c).

(** eq. (13). `B × T`. *)
Definition unit_normal_by_product (c : framed A) : list A :=
  cross (unit_binormal c) (unit_tangent c).

(** eq. (13). The scalar products and the determinant of T, N, B without those of an orthonormal, right-handed basis. *)
Definition frame_products (c : framed A) : list A :=
  ([dot (unit_tangent c) (unit_tangent c) - number 1] ++ [dot (unit_normal c) (unit_normal c) - number 1] ++ [dot (unit_binormal c) (unit_binormal c) - number 1] ++ [dot (unit_tangent c) (unit_normal c)] ++ [dot (unit_normal c) (unit_binormal c)] ++ [dot (unit_binormal c) (unit_tangent c)] ++ [det [unit_tangent c; unit_normal c; unit_binormal c] - number 1]).

(** eq. (15). `‖γ′ × γ″‖ / ‖γ′‖³`. *)
Definition curvature_in_space (c : framed A) : A :=
  rho c / sigma c ^ 3.

(** eq. (16). `N / κ`. *)
Definition normal_by_curvature (c : framed A) : list A :=
  vdiv (unit_normal c) (curvature_in_space c).

(** Frenet equations. `T′`. *)
Definition unit_tangent_derivative (c : framed A) : list A :=
  vder (along c) (unit_tangent c).

(** Frenet equations. `N′`. *)
Definition unit_normal_derivative (c : framed A) : list A :=
  vder (along c) (unit_normal c).

(** Frenet equations. `B′`. *)
Definition unit_binormal_derivative (c : framed A) : list A :=
  vder (along c) (unit_binormal c).

(** Frenet equations. `τ B − κ T`: the derivative of N by arc length. *)
Definition turn_of_normal (c : framed A) : list A :=
  vsub (vmul (torsion c) (unit_binormal c)) (vmul (curvature_in_space c) (unit_tangent c)).

(** §5.4. `τ T + κ B`. *)
Definition rectifying_direction (c : framed A) : list A :=
  vadd (vmul (torsion c) (unit_tangent c)) (vmul (curvature_in_space c) (unit_binormal c)).

(** §5.4. The generator of the rectifying developable. *)
Definition rectifying_generator (c : framed A) : list A :=
  generator (rectifying_developable c).

(** §5.5. `(1/κ)′ B`. *)
Definition radius_derivative_along_binormal (c : framed A) : list A :=
  vmul (der (along c) (number 1 / curvature_in_space c)) (unit_binormal c).

(** §4.3. `γ′⊥ / ‖γ′⊥‖`. *)
Definition unit_normal_in_plane (c : framed A) : list A :=
  vdiv (perp (vder (along c) (gamma c))) (sigma c).

(** §4.1. `[γ′ γ″] / ‖γ′‖³`. *)
Definition signed_curvature (c : framed A) : A :=
  f0 c / sigma c ^ 3.

(** §4.2. `κ′`. *)
Definition signed_curvature_derivative (c : framed A) : A :=
  der (along c) (signed_curvature c).

(** eq. (12). `γ + N/κ`. *)
Definition evolute_by_unit_normal (c : framed A) : list A :=
  vadd (gamma c) (vdiv (unit_normal_in_plane c) (signed_curvature c)).

(** eq. (22). `γ·γ′`: the height of the normal plane, naive. *)
Definition normal_height (c : curve A) : A :=
  dot (gamma c) (vder (along c) (gamma c)).

(** eq. (26). `γ′`, brought to one denominator with `γ·γ′`. *)
Definition normal_levelled (c : curve A) : list A :=
  vder (along c) (gamma c).

(** eq. (26). `γ·γ′`, brought to one denominator with `γ′`. *)
Definition normal_height_levelled (c : curve A) : A :=
  normal_height c.

(** eq. (27). `p·D1`: the height of the normal plane in the unknown wB. *)
Definition normal_height_polynomial (c : curve A) : A :=
  dot (p c) (D1 c).

(** eq. (22). `γ̄′`: the normal of the second plane. *)
Definition second_normal (c : pair A) : list A :=
  vder (along (second c)) (gamma (second c)).

(** eq. (22). `γ̄·γ̄′`: the height of the second plane. *)
Definition second_height (c : pair A) : A :=
  normal_height (second c).

(** eq. (27). `w γ̄·γ̄′`: the height of the second plane in the unknown wB. *)
Definition second_height_polynomial (c : pair A) : A :=
  normal_height (second c) * w (first c).

(** eq. (22). `γ − γ̄`: the normal of the middle plane. *)
Definition middle_normal (c : pair A) : list A :=
  vsub (gamma (first c)) (gamma (second c)).

(** eq. (22). `½(‖γ‖² − ‖γ̄‖²)`: the height of the middle plane. *)
Definition middle_height (c : pair A) : A :=
  (dot (gamma (first c)) (gamma (first c)) - dot (gamma (second c)) (gamma (second c))) / number 2.

(** eq. (26). `γ − γ̄`, brought to one denominator with the height. *)
Definition middle_normal_levelled (c : pair A) : list A :=
  vsub (gamma (first c)) (gamma (second c)).

(** eq. (26). `½(‖γ‖² − ‖γ̄‖²)`, brought to one denominator with the normal. *)
Definition middle_height_levelled (c : pair A) : A :=
  (dot (gamma (first c)) (gamma (first c)) - dot (gamma (second c)) (gamma (second c))) / number 2.

(** eq. (27). `p − wγ̄`: the normal of the middle plane in the unknown wB. *)
Definition middle_normal_polynomial (c : pair A) : list A :=
  vsub (p (first c)) (vmul (w (first c)) (gamma (second c))).

(** eq. (27). `½(‖p‖² − ‖γ̄‖²w²)`: the height of the middle plane in the unknown wB. *)
Definition middle_height_polynomial (c : pair A) : A :=
  (dot (p (first c)) (p (first c)) - dot (gamma (second c)) (gamma (second c)) * w (first c) ^ 2) / number 2.

(** eqs. (22), (23). `[γ′ γ̄′ γ − γ̄]`: the determinant of the system (22), naive. *)
Definition bisector_determinant (c : pair A) : A :=
  det [vder (along (first c)) (gamma (first c)); vder (along (second c)) (gamma (second c)); vsub (gamma (first c)) (gamma (second c))].

(** eqs. (22), (23). The numerators of Cramer's rule for (22), added as Table 1 adds. *)
Definition bisector_numerators (c : pair A) : list A :=
  vadd (vadd (vmul (normal_height (first c)) (cross (vder (along (second c)) (gamma (second c))) (vsub (gamma (first c)) (gamma (second c))))) (vmul (normal_height (second c)) (cross (vsub (gamma (first c)) (gamma (second c))) (vder (along (first c)) (gamma (first c)))))) (vmul ((dot (gamma (first c)) (gamma (first c)) - dot (gamma (second c)) (gamma (second c))) / number 2) (cross (vder (along (first c)) (gamma (first c))) (vder (along (second c)) (gamma (second c))))).

(** eqs. (22), (23), (26). The numerators of Cramer's rule for (22), each row first brought to one denominator. *)
Definition bisector_numerators_levelled (c : pair A) : list A :=
  vadd (vadd (vmul (normal_height (first c)) (cross (vder (along (second c)) (gamma (second c))) (vsub (gamma (first c)) (gamma (second c))))) (vmul (normal_height (second c)) (cross (vsub (gamma (first c)) (gamma (second c))) (vder (along (first c)) (gamma (first c)))))) (vmul ((dot (gamma (first c)) (gamma (first c)) - dot (gamma (second c)) (gamma (second c))) / number 2) (cross (vder (along (first c)) (gamma (first c))) (vder (along (second c)) (gamma (second c))))).

(** eqs. (22), (23). Bisector of two space curves, naive: (22) by Cramer's rule. *)
Definition bisector (c : pair A) : list A :=
  vdiv (bisector_numerators c) (bisector_determinant c).

(** eqs. (22), (23), (26). Bisector of two space curves: (22) by Cramer's rule, each row first brought to one denominator. *)
Definition bisector_levelled (c : pair A) : list A :=
  vdiv (bisector_numerators_levelled c) (bisector_determinant c).

(** eq. (27). `[D1 γ̄′ p − wγ̄]`: the determinant of the system (27). *)
Definition bisector_determinant_polynomial (c : pair A) : A :=
  det [D1 (first c); vder (along (second c)) (gamma (second c)); middle_normal_polynomial c].

(** eq. (27). The numerators of Cramer's rule for (27), in the unknown wB. *)
Definition bisector_numerators_polynomial (c : pair A) : list A :=
  vadd (vadd (vmul (dot (p (first c)) (D1 (first c))) (cross (second_normal c) (middle_normal_polynomial c))) (vmul (second_height_polynomial c) (cross (middle_normal_polynomial c) (D1 (first c))))) (vmul (middle_height_polynomial c) (cross (D1 (first c)) (second_normal c))).

(** eqs. (27), (28). Bisector of two space curves by the system (27), polynomial in the first curve. *)
Definition bisector_polynomial (c : pair A) : list A :=
  vdiv (bisector_numerators_polynomial c) (bisector_determinant_polynomial c * w (first c)).

(** eq. (27), for both curves. `w̄p − wp̄`: the direction from one foot to the other. *)
Definition chord (c : pair A) : list A :=
  vsub (vmul (w (second c)) (p (first c))) (vmul (w (first c)) (p (second c))).

(** eq. (27), for both curves. `[D1 D̄1 w̄p − wp̄]`. *)
Definition bisector_determinant_symmetric (c : pair A) : A :=
  det [D1 (first c); D1 (second c); chord c].

(** eq. (27), for both curves. The numerators of Cramer's rule for (27) polynomial in both curves, in the unknown ww̄B. *)
Definition bisector_numerators_symmetric (c : pair A) : list A :=
  vadd (vadd (vmul (dot (p (first c)) (D1 (first c)) * w (second c)) (cross (D1 (second c)) (chord c))) (vmul (dot (p (second c)) (D1 (second c)) * w (first c)) (cross (chord c) (D1 (first c))))) (vmul ((dot (p (first c)) (p (first c)) * w (second c) ^ 2 - dot (p (second c)) (p (second c)) * w (first c) ^ 2) / number 2) (cross (D1 (first c)) (D1 (second c)))).

(** eqs. (27), (28), for both curves. Bisector of two space curves, polynomial in both. *)
Definition bisector_symmetric (c : pair A) : list A :=
  vdiv (bisector_numerators_symmetric c) (bisector_determinant_symmetric c * (w (first c) * w (second c))).

(** definition of the bisector. `(B − γ)·γ′`: zero when γ(s) is a critical point of the distance from B. *)
Definition bisector_in_first_normal_plane (c : pair A) : A :=
  dot (vsub (bisector_symmetric c) (gamma (first c))) (vder (along (first c)) (gamma (first c))).

(** definition of the bisector. `(B − γ̄)·γ̄′`: zero when γ̄(s̄) is a critical point of the distance from B. *)
Definition bisector_in_second_normal_plane (c : pair A) : A :=
  dot (vsub (bisector_symmetric c) (gamma (second c))) (vder (along (second c)) (gamma (second c))).

(** definition of the bisector. `‖B − γ‖² − ‖B − γ̄‖²`: zero when B is as far from one foot as from the other. *)
Definition bisector_equidistance (c : pair A) : A :=
  dot (vsub (bisector_symmetric c) (gamma (first c))) (vsub (bisector_symmetric c) (gamma (first c))) - dot (vsub (bisector_symmetric c) (gamma (second c))) (vsub (bisector_symmetric c) (gamma (second c))).

(** eq. (31). `γ′ × (γ − Q)`: the direction of the generators, naive. *)
Definition point_bisector_generator (c : curve A) : list A :=
  cross (vder (along c) (gamma c)) (vsub (gamma c) (point c)).

(** eq. (31). `Q·(γ′ × (γ − Q))`: the height of the third plane of (31). *)
Definition through_point_height (c : curve A) : A :=
  dot (point c) (point_bisector_generator c).

(** eq. (30). `γ − Q`: the normal of the middle plane. *)
Definition point_middle_normal (c : curve A) : list A :=
  vsub (gamma c) (point c).

(** eq. (30). `½(‖γ‖² − ‖Q‖²)`: the height of the middle plane. *)
Definition point_middle_height (c : curve A) : A :=
  (dot (gamma c) (gamma c) - dot (point c) (point c)) / number 2.

(** eq. (31). `[γ′ γ′×(γ − Q) γ − Q]`: the determinant of the system (31), naive. *)
Definition point_bisector_determinant (c : curve A) : A :=
  det [vder (along c) (gamma c); point_bisector_generator c; vsub (gamma c) (point c)].

(** eq. (31). Directrix of the point/curve bisector by (31), added as Table 1 adds. *)
Definition point_bisector_directrix (c : curve A) : list A :=
  vdiv (vadd (vadd (vmul (normal_height c) (cross (point_bisector_generator c) (vsub (gamma c) (point c)))) (vmul (dot (point c) (point_bisector_generator c)) (cross (vsub (gamma c) (point c)) (vder (along c) (gamma c))))) (vmul ((dot (gamma c) (gamma c) - dot (point c) (point c)) / number 2) (cross (vder (along c) (gamma c)) (point_bisector_generator c)))) (point_bisector_determinant c).

(** eqs. (31), (32). Directrix of the point/curve bisector by (31), each row first brought to one denominator. *)
Definition point_bisector_directrix_levelled (c : curve A) : list A :=
  vdiv (vadd (vadd (vmul (normal_height c) (cross (point_bisector_generator c) (vsub (gamma c) (point c)))) (vmul (dot (point c) (point_bisector_generator c)) (cross (vsub (gamma c) (point c)) (vder (along c) (gamma c))))) (vmul ((dot (gamma c) (gamma c) - dot (point c) (point c)) / number 2) (cross (vder (along c) (gamma c)) (point_bisector_generator c)))) (point_bisector_determinant c).

(** eq. (31). Point/curve bisector with the explicit directrix, added as Table 1 adds. *)
Definition point_bisector_naive (c : curve A) : surface A :=
  ruled (point_bisector_directrix c) (point_bisector_generator c).

(** eqs. (31), (32). Point/curve bisector with the explicit directrix, each row first brought to one denominator. *)
Definition point_bisector (c : curve A) : surface A :=
  ruled (point_bisector_directrix_levelled c) (point_bisector_generator c).

(** eq. (34). `D1 × (p − wQ)`: the direction of the generators, polynomial. *)
Definition point_bisector_generator_polynomial (c : curve A) : list A :=
  cross (D1 c) (vsub (p c) (vmul (w c) (point c))).

(** eq. (34). The determinant of the system (34). *)
Definition point_bisector_determinant_polynomial (c : curve A) : A :=
  det [D1 c; point_bisector_generator_polynomial c; vsub (p c) (vmul (w c) (point c))].

(** eq. (34), as printed. Directrix by (34) with the last height as it is printed, `½(p² − wQ²)`. *)
Definition point_bisector_directrix_printed (c : curve A) : list A :=
  vdiv (vadd (vadd (vmul (dot (p c) (D1 c)) (cross (point_bisector_generator_polynomial c) (vsub (p c) (vmul (w c) (point c))))) (vmul (dot (vmul (w c) (point c)) (point_bisector_generator_polynomial c)) (cross (vsub (p c) (vmul (w c) (point c))) (D1 c)))) (vmul ((dot (p c) (p c) - w c * dot (point c) (point c)) / number 2) (cross (D1 c) (point_bisector_generator_polynomial c)))) (point_bisector_determinant_polynomial c * w c).

(** eq. (34). Directrix by (34) with the last height as it must be, `½(‖p‖² − w²‖Q‖²)`. *)
Definition point_bisector_directrix_polynomial (c : curve A) : list A :=
  vdiv (vadd (vadd (vmul (dot (p c) (D1 c)) (cross (point_bisector_generator_polynomial c) (vsub (p c) (vmul (w c) (point c))))) (vmul (dot (vmul (w c) (point c)) (point_bisector_generator_polynomial c)) (cross (vsub (p c) (vmul (w c) (point c))) (D1 c)))) (vmul ((dot (p c) (p c) - w c ^ 2 * dot (point c) (point c)) / number 2) (cross (D1 c) (point_bisector_generator_polynomial c)))) (point_bisector_determinant_polynomial c * w c).

(** eq. (34). Point/curve bisector with the explicit directrix, polynomial; the generator is `D1 × (γ − Q)`. *)
Definition point_bisector_polynomial (c : curve A) : surface A :=
  ruled (point_bisector_directrix_polynomial c) (cross (D1 c) (vsub (gamma c) (point c))).

(** §6.2, direct approach. Point/curve bisector by the 2×2 system with the first component moved: it is the ruling parameter. *)
Definition point_bisector_direct_x (c : curve A) : surface A :=
  ruled (vdiv (vadd (vadd (vmul (dot (p c) (D1 c)) (cross (vsub (p c) (vmul (w c) (point c))) (axis 0 (length (p c))))) (vmul ((dot (p c) (p c) - w c ^ 2 * dot (point c) (point c)) / number 2) (cross (axis 0 (length (p c))) (D1 c)))) (vmul (number 0) (cross (D1 c) (vsub (p c) (vmul (w c) (point c)))))) (det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 0 (length (p c))] * w c)) (vdiv (vmul (w c) (cross (D1 c) (vsub (p c) (vmul (w c) (point c))))) (det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 0 (length (p c))] * w c)).

(** §6.2, direct approach. Point/curve bisector by the 2×2 system with the second component moved: it is the ruling parameter. *)
Definition point_bisector_direct_y (c : curve A) : surface A :=
  ruled (vdiv (vadd (vadd (vmul (dot (p c) (D1 c)) (cross (vsub (p c) (vmul (w c) (point c))) (axis 1 (length (p c))))) (vmul ((dot (p c) (p c) - w c ^ 2 * dot (point c) (point c)) / number 2) (cross (axis 1 (length (p c))) (D1 c)))) (vmul (number 0) (cross (D1 c) (vsub (p c) (vmul (w c) (point c)))))) (det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 1 (length (p c))] * w c)) (vdiv (vmul (w c) (cross (D1 c) (vsub (p c) (vmul (w c) (point c))))) (det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 1 (length (p c))] * w c)).

(** §6.2, direct approach. Point/curve bisector by the 2×2 system with the third component moved: it is the ruling parameter. *)
Definition point_bisector_direct_z (c : curve A) : surface A :=
  ruled (vdiv (vadd (vadd (vmul (dot (p c) (D1 c)) (cross (vsub (p c) (vmul (w c) (point c))) (axis 2 (length (p c))))) (vmul ((dot (p c) (p c) - w c ^ 2 * dot (point c) (point c)) / number 2) (cross (axis 2 (length (p c))) (D1 c)))) (vmul (number 0) (cross (D1 c) (vsub (p c) (vmul (w c) (point c)))))) (det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 2 (length (p c))] * w c)) (vdiv (vmul (w c) (cross (D1 c) (vsub (p c) (vmul (w c) (point c))))) (det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 2 (length (p c))] * w c)).

(** eq. (35). Point/curve bisector by the naive 2×2 system, each row brought to one denominator, with the third component moved. *)
Definition point_bisector_direct_naive (c : curve A) : surface A :=
  ruled (vdiv (vadd (vadd (vmul (normal_height c) (cross (vsub (gamma c) (point c)) (axis 2 (length (p c))))) (vmul ((dot (gamma c) (gamma c) - dot (point c) (point c)) / number 2) (cross (axis 2 (length (p c))) (vder (along c) (gamma c))))) (vmul (number 0) (cross (vder (along c) (gamma c)) (vsub (gamma c) (point c))))) (det [vder (along c) (gamma c); vsub (gamma c) (point c); axis 2 (length (p c))])) (vdiv (cross (vder (along c) (gamma c)) (vsub (gamma c) (point c))) (det [vder (along c) (gamma c); vsub (gamma c) (point c); axis 2 (length (p c))])).

(** §6.2, direct approach. The directrix of the direct form: the bisector in the plane of height 0. *)
Definition direct_directrix (c : curve A) : list A :=
  directrix (point_bisector_direct_z c).

(** §6.2, direct approach. The third component of the directrix of the direct form. *)
Definition direct_height_of_directrix (c : curve A) : A :=
  dot (axis 2 (length (p c))) (directrix (point_bisector_direct_z c)).

(** §6.2, direct approach. The third component of the generator of the direct form, less 1. *)
Definition direct_height_of_generator (c : curve A) : A :=
  dot (axis 2 (length (p c))) (generator (point_bisector_direct_z c)) - number 1.

(** §6.2, direct approach. The determinant of the 2×2 system with the first component moved. *)
Definition direct_determinant_x (c : curve A) : A :=
  det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 0 (length (p c))].

(** §6.2, direct approach. The determinant of the 2×2 system with the second component moved. *)
Definition direct_determinant_y (c : curve A) : A :=
  det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 1 (length (p c))].

(** §6.2, direct approach. The determinant of the 2×2 system with the third component moved. *)
Definition direct_determinant_z (c : curve A) : A :=
  det [D1 c; vsub (p c) (vmul (w c) (point c)); axis 2 (length (p c))].

(** §6.2, direct approach. The third component of `D1 × (p − wQ)`. *)
Definition generator_z (c : curve A) : A :=
  component 2 (point_bisector_generator_polynomial c).

(** definition of the bisector. `(δ − γ)·γ′`: zero when γ(s) is a critical point of the distance from δ. *)
Definition point_bisector_in_normal_plane (c : curve A) : A :=
  dot (vsub (point_bisector_directrix_polynomial c) (gamma c)) (vder (along c) (gamma c)).

(** definition of the bisector. `‖δ − γ‖² − ‖δ − Q‖²`: zero when δ is as far from its foot as from Q. *)
Definition point_bisector_equidistance (c : curve A) : A :=
  dot (vsub (point_bisector_directrix_polynomial c) (gamma c)) (vsub (point_bisector_directrix_polynomial c) (gamma c)) - dot (vsub (point_bisector_directrix_polynomial c) (point c)) (vsub (point_bisector_directrix_polynomial c) (point c)).

(** eq. (30) in the plane. The numerators of the planar point/curve bisector, polynomial, in the unknown wB. *)
Definition plane_bisector_numerators (c : curve A) : list A :=
  vsub (vmul ((dot (p c) (p c) - w c ^ 2 * dot (point c) (point c)) / number 2) (perp (D1 c))) (vmul (dot (p c) (D1 c)) (perp (vsub (p c) (vmul (w c) (point c))))).

(** eq. (30) in the plane. `[D1 p − wQ]`. *)
Definition plane_bisector_determinant (c : curve A) : A :=
  det [D1 c; vsub (p c) (vmul (w c) (point c))].

(** eq. (30) in the plane. Bisector of a plane curve and a point, naive, each row brought to one denominator. *)
Definition plane_bisector (c : curve A) : list A :=
  vdiv (vsub (vmul ((dot (gamma c) (gamma c) - dot (point c) (point c)) / number 2) (perp (vder (along c) (gamma c)))) (vmul (normal_height c) (perp (vsub (gamma c) (point c))))) (det [vder (along c) (gamma c); vsub (gamma c) (point c)]).

(** eq. (30) in the plane. Bisector of a plane curve and a point, polynomial. *)
Definition plane_bisector_polynomial (c : curve A) : list A :=
  vdiv (plane_bisector_numerators c) (plane_bisector_determinant c * w c).

(** definition of the bisector. `(B − γ)·γ′`: zero when B lies on the normal at its foot. *)
Definition plane_bisector_in_normal (c : curve A) : A :=
  dot (vsub (plane_bisector_polynomial c) (gamma c)) (vder (along c) (gamma c)).

(** definition of the bisector. `‖B − γ‖² − ‖B − Q‖²`: zero when B is as far from its foot as from Q. *)
Definition plane_bisector_equidistance (c : curve A) : A :=
  dot (vsub (plane_bisector_polynomial c) (gamma c)) (vsub (plane_bisector_polynomial c) (gamma c)) - dot (vsub (plane_bisector_polynomial c) (point c)) (vsub (plane_bisector_polynomial c) (point c)).

(** Remark 3.2, last display. `(w′/w³) D2 − (w″/w³) D1`: D21/w² by its parts along D2 and D1. *)
Definition jerk_term_21_parts (c : curve A) : list A :=
  vsub (jerk_term_21_2 c) (jerk_term_21_1 c).

(** eq. (5). `[γ′ γ‴]` with γ‴ by eq. (5): what is left beside [D1 D3]. *)
Definition velocity_jerk_by_terms (c : curve A) : A :=
  (D1_D3 c + det [D1 c; D21 c]) / w c ^ 4 - number 4 * der (along c) (w c) / w c ^ 5 * det [D1 c; D2 c].

(** §5.5. `Ψ·(γ′ × γ″)`. *)
Definition psi_along_binormal (c : curve A) : A :=
  dot (psi c) (binormal c).

(** definition of a geodesic. `γ′ × G`: the normal of the rectifying developable with generator G, along γ. *)
Definition rectifying_surface_normal (c : curve A) : list A :=
  cross (vder (along c) (gamma c)) (generator (rectifying_developable c)).

(** eq. (34), as printed. What the directrix with the height as it is printed is off by. *)
Definition point_bisector_misprint (c : curve A) : list A :=
  vsub (point_bisector_directrix_printed c) (point_bisector_directrix_polynomial c).

(** eq. (34), as printed. The same from the difference `½(w² − w)‖Q‖²` of the heights. *)
Definition point_bisector_misprint_by_height (c : curve A) : list A :=
  vdiv (vmul ((w c - number 1) * dot (point c) (point c)) (cross (D1 c) (point_bisector_generator_polynomial c))) (number 2 * point_bisector_determinant_polynomial c).

(** eq. (34). The generator of the polynomial form. *)
Definition generator_of_34 (c : curve A) : list A :=
  generator (point_bisector_polynomial c).

(** §6.2, direct approach. The first component of the directrix of the direct form that moves it. *)
Definition direct_x_of_directrix (c : curve A) : A :=
  dot (axis 0 (length (p c))) (directrix (point_bisector_direct_x c)).

(** §6.2, direct approach. The second component of the directrix of the direct form that moves it. *)
Definition direct_y_of_directrix (c : curve A) : A :=
  dot (axis 1 (length (p c))) (directrix (point_bisector_direct_y c)).

(** §6.2, direct approach. The first component of `D1 × (p − wQ)`. *)
Definition generator_x (c : curve A) : A :=
  component 0 (point_bisector_generator_polynomial c).

(** §6.2, direct approach. The second component of `D1 × (p − wQ)`. *)
Definition generator_y (c : curve A) : A :=
  component 1 (point_bisector_generator_polynomial c).

(** eq. (31). `[Q γ′ γ]`: what `Q·(γ′ × (γ − Q))` comes to. *)
Definition through_point_height_by_determinant (c : curve A) : A :=
  det [point c; vder (along c) (gamma c); gamma c].

End Formulas.
