(** Pythagorean-hodograph curves: the hodograph lies on the light cone: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import demers_hodographs.
Import ListNotations.
Local Open Scope formula_scope.

(** PH8a, Two Points or a Circle. *)
Theorem PH8a_sandwich_real_part : every_space_curve (fun K c =>
  sandwich_real_part c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 z_ ++ jets s 0 w_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 2; var 3] (var 4) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (sandwich_real_part c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH8b, Two Points or a Circle. *)
Theorem PH8b_sandwich_squared_quaternion_squared : every_space_curve (fun K c =>
  sandwich_squared c = quaternion_squared c * quaternion_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 z_ ++ jets s 0 w_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 2; var 3] (var 4) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (sandwich_squared c : expr)%formula = value K l (quaternion_squared c * quaternion_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH8c, Two Points or a Circle. *)
Theorem PH8c_sandwich_vector_hopf_map : every_space_curve (fun K c =>
  sandwich_vector c = hopf_map c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 z_ ++ jets s 0 w_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 2; var 3] (var 4) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (sandwich_vector c : list expr)%formula = map (value K l) (hopf_map c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH8d, The Hodograph Lies on the Light Cone. *)
Theorem PH8d_turned_sandwich_sandwich_vector : every_space_curve_with 2 (fun K c =>
  turned_sandwich c = vmul (turning_squared c) (sandwich_vector c)).
Proof.
  apply space_with_by_position; intros K x_ y_ z_ w_ Hw a_ Ha_ b_ Hb_.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 z_ ++ jets s 0 w_ ++ [a_; b_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ constants [5; 6]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 2; var 3] (var 4) []) [var 5; var 6]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (turned_sandwich c : list expr)%formula = map (value K l) (vmul (turning_squared c) (sandwich_vector c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH8f, The Price of a Circle. *)
Theorem PH8f_quaternion_speed_change : every_space_curve (fun K c =>
  quaternion_speed_change c = zero K).
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
  assert (E : value K l (quaternion_speed_change c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
