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

(** Every spinor works. `σσ′ − c′·c″` for `c′ = A i A*` and `σ = |A|²`. *)
Definition quaternion_speed_change (c : curve A) : A :=
  quaternion_squared c * der (along c) (quaternion_squared c) - dot (sandwich_vector c) (vder (along c) (sandwich_vector c)).

End Formulas.
