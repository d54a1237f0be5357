(** Geometric Tools: curves and implicit surfaces: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import eberly_geometric_tools.
Import ListNotations.
Local Open Scope formula_scope.

(** GT1a, NURBSCurve.h. *)
Theorem GT1a_jet_1_velocity_in_dimension_2 : every_plane_curve (fun K c =>
  jet_1 c = chen_riesenfeld_cohen_2007.velocity c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := [var 5]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jet_1 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.velocity c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT1a, NURBSCurve.h. *)
Theorem GT1a_jet_1_velocity_in_dimension_3 : every_space_curve (fun K c =>
  jet_1 c = chen_riesenfeld_cohen_2007.velocity c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) []).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jet_1 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.velocity c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT1b, NURBSCurve.h. *)
Theorem GT1b_jet_2_acceleration_in_dimension_2 : every_plane_curve (fun K c =>
  jet_2 c = chen_riesenfeld_cohen_2007.acceleration c).
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
  assert (E : map (value K l) (jet_2 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.acceleration c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT1b, NURBSCurve.h. *)
Theorem GT1b_jet_2_acceleration_in_dimension_3 : every_space_curve (fun K c =>
  jet_2 c = chen_riesenfeld_cohen_2007.acceleration c).
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
  assert (E : map (value K l) (jet_2 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.acceleration c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT1c, NURBSCurve.h. *)
Theorem GT1c_jet_3_jerk_in_dimension_2 : every_plane_curve (fun K c =>
  jet_3 c = chen_riesenfeld_cohen_2007.jerk c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5] (var 9) []).
  pose (atoms := [var 9]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jet_3 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.jerk c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT1c, NURBSCurve.h. *)
Theorem GT1c_jet_3_jerk_in_dimension_3 : every_space_curve (fun K c =>
  jet_3 c = chen_riesenfeld_cohen_2007.jerk c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 13]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (jet_3 c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.jerk c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT2a, Vector2.h. *)
Theorem GT2a_dot_perp_f0 : every_plane_curve (fun K c =>
  dot_perp c = chen_riesenfeld_cohen_2007.f0 c).
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
  assert (E : value K l (dot_perp c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.f0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT2b, FrenetFrame.h, fails. *)
Theorem GT2b_tangent_by_arc_length_bending_along_the_clockwise_normal_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1 + t) [] in
  w c <> zero K /\
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K /\
  tangent_by_arc_length c <> bending_along_the_clockwise_normal c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 1 + num 4 * var 1 ^ 2 + num 4 * var 1 ^ 3 + var 1 ^ 4; num 2; var 1; num 2 + var 1]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 0; 0]); ([0; 2; 0], [8; 0; 0]); ([3; 0; 2; 1; 1], [0; 2; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 4). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (component 0 (tangent_by_arc_length c) - component 0 (bending_along_the_clockwise_normal c) : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  apply (different_vectors K 0); vm_cast_no_check U.
Qed.

(** GT2b, FrenetFrame.h. *)
Theorem GT2b_tangent_by_arc_length_bending_along_the_clockwise_normal_meant : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  tangent_by_arc_length c = vmul (number (-1)) (bending_along_the_clockwise_normal c)).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 2; var 2 ^ 2 + var 5 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (tangent_by_arc_length c : list expr)%formula = map (value K l) (vmul (number (-1)) (bending_along_the_clockwise_normal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT2c, FrenetFrame.h. *)
Theorem GT2c_normal_of_the_frame_normal : every_space_curve (fun K c =>
  normal_of_the_frame c = chen_riesenfeld_cohen_2007.normal c).
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
  assert (E : map (value K l) (normal_of_the_frame c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.normal c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
