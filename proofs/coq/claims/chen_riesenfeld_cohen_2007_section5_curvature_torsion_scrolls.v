(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** C5.1a, §5.1. *)
Theorem C51a_curvature_vector_squared_space_curvature_squared : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  curvature_vector_squared c = space_curvature_squared c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (E : value K l (curvature_vector_squared c : expr)%formula = value K l (space_curvature_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.1a, eq. (16). *)
Theorem C51a_curvature_vector_radius_vector : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  curvature_vector c = vmul (space_curvature_squared c) (radius_vector c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2; var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (curvature_vector c : list expr)%formula = map (value K l) (vmul (space_curvature_squared c) (radius_vector c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.1a, §5.1, definition. *)
Theorem C51a_curvature_vector_by_definition_curvature_vector : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  curvature_vector_by_definition c = curvature_vector c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([2], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (curvature_vector_by_definition c : list expr)%formula = map (value K l) (curvature_vector c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.2a, eqs. (17), (18). *)
Theorem C52a_torsion_torsion_reduced : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  torsion c = torsion_reduced c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 13]%formula : list expr).
  pose (known := [([1], [0]); ([1; 8], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (torsion c : expr)%formula = value K l (torsion_reduced c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.3a, §5.3. *)
Theorem C53a_tangent_developable_tangent_developable_reduced : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  same_surface (tangent_developable c) (tangent_developable_reduced c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 10; var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([2; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (E1 : map (value K l) (cross (generator (tangent_developable c)) (generator (tangent_developable_reduced c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (tangent_developable c)) (vsub (directrix (tangent_developable_reduced c)) (directrix (tangent_developable c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (tangent_developable c)) (generator (tangent_developable c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (tangent_developable_reduced c)) (generator (tangent_developable_reduced c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (tangent_developable c))) (map (value K l) (generator (tangent_developable c))) (map (value K l) (directrix (tangent_developable_reduced c))) (map (value K l) (generator (tangent_developable_reduced c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (tangent_developable c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (tangent_developable_reduced c))) (conj eq_refl U2)) E1 E2).
Qed.

(** C5.3b, §5.3. *)
Theorem C53b_binormal_scroll_binormal_scroll_reduced : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  same_surface (binormal_scroll c) (binormal_scroll_reduced c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 10; var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([6; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (E1 : map (value K l) (cross (generator (binormal_scroll c)) (generator (binormal_scroll_reduced c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (binormal_scroll c)) (vsub (directrix (binormal_scroll_reduced c)) (directrix (binormal_scroll c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (binormal_scroll c)) (generator (binormal_scroll c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (binormal_scroll_reduced c)) (generator (binormal_scroll_reduced c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (binormal_scroll c))) (map (value K l) (generator (binormal_scroll c))) (map (value K l) (directrix (binormal_scroll_reduced c))) (map (value K l) (generator (binormal_scroll_reduced c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (binormal_scroll c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (binormal_scroll_reduced c))) (conj eq_refl U2)) E1 E2).
Qed.

(** C5.3c, §5.3. *)
Theorem C53c_normal_scroll_normal_scroll_reduced : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  same_surface (normal_scroll c) (normal_scroll_reduced c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 10; var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2; var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 1], [0; 0; 0]); ([10; 1; 1], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 2 atoms) known N (D1_squared c : expr)%formula (var 10 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2 + var 8 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N3 into N.
  assert (E1 : map (value K l) (cross (generator (normal_scroll c)) (generator (normal_scroll_reduced c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (normal_scroll c)) (vsub (directrix (normal_scroll_reduced c)) (directrix (normal_scroll c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (normal_scroll c)) (generator (normal_scroll c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (normal_scroll_reduced c)) (generator (normal_scroll_reduced c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (normal_scroll c))) (map (value K l) (generator (normal_scroll c))) (map (value K l) (directrix (normal_scroll_reduced c))) (map (value K l) (generator (normal_scroll_reduced c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (normal_scroll c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (normal_scroll_reduced c))) (conj eq_refl U2)) E1 E2).
Qed.
