(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** E1, eq. (1). *)
Theorem E1_velocity_velocity_shared_in_dimension_2 : every_plane_curve (fun K c =>
  velocity c = velocity_shared c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := [var 5]%formula : list expr).
  pose (known := [([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (velocity c : list expr)%formula = map (value K l) (velocity_shared c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E1, eq. (1). *)
Theorem E1_velocity_velocity_shared_in_dimension_3 : every_space_curve (fun K c =>
  velocity c = velocity_shared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (velocity c : list expr)%formula = map (value K l) (velocity_shared c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E2, eq. (2). *)
Theorem E2_acceleration_acceleration_shared_in_dimension_2 : every_plane_curve (fun K c =>
  acceleration c = acceleration_shared c).
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
  assert (E : map (value K l) (acceleration c : list expr)%formula = map (value K l) (acceleration_shared c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E2, eq. (2). *)
Theorem E2_acceleration_acceleration_shared_in_dimension_3 : every_space_curve (fun K c =>
  acceleration c = acceleration_shared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (acceleration c : list expr)%formula = map (value K l) (acceleration_shared c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E3, eq. (3). *)
Theorem E3_jerk_jerk_shared_in_dimension_2 : every_plane_curve (fun K c =>
  jerk c = jerk_shared c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [var 9]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jerk c : list expr)%formula = map (value K l) (jerk_shared c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E3, eq. (3). *)
Theorem E3_jerk_jerk_shared_in_dimension_3 : every_space_curve (fun K c =>
  jerk c = jerk_shared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 13]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jerk c : list expr)%formula = map (value K l) (jerk_shared c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E5, eq. (5). *)
Theorem E5_acceleration_acceleration_terms_in_dimension_2 : every_plane_curve (fun K c =>
  acceleration c = acceleration_terms c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (acceleration c : list expr)%formula = map (value K l) (acceleration_terms c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E5, eq. (5). *)
Theorem E5_acceleration_acceleration_terms_in_dimension_3 : every_space_curve (fun K c =>
  acceleration c = acceleration_terms c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (acceleration c : list expr)%formula = map (value K l) (acceleration_terms c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E5, eq. (5). *)
Theorem E5_jerk_jerk_terms_in_dimension_2 : every_plane_curve (fun K c =>
  jerk c = jerk_terms c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [var 9]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0]); ([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jerk c : list expr)%formula = map (value K l) (jerk_terms c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E5, eq. (5). *)
Theorem E5_jerk_jerk_terms_in_dimension_3 : every_space_curve (fun K c =>
  jerk c = jerk_terms c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 13]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0]); ([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jerk c : list expr)%formula = map (value K l) (jerk_terms c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3c, §3, before Remark 3.2, fails. *)
Theorem C3c_D1_D2_D3_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2; number 1 + t ^ 3] (number 1 + t) [] in
  w c <> zero K /\
  D1_D2_D3 c <> zero K.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([2; 2; 1], [0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (D1_D2_D3 c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  exact U.
Qed.

(** C3c, §3, before Remark 3.2. *)
Theorem C3c_D1_D2_D21 : every_space_curve (fun K c =>
  D1_D2_D21 c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (D1_D2_D21 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3c, §3, before Remark 3.2. *)
Theorem C3c_D21_D21_in_span_in_dimension_2 : every_plane_curve (fun K c =>
  D21 c = D21_in_span c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (D21 c : list expr)%formula = map (value K l) (D21_in_span c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3c, §3, before Remark 3.2. *)
Theorem C3c_D21_D21_in_span_in_dimension_3 : every_space_curve (fun K c =>
  D21 c = D21_in_span c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (D21 c : list expr)%formula = map (value K l) (D21_in_span c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3d, Remark 3.2. *)
Theorem C3d_acceleration_rest_plane : every_plane_curve (fun K c =>
  acceleration_rest_plane c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (acceleration_rest_plane c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3d, Remark 3.2. *)
Theorem C3d_acceleration_rest_space : every_space_curve (fun K c =>
  acceleration_rest_space c = [zero K; zero K; zero K]).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (acceleration_rest_space c : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3d, Remark 3.2. *)
Theorem C3d_jerk_rest : every_space_curve (fun K c =>
  jerk_rest c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 13]%formula : list expr).
  pose (known := [([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (jerk_rest c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3d, Remark 3.2. *)
Theorem C3d_f0_f1 : every_plane_curve (fun K c =>
  f0 c = number 1 / w c ^ 4 * f1 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (f0 c : expr)%formula = value K l (number 1 / w c ^ 4 * f1 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C3d, Remark 3.2. *)
Theorem C3d_velocity_acceleration_jerk_D1_D2_D3 : every_space_curve (fun K c =>
  velocity_acceleration_jerk c = number 1 / w c ^ 6 * D1_D2_D3 c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 13]%formula : list expr).
  pose (known := [([6], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (velocity_acceleration_jerk c : expr)%formula = value K l (number 1 / w c ^ 6 * D1_D2_D3 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
