(** What is differential geometry: curves and surfaces: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require lifted.
From ExactSpline.formulas Require Import petrunin_zamora_barrera.
Import ListNotations.
Local Open Scope formula_scope.

(** PZ1a, ch. Curvature. *)
Theorem PZ1a_acceleration_on_velocity_in_dimension_2 : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  acceleration_on_velocity c = zero K).
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
  assert (E : value K l (acceleration_on_velocity c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1a, ch. Curvature. *)
Theorem PZ1a_acceleration_on_velocity_in_dimension_3 : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  acceleration_on_velocity c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [num 2; var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : value K l (acceleration_on_velocity c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1b, ch. Curvature. *)
Theorem PZ1b_acceleration_squared_space_curvature_squared : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  acceleration_squared c = chen_riesenfeld_cohen_2007.space_curvature_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [num 2; var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0]); ([0; 3], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : value K l (acceleration_squared c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.space_curvature_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1b, ch. Curvature. *)
Theorem PZ1b_acceleration_by_arc_length_curvature_vector_by_definition : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  acceleration_by_arc_length c = chen_riesenfeld_cohen_2007.curvature_vector_by_definition c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [num 2; var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (acceleration_by_arc_length c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.curvature_vector_by_definition c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1c, ch. Curvature. *)
Theorem PZ1c_indicatrix_speed_squared_acceleration_squared_in_dimension_2 : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  indicatrix_speed_squared c = chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2; num 2]%formula : list expr).
  pose (known := [([2], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (indicatrix_speed_squared c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1c, ch. Curvature. *)
Theorem PZ1c_indicatrix_speed_squared_acceleration_squared_in_dimension_3 : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  indicatrix_speed_squared c = chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2; num 2]%formula : list expr).
  pose (known := [([2], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (indicatrix_speed_squared c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.speed_squared c * acceleration_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1d, ch. Curvature. *)
Theorem PZ1d_curvature_squared_by_projection_acceleration_squared_in_dimension_2 : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  curvature_squared_by_projection c = acceleration_squared c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([2], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (curvature_squared_by_projection c : expr)%formula = value K l (acceleration_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1d, ch. Curvature. *)
Theorem PZ1d_curvature_squared_by_projection_acceleration_squared_in_dimension_3 : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  curvature_squared_by_projection c = acceleration_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2; num 2]%formula : list expr).
  pose (known := [([1], [0]); ([2], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (curvature_squared_by_projection c : expr)%formula = value K l (acceleration_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ1e, ch. Curvature. *)
Theorem PZ1e_curvature_squared_by_product_acceleration_squared : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  curvature_squared_by_product c = acceleration_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2; num 2]%formula : list expr).
  pose (known := [([3], [0]); ([0; 1], [0; 0]); ([2; 0], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : value K l (curvature_squared_by_product c : expr)%formula = value K l (acceleration_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ2a, ch. Torsion. *)
Theorem PZ2a_binormal_by_arc_length_binormal : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  binormal_by_arc_length c = vmul (number 1 / chen_riesenfeld_cohen_2007.speed_squared c) (chen_riesenfeld_cohen_2007.binormal c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [num 2; var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (binormal_by_arc_length c : list expr)%formula = map (value K l) (vmul (number 1 / chen_riesenfeld_cohen_2007.speed_squared c) (chen_riesenfeld_cohen_2007.binormal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ2b, ch. Torsion. *)
Theorem PZ2b_torsion_by_definition_torsion : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  torsion_by_definition c = chen_riesenfeld_cohen_2007.torsion c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([2; 1], [0; 0]); ([0; 0; 2], [0; 0; 0]); ([0; 1; 0], [0; 0; 2]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2) ^ 1)%formula (num 4 * var 3 ^ 2 + num 4 * var 7 ^ 2 + num 4 * var 11 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 6 * var 7 - num 2 * var 10 * var 11)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (E : value K l (torsion_by_definition c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.torsion c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ2c, ch. Torsion. *)
Theorem PZ2c_torsion_by_derivatives_torsion_by_definition : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  torsion_by_derivatives c = torsion_by_definition c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; num 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 2], [0; 0]); ([0; 0; 2], [0; 0; 0]); ([1; 0; 0], [0; 0; 2])] : list (list nat * list nat)).
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
  assert (E : value K l (torsion_by_derivatives c : expr)%formula = value K l (torsion_by_definition c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ2d, ch. Torsion. *)
Theorem PZ2d_frenet_equation_of_the_normal : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  frenet_equation_of_the_normal c = [zero K; zero K; zero K]).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([2; 1], [0; 0]); ([0; 0; 2], [0; 0; 0]); ([1; 1; 0], [0; 0; 3]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2) ^ 1)%formula (num 4 * var 3 ^ 2 + num 4 * var 7 ^ 2 + num 4 * var 11 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 6 * var 7 - num 2 * var 10 * var 11)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (frenet_equation_of_the_normal c : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ2e, ch. Torsion. *)
Theorem PZ2e_frenet_equation_of_the_binormal : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  frenet_equation_of_the_binormal c = [zero K; zero K; zero K]).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([2; 1], [0; 0]); ([0; 0; 2], [0; 0; 0]); ([1; 1; 0], [0; 0; 2]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2) ^ 1)%formula (num 4 * var 3 ^ 2 + num 4 * var 7 ^ 2 + num 4 * var 11 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 6 * var 7 - num 2 * var 10 * var 11)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (frenet_equation_of_the_binormal c : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ2f, ch. Torsion. *)
Theorem PZ2f_lancret_derivative : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  lancret_derivative c = [zero K; zero K; zero K]).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 4 x_ ++ jets s 4 y_ ++ jets s 4 z_ ++ jets s 4 w_).
  pose (r := of_parameters (chain 1 4 ++ chain 6 4 ++ chain 11 4 ++ chain 16 4) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 6; var 11] (var 16) []).
  pose (atoms := [var 3 ^ 2 * var 7 ^ 2 - num 2 * var 2 * var 3 * var 7 * var 8 + var 2 ^ 2 * var 8 ^ 2 + var 3 ^ 2 * var 12 ^ 2 + var 8 ^ 2 * var 12 ^ 2 - num 2 * var 2 * var 3 * var 12 * var 13 - num 2 * var 7 * var 8 * var 12 * var 13 + var 2 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 13 ^ 2; num 2; var 2 ^ 2 + var 7 ^ 2 + var 12 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 2], [0; 0]); ([0; 0; 2], [0; 0; 0]); ([1; 1; 0], [0; 0; 2]); ([1; 1; 0], [0; 0; 3])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (chen_riesenfeld_cohen_2007.binormal_form_squared c : expr)%formula (var 16 ^ 6)%formula (var 3 ^ 2 * var 7 ^ 2 - num 2 * var 2 * var 3 * var 7 * var 8 + var 2 ^ 2 * var 8 ^ 2 + var 3 ^ 2 * var 12 ^ 2 + var 8 ^ 2 * var 12 ^ 2 - num 2 * var 2 * var 3 * var 12 * var 13 - num 2 * var 7 * var 8 * var 12 * var 13 + var 2 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 13 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 ^ 2 * var 7 ^ 2 - num 2 * var 2 * var 3 * var 7 * var 8 + var 2 ^ 2 * var 8 ^ 2 + var 3 ^ 2 * var 12 ^ 2 + var 8 ^ 2 * var 12 ^ 2 - num 2 * var 2 * var 3 * var 12 * var 13 - num 2 * var 7 * var 8 * var 12 * var 13 + var 2 ^ 2 * var 13 ^ 2 + var 7 ^ 2 * var 13 ^ 2) ^ 1)%formula (num 4 * var 3 ^ 2 + num 4 * var 8 ^ 2 + num 4 * var 13 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 7 * var 8 - num 2 * var 12 * var 13)%formula (var 2 ^ 2 + var 7 ^ 2 + var 12 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (lancret_derivative c : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ2g, ch. Torsion. *)
Theorem PZ2g_lancret_vector_rectifying_generator_lifted : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  lancret_vector c = vmul (number 1 / (chen_riesenfeld_cohen_2007.D1_squared c * chen_riesenfeld_cohen_2007.binormal_form_squared c)) (lifted.rectifying_generator_lifted c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; num 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2; var 13]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 2], [0; 0]); ([0; 0; 2], [0; 0; 0]); ([1; 0; 1; 10], [0; 0; 0; 0])] : list (list nat * list nat)).
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
  assert (E : map (value K l) (lancret_vector c : list expr)%formula = map (value K l) (vmul (number 1 / (chen_riesenfeld_cohen_2007.D1_squared c * chen_riesenfeld_cohen_2007.binormal_form_squared c)) (lifted.rectifying_generator_lifted c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ3a, ch. Torsion. *)
Theorem PZ3a_sphere_centre_meant_focal_curve : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_D2_D3 c <> zero K ->
  number 2 <> zero K ->
  chen_riesenfeld_cohen_2007.speed_squared c ^ 2 <> zero K ->
  acceleration_squared c <> zero K ->
  sphere_centre_meant c = chen_riesenfeld_cohen_2007.focal_curve c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2 D1 D2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2; var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0]); ([0; 3], [0; 0]); ([0; 0; 1], [0; 3; 0]); ([0; 0; 1], [0; 0; 0]); ([1; 0; 1; 1], [0; 5; 0; 0]); ([0; 0; 0; 1], [0; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.speed_squared c ^ 2 : expr)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (acceleration_squared c : expr)%formula ((num 1) / (var 2 ^ 6 + num 3 * var 2 ^ 4 * var 6 ^ 2 + num 3 * var 2 ^ 2 * var 6 ^ 4 + var 6 ^ 6 + num 3 * var 2 ^ 4 * var 10 ^ 2 + num 6 * var 2 ^ 2 * var 6 ^ 2 * var 10 ^ 2 + num 3 * var 6 ^ 4 * var 10 ^ 2 + num 3 * var 2 ^ 2 * var 10 ^ 4 + num 3 * var 6 ^ 2 * var 10 ^ 4 + var 10 ^ 6))%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : map (value K l) (sphere_centre_meant c : list expr)%formula = map (value K l) (chen_riesenfeld_cohen_2007.focal_curve c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ3d, ch. Torsion. *)
Theorem PZ3d_spherical_identity_off_the_unit_sphere : every_space_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_D2_D3 c <> zero K ->
  number 2 <> zero K ->
  chen_riesenfeld_cohen_2007.speed_squared c ^ 2 <> zero K ->
  dot (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) <> zero K ->
  spherical_identity c = number 4 * acceleration_squared c ^ 3 * torsion_by_derivatives c ^ 2 * off_the_unit_sphere c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 P2 D1 D2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2; var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0]); ([0; 2], [0; 0]); ([0; 1], [0; 0]); ([0; 0; 1], [0; 0; 0]); ([0; 0; 1], [0; 3; 0]); ([1; 0; 1; 1], [0; 5; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (chen_riesenfeld_cohen_2007.speed_squared c ^ 2 : expr)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (dot (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) : expr)%formula (num 1)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D2]. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (O : value K l (acceleration_on_velocity c : expr)%formula = value K l (num 0)).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (NS : value K l (chen_riesenfeld_cohen_2007.speed_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (NB : value K l (acceleration_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (NT : value K l (torsion_by_derivatives c : expr)%formula <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms (([0; 0; 0; 1], [0; 0; 1; 0]) :: known) N). vm_cast_no_check (eq_refl true). }
  pose (x := fun (v : list expr) i => value K l (component i v)).
  pose (a := vder s (gamma c)).
  pose (k := acceleration_by_arc_length c).
  pose (b := value K l (der s (acceleration_squared c : expr))%formula).
  pose (t := value K l (torsion_by_derivatives c : expr)).
  vm_cast_no_check (radius_of_the_sphere K (x (gamma c) 0) (x (gamma c) 1) (x (gamma c) 2) (x a 0) (x a 1) (x a 2)
    (x k 0) (x k 1) (x k 2) b t P2 O NS NB NT).
Qed.
