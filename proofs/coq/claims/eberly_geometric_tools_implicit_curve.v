(** Geometric Tools: curves and implicit surfaces: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import eberly_geometric_tools.
Import ListNotations.
Local Open Scope formula_scope.

(** GT3a, ImplicitCurve2.h. *)
Theorem GT3a_implicit_curvature_squared_curvature_squared : every_implicit_curve (fun K c =>
  gradient_squared c ^ 3 <> zero K ->
  chen_riesenfeld_cohen_2007.speed_squared c ^ 3 <> zero K ->
  implicit_curvature_squared c = chen_riesenfeld_cohen_2007.curvature_squared c).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy D1 D2.
  pose (l := jets s 2 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 2 ++ [(4%positive, (- (var 7) * var 1)); (5%positive, (var 6 * var 1)); (6%positive, var 8 * (- (var 7) * var 1) + var 9 * (var 6 * var 1)); (7%positive, var 9 * (- (var 7) * var 1) + var 10 * (var 6 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5] (number 1) []) [var 1] [var 6; var 7] [[var 8; var 9]; [var 9; var 10]]).
  pose (atoms := [var 6 ^ 2 + var 7 ^ 2; var 1]%formula : list expr).
  pose (known := [([3], [0]); ([3; 6], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (gradient_squared c ^ 3 : expr)%formula (var 6 ^ 4 + num 2 * var 6 ^ 2 * var 7 ^ 2 + var 7 ^ 4)%formula (var 6 ^ 2 + var 7 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.speed_squared c ^ 3 : expr)%formula (var 1 ^ 5 * var 6 ^ 6 + num 3 * var 1 ^ 5 * var 6 ^ 4 * var 7 ^ 2 + num 3 * var 1 ^ 5 * var 6 ^ 2 * var 7 ^ 4 + var 1 ^ 5 * var 7 ^ 6)%formula (var 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N2 into N.
  assert (E : value K l (implicit_curvature_squared c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.curvature_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3b, ImplicitCurve2.h. *)
Theorem GT3b_f0_implicit_curvature_numerator : every_implicit_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f0 c = number (-1) * pace_of_the_curve c ^ 3 * implicit_curvature_numerator c).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy.
  pose (l := jets s 2 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 2 ++ [(4%positive, (- (var 7) * var 1)); (5%positive, (var 6 * var 1)); (6%positive, var 8 * (- (var 7) * var 1) + var 9 * (var 6 * var 1)); (7%positive, var 9 * (- (var 7) * var 1) + var 10 * (var 6 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5] (number 1) []) [var 1] [var 6; var 7] [[var 8; var 9]; [var 9; var 10]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (chen_riesenfeld_cohen_2007.f0 c : expr)%formula = value K l (number (-1) * pace_of_the_curve c ^ 3 * implicit_curvature_numerator c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3c, ImplicitCurve2.h. *)
Theorem GT3c_implicit_speed_squared_gradient_squared : every_implicit_curve (fun K c =>
  implicit_speed_squared c = pace_of_the_curve c ^ 2 * gradient_squared c).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy.
  pose (l := jets s 1 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 1 ++ [(3%positive, (- (var 6) * var 1)); (4%positive, (var 5 * var 1)); (5%positive, var 7 * (- (var 6) * var 1) + var 8 * (var 5 * var 1)); (6%positive, var 8 * (- (var 6) * var 1) + var 9 * (var 5 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 3; var 4] (number 1) []) [var 1] [var 5; var 6] [[var 7; var 8]; [var 8; var 9]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (implicit_speed_squared c : expr)%formula = value K l (pace_of_the_curve c ^ 2 * gradient_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3d, ImplicitCurve2.h, fails. *)
Theorem GT3d_tangent_then_normal_gradient_squared_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := Implicit (rational_curve s [t; t ^ 2] (number 1) []) [number 0 - number 1] [number 0 - number 2 * t; number 1] [[number 0 - number 2; number 0]; [number 0; number 0]] in
  w c <> zero K /\
  vder s (gamma c) = vmul (pace_of c) (perp (gradient_f c)) /\
  chain_rule c /\
  tangent_then_normal c <> gradient_squared c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 2; num 1 + num 4 * var 1 ^ 2]%formula : list expr).
  pose (known := [([], []); ([1; 1], [0; 0])] : list (list nat * list nat)).
  pose (c := (Implicit (rational_curve s [(var 1); (var 1) ^ 2] (number 1) []) [number 0 - number 1] [number 0 - number 2 * (var 1); number 1] [[number 0 - number 2; number 0]; [number 0; number 0]])%formula : implicit expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E0 : map (value K l) (vder s (gamma c) : list expr)%formula = map (value K l) (vmul (pace_of c) (perp (gradient_f c)) : list expr)%formula).
  { apply (one_vector K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E1 : map (value K l) (vder s (gradient_f c) : list expr)%formula = map (value K l) (map (fun row => dot row (vder s (gamma c))) (hessian_f c) : list expr)%formula).
  { apply (one_vector K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (tangent_then_normal c - gradient_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check E0|].
  split; [vm_cast_no_check E1|].
  apply different; vm_cast_no_check U.
Qed.

(** GT3d, ImplicitCurve2.h. *)
Theorem GT3d_tangent_then_normal_gradient_squared_meant : every_implicit_curve (fun K c =>
  tangent_then_normal c = number (-1) * gradient_squared c).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy.
  pose (l := jets s 0 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 0 ++ [(2%positive, (- (var 5) * var 1)); (3%positive, (var 4 * var 1)); (4%positive, var 6 * (- (var 5) * var 1) + var 7 * (var 4 * var 1)); (5%positive, var 7 * (- (var 5) * var 1) + var 8 * (var 4 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 2; var 3] (number 1) []) [var 1] [var 4; var 5] [[var 6; var 7]; [var 7; var 8]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (tangent_then_normal c : expr)%formula = value K l (number (-1) * gradient_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3e, ImplicitCurve2.h. *)
Theorem GT3e_tangent_on_normal : every_implicit_curve (fun K c =>
  tangent_on_normal c = zero K).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy.
  pose (l := jets s 0 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 0 ++ [(2%positive, (- (var 5) * var 1)); (3%positive, (var 4 * var 1)); (4%positive, var 6 * (- (var 5) * var 1) + var 7 * (var 4 * var 1)); (5%positive, var 7 * (- (var 5) * var 1) + var 8 * (var 4 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 2; var 3] (number 1) []) [var 1] [var 4; var 5] [[var 6; var 7]; [var 7; var 8]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (tangent_on_normal c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3f, ImplicitCurve2.h. *)
Theorem GT3f_tangent_off_the_curve : every_implicit_curve (fun K c =>
  tangent_off_the_curve c = zero K).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy.
  pose (l := jets s 1 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 1 ++ [(3%positive, (- (var 6) * var 1)); (4%positive, (var 5 * var 1)); (5%positive, var 7 * (- (var 6) * var 1) + var 8 * (var 5 * var 1)); (6%positive, var 8 * (- (var 6) * var 1) + var 9 * (var 5 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 3; var 4] (number 1) []) [var 1] [var 5; var 6] [[var 7; var 8]; [var 8; var 9]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (tangent_off_the_curve c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3g, ImplicitCurve2.h. *)
Theorem GT3g_tangent_by_arc_length_implicit_bending : every_implicit_curve (fun K c =>
  number 2 <> zero K ->
  chen_riesenfeld_cohen_2007.speed_squared c ^ 2 <> zero K ->
  tangent_by_arc_length c = implicit_bending c).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy P2 D1.
  pose (l := jets s 2 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 2 ++ [(4%positive, (- (var 7) * var 1)); (5%positive, (var 6 * var 1)); (6%positive, var 8 * (- (var 7) * var 1) + var 9 * (var 6 * var 1)); (7%positive, var 9 * (- (var 7) * var 1) + var 10 * (var 6 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5] (number 1) []) [var 1] [var 6; var 7] [[var 8; var 9]; [var 9; var 10]]).
  pose (atoms := [num 2; var 6 ^ 2 + var 7 ^ 2; var 1]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2; 4], [0; 0; 0]); ([0; 2; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.speed_squared c ^ 2 : expr)%formula (var 1 ^ 4 * var 6 ^ 2 + var 1 ^ 4 * var 7 ^ 2)%formula (var 6 ^ 2 + var 7 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (chen_riesenfeld_cohen_2007.speed_squared c ^ 2 : expr)%formula (var 1 ^ 3 * var 6 ^ 4 + num 2 * var 1 ^ 3 * var 6 ^ 2 * var 7 ^ 2 + var 1 ^ 3 * var 7 ^ 4)%formula (var 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (tangent_by_arc_length c : list expr)%formula = map (value K l) (implicit_bending c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3h, ImplicitCurve2.h. *)
Theorem GT3h_implicit_curvature_numerator_hessian_on_the_tangent : every_implicit_curve (fun K c =>
  implicit_curvature_numerator c = number (-1) * hessian_on_the_tangent c).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy.
  pose (l := jets s 0 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 0 ++ [(2%positive, (- (var 5) * var 1)); (3%positive, (var 4 * var 1)); (4%positive, var 6 * (- (var 5) * var 1) + var 7 * (var 4 * var 1)); (5%positive, var 7 * (- (var 5) * var 1) + var 8 * (var 4 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 2; var 3] (number 1) []) [var 1] [var 4; var 5] [[var 6; var 7]; [var 7; var 8]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (implicit_curvature_numerator c : expr)%formula = value K l (number (-1) * hessian_on_the_tangent c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT3i, ImplicitCurve2.h. *)
Theorem GT3i_height_of_the_acceleration_hessian_on_the_tangent : every_implicit_curve (fun K c =>
  height_of_the_acceleration c = number (-1) * pace_of_the_curve c ^ 2 * hessian_on_the_tangent c).
Proof.
  apply implicit_curve_by_position; intros K x_ y_ pace_ fx_ fy_ fxx_ fxy_ fyy_ dx_ dy_ Hx Hy Hfx Hfy.
  pose (l := jets s 2 pace_ ++ [x_; y_; fx_; fy_; fxx_; fxy_; fyy_]).
  pose (r := of_parameters (chain 1 2 ++ [(4%positive, (- (var 7) * var 1)); (5%positive, (var 6 * var 1)); (6%positive, var 8 * (- (var 7) * var 1) + var 9 * (var 6 * var 1)); (7%positive, var 9 * (- (var 7) * var 1) + var 10 * (var 6 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5] (number 1) []) [var 1] [var 6; var 7] [[var 8; var 9]; [var 9; var 10]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (height_of_the_acceleration c : expr)%formula = value K l (number (-1) * pace_of_the_curve c ^ 2 * hessian_on_the_tangent c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
