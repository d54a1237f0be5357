(** Pythagorean-hodograph curves: the hodograph lies on the light cone: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import demers_hodographs.
Import ListNotations.
Local Open Scope formula_scope.

(** PH5c, The Hodograph Lies on the Light Cone. *)
Theorem PH5c_inversion_times_curve : every_plane_curve (fun K c =>
  dot (p c) (p c) <> zero K ->
  inversion_times_curve c = [zero K; zero K]).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw D1.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 w_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 2] (var 3) []).
  pose (atoms := [var 1 ^ 2 + var 2 ^ 2; var 3]%formula : list expr).
  pose (known := [([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (p c) (p c) : expr)%formula (var 3 ^ 2)%formula (var 1 ^ 2 + var 2 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (inversion_times_curve c : list expr)%formula = map (value K l) ([num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH6f, The Hodograph Lies on the Light Cone. *)
Theorem PH6f_functions_squared_quaternion_squared : every_space_curve (fun K c =>
  functions_squared c = quaternion_squared c).
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
  assert (E : value K l (functions_squared c : expr)%formula = value K l (quaternion_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH6g, The Hodograph Lies on the Light Cone. *)
Theorem PH6g_affine_image_affine_image_of_point : every_space_curve_with 4 (fun K c =>
  dot (complex_denominator c) (complex_denominator c) <> zero K ->
  affine_image c = affine_image_of_point c).
Proof.
  apply space_with_by_position; intros K x_ y_ z_ w_ Hw a_ Ha_ b_ Hb_ m_ Hm_ n_ Hn_ D1.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 z_ ++ jets s 0 w_ ++ [a_; b_; m_; n_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ chain 4 0 ++ constants [5; 6; 7; 8]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 2; var 3] (var 4) []) [var 5; var 6; var 7; var 8]).
  pose (atoms := [var 3 ^ 2 + num 1; var 4]%formula : list expr).
  pose (known := [([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (complex_denominator c) (complex_denominator c) : expr)%formula (var 4 ^ 2)%formula (var 3 ^ 2 + num 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (affine_image c : list expr)%formula = map (value K l) (affine_image_of_point c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH6a, The Hodograph Lies on the Light Cone. *)
Theorem PH6a_complex_velocity_complex_velocity_by_wronskian : every_space_curve (fun K c =>
  dot (complex_denominator c) (complex_denominator c) <> zero K ->
  complex_velocity c = complex_velocity_by_wronskian c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := [var 5 ^ 2 + num 1; var 7]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([2; 4], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (complex_denominator c) (complex_denominator c) : expr)%formula (var 7 ^ 2)%formula (var 5 ^ 2 + num 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (complex_velocity c : list expr)%formula = map (value K l) (complex_velocity_by_wronskian c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH6b, The Hodograph Lies on the Light Cone. *)
Theorem PH6b_complex_speed_squared_complex_speed_squared_by_wronskian : every_space_curve (fun K c =>
  dot (complex_denominator c) (complex_denominator c) <> zero K ->
  complex_speed_squared c = complex_speed_squared_by_wronskian c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := [var 5 ^ 2 + num 1; var 7]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([2; 4], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (complex_denominator c) (complex_denominator c) : expr)%formula (var 7 ^ 2)%formula (var 5 ^ 2 + num 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (complex_speed_squared c : expr)%formula = value K l (complex_speed_squared_by_wronskian c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH6c, The Hodograph Lies on the Light Cone. *)
Theorem PH6c_inverted_wronskian_complex_wronskian : every_space_curve (fun K c =>
  inverted_wronskian c = vmul (number (-1)) (complex_wronskian c)).
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
  assert (E : map (value K l) (inverted_wronskian c : list expr)%formula = map (value K l) (vmul (number (-1)) (complex_wronskian c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH6d, The Hodograph Lies on the Light Cone. *)
Theorem PH6d_affine_wronskian_turned_wronskian : every_space_curve_with 4 (fun K c =>
  affine_wronskian c = turned_wronskian c).
Proof.
  apply space_with_by_position; intros K x_ y_ z_ w_ Hw a_ Ha_ b_ Hb_ m_ Hm_ n_ Hn_.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [a_; b_; m_; n_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11; 12]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3; var 5] (var 7) []) [var 9; var 10; var 11; var 12]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (affine_wronskian c : list expr)%formula = map (value K l) (turned_wronskian c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH7a, The Hodograph Lies on the Light Cone. *)
Theorem PH7a_conformal_square : every_space_curve (fun K c =>
  conformal_square c = zero K).
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
  assert (E : value K l (conformal_square c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PH7b, The Hodograph Lies on the Light Cone. *)
Theorem PH7b_conformal_speed_squared_speed_squared : every_space_curve (fun K c =>
  conformal_speed_squared c = w c ^ 4 * chen_riesenfeld_cohen_2007.speed_squared c).
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
  assert (E : value K l (conformal_speed_squared c : expr)%formula = value K l (w c ^ 4 * chen_riesenfeld_cohen_2007.speed_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
