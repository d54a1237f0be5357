(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** E17, eq. (17). *)
Theorem E17_torsion_torsion_by_frenet : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  torsion c = torsion_by_frenet c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([1; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_squared c : expr)%formula (var 13 ^ 4)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : value K l (torsion c : expr)%formula = value K l (torsion_by_frenet c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.4a, §5.4, definition. *)
Theorem C54a_rectifying_geodesic : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  rectifying_geodesic c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_squared c : expr)%formula (var 13 ^ 4)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : value K l (rectifying_geodesic c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.6a, §5.6, definition. *)
Theorem C56a_focal_development : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  focal_development c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 13; var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([10; 1], [0; 0]); ([4; 0], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (E : value K l (focal_development c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** O5, ours. *)
Theorem O5_D1_x_D2_binormal_form : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_x_D2 c = vmul (w c) (binormal_form c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (D1_x_D2 c : list expr)%formula = map (value K l) (vmul (w c) (binormal_form c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** O5, ours. *)
Theorem O5_D1_x_D2_squared_binormal_form_squared : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_x_D2_squared c = w c ^ 2 * binormal_form_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (D1_x_D2_squared c : expr)%formula = value K l (w c ^ 2 * binormal_form_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** O5, ours. *)
Theorem O5_space_critical_curvature_reduced_space_critical_curvature : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  space_critical_curvature_reduced c = w c ^ 13 * space_critical_curvature c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (space_critical_curvature_reduced c : expr)%formula = value K l (w c ^ 13 * space_critical_curvature c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** O5, ours. *)
Theorem O5_space_curvature_squared_derivative_space_critical_curvature : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  space_curvature_squared_derivative c = number 2 / speed_squared c ^ 4 * space_critical_curvature c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([3], [0]); ([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_squared c : expr)%formula (var 13 ^ 4)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (E : value K l (space_curvature_squared_derivative c : expr)%formula = value K l (number 2 / speed_squared c ^ 4 * space_critical_curvature c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5b, §5.5. *)
Theorem C55b_psi_along_binormal_psi_numerator : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  psi_along_binormal c = number 1 / binormal_squared c * psi_numerator c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2]%formula : list expr).
  pose (known := [([2], [0]); ([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (E : value K l (psi_along_binormal c : expr)%formula = value K l (number 1 / binormal_squared c * psi_numerator c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.4a, §5.4. *)
Theorem C54a_rectifying_surface_normal_normal : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  rectifying_surface_normal c = vmul (number (-1) / speed_squared c) (normal c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_squared c : expr)%formula (var 13 ^ 4)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (rectifying_surface_normal c : list expr)%formula = map (value K l) (vmul (number (-1) / speed_squared c) (normal c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
