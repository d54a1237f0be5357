(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** T1, Table 1. *)
Theorem T1_identity : every_table (fun K c =>
  T1 c = T1_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (T1 c : expr)%formula = value K l (T1_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T4, Table 1. *)
Theorem T4_identity : every_table (fun K c =>
  T4 c = T4_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (E : value K l (T4 c : expr)%formula = value K l (T4_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T5, Table 1. *)
Theorem T5_identity : every_table (fun K c =>
  T5 c = T5_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw2. }
  clear N. rename N2 into N.
  assert (E : value K l (T5 c : expr)%formula = value K l (T5_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T6, Table 1. *)
Theorem T6_identity : every_table (fun K c =>
  T6 c = T6_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (E : value K l (T6 c : expr)%formula = value K l (T6_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T7, Table 1. *)
Theorem T7_identity : every_table (fun K c =>
  T7 c = T7_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw2. }
  clear N. rename N2 into N.
  assert (E : value K l (T7 c : expr)%formula = value K l (T7_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T8, Table 1. *)
Theorem T8_identity : every_table (fun K c =>
  p2 c <> zero K ->
  T8 c = T8_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2 D1.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2; var 6]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (p2 c : expr)%formula (num 1)%formula (var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (E : value K l (T8 c : expr)%formula = value K l (T8_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T9, Table 1. *)
Theorem T9_identity : every_table (fun K c =>
  p2 c / w2 c <> zero K ->
  T9 c = T9_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2 D1.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2; var 7; var 6]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 1; 0]); ([1; 0; 1], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw2. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (p2 c / w2 c : expr)%formula ((num 1) / (var 7))%formula (var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (E : value K l (T9 c : expr)%formula = value K l (T9_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T10, Table 1. *)
Theorem T10_identity : every_table (fun K c =>
  T10 c = T10_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (T10 c : list expr)%formula = map (value K l) (T10_carried_out c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T12, Table 1. *)
Theorem T12_identity : every_table (fun K c =>
  T12 c = T12_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (T12 c : list expr)%formula = map (value K l) (T12_carried_out c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T13, Table 1. *)
Theorem T13_identity : every_table (fun K c =>
  T13 c = T13_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (T13 c : list expr)%formula = map (value K l) (T13_carried_out c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T14, Table 1. *)
Theorem T14_identity : every_table (fun K c =>
  T14 c = T14_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (E : value K l (T14 c : expr)%formula = value K l (T14_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T15, Table 1. *)
Theorem T15_identity : every_table (fun K c =>
  T15 c = T15_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 0 p1_ ++ jets s 0 w1_ ++ jets s 0 v0_1_ ++ jets s 0 v1_1_ ++ jets s 0 v2_1_ ++ jets s 0 p2_ ++ jets s 0 w2_ ++ jets s 0 v0_2_ ++ jets s 0 v1_2_ ++ jets s 0 v2_2_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0 ++ chain 9 0 ++ chain 10 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 2) [var 3; var 4; var 5] (var 6) (var 7) [var 8; var 9; var 10]).
  pose (atoms := [var 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw2. }
  clear N. rename N2 into N.
  assert (E : value K l (T15 c : expr)%formula = value K l (T15_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** T17, Table 1. *)
Theorem T17_identity : every_table (fun K c =>
  T17 c = T17_carried_out c).
Proof.
  unfold every_table; intros K p1_ w1_ v0_1_ v1_1_ v2_1_ p2_ w2_ v0_2_ v1_2_ v2_2_ Hw1 Hw2.
  pose (l := jets s 1 p1_ ++ jets s 1 w1_ ++ jets s 1 v0_1_ ++ jets s 1 v1_1_ ++ jets s 1 v2_1_ ++ jets s 1 p2_ ++ jets s 1 w2_ ++ jets s 1 v0_2_ ++ jets s 1 v1_2_ ++ jets s 1 v2_2_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1 ++ chain 17 1 ++ chain 19 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Table (var 1) (var 3) [var 5; var 7; var 9] (var 11) (var 13) [var 15; var 17; var 19]).
  pose (atoms := [var 3]%formula : list expr).
  pose (known := [([1], [0]); ([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw1. }
  clear N. rename N1 into N.
  assert (E : value K l (T17 c : expr)%formula = value K l (T17_carried_out c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
