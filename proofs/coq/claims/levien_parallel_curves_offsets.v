(** Parallel curves of cubic Béziers; Flattening quadratic Béziers: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
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
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 2] (var 3) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (root_velocity_squared c : expr)%formula = value K l (root_speed_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
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
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([3; 6], [0; 0]); ([2; 4], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 5 ^ 6 + num 2 * var 1 ^ 2 * var 3 ^ 2 * var 5 ^ 6 + var 3 ^ 4 * var 5 ^ 6)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (offset_curvature_printed c : expr)%formula = value K l (number (-1) * curvature_by_root c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC1c, Parallel curves of cubic Béziers. *)
Theorem OC1c_offset_velocity_in_code_offset_velocity : every_plane_curve_with 1 (fun K c =>
  root_speed c ^ 3 <> zero K ->
  offset_velocity_in_code c = offset_velocity c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3] (var 5) []) [var 7]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([3; 6], [0; 0]); ([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 5 ^ 6 + num 2 * var 1 ^ 2 * var 3 ^ 2 * var 5 ^ 6 + var 3 ^ 4 * var 5 ^ 6)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (offset_velocity_in_code c : list expr)%formula = map (value K l) (offset_velocity c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC1d, Parallel curves of cubic Béziers. *)
Theorem OC1d_offset_velocity_root_velocity : every_plane_curve_with 1 (fun K c =>
  root_speed c <> zero K ->
  offset_velocity c = vmul (cusp_function c / root_speed c ^ 3) (root_velocity c)).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3] (var 5) []) [var 7]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([3; 6], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c : expr)%formula (var 5 ^ 2)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (offset_velocity c : list expr)%formula = map (value K l) (vmul (cusp_function c / root_speed c ^ 3) (root_velocity c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC1e, Parallel curves of cubic Béziers, fails. *)
Theorem OC1e_offset_velocity_velocity_less_curvature_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := Accompanied (rational_curve s [t; t ^ 2] (number 1) []) [number 2] in
  w c <> zero K /\
  offset_velocity c <> velocity_less_curvature c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [var 1; num 1 + var 1 ^ 2; num 2; num 0 - num 1 + var 1; num 1 + var 1]%formula : list expr).
  pose (known := [([], []); ([2; 1], [0; 0]); ([6; 3], [0; 0]); ([0; 0; 3; 1; 1], [0; 2; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (Accompanied (rational_curve s [(var 1); (var 1) ^ 2] (number 1) []) [number 2])%formula : accompanied expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (offset_velocity c) - component 0 (velocity_less_curvature c) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  apply (different_vectors K 0); vm_cast_no_check U.
Qed.

(** OC1e, Parallel curves of cubic Béziers. *)
Theorem OC1e_offset_velocity_velocity_plus_curvature : every_plane_curve_with 1 (fun K c =>
  root_speed c <> zero K ->
  offset_velocity c = velocity_plus_curvature c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3] (var 5) []) [var 7]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([3; 6], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c : expr)%formula (var 5 ^ 2)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (offset_velocity c : list expr)%formula = map (value K l) (velocity_plus_curvature c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC1f, Parallel curves of cubic Béziers. *)
Theorem OC1f_velocity_plus_curvature_offset_velocity_in_code : every_plane_curve_with 1 (fun K c =>
  root_speed c ^ 3 <> zero K ->
  velocity_plus_curvature c = offset_velocity_in_code c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3] (var 5) []) [var 7]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([3; 6], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 5 ^ 6 + num 2 * var 1 ^ 2 * var 3 ^ 2 * var 5 ^ 6 + var 3 ^ 4 * var 5 ^ 6)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (velocity_plus_curvature c : list expr)%formula = map (value K l) (offset_velocity_in_code c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC2a, Parallel curves of cubic Béziers. *)
Theorem OC2a_offset_distance_squared_distance_squared : every_plane_curve_with 1 (fun K c =>
  root_speed c <> zero K ->
  offset_distance_squared c = distance_squared c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ constants [4]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 2] (var 3) []) [var 4]).
  pose (atoms := [var 1 ^ 2 + var 2 ^ 2; var 3]%formula : list expr).
  pose (known := [([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c : expr)%formula (var 3 ^ 2)%formula (var 1 ^ 2 + var 2 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (offset_distance_squared c : expr)%formula = value K l (distance_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC2b, Parallel curves of cubic Béziers. *)
Theorem OC2b_offset_step_on_velocity : every_plane_curve_with 1 (fun K c =>
  root_speed c <> zero K ->
  offset_step_on_velocity c = zero K).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ constants [4]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 2] (var 3) []) [var 4]).
  pose (atoms := [var 1 ^ 2 + var 2 ^ 2; var 3]%formula : list expr).
  pose (known := [([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c : expr)%formula (var 3 ^ 2)%formula (var 1 ^ 2 + var 2 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (offset_step_on_velocity c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC2d, Cleaner parallel curves with Euler spirals. *)
Theorem OC2d_curvature_of_the_parallel_curvature_over_shrinking : every_plane_curve_with 1 (fun K c =>
  root_speed c <> zero K ->
  (shrinking c * root_speed c) ^ 3 <> zero K ->
  curvature_of_the_parallel c = curvature_over_shrinking c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1 D2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ constants [10]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 4] (var 7) []) [var 10]).
  pose (atoms := [var 1 ^ 2 + var 4 ^ 2; var 7; var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2 + num 2 * var 2 * var 4 * var 10 - num 2 * var 1 * var 5 * var 10]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([3; 6], [0; 0]); ([3; 0], [0; 0]); ([0; 0; 3], [3; 0; 0]); ([0; 0; 1], [2; 2; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c : expr)%formula (var 7 ^ 2)%formula (var 1 ^ 2 + var 4 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N ((shrinking c * root_speed c) ^ 3 : expr)%formula ((var 1 ^ 8 * var 7 ^ 4 + num 4 * var 1 ^ 6 * var 4 ^ 2 * var 7 ^ 4 + num 6 * var 1 ^ 4 * var 4 ^ 4 * var 7 ^ 4 + num 4 * var 1 ^ 2 * var 4 ^ 6 * var 7 ^ 4 + var 4 ^ 8 * var 7 ^ 4 + num 4 * var 1 ^ 4 * var 2 * var 4 * var 7 ^ 2 * var 10 + num 8 * var 1 ^ 2 * var 2 * var 4 ^ 3 * var 7 ^ 2 * var 10 + num 4 * var 2 * var 4 ^ 5 * var 7 ^ 2 * var 10 - num 4 * var 1 ^ 5 * var 5 * var 7 ^ 2 * var 10 - num 8 * var 1 ^ 3 * var 4 ^ 2 * var 5 * var 7 ^ 2 * var 10 - num 4 * var 1 * var 4 ^ 4 * var 5 * var 7 ^ 2 * var 10 + num 4 * var 2 ^ 2 * var 4 ^ 2 * var 10 ^ 2 - num 8 * var 1 * var 2 * var 4 * var 5 * var 10 ^ 2 + num 4 * var 1 ^ 2 * var 5 ^ 2 * var 10 ^ 2) / (var 1 ^ 6 + num 3 * var 1 ^ 4 * var 4 ^ 2 + num 3 * var 1 ^ 2 * var 4 ^ 4 + var 4 ^ 6))%formula (var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2 + num 2 * var 2 * var 4 * var 10 - num 2 * var 1 * var 5 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N3 into N.
  assert (E : value K l (curvature_of_the_parallel c : expr)%formula = value K l (curvature_over_shrinking c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC2e, Cleaner parallel curves with Euler spirals. *)
Theorem OC2e_curvature_change_of_the_parallel_curvature_change : every_plane_curve_with 1 (fun K c =>
  root_speed c ^ 3 <> zero K ->
  shrinking c <> zero K ->
  curvature_change_of_the_parallel c = number 1 / shrinking c ^ 2 * curvature_change c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1 D2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ constants [10]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 4] (var 7) []) [var 10]).
  pose (atoms := [var 1 ^ 2 + var 4 ^ 2; var 7; var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2 + num 2 * var 2 * var 4 * var 10 - num 2 * var 1 * var 5 * var 10]%formula : list expr).
  pose (known := [([3; 6], [0; 0]); ([2; 2], [0; 0]); ([0; 0; 1], [2; 2; 0]); ([0; 0; 2], [4; 4; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 7 ^ 6 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 6 + var 4 ^ 4 * var 7 ^ 6)%formula (var 1 ^ 2 + var 4 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (shrinking c : expr)%formula ((num 1) / (var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2))%formula (var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2 + num 2 * var 2 * var 4 * var 10 - num 2 * var 1 * var 5 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N3 into N.
  assert (E : value K l (curvature_change_of_the_parallel c : expr)%formula = value K l (number 1 / shrinking c ^ 2 * curvature_change c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC2f, Cleaner parallel curves with Euler spirals. *)
Theorem OC2f_radii_less_distance : every_plane_curve_with 1 (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  root_speed c ^ 3 <> zero K ->
  shrinking c <> zero K ->
  curvature_over_shrinking c <> zero K ->
  radii_less_distance c = zero K).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ H1 P2 D1 D2 D3.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ constants [10]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 4] (var 7) []) [var 10]).
  pose (atoms := [var 1 ^ 2 + var 4 ^ 2; var 7; var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2 + num 2 * var 2 * var 4 * var 10 - num 2 * var 1 * var 5 * var 10; var 2 * var 4 - var 1 * var 5; num 2]%formula : list expr).
  pose (known := [([3; 6], [0; 0]); ([2; 2], [0; 0]); ([0; 0; 1], [2; 2; 0]); ([0; 0; 1], [0; 0; 0]); ([0; 0; 0; 1; 1], [0; 0; 1; 0; 0]); ([0; 0; 0; 1; 1], [2; 2; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 7 ^ 6 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 6 + var 4 ^ 4 * var 7 ^ 6)%formula (var 1 ^ 2 + var 4 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (shrinking c : expr)%formula ((num 1) / (var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2))%formula (var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2 + num 2 * var 2 * var 4 * var 10 - num 2 * var 1 * var 5 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (curvature_over_shrinking c : expr)%formula ((num 2) / (var 1 ^ 4 * var 7 ^ 2 + num 2 * var 1 ^ 2 * var 4 ^ 2 * var 7 ^ 2 + var 4 ^ 4 * var 7 ^ 2 + num 2 * var 2 * var 4 * var 10 - num 2 * var 1 * var 5 * var 10))%formula (var 2 * var 4 - var 1 * var 5)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D3]. }
  clear N. rename N4 into N.
  assert (N5 : all_nonzero K l (firstn 5 atoms)).
  { apply (and_nonzero K l (firstn 4 atoms) (nth 4 atoms (num 0)) N). exact P2. }
  clear N. rename N5 into N.
  assert (E : value K l (radii_less_distance c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC2g, Parallel curves of cubic Béziers. *)
Theorem OC2g_velocities_of_both_sides : every_plane_curve_with 1 (fun K c =>
  root_speed c ^ 3 <> zero K ->
  velocities_of_both_sides c = [zero K; zero K]).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3] (var 5) []) [var 7]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([3; 6], [0; 0]); ([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c ^ 3 : expr)%formula (var 1 ^ 4 * var 5 ^ 6 + num 2 * var 1 ^ 2 * var 3 ^ 2 * var 5 ^ 6 + var 3 ^ 4 * var 5 ^ 6)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (velocities_of_both_sides c : list expr)%formula = map (value K l) ([num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC2h, Parallel curves of cubic Béziers. *)
Theorem OC2h_offset_step_derivative_root_velocity : every_plane_curve_with 1 (fun K c =>
  root_speed c <> zero K ->
  offset_step_derivative c = vmul (offset_curvature_printed c * distance c) (root_velocity c)).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ constants [7]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 3] (var 5) []) [var 7]).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2; var 5]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([3; 6], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c : expr)%formula (var 5 ^ 2)%formula (var 1 ^ 2 + var 3 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (offset_step_derivative c : list expr)%formula = map (value K l) (vmul (offset_curvature_printed c * distance c) (root_velocity c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC3a, Cleaner parallel curves with Euler spirals, fails. *)
Theorem OC3a_offset_step_derivative_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := Accompanied (rational_curve s [t; t ^ 2] (number 1) []) [number 2] in
  w c <> zero K /\
  offset_step_derivative c <> [zero K; zero K].
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [var 1; num 1 + var 1 ^ 2; num 2; num 0 - num 1 + var 1; num 1 + var 1]%formula : list expr).
  pose (known := [([], []); ([2; 1], [0; 0]); ([0; 0; 2; 1; 1], [0; 2; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (Accompanied (rational_curve s [(var 1); (var 1) ^ 2] (number 1) []) [number 2])%formula : accompanied expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (offset_step_derivative c) - number 0 : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  apply (different_vectors K 0); vm_cast_no_check U.
Qed.

(** OC3a, Cleaner parallel curves with Euler spirals. *)
Theorem OC3a_step_times_speed_step_numerator : every_plane_curve_with 1 (fun K c =>
  root_speed c <> zero K ->
  step_times_speed c = step_numerator c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ D1.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ constants [4]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 2] (var 3) []) [var 4]).
  pose (atoms := [var 1 ^ 2 + var 2 ^ 2; var 3]%formula : list expr).
  pose (known := [([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (root_speed c : expr)%formula (var 3 ^ 2)%formula (var 1 ^ 2 + var 2 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (step_times_speed c : list expr)%formula = map (value K l) (step_numerator c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
