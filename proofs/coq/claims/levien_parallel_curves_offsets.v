(** Parallel curves of cubic Béziers; Flattening quadratic Béziers: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import levien_parallel_curves.
Import ListNotations.
Local Open Scope formula_scope.

(** OC1a, Parallel curves of cubic Béziers. *)
Theorem OC1a_root_velocity_squared_root_speed_squared : every_plane_curve (fun K c =>
  root_velocity_squared c = root_speed_squared c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 w_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (c := homogeneous s [var 1; var 2] (var 3) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (root_velocity_squared c : expr)%formula = value K l (root_speed_squared c : expr)%formula).
  { apply (one_value K l r R atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC1b, Parallel curves of cubic Béziers. *)
Theorem OC1b_offset_curvature_printed_curvature_by_root : every_plane_curve (fun K c =>
  root_speed c ^ 3 <> zero K ->
  offset_curvature_printed c = number (-1) * curvature_by_root c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([3; 6], [0; 0]); ([2; 4], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R (firstn 0 atoms) known N (root_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 5 ^ 6 + num 2 * var 1 ^ 2 * var 3 ^ 2 * var 5 ^ 6 + var 3 ^ 4 * var 5 ^ 6)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (offset_curvature_printed c : expr)%formula = value K l (number (-1) * curvature_by_root c : expr)%formula).
  { apply (one_value K l r R atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
