(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** C6.1c, eqs. (27), (28). *)
Theorem C61c_bisector_polynomial_bisector : every_two_curves (fun K c =>
  bisector_determinant_symmetric c <> zero K ->
  number 2 <> zero K ->
  bisector_polynomial c = bisector c).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ jets s_bar 1 X_ ++ jets s_bar 1 Y_ ++ jets s_bar 1 Z_ ++ jets s_bar 1 W_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) (chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 3; var 5] (var 7) []) (homogeneous s_bar [var 9; var 11; var 13] (var 15) [])).
  pose (atoms := [num 2; var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (bisector_determinant_symmetric c : expr)%formula (num 0 - var 7 ^ 3 * var 15 ^ 3)%formula (var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (bisector_polynomial c : list expr)%formula = map (value K l) (bisector c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.1e, §6.1. *)
Theorem C61e_bisector_symmetric_bisector_polynomial : every_two_curves (fun K c =>
  bisector_determinant_symmetric c <> zero K ->
  number 2 <> zero K ->
  bisector_symmetric c = bisector_polynomial c).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ jets s_bar 1 X_ ++ jets s_bar 1 Y_ ++ jets s_bar 1 Z_ ++ jets s_bar 1 W_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) (chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 3; var 5] (var 7) []) (homogeneous s_bar [var 9; var 11; var 13] (var 15) [])).
  pose (atoms := [num 2; var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14; var 15; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4; 4], [0; 0; 0; 0]); ([0; 1; 0; 4], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (bisector_determinant_symmetric c : expr)%formula (num 0 - var 7 ^ 3 * var 15 ^ 3)%formula (var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact HW. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Hw. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (bisector_symmetric c : list expr)%formula = map (value K l) (bisector_polynomial c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E22, definition of the bisector. *)
Theorem E22_bisector_in_first_normal_plane : every_two_curves (fun K c =>
  bisector_determinant_symmetric c <> zero K ->
  number 2 <> zero K ->
  bisector_in_first_normal_plane c = zero K).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ jets s_bar 1 X_ ++ jets s_bar 1 Y_ ++ jets s_bar 1 Z_ ++ jets s_bar 1 W_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) (chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 3; var 5] (var 7) []) (homogeneous s_bar [var 9; var 11; var 13] (var 15) [])).
  pose (atoms := [num 2; var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14; var 15; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4; 4], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (bisector_determinant_symmetric c : expr)%formula (num 0 - var 7 ^ 3 * var 15 ^ 3)%formula (var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact HW. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Hw. }
  clear N. rename N4 into N.
  assert (E : value K l (bisector_in_first_normal_plane c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E22, definition of the bisector. *)
Theorem E22_bisector_in_second_normal_plane : every_two_curves (fun K c =>
  bisector_determinant_symmetric c <> zero K ->
  number 2 <> zero K ->
  bisector_in_second_normal_plane c = zero K).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ jets s_bar 1 X_ ++ jets s_bar 1 Y_ ++ jets s_bar 1 Z_ ++ jets s_bar 1 W_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) (chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 3; var 5] (var 7) []) (homogeneous s_bar [var 9; var 11; var 13] (var 15) [])).
  pose (atoms := [num 2; var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14; var 15; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4; 4], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (bisector_determinant_symmetric c : expr)%formula (num 0 - var 7 ^ 3 * var 15 ^ 3)%formula (var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact HW. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Hw. }
  clear N. rename N4 into N.
  assert (E : value K l (bisector_in_second_normal_plane c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E22, definition of the bisector. *)
Theorem E22_bisector_equidistance : every_two_curves (fun K c =>
  bisector_determinant_symmetric c <> zero K ->
  number 2 <> zero K ->
  bisector_equidistance c = zero K).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ jets s_bar 1 X_ ++ jets s_bar 1 Y_ ++ jets s_bar 1 Z_ ++ jets s_bar 1 W_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) (chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 3; var 5] (var 7) []) (homogeneous s_bar [var 9; var 11; var 13] (var 15) [])).
  pose (atoms := [num 2; var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14; var 15; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 4; 4], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (bisector_determinant_symmetric c : expr)%formula (num 0 - var 7 ^ 3 * var 15 ^ 3)%formula (var 4 * var 5 * var 10 - var 3 * var 6 * var 10 + var 6 * var 10 * var 11 - var 2 * var 5 * var 12 + var 1 * var 6 * var 12 - var 6 * var 9 * var 12 - var 4 * var 10 * var 13 + var 2 * var 12 * var 13 + var 2 * var 3 * var 14 - var 1 * var 4 * var 14 + var 4 * var 9 * var 14 - var 2 * var 11 * var 14)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact HW. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Hw. }
  clear N. rename N4 into N.
  assert (E : value K l (bisector_equidistance c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
