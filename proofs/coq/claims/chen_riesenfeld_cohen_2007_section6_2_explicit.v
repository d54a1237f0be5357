(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** C6.2a, eq. (31). *)
Theorem C62a_point_bisector_point_bisector_naive : every_space_curve_with_point (fun K c =>
  dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  same_surface (point_bisector c) (point_bisector_naive c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (point_bisector_generator_polynomial c) (point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E1 : map (value K l) (cross (generator (point_bisector c)) (generator (point_bisector_naive c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (point_bisector c)) (vsub (directrix (point_bisector_naive c)) (directrix (point_bisector c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (point_bisector c)) (generator (point_bisector c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (point_bisector_naive c)) (generator (point_bisector_naive c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (point_bisector c))) (map (value K l) (generator (point_bisector c))) (map (value K l) (directrix (point_bisector_naive c))) (map (value K l) (generator (point_bisector_naive c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (point_bisector c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (point_bisector_naive c))) (conj eq_refl U2)) E1 E2).
Qed.
