(** A Primer on Bézier Curves: its formulas.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require lifted.
Import ListNotations.
Local Open Scope formula_scope.

Section Formulas.
Context {A : Type} {o : operations A}.

(** derivatives. First control point: the curve itself. *)
Definition bezier_1 (c : curve A) : list A :=
  p c.

(** derivatives. Second control point, `p + p′/3`. *)
Definition bezier_2 (c : curve A) : list A :=
  vadd (p c) (vdiv (vder (along c) (p c)) (number 3)).

(** derivatives. Third control point, `p + 2p′/3 + p″/6`. *)
Definition bezier_3 (c : curve A) : list A :=
  vadd (vadd (p c) (vdiv (vmul (number 2) (vder (along c) (p c))) (number 3))) (vdiv (vders (along c) 2 (p c)) (number 6)).

(** derivatives. Fourth control point, `p + p′ + p″/2 + p‴/6`: the end of a cubic. *)
Definition bezier_4 (c : curve A) : list A :=
  vadd (vadd (vadd (p c) (vder (along c) (p c))) (vdiv (vders (along c) 2 (p c)) (number 2))) (vdiv (vders (along c) 3 (p c)) (number 6)).

(** derivatives. `3 (B − A)`. *)
Definition derivative_weight_1 (c : curve A) : list A :=
  vmul (number 3) (vsub (bezier_2 c) (bezier_1 c)).

(** derivatives. `3 (C − B)`. *)
Definition derivative_weight_2 (c : curve A) : list A :=
  vmul (number 3) (vsub (bezier_3 c) (bezier_2 c)).

(** derivatives. `3 (D − C)`. *)
Definition derivative_weight_3 (c : curve A) : list A :=
  vmul (number 3) (vsub (bezier_4 c) (bezier_3 c)).

(** derivatives. `2 (B′ − A′)`. *)
Definition second_derivative_weight_1 (c : curve A) : list A :=
  vmul (number 2) (vsub (derivative_weight_2 c) (derivative_weight_1 c)).

(** derivatives. `2 (C′ − B′)`. *)
Definition second_derivative_weight_2 (c : curve A) : list A :=
  vmul (number 2) (vsub (derivative_weight_3 c) (derivative_weight_2 c)).

(** derivatives. `1 (B″ − A″)`. *)
Definition third_derivative_weight (c : curve A) : list A :=
  vsub (second_derivative_weight_2 c) (second_derivative_weight_1 c).

(** derivatives. The derivative of a cubic where its control points end, `p′ + p″ + p‴/2`. *)
Definition velocity_at_the_end (c : curve A) : list A :=
  vadd (vadd (vder (along c) (p c)) (vders (along c) 2 (p c))) (vdiv (vders (along c) 3 (p c)) (number 2)).

(** derivatives. The second derivative there, `p″ + p‴`. *)
Definition acceleration_at_the_end (c : curve A) : list A :=
  vadd (vders (along c) 2 (p c)) (vders (along c) 3 (p c)).

(** extremities. `3 (−p₁ + 3p₂ − 3p₃ + p₄)`: the coefficient of t² in the derivative of a cubic. *)
Definition extremities_a (c : curve A) : list A :=
  vmul (number 3) (vadd (vsub (vadd (vneg (bezier_1 c)) (vmul (number 3) (bezier_2 c))) (vmul (number 3) (bezier_3 c))) (bezier_4 c)).

(** extremities. `v₁ − 2v₂ + v₃`. *)
Definition extremities_a_by_v (c : curve A) : list A :=
  vadd (vsub (derivative_weight_1 c) (vmul (number 2) (derivative_weight_2 c))) (derivative_weight_3 c).

(** extremities. `6 (p₁ − 2p₂ + p₃)`: the coefficient of t. *)
Definition extremities_b (c : curve A) : list A :=
  vmul (number 6) (vadd (vsub (bezier_1 c) (vmul (number 2) (bezier_2 c))) (bezier_3 c)).

(** reordering. The middle control point of a quadratic curve, `p + p′/2`. *)
Definition quadratic_2 (c : curve A) : list A :=
  vadd (p c) (vdiv (vder (along c) (p c)) (number 2)).

(** reordering. The last control point of a quadratic curve, `p + p′ + p″/2`. *)
Definition quadratic_3 (c : curve A) : list A :=
  vadd (vadd (p c) (vder (along c) (p c))) (vdiv (vders (along c) 2 (p c)) (number 2)).

(** reordering. `1/3 start + 2/3 control`. *)
Definition elevated_2 (c : curve A) : list A :=
  vadd (vdiv (bezier_1 c) (number 3)) (vdiv (vmul (number 2) (quadratic_2 c)) (number 3)).

(** reordering. `2/3 control + 1/3 end`. *)
Definition elevated_3 (c : curve A) : list A :=
  vadd (vdiv (vmul (number 2) (quadratic_2 c)) (number 3)) (vdiv (quadratic_3 c) (number 3)).

(** inflections. `[p′ p‴]`: the derivative of `[p′ p″]`. *)
Definition turning (c : curve A) : A :=
  det [vder (along c) (p c); vders (along c) 3 (p c)].

(** inflections. `[p″ p‴]`: the second derivative of `[p′ p″]` for a cubic. *)
Definition second_turning (c : curve A) : A :=
  det [vders (along c) 2 (p c); vders (along c) 3 (p c)].

(** inflections, the full formula. The coefficient of t² in C(t), printed as ten terms. *)
Definition inflection_coefficient_2 (c : curve A) : A :=
  number (-18) * component 0 (bezier_2 c) * component 1 (bezier_1 c) + number 36 * component 0 (bezier_3 c) * component 1 (bezier_1 c) - number 18 * component 0 (bezier_4 c) * component 1 (bezier_1 c) + number 18 * component 0 (bezier_1 c) * component 1 (bezier_2 c) - number 54 * component 0 (bezier_3 c) * component 1 (bezier_2 c) + (number 36 * component 0 (bezier_4 c) * component 1 (bezier_2 c) - number 36 * component 0 (bezier_1 c) * component 1 (bezier_3 c) + number 54 * component 0 (bezier_2 c) * component 1 (bezier_3 c) - number 18 * component 0 (bezier_4 c) * component 1 (bezier_3 c) + number 18 * component 0 (bezier_1 c) * component 1 (bezier_4 c)) - number 36 * component 0 (bezier_2 c) * component 1 (bezier_4 c) + number 18 * component 0 (bezier_3 c) * component 1 (bezier_4 c).

(** inflections, the full formula. The coefficient of t in C(t). *)
Definition inflection_coefficient_1 (c : curve A) : A :=
  number 36 * component 0 (bezier_2 c) * component 1 (bezier_1 c) - number 54 * component 0 (bezier_3 c) * component 1 (bezier_1 c) + number 18 * component 0 (bezier_4 c) * component 1 (bezier_1 c) - number 36 * component 0 (bezier_1 c) * component 1 (bezier_2 c) + number 54 * component 0 (bezier_3 c) * component 1 (bezier_2 c) - number 18 * component 0 (bezier_4 c) * component 1 (bezier_2 c) + number 54 * component 0 (bezier_1 c) * component 1 (bezier_3 c) - number 54 * component 0 (bezier_2 c) * component 1 (bezier_3 c) - number 18 * component 0 (bezier_1 c) * component 1 (bezier_4 c) + number 18 * component 0 (bezier_2 c) * component 1 (bezier_4 c).

(** inflections, the full formula. The constant coefficient of C(t). *)
Definition inflection_coefficient_0 (c : curve A) : A :=
  number (-18) * component 0 (bezier_2 c) * component 1 (bezier_1 c) + number 18 * component 0 (bezier_3 c) * component 1 (bezier_1 c) + number 18 * component 0 (bezier_1 c) * component 1 (bezier_2 c) - number 18 * component 0 (bezier_3 c) * component 1 (bezier_2 c) - number 18 * component 0 (bezier_1 c) * component 1 (bezier_3 c) + number 18 * component 0 (bezier_2 c) * component 1 (bezier_3 c).

(** inflections. From the first control point to the last, along which the curve is aligned. *)
Definition chord (c : curve A) : list A :=
  vsub (bezier_4 c) (bezier_1 c).

(** inflections. Its squared length. *)
Definition chord_squared (c : curve A) : A :=
  dot (chord c) (chord c).

(** inflections, aligned. The second control point after aligning, scaled by the length of the chord. *)
Definition aligned_2 (c : curve A) : list A :=
  ([dot (chord c) (vsub (bezier_2 c) (bezier_1 c))] ++ [det [chord c; vsub (bezier_2 c) (bezier_1 c)]]).

(** inflections, aligned. The third control point after aligning, scaled likewise. *)
Definition aligned_3 (c : curve A) : list A :=
  ([dot (chord c) (vsub (bezier_3 c) (bezier_1 c))] ++ [det [chord c; vsub (bezier_3 c) (bezier_1 c)]]).

(** inflections, aligned. `3x₃y₂ + 2x₄y₂ + 3x₂y₃ − x₄y₃`: the coefficient of t² as it is first printed. *)
Definition aligned_t2_printed (c : curve A) : A :=
  number 3 * component 0 (aligned_3 c) * component 1 (aligned_2 c) + number 2 * chord_squared c * component 1 (aligned_2 c) + number 3 * component 0 (aligned_2 c) * component 1 (aligned_3 c) - chord_squared c * component 1 (aligned_3 c).

(** inflections, aligned. `−3a + 2b + 3c − d`: the same as it is printed next. *)
Definition aligned_t2 (c : curve A) : A :=
  number (-3) * (component 0 (aligned_3 c) * component 1 (aligned_2 c)) + number 2 * (chord_squared c * component 1 (aligned_2 c)) + number 3 * (component 0 (aligned_2 c) * component 1 (aligned_3 c)) - chord_squared c * component 1 (aligned_3 c).

(** inflections, aligned. What the coefficient that is first printed is off by. *)
Definition aligned_t2_slip (c : curve A) : A :=
  aligned_t2_printed c - aligned_t2 c.

(** inflections, aligned. `2 · 3x₃y₂`: what a wrong sign of the first term makes. *)
Definition first_term_twice (c : curve A) : A :=
  number 6 * component 0 (aligned_3 c) * component 1 (aligned_2 c).

(** inflections, aligned. `3a − b − 3c`: the coefficient of t. *)
Definition aligned_t1 (c : curve A) : A :=
  number 3 * (component 0 (aligned_3 c) * component 1 (aligned_2 c)) - chord_squared c * component 1 (aligned_2 c) - number 3 * (component 0 (aligned_2 c) * component 1 (aligned_3 c)).

(** inflections, aligned. `c − a`: the constant coefficient. *)
Definition aligned_t0 (c : curve A) : A :=
  component 0 (aligned_2 c) * component 1 (aligned_3 c) - component 0 (aligned_3 c) * component 1 (aligned_2 c).

(** inflections. `y² − 4xz`: what stands under the root where C(t) is solved. *)
Definition inflection_discriminant (c : curve A) : A :=
  aligned_t1 c ^ 2 - number 4 * aligned_t2 c * aligned_t0 c.

(** the canonical form, mapped₄. The first coordinate of the mapped fourth point, in the coordinates x₁ … y₄. *)
Definition mapped_x (c : curve A) : A :=
  (- component 0 (bezier_1 c) + component 0 (bezier_4 c) - (- component 0 (bezier_1 c) + component 0 (bezier_2 c)) * (- component 1 (bezier_1 c) + component 1 (bezier_4 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c))) / (- component 0 (bezier_1 c) + component 0 (bezier_3 c) - (- component 0 (bezier_1 c) + component 0 (bezier_2 c)) * (- component 1 (bezier_1 c) + component 1 (bezier_3 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c))).

(** the canonical form, mapped₄. The second coordinate of the mapped fourth point, in the coordinates x₁ … y₄. *)
Definition mapped_y (c : curve A) : A :=
  (- component 1 (bezier_1 c) + component 1 (bezier_4 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c)) + (number 1 - (- component 1 (bezier_1 c) + component 1 (bezier_3 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c))) * (- component 0 (bezier_1 c) + component 0 (bezier_4 c) - (- component 0 (bezier_1 c) + component 0 (bezier_2 c)) * (- component 1 (bezier_1 c) + component 1 (bezier_4 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c))) / (- component 0 (bezier_1 c) + component 0 (bezier_3 c) - (- component 0 (bezier_1 c) + component 0 (bezier_2 c)) * (- component 1 (bezier_1 c) + component 1 (bezier_3 c)) / (- component 1 (bezier_1 c) + component 1 (bezier_2 c))).

(** the canonical form. The second point after T₁, which moves the first to the origin. *)
Definition moved_2 (c : curve A) : list A :=
  vsub (bezier_2 c) (bezier_1 c).

(** the canonical form. The third point after T₁. *)
Definition moved_3 (c : curve A) : list A :=
  vsub (bezier_3 c) (bezier_1 c).

(** the canonical form. The fourth point after T₁. *)
Definition moved_4 (c : curve A) : list A :=
  vsub (bezier_4 c) (bezier_1 c).

(** the canonical form. `(x₄ − x₂ y₄₂) / (x₃ − x₂ y₃₂)` with `y₄₂ = y₄/y₂` and `y₃₂ = y₃/y₂`, after the translation. *)
Definition x43 (c : curve A) : A :=
  (component 0 (moved_4 c) - component 0 (moved_2 c) * (component 1 (moved_4 c) / component 1 (moved_2 c))) / (component 0 (moved_3 c) - component 0 (moved_2 c) * (component 1 (moved_3 c) / component 1 (moved_2 c))).

(** the canonical form. `y₄₂ + x₄₃ (1 − y₃₂)`. *)
Definition y_by_x43 (c : curve A) : A :=
  component 1 (moved_4 c) / component 1 (moved_2 c) + x43 c * (number 1 - component 1 (moved_3 c) / component 1 (moved_2 c)).

(** the canonical form. The second point after T₂, which shears it onto `x = 0`. *)
Definition sheared_2 (c : curve A) : list A :=
  ([component 0 (moved_2 c) - component 0 (moved_2 c) / component 1 (moved_2 c) * component 1 (moved_2 c)] ++ [component 1 (moved_2 c)]).

(** the canonical form. The third point after T₂. *)
Definition sheared_3 (c : curve A) : list A :=
  ([component 0 (moved_3 c) - component 0 (moved_2 c) / component 1 (moved_2 c) * component 1 (moved_3 c)] ++ [component 1 (moved_3 c)]).

(** the canonical form. The fourth point after T₂. *)
Definition sheared_4 (c : curve A) : list A :=
  ([component 0 (moved_4 c) - component 0 (moved_2 c) / component 1 (moved_2 c) * component 1 (moved_4 c)] ++ [component 1 (moved_4 c)]).

(** the canonical form. The third point after T₃: its coordinates over `V₃ₓ` and `V₂ᵧ`. *)
Definition scaled_3 (c : curve A) : list A :=
  ([component 0 (sheared_3 c) / component 0 (sheared_3 c)] ++ [component 1 (sheared_3 c) / component 1 (sheared_2 c)]).

(** the canonical form. The fourth point after T₃. *)
Definition scaled_4 (c : curve A) : list A :=
  ([component 0 (sheared_4 c) / component 0 (sheared_3 c)] ++ [component 1 (sheared_4 c) / component 1 (sheared_2 c)]).

(** the canonical form. The fourth point after T₄, which shears by `(1 − W₃ᵧ)/W₃ₓ`. *)
Definition mapped_by_steps (c : curve A) : list A :=
  ([component 0 (scaled_4 c)] ++ [(number 1 - component 1 (scaled_3 c)) / component 0 (scaled_3 c) * component 0 (scaled_4 c) + component 1 (scaled_4 c)]).

(** the canonical form. Both coordinates of the mapped fourth point. *)
Definition mapped (c : curve A) : list A :=
  ([mapped_x c] ++ [mapped_y c]).

(** the canonical form. Both coordinates as they are pulled apart. *)
Definition mapped_by_x43 (c : curve A) : list A :=
  ([x43 c] ++ [y_by_x43 c]).

(** affine coordinates. The same as quotients of areas: `U₄ = α U₂ + x U₃` is mapped to `(x, α + x)`. *)
Definition mapped_by_areas (c : curve A) : list A :=
  ([det [moved_2 c; moved_4 c] / det [moved_2 c; moved_3 c]] ++ [(det [moved_4 c; moved_3 c] + det [moved_2 c; moved_4 c]) / det [moved_2 c; moved_3 c]]).

(** the canonical form. The first coordinate of the second point after T₂: zero, so that it lies on `x = 0`. *)
Definition sheared_2_off_axis (c : curve A) : A :=
  component 0 (sheared_2 c).

(** the canonical form. The height of the second point, scaled by `point2ᵧ`. *)
Definition height_by_the_words (c : curve A) : A :=
  component 1 (sheared_2 c) * component 1 (sheared_2 c).

(** the canonical form. Its height, scaled by T₃. *)
Definition height_by_the_matrix (c : curve A) : A :=
  component 1 (sheared_2 c) / component 1 (sheared_2 c).

(** the canonical form. What that height is off 1. *)
Definition height_off (c : curve A) : A :=
  height_by_the_matrix c - number 1.

(** the canonical form. `(y₂ − y₁)²`. *)
Definition first_rise_squared (c : curve A) : A :=
  (component 1 (bezier_2 c) - component 1 (bezier_1 c)) ^ 2.

(** the canonical form, 2. `4y + x² − 2x − 3`: zero on the edge `y = (−x² + 2x + 3)/4`. *)
Definition cusp_edge (c : curve A) : A :=
  number 4 * mapped_y c + mapped_x c ^ 2 - number 2 * mapped_x c - number 3.

(** the canonical form, 4. `3y + x² − 3x`: zero on the edge `y = (−x² + 3x)/3`. *)
Definition start_edge (c : curve A) : A :=
  number 3 * mapped_y c + mapped_x c ^ 2 - number 3 * mapped_x c.

(** the canonical form, 3. `(2y + x)² − 3(4x − x²)`: zero on the edge `y = (√(3(4x − x²)) − x)/2`. *)
Definition end_edge (c : curve A) : A :=
  (number 2 * mapped_y c + mapped_x c) ^ 2 - number 3 * (number 4 * mapped_x c - mapped_x c ^ 2).

(** the canonical form, 5. `1 − y`: negative past `y = 1`. *)
Definition single_inflection_edge (c : curve A) : A :=
  number 1 - mapped_y c.

(** cusps of a cubic. `[p′ p‴]² − 2 [p′ p″] [p″ p‴]`: the discriminant of `[γ′ γ″]` along the cubic. *)
Definition cusp_condition (c : curve A) : A :=
  det [vder (along c) (p c); vders (along c) 3 (p c)] ^ 2 - number 2 * det [vder (along c) (p c); vders (along c) 2 (p c)] * det [vders (along c) 2 (p c); vders (along c) 3 (p c)].

(** a cubic through its start. Zero where `p′ + p″s/2 + p‴s²/6` vanishes for an s: the cubic meets its start again. *)
Definition start_condition (c : curve A) : A :=
  det [vder (along c) (p c); vdiv (vders (along c) 3 (p c)) (number 6)] ^ 2 - det [vder (along c) (p c); vdiv (vders (along c) 2 (p c)) (number 2)] * det [vdiv (vders (along c) 2 (p c)) (number 2); vdiv (vders (along c) 3 (p c)) (number 6)].

(** a cubic through its end. The same at the other end of the cubic. *)
Definition end_condition (c : curve A) : A :=
  det [velocity_at_the_end c; vdiv (vders (along c) 3 (p c)) (number 6)] ^ 2 - det [velocity_at_the_end c; vdiv (acceleration_at_the_end c) (number 2)] * det [vdiv (acceleration_at_the_end c) (number 2); vdiv (vders (along c) 3 (p c)) (number 6)].

(** inflections between the ends. `[γ′ γ″]` at the start times the same at the end: negative where a cubic inflects an odd number of times. *)
Definition turning_at_both_ends (c : curve A) : A :=
  det [vder (along c) (p c); vders (along c) 2 (p c)] * det [velocity_at_the_end c; acceleration_at_the_end c].

(** the canonical form. Twice the area of the triangle of the first three control points. *)
Definition first_triangle (c : curve A) : A :=
  det [moved_2 c; moved_3 c].

(** tangents and normals. `(−B′_y, B′_x)`: the tangent turned by a quarter circle; normal_x and normal_y times d. *)
Definition rotated_tangent (c : curve A) : list A :=
  ([- component 1 (vder (along c) (gamma c))] ++ [component 0 (vder (along c) (gamma c))]).

(** tangents and normals. `B′_x² + B′_y²`. *)
Definition tangent_length_squared (c : curve A) : A :=
  component 0 (vder (along c) (gamma c)) ^ 2 + component 1 (vder (along c) (gamma c)) ^ 2.

(** tangents and normals. The scalar product of the normal and the tangent: zero at a right angle. *)
Definition rotated_tangent_on_tangent (c : curve A) : A :=
  dot (rotated_tangent c) (vder (along c) (gamma c)).

(** tangents and normals. The squared length of the turned tangent. *)
Definition rotated_tangent_squared (c : curve A) : A :=
  dot (rotated_tangent c) (rotated_tangent c).

(** inflections; curvature. `C(t) = x′ y″ − y′ x″`. *)
Definition curvature_function (c : curve A) : A :=
  component 0 (vder (along c) (gamma c)) * component 1 (vders (along c) 2 (gamma c)) - component 1 (vder (along c) (gamma c)) * component 0 (vders (along c) 2 (gamma c)).

(** curvature. The square of `(x′y″ − x″y′) / (x′² + y′²)^(3/2)`. *)
Definition primer_curvature_squared (c : curve A) : A :=
  curvature_function c ^ 2 / tangent_length_squared c ^ 3.

(** curvature. The square of `R = 1/κ`. *)
Definition primer_radius_squared (c : curve A) : A :=
  number 1 / primer_curvature_squared c.

(** offsetting. The derivative of `‖B′‖²`: zero if the length of the tangent were one number, as an integral from 0 to 1 is. *)
Definition tangent_length_changes (c : curve A) : A :=
  der (along c) (chen_riesenfeld_cohen_2007.speed_squared c).

(** offsetting. `2 B′·B″`. *)
Definition twice_velocity_on_acceleration (c : curve A) : A :=
  number 2 * dot (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)).

(** derivatives. The third derivative, in the Primer ”(meaningful)” for curves of order four and more alone. *)
Definition third_derivative (c : curve A) : list A :=
  chen_riesenfeld_cohen_2007.jerk c.

(** working with 3D normals. `b × a` with `a = B′` and `b = a + B″`: r without its length. *)
Definition rotation_axis (c : curve A) : list A :=
  cross (vadd (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (vder (along c) (gamma c)).

(** working with 3D normals. `r × a`: the normal without its length. *)
Definition frenet_normal_in_four_lines (c : curve A) : list A :=
  cross (rotation_axis c) (vder (along c) (gamma c)).

(** working with 3D normals. The scalar product of that normal and the tangent. *)
Definition frenet_normal_across (c : curve A) : A :=
  dot (frenet_normal_in_four_lines c) (vder (along c) (gamma c)).

(** rational Béziers. The curve with every ratio doubled: numerator and denominator. *)
Definition ratios_doubled (c : curve A) : list A :=
  vdiv (vmul (number 2) (p c)) (w c * number 2).

(** rational Béziers. The rational curve itself. *)
Definition the_curve (c : curve A) : list A :=
  vdiv (p c) (w c).

End Formulas.
