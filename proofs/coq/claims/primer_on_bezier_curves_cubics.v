(** A Primer on Bézier Curves: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import primer_on_bezier_curves.
Import ListNotations.
Local Open Scope formula_scope.

(** PB1a, § Derivatives. *)
Theorem PB1a_derivative_weight_1_velocity_in_dimension_2 : every_polynomial_plane_curve (fun K c =>
  number 3 <> zero K ->
  derivative_weight_1 c = chen_riesenfeld_cohen_2007.velocity c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ P3.
  pose (l := jets s 1 x_ ++ jets s 1 y_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (number 1) []).
  pose (atoms := [num 3]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (derivative_weight_1 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.velocity c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1a, § Derivatives. *)
Theorem PB1a_derivative_weight_1_velocity_in_dimension_3 : every_polynomial_space_curve (fun K c =>
  number 3 <> zero K ->
  derivative_weight_1 c = chen_riesenfeld_cohen_2007.velocity c).
Proof.
  apply polynomial_space_by_position; intros K x_ y_ z_ P3.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (number 1) []).
  pose (atoms := [num 3]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (derivative_weight_1 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.velocity c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1a, § Derivatives. *)
Theorem PB1a_derivative_weight_3_velocity_at_the_end_in_dimension_2 : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  derivative_weight_3 c = velocity_at_the_end c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (derivative_weight_3 c : list expr)%formula = map (value K l) (velocity_at_the_end c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1a, § Derivatives. *)
Theorem PB1a_derivative_weight_3_velocity_at_the_end_in_dimension_3 : every_space_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  derivative_weight_3 c = velocity_at_the_end c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (derivative_weight_3 c : list expr)%formula = map (value K l) (velocity_at_the_end c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1b, § Derivatives. *)
Theorem PB1b_second_derivative_weight_1_acceleration_in_dimension_2 : every_polynomial_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  second_derivative_weight_1 c = chen_riesenfeld_cohen_2007.acceleration c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ P3 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (number 1) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (second_derivative_weight_1 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.acceleration c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1b, § Derivatives. *)
Theorem PB1b_second_derivative_weight_1_acceleration_in_dimension_3 : every_polynomial_space_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  second_derivative_weight_1 c = chen_riesenfeld_cohen_2007.acceleration c).
Proof.
  apply polynomial_space_by_position; intros K x_ y_ z_ P3 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (number 1) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (second_derivative_weight_1 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.acceleration c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1b, § Derivatives. *)
Theorem PB1b_second_derivative_weight_2_acceleration_at_the_end_in_dimension_2 : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  second_derivative_weight_2 c = acceleration_at_the_end c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (second_derivative_weight_2 c : list expr)%formula = map (value K l) (acceleration_at_the_end c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1b, § Derivatives. *)
Theorem PB1b_second_derivative_weight_2_acceleration_at_the_end_in_dimension_3 : every_space_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  second_derivative_weight_2 c = acceleration_at_the_end c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (second_derivative_weight_2 c : list expr)%formula = map (value K l) (acceleration_at_the_end c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1c, § Derivatives. *)
Theorem PB1c_third_derivative_weight_jerk_in_dimension_2 : every_polynomial_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  third_derivative_weight c = chen_riesenfeld_cohen_2007.jerk c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (number 1) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (third_derivative_weight c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.jerk c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1c, § Derivatives. *)
Theorem PB1c_third_derivative_weight_jerk_in_dimension_3 : every_polynomial_space_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  third_derivative_weight c = chen_riesenfeld_cohen_2007.jerk c).
Proof.
  apply polynomial_space_by_position; intros K x_ y_ z_ P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (number 1) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (third_derivative_weight c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.jerk c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB1d, § Derivatives, fails. *)
Theorem PB1d_third_derivative_in_dimension_2_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t ^ 2; number 1 + t ^ 3] (number 1) [] in
  w c <> zero K /\
  third_derivative c <> [zero K; zero K].
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([], []); ([1; 1], [0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 1 (third_derivative c) - number 0 : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  apply (different_vectors K 1); vm_cast_no_check U.
Qed.

(** PB1d, § Derivatives, fails. *)
Theorem PB1d_third_derivative_in_dimension_3_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2; number 1 + t ^ 3] (number 1) [] in
  w c <> zero K /\
  third_derivative c <> [zero K; zero K; zero K].
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([], []); ([1; 1], [0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 2 (third_derivative c) - number 0 : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  apply (different_vectors K 2); vm_cast_no_check U.
Qed.

(** PB2a, § Finding extremities: root finding. *)
Theorem PB2a_extremities_a_extremities_a_by_v_in_dimension_2 : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  extremities_a c = extremities_a_by_v c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P3 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (extremities_a c : list expr)%formula = map (value K l) (extremities_a_by_v c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB2a, § Finding extremities: root finding. *)
Theorem PB2a_extremities_a_extremities_a_by_v_in_dimension_3 : every_space_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  extremities_a c = extremities_a_by_v c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw P3 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (extremities_a c : list expr)%formula = map (value K l) (extremities_a_by_v c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB2b, § Finding extremities: root finding. *)
Theorem PB2b_extremities_a_by_v_jerk_in_dimension_2 : every_polynomial_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  extremities_a_by_v c = vmul (number 1 / number 2) (chen_riesenfeld_cohen_2007.jerk c)).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ P3 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (number 1) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (extremities_a_by_v c : list expr)%formula = map (value K l) (vmul (number 1 / number 2) (chen_riesenfeld_cohen_2007.jerk c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB2b, § Finding extremities: root finding. *)
Theorem PB2b_extremities_a_by_v_jerk_in_dimension_3 : every_polynomial_space_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  extremities_a_by_v c = vmul (number 1 / number 2) (chen_riesenfeld_cohen_2007.jerk c)).
Proof.
  apply polynomial_space_by_position; intros K x_ y_ z_ P3 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (number 1) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (extremities_a_by_v c : list expr)%formula = map (value K l) (vmul (number 1 / number 2) (chen_riesenfeld_cohen_2007.jerk c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB2c, § Finding extremities: root finding. *)
Theorem PB2c_extremities_b_second_derivative_weight_1_in_dimension_2 : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  extremities_b c = second_derivative_weight_1 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P3 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (extremities_b c : list expr)%formula = map (value K l) (second_derivative_weight_1 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB2c, § Finding extremities: root finding. *)
Theorem PB2c_extremities_b_second_derivative_weight_1_in_dimension_3 : every_space_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  extremities_b c = second_derivative_weight_1 c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw P3 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (extremities_b c : list expr)%formula = map (value K l) (second_derivative_weight_1 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB3a, § Lowering and elevating curve order. *)
Theorem PB3a_elevated_2_bezier_2_in_dimension_2 : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  elevated_2 c = bezier_2 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P3 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (elevated_2 c : list expr)%formula = map (value K l) (bezier_2 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB3a, § Lowering and elevating curve order. *)
Theorem PB3a_elevated_2_bezier_2_in_dimension_3 : every_space_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  elevated_2 c = bezier_2 c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw P3 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := [num 3; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P3. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (elevated_2 c : list expr)%formula = map (value K l) (bezier_2 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB3a, § Lowering and elevating curve order. *)
Theorem PB3a_elevated_3_bezier_3_in_dimension_2 : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  elevated_3 c = bezier_3 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P2 P3.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (elevated_3 c : list expr)%formula = map (value K l) (bezier_3 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB3a, § Lowering and elevating curve order. *)
Theorem PB3a_elevated_3_bezier_3_in_dimension_3 : every_space_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  elevated_3 c = bezier_3 c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw P2 P3.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (elevated_3 c : list expr)%formula = map (value K l) (bezier_3 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
