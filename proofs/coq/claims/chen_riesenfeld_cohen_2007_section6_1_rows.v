(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** C6.1b, eq. (26). *)
Theorem C61b_normal_levelled_velocity_in_dimension_2 : every_plane_curve (fun K c =>
  normal_levelled c = velocity c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (normal_levelled c : list expr)%formula = map (value K l) (velocity c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.1b, eq. (26). *)
Theorem C61b_normal_levelled_velocity_in_dimension_3 : every_space_curve (fun K c =>
  normal_levelled c = velocity c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (normal_levelled c : list expr)%formula = map (value K l) (velocity c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.1b, eq. (26). *)
Theorem C61b_normal_height_levelled_normal_height_in_dimension_2 : every_plane_curve (fun K c =>
  normal_height_levelled c = normal_height c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (normal_height_levelled c : expr)%formula = value K l (normal_height c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.1b, eq. (26). *)
Theorem C61b_normal_height_levelled_normal_height_in_dimension_3 : every_space_curve (fun K c =>
  normal_height_levelled c = normal_height c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (normal_height_levelled c : expr)%formula = value K l (normal_height c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.1b, eq. (26). *)
Theorem C61b_middle_normal_levelled_middle_normal : every_two_curves (fun K c =>
  number 2 <> zero K ->
  middle_normal_levelled c = middle_normal c).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW P2.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 z_ ++ jets s 0 w_ ++ jets s_bar 0 X_ ++ jets s_bar 0 Y_ ++ jets s_bar 0 Z_ ++ jets s_bar 0 W_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0) (chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 2; var 3] (var 4) []) (homogeneous s_bar [var 5; var 6; var 7] (var 8) [])).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (middle_normal_levelled c : list expr)%formula = map (value K l) (middle_normal c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C6.1b, eq. (26). *)
Theorem C61b_middle_height_levelled_middle_height : every_two_curves (fun K c =>
  number 2 <> zero K ->
  middle_height_levelled c = middle_height c).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW P2.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 z_ ++ jets s 0 w_ ++ jets s_bar 0 X_ ++ jets s_bar 0 Y_ ++ jets s_bar 0 Z_ ++ jets s_bar 0 W_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0) (chain 5 0 ++ chain 6 0 ++ chain 7 0 ++ chain 8 0)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 2; var 3] (var 4) []) (homogeneous s_bar [var 5; var 6; var 7] (var 8) [])).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : value K l (middle_height_levelled c : expr)%formula = value K l (middle_height c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
