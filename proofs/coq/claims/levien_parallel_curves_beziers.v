(** Parallel curves of cubic Béziers; Flattening quadratic Béziers: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require primer_on_bezier_curves.
From ExactSpline.formulas Require Import levien_parallel_curves.
Import ListNotations.
Local Open Scope formula_scope.

(** OC4b, Parallel curves of cubic Béziers. *)
Theorem OC4b_cusp_coefficient_1_turning : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  cusp_coefficient_1 c = number (-1) * primer_on_bezier_curves.turning c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P3 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (cusp_coefficient_1 c : expr)%formula = value K l (number (-1) * primer_on_bezier_curves.turning c : expr)%formula).
  { apply (one_value K l r R atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC4c, Parallel curves of cubic Béziers. *)
Theorem OC4c_cusp_coefficient_2_second_turning : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  cusp_coefficient_2 c = number (-1) / number 2 * primer_on_bezier_curves.second_turning c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P3 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (cusp_coefficient_2 c : expr)%formula = value K l (number (-1) / number 2 * primer_on_bezier_curves.second_turning c : expr)%formula).
  { apply (one_value K l r R atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
