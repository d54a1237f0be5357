(** Lifted forms: the lowest degrees, and why: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import lifted.
Import ListNotations.
Local Open Scope formula_scope.

(** L1, lifted forms. *)
Theorem L1_inflections_lifted_f2 : every_plane_curve (fun K c =>
  inflections_lifted c = chen_riesenfeld_cohen_2007.f2 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (inflections_lifted c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.f2 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L1, lifted forms. *)
Theorem L1_inflections_lifted_f0 : every_plane_curve (fun K c =>
  inflections_lifted c = w c ^ 3 * chen_riesenfeld_cohen_2007.f0 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (inflections_lifted c : expr)%formula = value K l (w c ^ 3 * chen_riesenfeld_cohen_2007.f0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L2, lifted forms. *)
Theorem L2_vertices_lifted_g0 : every_plane_curve (fun K c =>
  vertices_lifted c = number 2 * w c ^ 8 * chen_riesenfeld_cohen_2007.g0 c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (vertices_lifted c : expr)%formula = value K l (number 2 * w c ^ 8 * chen_riesenfeld_cohen_2007.g0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L2, lifted forms. *)
Theorem L2_g2_vertices_lifted : every_plane_curve (fun K c =>
  number 2 <> zero K ->
  chen_riesenfeld_cohen_2007.g2 c = number 1 / number 2 * w c * vertices_lifted c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : value K l (chen_riesenfeld_cohen_2007.g2 c : expr)%formula = value K l (number 1 / number 2 * w c * vertices_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L3, lifted forms. *)
Theorem L3_evolute_lifted_evolute : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  evolute_lifted c = chen_riesenfeld_cohen_2007.evolute c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 2; var 3 * var 5 - var 2 * var 6; var 7]%formula : list expr).
  pose (known := [([1; 1; 6], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - var 7 ^ 3)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (evolute_lifted c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.evolute c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L3, lifted forms. *)
Theorem L3_curvature_squared_lifted_curvature_squared : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  curvature_squared_lifted c = chen_riesenfeld_cohen_2007.curvature_squared c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2; var 7]%formula : list expr).
  pose (known := [([3; 12], [0; 0]); ([3; 0], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (curvature_squared_lifted c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.curvature_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L4, lifted forms. *)
Theorem L4_torsion_zeros_lifted_velocity_acceleration_jerk : every_space_curve (fun K c =>
  torsion_zeros_lifted c = w c ^ 4 * chen_riesenfeld_cohen_2007.velocity_acceleration_jerk c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (torsion_zeros_lifted c : expr)%formula = value K l (w c ^ 4 * chen_riesenfeld_cohen_2007.velocity_acceleration_jerk c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L4, lifted forms. *)
Theorem L4_D1_D2_D3_torsion_zeros_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_D2_D3 c = w c ^ 2 * torsion_zeros_lifted c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (chen_riesenfeld_cohen_2007.D1_D2_D3 c : expr)%formula = value K l (w c ^ 2 * torsion_zeros_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L5, lifted forms. *)
Theorem L5_torsion_lifted_torsion : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  torsion_lifted c = chen_riesenfeld_cohen_2007.torsion c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 13]%formula : list expr).
  pose (known := [([1; 6], [0; 0]); ([1; 0], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (torsion_lifted c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.torsion c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L6, lifted forms. *)
Theorem L6_focal_curve_lifted_focal_curve : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_D2_D3 c <> zero K ->
  number 2 <> zero K ->
  focal_curve_lifted c = chen_riesenfeld_cohen_2007.focal_curve c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12; var 13]%formula : list expr).
  pose (known := [([1; 1; 8], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (focal_curve_lifted c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.focal_curve c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L7, lifted forms. *)
Theorem L7_circle_centre_lifted_osculating_circle_centre : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  circle_centre_lifted c = chen_riesenfeld_cohen_2007.osculating_circle_centre c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [num 2; var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2; var 10]%formula : list expr).
  pose (known := [([1; 1; 9], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (circle_centre_lifted c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.osculating_circle_centre c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L8, lifted forms. *)
Theorem L8_binormal_lifted_binormal : every_space_curve (fun K c =>
  binormal_lifted c = vmul (w c ^ 3) (chen_riesenfeld_cohen_2007.binormal c)).
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
  assert (E : map (value K l) (binormal_lifted c : list expr)%formula = map (value K l) (vmul (w c ^ 3) (chen_riesenfeld_cohen_2007.binormal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L8, lifted forms. *)
Theorem L8_D1_x_D2_binormal_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_x_D2 c = vmul (w c) (binormal_lifted c)).
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
  assert (E : map (value K l) (chen_riesenfeld_cohen_2007.D1_x_D2 c : list expr)%formula = map (value K l) (vmul (w c) (binormal_lifted c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L9, lifted forms. *)
Theorem L9_space_critical_curvature_lifted_space_critical_curvature : every_space_curve (fun K c =>
  space_critical_curvature_lifted c = number 2 * w c ^ 11 * chen_riesenfeld_cohen_2007.space_critical_curvature c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (space_critical_curvature_lifted c : expr)%formula = value K l (number 2 * w c ^ 11 * chen_riesenfeld_cohen_2007.space_critical_curvature c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L9, lifted forms. *)
Theorem L9_space_curvature_squared_lifted_space_curvature_squared : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  space_curvature_squared_lifted c = chen_riesenfeld_cohen_2007.space_curvature_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2; var 10]%formula : list expr).
  pose (known := [([3; 12], [0; 0]); ([3; 0], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (space_curvature_squared_lifted c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.space_curvature_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L10, lifted forms. *)
Theorem L10_tangent_developable_tangent_developable_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  same_surface (chen_riesenfeld_cohen_2007.tangent_developable c) (tangent_developable_lifted c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := [var 2 ^ 2 + var 4 ^ 2 + var 6 ^ 2; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([1; 4], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 4 ^ 2 + var 6 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E1 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.tangent_developable c)) (generator (tangent_developable_lifted c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.tangent_developable c)) (vsub (directrix (tangent_developable_lifted c)) (directrix (chen_riesenfeld_cohen_2007.tangent_developable c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (chen_riesenfeld_cohen_2007.tangent_developable c)) (generator (chen_riesenfeld_cohen_2007.tangent_developable c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (tangent_developable_lifted c)) (generator (tangent_developable_lifted c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.tangent_developable c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.tangent_developable c))) (map (value K l) (directrix (tangent_developable_lifted c))) (map (value K l) (generator (tangent_developable_lifted c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (chen_riesenfeld_cohen_2007.tangent_developable c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (tangent_developable_lifted c))) (conj eq_refl U2)) E1 E2).
Qed.

(** L10, lifted forms. *)
Theorem L10_binormal_scroll_binormal_scroll_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  same_surface (chen_riesenfeld_cohen_2007.binormal_scroll c) (binormal_scroll_lifted c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2; var 10]%formula : list expr).
  pose (known := [([1], [0]); ([1; 6], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E1 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.binormal_scroll c)) (generator (binormal_scroll_lifted c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.binormal_scroll c)) (vsub (directrix (binormal_scroll_lifted c)) (directrix (chen_riesenfeld_cohen_2007.binormal_scroll c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (chen_riesenfeld_cohen_2007.binormal_scroll c)) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (binormal_scroll_lifted c)) (generator (binormal_scroll_lifted c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.binormal_scroll c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c))) (map (value K l) (directrix (binormal_scroll_lifted c))) (map (value K l) (generator (binormal_scroll_lifted c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (chen_riesenfeld_cohen_2007.binormal_scroll c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (binormal_scroll_lifted c))) (conj eq_refl U2)) E1 E2).
Qed.

(** L10, lifted forms. *)
Theorem L10_normal_scroll_normal_scroll_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  same_surface (chen_riesenfeld_cohen_2007.normal_scroll c) (normal_scroll_lifted c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2; num 2; var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2; var 10]%formula : list expr).
  pose (known := [([0; 1], [0; 0]); ([1; 2], [0; 0]); ([1; 0; 1], [0; 0; 0]); ([1; 0; 1; 10], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2) ^ 1)%formula (num 4 * var 3 ^ 2 + num 4 * var 6 ^ 2 + num 4 * var 9 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 5 * var 6 - num 2 * var 8 * var 9)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Hw. }
  clear N. rename N4 into N.
  assert (E1 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.normal_scroll c)) (generator (normal_scroll_lifted c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.normal_scroll c)) (vsub (directrix (normal_scroll_lifted c)) (directrix (chen_riesenfeld_cohen_2007.normal_scroll c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (chen_riesenfeld_cohen_2007.normal_scroll c)) (generator (chen_riesenfeld_cohen_2007.normal_scroll c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (normal_scroll_lifted c)) (generator (normal_scroll_lifted c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.normal_scroll c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.normal_scroll c))) (map (value K l) (directrix (normal_scroll_lifted c))) (map (value K l) (generator (normal_scroll_lifted c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (chen_riesenfeld_cohen_2007.normal_scroll c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (normal_scroll_lifted c))) (conj eq_refl U2)) E1 E2).
Qed.

(** L10, lifted forms. *)
Theorem L10_rectifying_developable_rectifying_developable_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  same_surface (chen_riesenfeld_cohen_2007.rectifying_developable c) (rectifying_developable_lifted c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; num 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2; var 13]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 2], [0; 0]); ([0; 0; 1], [0; 0; 0]); ([1; 0; 0], [0; 0; 1]); ([2; 0; 0; 10], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2) ^ 1)%formula (num 4 * var 3 ^ 2 + num 4 * var 7 ^ 2 + num 4 * var 11 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 6 * var 7 - num 2 * var 10 * var 11)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). exact Hw. }
  clear N. rename N4 into N.
  assert (E1 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.rectifying_developable c)) (generator (rectifying_developable_lifted c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.rectifying_developable c)) (vsub (directrix (rectifying_developable_lifted c)) (directrix (chen_riesenfeld_cohen_2007.rectifying_developable c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (chen_riesenfeld_cohen_2007.rectifying_developable c)) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (rectifying_developable_lifted c)) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.rectifying_developable c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.rectifying_developable c))) (map (value K l) (directrix (rectifying_developable_lifted c))) (map (value K l) (generator (rectifying_developable_lifted c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)))) (conj eq_refl U2)) E1 E2).
Qed.

(** L10, lifted forms. *)
Theorem L10_focal_surface_focal_surface_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  same_surface (chen_riesenfeld_cohen_2007.focal_surface c) (focal_surface_lifted c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2; num 2; var 10]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1; 9], [0; 0; 0]); ([1; 0; 0], [0; 0; 0]); ([1; 0; 6], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E1 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.focal_surface c)) (generator (focal_surface_lifted c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (chen_riesenfeld_cohen_2007.focal_surface c)) (vsub (directrix (focal_surface_lifted c)) (directrix (chen_riesenfeld_cohen_2007.focal_surface c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (chen_riesenfeld_cohen_2007.focal_surface c)) (generator (chen_riesenfeld_cohen_2007.focal_surface c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (focal_surface_lifted c)) (generator (focal_surface_lifted c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (chen_riesenfeld_cohen_2007.focal_surface c))) (map (value K l) (generator (chen_riesenfeld_cohen_2007.focal_surface c))) (map (value K l) (directrix (focal_surface_lifted c))) (map (value K l) (generator (focal_surface_lifted c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (chen_riesenfeld_cohen_2007.focal_surface c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (focal_surface_lifted c))) (conj eq_refl U2)) E1 E2).
Qed.
