(** Pythagorean-hodograph curves: the hodograph lies on the light cone: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require lifted.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** The constant a. *)
Definition a_of (c : accompanied A) : A := component 0 (beside c).

(** The constant b. *)
Definition b_of (c : accompanied A) : A := component 1 (beside c).

(** The constant delta. *)
Definition delta_of (c : accompanied A) : A := component 0 (beside c).

(** The constant m. *)
Definition m_of (c : accompanied A) : A := component 2 (beside c).

(** The constant n. *)
Definition n_of (c : accompanied A) : A := component 3 (beside c).

(** phCurve, computePHCurveFromUV. The curve: the integral of its hodograph. *)
Definition ph_curve (c : accompanied A) : list A :=
  p c.

(** phCurve. `w = u + iv`. *)
Definition spinor (c : accompanied A) : list A :=
  ([u_of c] ++ [v_of c]).

(** The plane: square the radius, double the angle. `w²`, in complex notation. *)
Definition spinor_squared (c : accompanied A) : list A :=
  ([component 0 (spinor c) * component 0 (spinor c) - component 1 (spinor c) * component 1 (spinor c)] ++ [component 0 (spinor c) * component 1 (spinor c) + component 1 (spinor c) * component 0 (spinor c)]).

(** phCurve. `σ = (u² + v²) h`. *)
Definition ph_speed (c : accompanied A) : A :=
  (u_of c * u_of c + v_of c * v_of c) * h_of c.

(** phCurve. `σ²`. *)
Definition ph_speed_squared (c : accompanied A) : A :=
  ph_speed c ^ 2.

(** phCurve, evaluatePHNormal. `(−2uv/(u² + v²), (u² − v²)/(u² + v²))`. *)
Definition ph_normal (c : accompanied A) : list A :=
  vdiv (([number (-2) * u_of c * v_of c] ++ [u_of c * u_of c - v_of c * v_of c])) (u_of c * u_of c + v_of c * v_of c).

(** phCurve, evaluatePHNormal. `c′/σ`, turned left. *)
Definition turned_unit_tangent (c : accompanied A) : list A :=
  vdiv (perp (vder (along c) (gamma c))) (ph_speed c).

(** phCurve, computePHOffset. `(x σ − d y′, y σ + d x′)` at the distance d = 1. *)
Definition ph_offset_numerator (c : accompanied A) : list A :=
  ([component 0 (p c) * ph_speed c - component 1 (vder (along c) (gamma c))] ++ [component 1 (p c) * ph_speed c + component 0 (vder (along c) (gamma c))]).

(** phCurve, computePHOffset. The offset at the distance 1, over the weight σ. *)
Definition ph_offset (c : accompanied A) : list A :=
  vdiv (ph_offset_numerator c) (ph_speed c).

(** phCurve, computePHOffset. Its squared distance from the curve, less 1. *)
Definition ph_offset_distance (c : accompanied A) : A :=
  dot (vsub (ph_offset c) (p c)) (vsub (ph_offset c) (p c)) - number 1.

(** Parametrize by the normal. What the support function `c·n` gains by the offset, less 1. *)
Definition support_gained (c : accompanied A) : A :=
  dot (ph_offset c) (ph_normal c) - dot (p c) (ph_normal c) - number 1.

(** phCurve, computePHOffset. The derivative of the offset. *)
Definition ph_offset_velocity (c : accompanied A) : list A :=
  vder (along c) (ph_offset c).

(** Divide out the scale. `[c′ c″]/σ³`. *)
Definition ph_curvature (c : accompanied A) : A :=
  det [vder (along c) (gamma c); vders (along c) 2 (gamma c)] / ph_speed c ^ 3.

(** Divide out the scale. `(1 − κ) c′`: the velocity of the offset, of the signed speed `σ(1 − εκ)` for ε = 1. *)
Definition signed_offset_speed (c : accompanied A) : list A :=
  vmul (number 1 - ph_curvature c) (vder (along c) (gamma c)).

(** phCurve. `c′ = w² h`, for u and v the numerators of a plane curve and h its denominator. *)
Definition hodograph_of_three (c : accompanied A) : list A :=
  vmul (w c) (([component 0 (p c) * component 0 (p c) - component 1 (p c) * component 1 (p c)] ++ [component 0 (p c) * component 1 (p c) + component 1 (p c) * component 0 (p c)])).

(** phCurve, computePHOffset. The derivative of the offset `c + δ n`. *)
Definition offset_velocity_at_any_distance (c : accompanied A) : list A :=
  vadd (hodograph_of_three c) (vder (along c) (vmul (delta_of c) (vdiv (perp (([component 0 (p c) * component 0 (p c) - component 1 (p c) * component 1 (p c)] ++ [component 0 (p c) * component 1 (p c) + component 1 (p c) * component 0 (p c)]))) (dot (p c) (p c))))).

(** Divide out the scale. `(1 − δκ) c′` with `κ = [c′ c″]/σ³`. *)
Definition velocity_times_offset_factor (c : accompanied A) : list A :=
  vmul (number 1 - det [hodograph_of_three c; vder (along c) (hodograph_of_three c)] * delta_of c / (dot (p c) (p c) * w c) ^ 3) (hodograph_of_three c).

(** curvature in complex notation. `2 (u v′ − v u′) h`. *)
Definition spinor_wronskian (c : accompanied A) : A :=
  number 2 * det [spinor c; vder (along c) (spinor c)] * h_of c.

(** Position is null. The tangent is not.. `‖c″‖² − σ′²`: the Minkowski square of the derivative of `(c′, σ)`. *)
Definition cone_tangent (c : accompanied A) : A :=
  dot (vders (along c) 2 (gamma c)) (vders (along c) 2 (gamma c)) - der (along c) (ph_speed c) ^ 2.

(** Position is null. The tangent is not.. `‖c′ × c″‖²/‖c′‖²`. *)
Definition cone_tangent_by_product (c : accompanied A) : A :=
  det [vder (along c) (gamma c); vders (along c) 2 (gamma c)] ^ 2 / dot (vder (along c) (gamma c)) (vder (along c) (gamma c)).

(** Position is null. The tangent is not.. `κ²σ⁴`. *)
Definition cone_tangent_by_curvature (c : accompanied A) : A :=
  ph_curvature c ^ 2 * ph_speed c ^ 4.

(** Position is null. The tangent is not.. `σ σ′ − c′·c″`. *)
Definition speed_change (c : accompanied A) : A :=
  ph_speed c * der (along c) (ph_speed c) - dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)).

(** What γ looks like, notes. `σ − x′`. *)
Definition speed_less_first (c : accompanied A) : A :=
  ph_speed c - component 0 (vder (along c) (gamma c)).

(** What γ looks like, notes. `2 (Im w)²`. *)
Definition twice_second_squared (c : accompanied A) : A :=
  number 2 * component 1 (spinor c) ^ 2.

(** phCurve, createDefaultSpiral. The second control point of a quadratic w. *)
Definition spinor_1 (c : accompanied A) : list A :=
  vadd (spinor c) (vdiv (vder (along c) (spinor c)) (number 2)).

(** phCurve, createDefaultSpiral. Its third control point. *)
Definition spinor_2 (c : accompanied A) : list A :=
  vadd (vadd (spinor c) (vder (along c) (spinor c))) (vdiv (vders (along c) 2 (spinor c)) (number 2)).

(** phCurve, createDefaultSpiral. `w₀·w₁`. *)
Definition hodograph_1 (c : accompanied A) : list A :=
  ([component 0 (spinor c) * component 0 (spinor_1 c) - component 1 (spinor c) * component 1 (spinor_1 c)] ++ [component 0 (spinor c) * component 1 (spinor_1 c) + component 1 (spinor c) * component 0 (spinor_1 c)]).

(** phCurve, createDefaultSpiral. `(2w₁² + w₀·w₂)/3`. *)
Definition hodograph_2 (c : accompanied A) : list A :=
  vdiv (vadd (vmul (number 2) (([component 0 (spinor_1 c) * component 0 (spinor_1 c) - component 1 (spinor_1 c) * component 1 (spinor_1 c)] ++ [component 0 (spinor_1 c) * component 1 (spinor_1 c) + component 1 (spinor_1 c) * component 0 (spinor_1 c)]))) (([component 0 (spinor c) * component 0 (spinor_2 c) - component 1 (spinor c) * component 1 (spinor_2 c)] ++ [component 0 (spinor c) * component 1 (spinor_2 c) + component 1 (spinor c) * component 0 (spinor_2 c)]))) (number 3).

(** control points of a quartic. The second control point of c′ as a quartic. *)
Definition quartic_1 (c : accompanied A) : list A :=
  vadd (vder (along c) (gamma c)) (vdiv (vders (along c) 2 (gamma c)) (number 4)).

(** control points of a quartic. The third control point of c′ as a quartic. *)
Definition quartic_2 (c : accompanied A) : list A :=
  vadd (vadd (vder (along c) (gamma c)) (vdiv (vders (along c) 2 (gamma c)) (number 2))) (vdiv (vders (along c) 3 (gamma c)) (number 12)).

(** control points of a quintic. The step from the second to the third control point of c as a quintic, times 5. *)
Definition quintic_step (c : accompanied A) : list A :=
  vmul (number 5) (vsub (vadd (vdiv (vmul (number 2) (vder (along c) (gamma c))) (number 5)) (vdiv (vders (along c) 2 (gamma c)) (number 20))) (vdiv (vder (along c) (gamma c)) (number 5))).

(** In the plane, Möbius is a linear map. `1/z = z̄/|z|²` of a rational curve. *)
Definition real_inversion (c : curve A) : list A :=
  vdiv (vmul (w c) (([component 0 (p c)] ++ [- component 1 (p c)]))) (dot (p c) (p c)).

(** In the plane, Möbius is a linear map. `z · 1/z − 1`. *)
Definition inversion_times_curve (c : curve A) : list A :=
  ([component 0 (([component 0 (gamma c) * component 0 (real_inversion c) - component 1 (gamma c) * component 1 (real_inversion c)] ++ [component 0 (gamma c) * component 1 (real_inversion c) + component 1 (gamma c) * component 0 (real_inversion c)])) - number 1] ++ [component 1 (([component 0 (gamma c) * component 0 (real_inversion c) - component 1 (gamma c) * component 1 (real_inversion c)] ++ [component 0 (gamma c) * component 1 (real_inversion c) + component 1 (gamma c) * component 0 (real_inversion c)]))]).

(** PH in one line. `P = x + iy`. *)
Definition complex_numerator (c : curve A) : list A :=
  ([component 0 (p c)] ++ [component 1 (p c)]).

(** PH in one line. `Q = z + iw`. *)
Definition complex_denominator (c : curve A) : list A :=
  ([component 2 (p c)] ++ [w c]).

(** PH in one line. `|P|² + |Q|²`: the squares of four functions. *)
Definition functions_squared (c : curve A) : A :=
  dot (complex_numerator c) (complex_numerator c) + dot (complex_denominator c) (complex_denominator c).

(** PH in one line. `M = P′Q − PQ′`. *)
Definition complex_wronskian (c : curve A) : list A :=
  vsub (([component 0 (vder (along c) (complex_numerator c)) * component 0 (complex_denominator c) - component 1 (vder (along c) (complex_numerator c)) * component 1 (complex_denominator c)] ++ [component 0 (vder (along c) (complex_numerator c)) * component 1 (complex_denominator c) + component 1 (vder (along c) (complex_numerator c)) * component 0 (complex_denominator c)])) (([component 0 (complex_numerator c) * component 0 (vder (along c) (complex_denominator c)) - component 1 (complex_numerator c) * component 1 (vder (along c) (complex_denominator c))] ++ [component 0 (complex_numerator c) * component 1 (vder (along c) (complex_denominator c)) + component 1 (complex_numerator c) * component 0 (vder (along c) (complex_denominator c))])).

(** PH in one line. The derivative of `z = P/Q`. *)
Definition complex_velocity (c : curve A) : list A :=
  vder (along c) (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c))).

(** PH in one line. `M/Q²`. *)
Definition complex_velocity_by_wronskian (c : curve A) : list A :=
  vdiv (([component 0 (complex_wronskian c) * component 0 (([component 0 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))] ++ [- component 1 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))])) - component 1 (complex_wronskian c) * component 1 (([component 0 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))] ++ [- component 1 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))]))] ++ [component 0 (complex_wronskian c) * component 1 (([component 0 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))] ++ [- component 1 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))])) + component 1 (complex_wronskian c) * component 0 (([component 0 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))] ++ [- component 1 (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))]))])) (dot (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)])) (([component 0 (complex_denominator c) * component 0 (complex_denominator c) - component 1 (complex_denominator c) * component 1 (complex_denominator c)] ++ [component 0 (complex_denominator c) * component 1 (complex_denominator c) + component 1 (complex_denominator c) * component 0 (complex_denominator c)]))).

(** PH in one line. `|z′|²`. *)
Definition complex_speed_squared (c : curve A) : A :=
  dot (complex_velocity c) (complex_velocity c).

(** PH in one line. `M M̄/(Q Q̄)²`. *)
Definition complex_speed_squared_by_wronskian (c : curve A) : A :=
  dot (complex_wronskian c) (complex_wronskian c) / dot (complex_denominator c) (complex_denominator c) ^ 2.

(** PH in one line. M of `1/z = Q/P`. *)
Definition inverted_wronskian (c : curve A) : list A :=
  vsub (([component 0 (vder (along c) (complex_denominator c)) * component 0 (complex_numerator c) - component 1 (vder (along c) (complex_denominator c)) * component 1 (complex_numerator c)] ++ [component 0 (vder (along c) (complex_denominator c)) * component 1 (complex_numerator c) + component 1 (vder (along c) (complex_denominator c)) * component 0 (complex_numerator c)])) (([component 0 (complex_denominator c) * component 0 (vder (along c) (complex_numerator c)) - component 1 (complex_denominator c) * component 1 (vder (along c) (complex_numerator c))] ++ [component 0 (complex_denominator c) * component 1 (vder (along c) (complex_numerator c)) + component 1 (complex_denominator c) * component 0 (vder (along c) (complex_numerator c))])).

(** PH in one line. `(a + ib) P + (m + in) Q`. *)
Definition affine_numerator (c : accompanied A) : list A :=
  vadd (([component 0 (([a_of c] ++ [b_of c])) * component 0 (complex_numerator c) - component 1 (([a_of c] ++ [b_of c])) * component 1 (complex_numerator c)] ++ [component 0 (([a_of c] ++ [b_of c])) * component 1 (complex_numerator c) + component 1 (([a_of c] ++ [b_of c])) * component 0 (complex_numerator c)])) (([component 0 (([m_of c] ++ [n_of c])) * component 0 (complex_denominator c) - component 1 (([m_of c] ++ [n_of c])) * component 1 (complex_denominator c)] ++ [component 0 (([m_of c] ++ [n_of c])) * component 1 (complex_denominator c) + component 1 (([m_of c] ++ [n_of c])) * component 0 (complex_denominator c)])).

(** PH in one line. The map of the pair, as a quotient. *)
Definition affine_image (c : accompanied A) : list A :=
  vdiv (([component 0 (affine_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (affine_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (affine_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (affine_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c)).

(** PH in one line. `(a + ib) z + (m + in)` for `z = P/Q`. *)
Definition affine_image_of_point (c : accompanied A) : list A :=
  ([component 0 (([component 0 (([a_of c] ++ [b_of c])) * component 0 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c))) - component 1 (([a_of c] ++ [b_of c])) * component 1 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c)))] ++ [component 0 (([a_of c] ++ [b_of c])) * component 1 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c))) + component 1 (([a_of c] ++ [b_of c])) * component 0 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c)))])) + m_of c] ++ [component 1 (([component 0 (([a_of c] ++ [b_of c])) * component 0 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c))) - component 1 (([a_of c] ++ [b_of c])) * component 1 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c)))] ++ [component 0 (([a_of c] ++ [b_of c])) * component 1 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c))) + component 1 (([a_of c] ++ [b_of c])) * component 0 (vdiv (([component 0 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) - component 1 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))] ++ [component 0 (complex_numerator c) * component 1 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)])) + component 1 (complex_numerator c) * component 0 (([component 0 (complex_denominator c)] ++ [- component 1 (complex_denominator c)]))])) (dot (complex_denominator c) (complex_denominator c)))])) + n_of c]).

(** PH in one line. M of `(a + ib) z + (m + in)`. *)
Definition affine_wronskian (c : accompanied A) : list A :=
  vsub (([component 0 (vder (along c) (affine_numerator c)) * component 0 (complex_denominator c) - component 1 (vder (along c) (affine_numerator c)) * component 1 (complex_denominator c)] ++ [component 0 (vder (along c) (affine_numerator c)) * component 1 (complex_denominator c) + component 1 (vder (along c) (affine_numerator c)) * component 0 (complex_denominator c)])) (([component 0 (affine_numerator c) * component 0 (vder (along c) (complex_denominator c)) - component 1 (affine_numerator c) * component 1 (vder (along c) (complex_denominator c))] ++ [component 0 (affine_numerator c) * component 1 (vder (along c) (complex_denominator c)) + component 1 (affine_numerator c) * component 0 (vder (along c) (complex_denominator c))])).

(** PH in one line. `(a + ib) M`. *)
Definition turned_wronskian (c : accompanied A) : list A :=
  ([component 0 (([a_of c] ++ [b_of c])) * component 0 (complex_wronskian c) - component 1 (([a_of c] ++ [b_of c])) * component 1 (complex_wronskian c)] ++ [component 0 (([a_of c] ++ [b_of c])) * component 1 (complex_wronskian c) + component 1 (([a_of c] ++ [b_of c])) * component 0 (complex_wronskian c)]).

(** Möbius invariance is two lines. The form on P. *)
Definition conformal_square (c : curve A) : A :=
  dot (components 1 4 (lifted.conformal_lift c)) (components 1 4 (lifted.conformal_lift c)) - component 0 (lifted.conformal_lift c) * component 4 (lifted.conformal_lift c).

(** Möbius invariance is two lines. The form on P′: h², the squared numerator of the speed. *)
Definition conformal_speed_squared (c : curve A) : A :=
  dot (components 1 4 (vder (along c) (lifted.conformal_lift c))) (components 1 4 (vder (along c) (lifted.conformal_lift c))) - component 0 (vder (along c) (lifted.conformal_lift c)) * component 4 (vder (along c) (lifted.conformal_lift c)).

(** Space: square the radius, rotate i. `A = w + xi + yj + zk`. *)
Definition quaternion (c : curve A) : list A :=
  ([w c] ++ p c).

(** Space: square the radius, rotate i. `A i A*`. *)
Definition sandwich (c : curve A) : list A :=
  ([component 0 (([- component 1 (quaternion c)] ++ [component 0 (quaternion c)] ++ [component 3 (quaternion c)] ++ [- component 2 (quaternion c)])) * component 0 (([component 0 (quaternion c)] ++ vneg (components 1 4 (quaternion c)))) - dot (components 1 4 (([- component 1 (quaternion c)] ++ [component 0 (quaternion c)] ++ [component 3 (quaternion c)] ++ [- component 2 (quaternion c)]))) (components 1 4 (([component 0 (quaternion c)] ++ vneg (components 1 4 (quaternion c)))))] ++ vadd (vadd (vmul (component 0 (([- component 1 (quaternion c)] ++ [component 0 (quaternion c)] ++ [component 3 (quaternion c)] ++ [- component 2 (quaternion c)]))) (components 1 4 (([component 0 (quaternion c)] ++ vneg (components 1 4 (quaternion c)))))) (vmul (component 0 (([component 0 (quaternion c)] ++ vneg (components 1 4 (quaternion c))))) (components 1 4 (([- component 1 (quaternion c)] ++ [component 0 (quaternion c)] ++ [component 3 (quaternion c)] ++ [- component 2 (quaternion c)]))))) (cross (components 1 4 (([- component 1 (quaternion c)] ++ [component 0 (quaternion c)] ++ [component 3 (quaternion c)] ++ [- component 2 (quaternion c)]))) (components 1 4 (([component 0 (quaternion c)] ++ vneg (components 1 4 (quaternion c))))))).

(** Space: square the radius, rotate i. Its real part: zero, so that it lies in R³. *)
Definition sandwich_real_part (c : curve A) : A :=
  component 0 (sandwich c).

(** Space: square the radius, rotate i. Its squared norm. *)
Definition sandwich_squared (c : curve A) : A :=
  dot (sandwich c) (sandwich c).

(** Space: square the radius, rotate i. `|A|²`. *)
Definition quaternion_squared (c : curve A) : A :=
  dot (quaternion c) (quaternion c).

(** polynomial quadruples. `(w² + x² − y² − z², 2(xy + wz), 2(xz − wy))`. *)
Definition hopf_map (c : curve A) : list A :=
  ([w c * w c + component 0 (p c) * component 0 (p c) - component 1 (p c) * component 1 (p c) - component 2 (p c) * component 2 (p c)] ++ [number 2 * (component 0 (p c) * component 1 (p c) + w c * component 2 (p c))] ++ [number 2 * (component 0 (p c) * component 2 (p c) - w c * component 1 (p c))]).

(** Space: square the radius, rotate i. The vector of the sandwich. *)
Definition sandwich_vector (c : curve A) : list A :=
  components 1 4 (sandwich c).

(** The ambiguity is a group. `B i B*` for `B = A (a + bi)`. *)
Definition turned_sandwich (c : accompanied A) : list A :=
  components 1 4 (([component 0 (([- component 1 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 3 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [- component 2 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))])) * component 0 (([component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ vneg (components 1 4 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))))) - dot (components 1 4 (([- component 1 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 3 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [- component 2 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))]))) (components 1 4 (([component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ vneg (components 1 4 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))))))] ++ vadd (vadd (vmul (component 0 (([- component 1 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 3 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [- component 2 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))]))) (components 1 4 (([component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ vneg (components 1 4 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))))))) (vmul (component 0 (([component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ vneg (components 1 4 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c])))))) (components 1 4 (([- component 1 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 3 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [- component 2 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))]))))) (cross (components 1 4 (([- component 1 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [component 3 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ [- component 2 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))]))) (components 1 4 (([component 0 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))] ++ vneg (components 1 4 (([component 0 (quaternion c) * a_of c - component 1 (quaternion c) * b_of c] ++ [component 0 (quaternion c) * b_of c + component 1 (quaternion c) * a_of c] ++ [component 2 (quaternion c) * a_of c + component 3 (quaternion c) * b_of c] ++ [component 3 (quaternion c) * a_of c - component 2 (quaternion c) * b_of c]))))))))).

(** The ambiguity is a group. `a² + b²`: 1 for `a + bi = e^{iθ}`. *)
Definition turning_squared (c : accompanied A) : A :=
  a_of c * a_of c + b_of c * b_of c.

(** Every spinor works. `σσ′ − c′·c″` for `c′ = A i A*` and `σ = |A|²`. *)
Definition quaternion_speed_change (c : curve A) : A :=
  quaternion_squared c * der (along c) (quaternion_squared c) - dot (sandwich_vector c) (vder (along c) (sandwich_vector c)).

End Formulas.
