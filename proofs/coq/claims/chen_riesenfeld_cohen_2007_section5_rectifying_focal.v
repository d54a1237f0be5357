(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** C5.4a, §5.4. *)
Theorem C54a_rectifying_developable_rectifying_developable_reduced : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  same_surface (rectifying_developable c) (rectifying_developable_reduced c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2; var 13]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 0; 8], [0; 0; 0]); ([0; 1; 4], [0; 0; 0]); ([1; 0; 0], [0; 1; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_squared c : expr)%formula (var 13 ^ 4)%formula (var 2 ^ 2 + var 6 ^ 2 + var 10 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E1 : map (value K l) (cross (generator (rectifying_developable c)) (generator (rectifying_developable_reduced c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (rectifying_developable c)) (vsub (directrix (rectifying_developable_reduced c)) (directrix (rectifying_developable c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (rectifying_developable c)) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (rectifying_developable_reduced c)) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c))) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (rectifying_developable c))) (map (value K l) (generator (rectifying_developable c))) (map (value K l) (directrix (rectifying_developable_reduced c))) (map (value K l) (generator (rectifying_developable_reduced c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (cross (vder (along c) (gamma c)) (vders (along c) 2 (gamma c)))) (conj eq_refl U2)) E1 E2).
Qed.

(** C5.4a, §5.4. *)
Theorem C54a_rectifying_plane : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  rectifying_plane c = zero K).
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
  assert (E : value K l (rectifying_plane c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.4a, §5.4, fails. *)
Theorem C54a_rectifying_along_tangent_torsion_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2; number 1 + t ^ 3] (number 1 + t) [] in
  w c <> zero K /\
  D1_squared c <> zero K /\
  binormal_form_squared c <> zero K /\
  rectifying_along_tangent c <> torsion c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; num 1 - var 1 ^ 2 + num 5 * var 1 ^ 4 + num 6 * var 1 ^ 5 + num 2 * var 1 ^ 6; num 2 + num 15 * var 1 ^ 2 + num 2 * var 1 ^ 3 + num 9 * var 1 ^ 4 + num 6 * var 1 ^ 5 + var 1 ^ 6; num 3; num 1 - num 4 * var 1 - num 8 * var 1 ^ 2 - num 4 * var 1 ^ 3 + num 9 * var 1 ^ 4 + num 12 * var 1 ^ 5 + num 4 * var 1 ^ 6]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 1], [0; 0; 0]); ([0; 2; 0; 1], [0; 0; 0; 0]); ([0; 2; 0; 1], [6; 0; 0; 0]); ([0; 1; 1; 0], [4; 0; 0; 0]); ([0; 0; 0; 0; 1; 1], [2; 0; 0; 1; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (D1_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H2 : value K l (binormal_form_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (rectifying_along_tangent c - torsion c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  split; [vm_cast_no_check H2|].
  apply different; vm_cast_no_check U.
Qed.

(** C5.4a, §5.4. *)
Theorem C54a_rectifying_along_tangent_torsion_both : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  rectifying_along_tangent c = speed_squared c * torsion c).
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
  assert (E : value K l (rectifying_along_tangent c : expr)%formula = value K l (speed_squared c * torsion c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.4a, §5.4. *)
Theorem C54a_rectifying_along_binormal_binormal_squared : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  rectifying_along_binormal c = number 1 / speed_squared c * binormal_squared c).
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
  assert (E : value K l (rectifying_along_binormal c : expr)%formula = value K l (number 1 / speed_squared c * binormal_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5a, §5.5. *)
Theorem C55a_psi_numerator_radius_logarithmic_derivative : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  number 2 <> zero K ->
  psi_numerator c = radius_logarithmic_derivative c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 P2.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : value K l (psi_numerator c : expr)%formula = value K l (radius_logarithmic_derivative c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E19, definition of the focal curve. *)
Theorem E19_focal_contact_1 : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_D2_D3 c <> zero K ->
  focal_contact_1 c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 H3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N1 into N.
  assert (E : value K l (focal_contact_1 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E19, definition of the focal curve. *)
Theorem E19_focal_contact_2 : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_D2_D3 c <> zero K ->
  focal_contact_2 c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 H3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N1 into N.
  assert (E : value K l (focal_contact_2 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E19, definition of the focal curve. *)
Theorem E19_focal_contact_3 : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_D2_D3 c <> zero K ->
  focal_contact_3 c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 H3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N1 into N.
  assert (E : value K l (focal_contact_3 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E19, eq. (19). *)
Theorem E19_focal_curve_by_arc_length_focal_curve : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_D2_D3 c <> zero K ->
  focal_curve_by_arc_length c = focal_curve c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 H3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0]); ([2], [0]); ([0; 1], [1; 0]); ([0; 1], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (focal_curve_by_arc_length c : list expr)%formula = map (value K l) (focal_curve c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5b, eq. (19), fails. *)
Theorem C55b_focal_binormal_squared_by_parameter_focal_binormal_squared_by_arc_length_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2; number 1 + t ^ 3] (number 1 + t) [] in
  w c <> zero K /\
  D1_squared c <> zero K /\
  binormal_form_squared c <> zero K /\
  D1_D2_D3 c <> zero K /\
  focal_binormal_squared_by_parameter c <> focal_binormal_squared_by_arc_length c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; num 1 - var 1 ^ 2 + num 5 * var 1 ^ 4 + num 6 * var 1 ^ 5 + num 2 * var 1 ^ 6; num 2 + num 15 * var 1 ^ 2 + num 2 * var 1 ^ 3 + num 9 * var 1 ^ 4 + num 6 * var 1 ^ 5 + var 1 ^ 6; num 3; num 1 - num 4 * var 1 - num 8 * var 1 ^ 2 - num 4 * var 1 ^ 3 + num 9 * var 1 ^ 4 + num 12 * var 1 ^ 5 + num 4 * var 1 ^ 6; num 0 - num 2 - num 7 * var 1 - num 21 * var 1 ^ 2 + var 1 ^ 3 + num 24 * var 1 ^ 4 + num 141 * var 1 ^ 5 + num 271 * var 1 ^ 6 + num 279 * var 1 ^ 7 + num 222 * var 1 ^ 8 + num 163 * var 1 ^ 9 + num 83 * var 1 ^ 10 + num 21 * var 1 ^ 11 + num 2 * var 1 ^ 12]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1; 1], [0; 0; 0]); ([0; 2; 0; 1], [0; 0; 0; 0]); ([2; 2; 0; 0; 1], [0; 0; 0; 0; 0]); ([0; 2; 0; 0; 1], [4; 0; 0; 0; 0]); ([0; 2; 0; 0; 0; 1; 2], [18; 0; 0; 0; 0; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2; number 1 + (var 1) ^ 3] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 6). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 12). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (D1_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H2 : value K l (binormal_form_squared c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H3 : value K l (D1_D2_D3 c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (focal_binormal_squared_by_parameter c - focal_binormal_squared_by_arc_length c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  split; [vm_cast_no_check H2|].
  split; [vm_cast_no_check H3|].
  apply different; vm_cast_no_check U.
Qed.

(** C5.5b, eq. (19). *)
Theorem C55b_focal_binormal_by_arc_length_focal_binormal : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_D2_D3 c <> zero K ->
  focal_binormal_by_arc_length c = focal_binormal c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 H3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N1 into N.
  assert (E : value K l (focal_binormal_by_arc_length c : expr)%formula = value K l (focal_binormal c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5b, §5.5. *)
Theorem C55b_focal_curve_by_arc_length_focal_curve_reduced : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  D1_D2_D3 c <> zero K ->
  focal_curve_by_arc_length c = focal_curve_reduced c).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2 H3.
  pose (l := jets s 3 x_ ++ jets s 3 y_ ++ jets s 3 z_ ++ jets s 3 w_).
  pose (r := of_parameters (chain 1 3 ++ chain 5 3 ++ chain 9 3 ++ chain 13 3) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 5; var 9] (var 13) []).
  pose (atoms := [var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2; var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12; var 13]%formula : list expr).
  pose (known := [([1], [0]); ([2], [0]); ([0; 1], [1; 0]); ([0; 1; 9], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 13 ^ 6)%formula (var 3 ^ 2 * var 6 ^ 2 - num 2 * var 2 * var 3 * var 6 * var 7 + var 2 ^ 2 * var 7 ^ 2 + var 3 ^ 2 * var 10 ^ 2 + var 7 ^ 2 * var 10 ^ 2 - num 2 * var 2 * var 3 * var 10 * var 11 - num 2 * var 6 * var 7 * var 10 * var 11 + var 2 ^ 2 * var 11 ^ 2 + var 6 ^ 2 * var 11 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (D1_D2_D3 c : expr)%formula (num 0 - var 13 ^ 6)%formula (var 4 * var 7 * var 10 - var 3 * var 8 * var 10 - var 4 * var 6 * var 11 + var 2 * var 8 * var 11 + var 3 * var 6 * var 12 - var 2 * var 7 * var 12)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H3]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (focal_curve_by_arc_length c : list expr)%formula = map (value K l) (focal_curve_reduced c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5c, §5.5. *)
Theorem C55c_circle_contact_1 : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  circle_contact_1 c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (E : value K l (circle_contact_1 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5c, §5.5. *)
Theorem C55c_circle_contact_2 : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  circle_contact_2 c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (E : value K l (circle_contact_2 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.5c, §5.5. *)
Theorem C55c_circle_contact_3 : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  circle_contact_3 c = zero K).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (E : value K l (circle_contact_3 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C5.6a, eqs. (20), (21). *)
Theorem C56a_focal_surface_focal_surface_reduced : every_space_curve (fun K c =>
  D1_squared c <> zero K ->
  binormal_form_squared c <> zero K ->
  same_surface (focal_surface c) (focal_surface_reduced c)).
Proof.
  apply space_by_position; intros K x_ y_ z_ w_ Hw H1 H2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 z_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ chain 10 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4; var 7] (var 10) []).
  pose (atoms := [var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2; var 10]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([1; 10], [0; 0]); ([0; 4], [0; 0]); ([1; 0], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (binormal_form_squared c : expr)%formula (var 10 ^ 6)%formula (var 3 ^ 2 * var 5 ^ 2 - num 2 * var 2 * var 3 * var 5 * var 6 + var 2 ^ 2 * var 6 ^ 2 + var 3 ^ 2 * var 8 ^ 2 + var 6 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 - num 2 * var 5 * var 6 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 5 ^ 2 * var 9 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H2]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E1 : map (value K l) (cross (generator (focal_surface c)) (generator (focal_surface_reduced c)) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (E2 : map (value K l) (cross (generator (focal_surface c)) (vsub (directrix (focal_surface_reduced c)) (directrix (focal_surface c))) : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U1 : value K l (dot (generator (focal_surface c)) (generator (focal_surface c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U2 : value K l (dot (generator (focal_surface_reduced c)) (generator (focal_surface_reduced c)) : expr) <> zero K).
  { apply (unit_nonzero K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check (one_surface K (map (value K l) (directrix (focal_surface c))) (map (value K l) (generator (focal_surface c))) (map (value K l) (directrix (focal_surface_reduced c))) (map (value K l) (generator (focal_surface_reduced c))) eq_refl eq_refl eq_refl eq_refl
    (ex_intro _ (map (value K l) (generator (focal_surface c))) (conj eq_refl U1))
    (ex_intro _ (map (value K l) (generator (focal_surface_reduced c))) (conj eq_refl U2)) E1 E2).
Qed.
