(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S10, ours. *)
Theorem S10_gauss_map_area_parabolic : every_surface (fun K c =>
  gauss_map_area c = parabolic c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (gauss_map_area c : expr)%formula = value K l (parabolic c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S10, ours. *)
Theorem S10_focal_linear_coefficient_minimality : every_surface (fun K c =>
  focal_linear_coefficient c = number (-1) * minimality c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (focal_linear_coefficient c : expr)%formula = value K l (number (-1) * minimality c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S10, ours. *)
Theorem S10_focal_constant_coefficient_area_squared : every_surface (fun K c =>
  focal_constant_coefficient c = area_squared c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (focal_constant_coefficient c : expr)%formula = value K l (area_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S10, ours. *)
Theorem S10_focal_discriminant_lifted_umbilicity : every_surface (fun K c =>
  focal_discriminant_lifted c = w c ^ 16 * umbilicity c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (focal_discriminant_lifted c : expr)%formula = value K l (w c ^ 16 * umbilicity c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S10, ours. *)
Theorem S10_area_of_lifted_forms_area_squared_lifted : every_surface (fun K c =>
  area_of_lifted_forms c = w c ^ 2 * area_squared_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (area_of_lifted_forms c : expr)%formula = value K l (w c ^ 2 * area_squared_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S10, ours. *)
Theorem S10_ridge_cubic_lifted_ridge_cubic_of_surface : every_surface (fun K c =>
  number 2 <> zero K ->
  ridge_cubic_lifted c = vmul (w c ^ 12) (ridge_cubic_of_surface c)).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw P2.
  pose (l := partials 3 x_ ++ partials 3 y_ ++ partials 3 z_ ++ partials 3 w_).
  pose (r := of_parameters (grid 1 3 0 ++ grid 11 3 0 ++ grid 21 3 0 ++ grid 31 3 0) (grid 1 3 1 ++ grid 11 3 1 ++ grid 21 3 1 ++ grid 31 3 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 11; var 21] (var 31) [])).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (ridge_cubic_lifted c : list expr)%formula = map (value K l) (vmul (w c ^ 12) (ridge_cubic_of_surface c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
