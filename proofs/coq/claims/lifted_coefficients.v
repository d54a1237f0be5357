(** Lifted forms: the lowest degrees, and why: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import lifted.
Import ListNotations.
Local Open Scope formula_scope.

(** L2, ours. *)
Theorem L2_osculating_circle_coefficient_inflections_lifted : every_plane_curve (fun K c =>
  osculating_circle_coefficient c = number (-1) * w c ^ 3 * inflections_lifted c).
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
  assert (E : value K l (osculating_circle_coefficient c : expr)%formula = value K l (number (-1) * w c ^ 3 * inflections_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L5, ours. *)
Theorem L5_osculating_sphere_coefficient_torsion_zeros_lifted : every_space_curve (fun K c =>
  osculating_sphere_coefficient c = number (-1) * w c ^ 4 * torsion_zeros_lifted c).
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
  assert (E : value K l (osculating_sphere_coefficient c : expr)%formula = value K l (number (-1) * w c ^ 4 * torsion_zeros_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L6, ours. *)
Theorem L6_circle_sphere_coefficient_binormal_lifted_squared : every_space_curve (fun K c =>
  circle_sphere_coefficient c = w c ^ 3 * binormal_lifted_squared c).
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
  assert (E : value K l (circle_sphere_coefficient c : expr)%formula = value K l (w c ^ 3 * binormal_lifted_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L14, ours. *)
Theorem L14_bisector_sphere_coefficient_bisector_determinant_symmetric : every_two_curves (fun K c =>
  bisector_sphere_coefficient c = number (-1) * w (first c) * w (second c) * chen_riesenfeld_cohen_2007.bisector_determinant_symmetric c).
Proof.
  apply pair_by_position; intros K x_ y_ z_ w_ X_ Y_ Z_ W_ Hw HW.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ jets s_bar 1 X_ ++ jets s_bar 1 Y_ ++ jets s_bar 1 Z_ ++ jets s_bar 1 W_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1) (chain 9 1 ++ chain 11 1 ++ chain 13 1 ++ chain 15 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Pair (homogeneous s [var 1; var 3; var 5] (var 7) []) (homogeneous s_bar [var 9; var 11; var 13] (var 15) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (bisector_sphere_coefficient c : expr)%formula = value K l (number (-1) * w (first c) * w (second c) * chen_riesenfeld_cohen_2007.bisector_determinant_symmetric c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L8, ours. *)
Theorem L8_normal_lifted_D1_x_D2_x_D1 : every_space_curve (fun K c =>
  normal_lifted c = vmul (number 1 / w c) (chen_riesenfeld_cohen_2007.D1_x_D2_x_D1 c)).
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
  assert (E : map (value K l) (normal_lifted c : list expr)%formula = map (value K l) (vmul (number 1 / w c) (chen_riesenfeld_cohen_2007.D1_x_D2_x_D1 c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L15, ours. *)
Theorem L15_point_bisector_lifted_directrix_point_bisector_directrix_levelled : every_space_curve_with_point (fun K c =>
  dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) <> zero K ->
  number 2 <> zero K ->
  point_bisector_lifted_directrix c = chen_riesenfeld_cohen_2007.point_bisector_directrix_levelled c).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; var 7]%formula : list expr).
  pose (known := [([1; 1; 6], [0; 0; 0]); ([1; 0; 0], [0; 0; 0]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (dot (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) : expr)%formula (var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (point_bisector_lifted_directrix c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.point_bisector_directrix_levelled c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L15, ours. *)
Theorem L15_point_bisector_lifted_generator_point_bisector_generator_polynomial : every_space_curve_with_point (fun K c =>
  number 2 <> zero K ->
  number 2 * component 0 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c; ([number 2 * component 0 (tangent_plane_through_point c)] ++ vneg (components 1 4 (tangent_plane_through_point c)) ++ [number 0])]) <> zero K ->
  point_bisector_lifted_generator c = vmul (number (-1) / w c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c)).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw P2 D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2; num 2; var 7]%formula : list expr).
  pose (known := [([1; 1; 6], [0; 0; 0]); ([0; 0; 1], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (number 2 * component 0 (generalized_cross [conformal_lift c; vder (along c) (conformal_lift c); conformal_point c; ([number 2 * component 0 (tangent_plane_through_point c)] ++ vneg (components 1 4 (tangent_plane_through_point c)) ++ [number 0])]) : expr)%formula (num 2 * var 7 ^ 6)%formula (var 2 ^ 2 * var 3 ^ 2 - num 2 * var 1 * var 2 * var 3 * var 4 + var 1 ^ 2 * var 4 ^ 2 + var 2 ^ 2 * var 5 ^ 2 + var 4 ^ 2 * var 5 ^ 2 - num 2 * var 1 * var 2 * var 5 * var 6 - num 2 * var 3 * var 4 * var 5 * var 6 + var 1 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 6 ^ 2 + num 2 * var 2 * var 3 * var 4 * var 9 - num 2 * var 1 * var 4 ^ 2 * var 9 + num 2 * var 2 * var 5 * var 6 * var 9 - num 2 * var 1 * var 6 ^ 2 * var 9 + var 4 ^ 2 * var 9 ^ 2 + var 6 ^ 2 * var 9 ^ 2 - num 2 * var 2 ^ 2 * var 3 * var 10 + num 2 * var 1 * var 2 * var 4 * var 10 + num 2 * var 4 * var 5 * var 6 * var 10 - num 2 * var 3 * var 6 ^ 2 * var 10 - num 2 * var 2 * var 4 * var 9 * var 10 + var 2 ^ 2 * var 10 ^ 2 + var 6 ^ 2 * var 10 ^ 2 - num 2 * var 2 ^ 2 * var 5 * var 11 - num 2 * var 4 ^ 2 * var 5 * var 11 + num 2 * var 1 * var 2 * var 6 * var 11 + num 2 * var 3 * var 4 * var 6 * var 11 - num 2 * var 2 * var 6 * var 9 * var 11 - num 2 * var 4 * var 6 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 4 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (point_bisector_lifted_generator c : list expr)%formula = map (value K l) (vmul (number (-1) / w c) (chen_riesenfeld_cohen_2007.point_bisector_generator_polynomial c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** L15, ours. *)
Theorem L15_point_bisector_direct_lifted_directrix_direct_directrix : every_space_curve_with_point (fun K c =>
  chen_riesenfeld_cohen_2007.direct_determinant_z c <> zero K ->
  number 2 <> zero K ->
  point_bisector_direct_lifted_directrix c = chen_riesenfeld_cohen_2007.direct_directrix c).
Proof.
  apply space_point_by_position; intros K x_ y_ z_ w_ q1 q2 q3 Hq1 Hq2 Hq3 Hw H1 P2.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 z_ ++ jets s 1 w_ ++ [q1; q2; q3]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ chain 7 1 ++ constants [9; 10; 11]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3; var 5] (var 7) [var 9; var 10; var 11]).
  pose (atoms := [num 2; var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10; var 7]%formula : list expr).
  pose (known := [([1; 1; 4], [0; 0; 0]); ([1; 0; 0], [0; 0; 0]); ([0; 1; 4], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.direct_determinant_z c : expr)%formula (var 7 ^ 3)%formula (var 2 * var 3 - var 1 * var 4 + var 4 * var 9 - var 2 * var 10)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (point_bisector_direct_lifted_directrix c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.direct_directrix c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
