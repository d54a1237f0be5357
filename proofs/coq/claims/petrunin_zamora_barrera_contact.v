(** What is differential geometry: curves and surfaces: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import petrunin_zamora_barrera.
Import ListNotations.
Local Open Scope formula_scope.

(** PZ7d, ch. Torsion. *)
Theorem PZ7d_between_the_spheres_along_the_offset : every_two_curves (fun K c =>
  chen_riesenfeld_cohen_2007.D1_D2_D3 (first c) <> zero K ->
  number 2 <> zero K ->
  chen_riesenfeld_cohen_2007.speed_squared (first c) ^ 2 <> zero K ->
  acceleration_squared (first c) <> zero K ->
  between_the_spheres c = number 4 * along_the_offset c).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW H1 P2 D1 D2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_ ++ jets s_bar 3 X_ ++ jets s_bar 3 Y_ ++ jets s_bar 3 Z_ ++ jets s_bar 3 W_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) (chain 17 3 ++ chain 21 3 ++ chain 25 3 ++ chain 29 3)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 5; var 9] (var 13) []) (homogeneous s_bar [var 17; var 21; var 25] (var 29) [])).
  pose (atoms := [num 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2; var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0]); ([0; 3], [0; 0]); ([0; 0; 1], [0; 3; 0]); ([0; 0; 1], [0; 0; 0]); ([1; 0; 1; 1], [0; 5; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.speed_squared (first c) ^ 2 : expr)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (acceleration_squared (first c) : expr)%formula ((num 1) / (var 2 ^ 6 + num 3 * var 2 ^ 4 * var 6 ^ 2 + num 3 * var 2 ^ 2 * var 6 ^ 4 + var 6 ^ 6 + num 3 * var 2 ^ 4 * var 10 ^ 2 + num 6 * var 2 ^ 2 * var 6 ^ 2 * var 10 ^ 2 + num 3 * var 6 ^ 4 * var 10 ^ 2 + num 3 * var 2 ^ 2 * var 10 ^ 4 + num 3 * var 6 ^ 2 * var 10 ^ 4 + var 10 ^ 6))%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.D1_D2_D3 (first c) : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : value K l (between_the_spheres c : expr)%formula = value K l (number 4 * along_the_offset c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
