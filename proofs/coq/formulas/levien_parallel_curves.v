(** Parallel curves of cubic Béziers; Flattening quadratic Béziers: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require primer_on_bezier_curves.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** The constant delta. *)
Definition delta_of (c : accompanied A) : A := component 0 (beside c).

(** complex notation. `x′ = (u + iv)²`. *)
Definition root_velocity (c : curve A) : list A :=
  ([component 0 (p c) * component 0 (p c) - component 1 (p c) * component 1 (p c)] ++ [component 0 (p c) * component 1 (p c) + component 1 (p c) * component 0 (p c)]).

(** complex notation. `|x′| = u² + v²`. *)
Definition root_speed (c : curve A) : A :=
  dot (p c) (p c).

(** complex notation. `|x′|²`. *)
Definition root_velocity_squared (c : curve A) : A :=
  dot (root_velocity c) (root_velocity c).

(** complex notation. `(u² + v²)²`. *)
Definition root_speed_squared (c : curve A) : A :=
  root_speed c ^ 2.

(** Cusp finding. `(x″ × x′) / |x′|³`. *)
Definition offset_curvature_printed (c : curve A) : A :=
  det [vder (along c) (root_velocity c); root_velocity c] / root_speed c ^ 3.

(** curvature in complex notation. `2 (u v′ − v u′) / (u² + v²)²`: positive where the curve turns left. *)
Definition curvature_by_root (c : curve A) : A :=
  number 2 * det [p c; vder (along c) (p c)] / root_speed c ^ 2.

(** CubicOffset.eval_offset. `(−s y′, s x′)` with `s = δ/|x′|`: from the curve to its parallel. *)
Definition offset_step (c : accompanied A) : list A :=
  vmul (delta_of c / root_speed c) (([- component 1 (root_velocity c)] ++ [component 0 (root_velocity c)])).

(** CubicOffset.eval_offset. The derivative of that step. *)
Definition offset_step_derivative (c : accompanied A) : list A :=
  vder (along c) (offset_step c).

(** CubicOffset.eval_deriv. `(1 + (x″ × x′) δ/|x′|³) x′`. *)
Definition offset_velocity_in_code (c : accompanied A) : list A :=
  vmul (number 1 + det [vder (along c) (root_velocity c); root_velocity c] * delta_of c / root_speed c ^ 3) (root_velocity c).

(** the parallel curve. The derivative of the parallel curve. *)
Definition offset_velocity (c : accompanied A) : list A :=
  vadd (root_velocity c) (vder (along c) (offset_step c)).

(** Cusp finding. `(x″ × x′) δ + |x′|³`. *)
Definition cusp_function (c : accompanied A) : A :=
  det [vder (along c) (root_velocity c); root_velocity c] * delta_of c + root_speed c ^ 3.

(** Cusp finding. `(1 − κδ) x′` for the curvature that is printed: zero where it is one over the distance. *)
Definition velocity_less_curvature (c : accompanied A) : list A :=
  vmul (number 1 - offset_curvature_printed c * delta_of c) (root_velocity c).

(** the parallel on the other side. `(1 − κδ) x′` and the velocity of the parallel, less twice x′. *)
Definition velocities_of_both_sides (c : accompanied A) : list A :=
  vsub (vadd (velocity_less_curvature c) (offset_velocity c)) (vmul (number 2) (root_velocity c)).

(** Cusp finding. `(1 + κδ) x′`. *)
Definition velocity_plus_curvature (c : accompanied A) : list A :=
  vmul (number 1 + offset_curvature_printed c * delta_of c) (root_velocity c).

(** the parallel curve. The squared distance of the parallel from the curve. *)
Definition offset_distance_squared (c : accompanied A) : A :=
  dot (offset_step c) (offset_step c).

(** the parallel curve. `δ`. *)
Definition distance (c : accompanied A) : A :=
  delta_of c.

(** the parallel curve. `δ²`. *)
Definition distance_squared (c : accompanied A) : A :=
  delta_of c ^ 2.

(** the parallel curve. The scalar product of the step and x′. *)
Definition offset_step_on_velocity (c : accompanied A) : A :=
  dot (offset_step c) (root_velocity c).

(** the parallel curve. `1 + κδ` for the curvature that is printed. *)
Definition shrinking (c : accompanied A) : A :=
  cusp_function c / root_speed c ^ 3.

(** the parallel curve. `(y″ × y′)/|y′|³` for the parallel curve y, with `|y′| = (1 + κδ)|x′|`. *)
Definition curvature_of_the_parallel (c : accompanied A) : A :=
  det [vder (along c) (offset_velocity c); offset_velocity c] / (shrinking c * root_speed c) ^ 3.

(** the parallel curve. `κ/(1 + κδ)`. *)
Definition curvature_over_shrinking (c : accompanied A) : A :=
  offset_curvature_printed c / shrinking c.

(** the parallel of a circular arc. The derivative of `κ/(1 + κδ)`. *)
Definition curvature_change_of_the_parallel (c : accompanied A) : A :=
  der (along c) (curvature_over_shrinking c).

(** the parallel of a circular arc. The derivative of κ. *)
Definition curvature_change (c : curve A) : A :=
  der (along c) (offset_curvature_printed c).

(** the parallel curve. `1/κ_δ − 1/κ − δ`: the centres of curvature are the same. *)
Definition radii_less_distance (c : accompanied A) : A :=
  number 1 / curvature_over_shrinking c - number 1 / offset_curvature_printed c - delta_of c.

(** the parallel of a Pythagorean hodograph. The step times `u² + v²`. *)
Definition step_times_speed (c : accompanied A) : list A :=
  vmul (root_speed c) (offset_step c).

(** the parallel of a Pythagorean hodograph. `δ (−2uv, u² − v²)`: a polynomial. *)
Definition step_numerator (c : accompanied A) : list A :=
  vmul (delta_of c) (perp (root_velocity c)).

(** CubicBez.find_offset_cusps. `(d1x, d1y)`: twice the first difference of the control points of the hodograph. *)
Definition hodograph_step (c : curve A) : list A :=
  primer_on_bezier_curves.second_derivative_weight_1 c.

(** CubicBez.find_offset_cusps. `(d2x, d2y)`: their second difference. *)
Definition hodograph_bend (c : curve A) : list A :=
  primer_on_bezier_curves.extremities_a_by_v c.

(** CubicBez.find_offset_cusps. `d1x d0y − d1y d0x`. *)
Definition cusp_coefficient_0 (c : curve A) : A :=
  det [hodograph_step c; primer_on_bezier_curves.derivative_weight_1 c].

(** CubicBez.find_offset_cusps. `2 (d2x d0y − d2y d0x)`. *)
Definition cusp_coefficient_1 (c : curve A) : A :=
  number 2 * det [hodograph_bend c; primer_on_bezier_curves.derivative_weight_1 c].

(** CubicBez.find_offset_cusps. `d2x d1y − d2y d1x`. *)
Definition cusp_coefficient_2 (c : curve A) : A :=
  det [hodograph_bend c; hodograph_step c].

(** Cusp finding. `δ² [x″ x′]² − |x′|⁶`: zero at the cusps of the parallels on both sides. *)
Definition cusps_on_both_sides (c : accompanied A) : A :=
  delta_of c ^ 2 * det [vders (along c) 2 (gamma c); vder (along c) (gamma c)] ^ 2 - dot (vder (along c) (gamma c)) (vder (along c) (gamma c)) ^ 3.

(** Cusp finding. `κ²δ² − 1`. *)
Definition cusps_by_curvature (c : accompanied A) : A :=
  chen_riesenfeld_cohen_2007.curvature_squared c * delta_of c ^ 2 - number 1.

(** QuadBez.map_to_basic. `(ddx, ddy)`: twice the middle control point less the others. *)
Definition basic_direction (c : curve A) : list A :=
  vsub (vsub (vmul (number 2) (primer_on_bezier_curves.quadratic_2 c)) (primer_on_bezier_curves.bezier_1 c)) (primer_on_bezier_curves.quadratic_3 c).

(** QuadBez.map_to_basic. `(x2 − x0) ddy − (y2 − y0) ddx`. *)
Definition basic_cross (c : curve A) : A :=
  det [vsub (primer_on_bezier_curves.quadratic_3 c) (primer_on_bezier_curves.bezier_1 c); basic_direction c].

(** QuadBez.map_to_basic. `u0/cross`: where the curve starts on `y = x²`. *)
Definition basic_start (c : curve A) : A :=
  dot (vsub (primer_on_bezier_curves.quadratic_2 c) (primer_on_bezier_curves.bezier_1 c)) (basic_direction c) / basic_cross c.

(** QuadBez.map_to_basic. `u2/cross`: where it ends. *)
Definition basic_end (c : curve A) : A :=
  dot (vsub (primer_on_bezier_curves.quadratic_3 c) (primer_on_bezier_curves.quadratic_2 c)) (basic_direction c) / basic_cross c.

(** the axis of a parabola. `γ′·γ″ / (2 [γ′ γ″])`: zero at the vertex, x for `(x, x²)`. *)
Definition parabola_parameter (c : curve A) : A :=
  dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)) / (number 2 * det [vder (along c) (gamma c); vders (along c) 2 (gamma c)]).

(** QuadBez.map_to_basic. The square of `scale = |cross| / (|dd| |x2 − x0|)`. *)
Definition basic_scale_squared (c : curve A) : A :=
  basic_cross c ^ 2 / (dot (basic_direction c) (basic_direction c) * (basic_end c - basic_start c) ^ 2).

(** Flattening quadratic Béziers. The square of `κ = 2/(1 + 4x²)^(3/2)` at x₀, divided by that of the scale. *)
Definition basic_curvature_squared (c : curve A) : A :=
  number 4 / ((number 1 + number 4 * basic_start c ^ 2) ^ 3 * basic_scale_squared c).

(** Flattening quadratic Béziers. The square of `Δs = √(1 + 4x²) Δx` at x₀, times the scale, for the Δx of one unit of the parameter. *)
Definition basic_arc_length_squared (c : curve A) : A :=
  (number 1 + number 4 * basic_start c ^ 2) * (basic_end c - basic_start c) ^ 2 * basic_scale_squared c.

End Formulas.
