(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S6, ours. *)
Theorem S6_turning_uu_line_coefficient_uu : every_surface (fun K c =>
  turning_uu c = line_coefficient_uu c).
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
  assert (E : value K l (turning_uu c : expr)%formula = value K l (line_coefficient_uu c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S6, ours. *)
Theorem S6_turning_uv_line_coefficient_uv : every_surface (fun K c =>
  turning_uv c = line_coefficient_uv c).
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
  assert (E : value K l (turning_uv c : expr)%formula = value K l (line_coefficient_uv c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S6, ours. *)
Theorem S6_turning_vv_line_coefficient_vv : every_surface (fun K c =>
  turning_vv c = line_coefficient_vv c).
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
  assert (E : value K l (turning_vv c : expr)%formula = value K l (line_coefficient_vv c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S7, ours. *)
Theorem S7_line_coefficient_uu_lifted_line_coefficient_uu : every_surface (fun K c =>
  line_coefficient_uu_lifted c = number 2 * w c ^ 10 * line_coefficient_uu c).
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
  assert (E : value K l (line_coefficient_uu_lifted c : expr)%formula = value K l (number 2 * w c ^ 10 * line_coefficient_uu c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S7, ours. *)
Theorem S7_line_coefficient_uv_lifted_line_coefficient_uv : every_surface (fun K c =>
  line_coefficient_uv_lifted c = number 2 * w c ^ 10 * line_coefficient_uv c).
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
  assert (E : value K l (line_coefficient_uv_lifted c : expr)%formula = value K l (number 2 * w c ^ 10 * line_coefficient_uv c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S7, ours. *)
Theorem S7_line_coefficient_vv_lifted_line_coefficient_vv : every_surface (fun K c =>
  line_coefficient_vv_lifted c = number 2 * w c ^ 10 * line_coefficient_vv c).
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
  assert (E : value K l (line_coefficient_vv_lifted c : expr)%formula = value K l (number 2 * w c ^ 10 * line_coefficient_vv c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S7, ours. *)
Theorem S7_line_coefficient_uu_lifted_line_coefficient_uu_projective : every_surface (fun K c =>
  line_coefficient_uu_lifted c = number 2 * w c ^ 2 * line_coefficient_uu_projective c).
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
  assert (E : value K l (line_coefficient_uu_lifted c : expr)%formula = value K l (number 2 * w c ^ 2 * line_coefficient_uu_projective c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S7, ours. *)
Theorem S7_line_coefficient_uv_lifted_line_coefficient_uv_projective : every_surface (fun K c =>
  line_coefficient_uv_lifted c = number 2 * w c ^ 2 * line_coefficient_uv_projective c).
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
  assert (E : value K l (line_coefficient_uv_lifted c : expr)%formula = value K l (number 2 * w c ^ 2 * line_coefficient_uv_projective c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S7, ours. *)
Theorem S7_line_coefficient_vv_lifted_line_coefficient_vv_projective : every_surface (fun K c =>
  line_coefficient_vv_lifted c = number 2 * w c ^ 2 * line_coefficient_vv_projective c).
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
  assert (E : value K l (line_coefficient_vv_lifted c : expr)%formula = value K l (number 2 * w c ^ 2 * line_coefficient_vv_projective c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
