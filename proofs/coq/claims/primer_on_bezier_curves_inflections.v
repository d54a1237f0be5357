(** A Primer on Bézier Curves: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import primer_on_bezier_curves.
Import ListNotations.
Local Open Scope formula_scope.

(** PB4a, § Curve inflections. *)
Theorem PB4a_inflection_coefficient_2_second_turning : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  inflection_coefficient_2 c = number 1 / number 2 * second_turning c).
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
  assert (E : value K l (inflection_coefficient_2 c : expr)%formula = value K l (number 1 / number 2 * second_turning c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB4a, § Curve inflections. *)
Theorem PB4a_inflection_coefficient_1_turning : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  inflection_coefficient_1 c = turning c).
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
  assert (E : value K l (inflection_coefficient_1 c : expr)%formula = value K l (turning c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB4a, § Curve inflections. *)
Theorem PB4a_inflection_coefficient_0_f0 : every_polynomial_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  inflection_coefficient_0 c = chen_riesenfeld_cohen_2007.f0 c).
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
  assert (E : value K l (inflection_coefficient_0 c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.f0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB4b, § Curve inflections, fails. *)
Theorem PB4b_aligned_t2_printed_second_turning_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1) [] in
  w c <> zero K /\
  aligned_t2_printed c <> number 1 / number 36 * chord_squared c * second_turning c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 2; num 3; num 3 + num 6 * var 1 + num 8 * var 1 ^ 2]%formula : list expr).
  pose (known := [([], []); ([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([2; 2], [0; 0]); ([1; 0; 1], [0; 1; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 2). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (aligned_t2_printed c - number 1 / number 36 * chord_squared c * second_turning c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  apply different; vm_cast_no_check U.
Qed.

(** PB4b, § Curve inflections. *)
Theorem PB4b_aligned_t2_second_turning : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  aligned_t2 c = number 1 / number 36 * chord_squared c * second_turning c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([2; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : value K l (aligned_t2 c : expr)%formula = value K l (number 1 / number 36 * chord_squared c * second_turning c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB4b, § Curve inflections. *)
Theorem PB4b_aligned_t2_slip_first_term_twice : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  aligned_t2_slip c = first_term_twice c).
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
  assert (E : value K l (aligned_t2_slip c : expr)%formula = value K l (first_term_twice c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB4c, § Curve inflections. *)
Theorem PB4c_aligned_t1_turning : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  aligned_t1 c = number 1 / number 18 * chord_squared c * turning c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : value K l (aligned_t1 c : expr)%formula = value K l (number 1 / number 18 * chord_squared c * turning c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB4c, § Curve inflections. *)
Theorem PB4c_aligned_t0_f0 : every_polynomial_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  aligned_t0 c = number 1 / number 18 * chord_squared c * chen_riesenfeld_cohen_2007.f0 c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (number 1) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : value K l (aligned_t0 c : expr)%formula = value K l (number 1 / number 18 * chord_squared c * chen_riesenfeld_cohen_2007.f0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PB4d, § Curve inflections. *)
Theorem PB4d_inflection_discriminant_cusp_condition : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  number 3 <> zero K ->
  inflection_discriminant c = number 1 / number 324 * chord_squared c ^ 2 * cusp_condition c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P2 P3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2; num 3]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0]); ([0; 1], [0; 0]); ([2; 4], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P3. }
  clear N. rename N2 into N.
  assert (E : value K l (inflection_discriminant c : expr)%formula = value K l (number 1 / number 324 * chord_squared c ^ 2 * cusp_condition c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
