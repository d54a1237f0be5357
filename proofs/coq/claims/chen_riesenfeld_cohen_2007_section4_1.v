(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** E8, eq. (8). *)
Theorem E8_f1_f1_expanded : every_plane_curve (fun K c =>
  f1 c = f1_expanded c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (f1 c : expr)%formula = value K l (f1_expanded c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C4.1a, §4.1, eq. (8). *)
Theorem C41a_f1_f2 : every_plane_curve (fun K c =>
  f1 c = w c * f2 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (f1 c : expr)%formula = value K l (w c * f2 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C4.1a, §4.1, eq. (8). *)
Theorem C41a_f0_f2 : every_plane_curve (fun K c =>
  f0 c = number 1 / w c ^ 3 * f2 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (f0 c : expr)%formula = value K l (number 1 / w c ^ 3 * f2 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
