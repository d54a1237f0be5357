(** Parallel curves of cubic Béziers; Flattening quadratic Béziers: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require primer_on_bezier_curves.
From ExactSpline.formulas Require Import levien_parallel_curves.
Import ListNotations.
Local Open Scope formula_scope.

(** OC4a, Parallel curves of cubic Béziers. *)
Theorem OC4a_cusp_coefficient_0_f0 : every_polynomial_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  cusp_coefficient_0 c = number (-1) * chen_riesenfeld_cohen_2007.f0 c).
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
  assert (E : value K l (cusp_coefficient_0 c : expr)%formula = value K l (number (-1) * chen_riesenfeld_cohen_2007.f0 c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC4b, Parallel curves of cubic Béziers. *)
Theorem OC4b_cusp_coefficient_1_turning : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  cusp_coefficient_1 c = number (-1) * primer_on_bezier_curves.turning c).
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
  assert (E : value K l (cusp_coefficient_1 c : expr)%formula = value K l (number (-1) * primer_on_bezier_curves.turning c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC4c, Parallel curves of cubic Béziers. *)
Theorem OC4c_cusp_coefficient_2_second_turning : every_plane_curve (fun K c =>
  number 3 <> zero K ->
  number 2 <> zero K ->
  cusp_coefficient_2 c = number (-1) / number 2 * primer_on_bezier_curves.second_turning c).
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
  assert (E : value K l (cusp_coefficient_2 c : expr)%formula = value K l (number (-1) / number 2 * primer_on_bezier_curves.second_turning c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC4e, Parallel curves of cubic Béziers. *)
Theorem OC4e_cusps_on_both_sides_cusps_by_curvature : every_plane_curve_with 1 (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  cusps_on_both_sides c = chen_riesenfeld_cohen_2007.speed_squared c ^ 3 * cusps_by_curvature c).
Proof.
  apply plane_with_by_position; intros K x_ y_ w_ Hw delta_ Hdelta_ H1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_ ++ [delta_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ constants [10]%positive) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (homogeneous s [var 1; var 4] (var 7) []) [var 10]).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2]%formula : list expr).
  pose (known := [([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (E : value K l (cusps_on_both_sides c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.speed_squared c ^ 3 * cusps_by_curvature c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC5f, Flattening quadratic Béziers. *)
Theorem OC5f_basic_start_parabola_parameter : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  basic_start c = parabola_parameter c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (number 1) []).
  pose (atoms := [num 2; var 3 * var 5 - var 2 * var 6]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [1; 0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - num 1)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : value K l (basic_start c : expr)%formula = value K l (parabola_parameter c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC5a, Flattening quadratic Béziers. *)
Theorem OC5a_basic_curvature_squared_curvature_squared : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  dot (basic_direction c) (basic_direction c) * (basic_end c - basic_start c) ^ 2 <> zero K ->
  basic_curvature_squared c = chen_riesenfeld_cohen_2007.curvature_squared c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P2 D1.
  pose (l := jets s 2 x_ ++ jets s 2 y_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (number 1) []).
  pose (atoms := [num 2; var 3 * var 5 - var 2 * var 6; var 3 ^ 2 + var 6 ^ 2; var 2 ^ 2 + var 5 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [1; 0]); ([4; 2], [0; 0]); ([0; 0; 3], [4; 2; 0]); ([1; 0; 0], [0; 0; 0]); ([2; 2; 0], [0; 0; 0]); ([2; 0; 0; 3], [0; 2; 0; 0]); ([0; 0; 0; 3], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - num 1)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (dot (basic_direction c) (basic_direction c) * (basic_end c - basic_start c) ^ 2 : expr)%formula ((var 3 ^ 4 + num 2 * var 3 ^ 2 * var 6 ^ 2 + var 6 ^ 4) / (num 16 * var 3 ^ 2 * var 5 ^ 2 - num 32 * var 2 * var 3 * var 5 * var 6 + num 16 * var 2 ^ 2 * var 6 ^ 2))%formula (var 3 ^ 2 + var 6 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 3 atoms) known N (num 4 * (var 3 * var 5 - var 2 * var 6) ^ 2)%formula (num 4 * var 3 ^ 2 + num 4 * var 6 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 5 * var 6)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 3 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N4 into N.
  assert (E : value K l (basic_curvature_squared c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.curvature_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** OC5b, Flattening quadratic Béziers. *)
Theorem OC5b_basic_arc_length_squared_speed_squared : every_polynomial_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.f2 c <> zero K ->
  number 2 <> zero K ->
  dot (basic_direction c) (basic_direction c) * (basic_end c - basic_start c) ^ 2 <> zero K ->
  basic_arc_length_squared c = chen_riesenfeld_cohen_2007.speed_squared c).
Proof.
  apply polynomial_plane_by_position; intros K x_ y_ H1 P2 D1.
  pose (l := jets s 2 x_ ++ jets s 2 y_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (number 1) []).
  pose (atoms := [num 2; var 3 * var 5 - var 2 * var 6; var 3 ^ 2 + var 6 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [1; 0]); ([4; 2], [0; 0]); ([0; 0; 3], [4; 2; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.f2 c : expr)%formula (num 0 - num 1)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (dot (basic_direction c) (basic_direction c) * (basic_end c - basic_start c) ^ 2 : expr)%formula ((var 3 ^ 4 + num 2 * var 3 ^ 2 * var 6 ^ 2 + var 6 ^ 4) / (num 16 * var 3 ^ 2 * var 5 ^ 2 - num 32 * var 2 * var 3 * var 5 * var 6 + num 16 * var 2 ^ 2 * var 6 ^ 2))%formula (var 3 ^ 2 + var 6 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N3 into N.
  assert (E : value K l (basic_arc_length_squared c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.speed_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
