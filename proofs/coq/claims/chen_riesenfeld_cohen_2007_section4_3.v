(** Complexity Reduction for Symbolic Computation with Rational B-splines: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import chen_riesenfeld_cohen_2007.
Import ListNotations.
Local Open Scope formula_scope.

(** E12, eq. (12). *)
Theorem E12_evolute_contact_1 : every_plane_curve (fun K c =>
  f2 c <> zero K ->
  evolute_contact_1 c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 3 * var 5 - var 2 * var 6]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (f2 c : expr)%formula (num 0 - var 7 ^ 3)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (E : value K l (evolute_contact_1 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** E12, eq. (12). *)
Theorem E12_evolute_contact_2 : every_plane_curve (fun K c =>
  f2 c <> zero K ->
  evolute_contact_2 c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 3 * var 5 - var 2 * var 6]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (f2 c : expr)%formula (num 0 - var 7 ^ 3)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (E : value K l (evolute_contact_2 c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C4.3a, §4.3, eq. (12). *)
Theorem C43a_evolute_evolute_reduced : every_plane_curve (fun K c =>
  f2 c <> zero K ->
  evolute c = evolute_reduced c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 3 * var 5 - var 2 * var 6; var 7]%formula : list expr).
  pose (known := [([1], [0]); ([1; 6], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (f2 c : expr)%formula (num 0 - var 7 ^ 3)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (evolute c : list expr)%formula = map (value K l) (evolute_reduced c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C4.3c, §4.3, beside eq. (12), fails. *)
Theorem C43c_curvature_squared_curvature_squared_inverted_fails : forall (K : differential_field) (t : K),
  characteristic_zero K -> derivative K s t = one K ->
  let c := rational_curve s [t; t ^ 2] (number 1 + t) [] in
  w c <> zero K /\
  f2 c <> zero K /\
  curvature_squared c <> curvature_squared_inverted c.
Proof.
  intros K t Hz Ht.
  pose (l := [t]).
  assert (R : forall q, rules_hold K l q (explicit_rules q)) by exact (explicit_rules_hold K t Ht).
  pose (atoms := [num 1 + var 1; num 2; num 1 + num 4 * var 1 ^ 2 + num 4 * var 1 ^ 3 + var 1 ^ 4; num 5 + num 24 * var 1 + num 72 * var 1 ^ 2 + num 92 * var 1 ^ 3 + num 111 * var 1 ^ 4 + num 120 * var 1 ^ 5 + num 140 * var 1 ^ 6 + num 216 * var 1 ^ 7 + num 243 * var 1 ^ 8 + num 160 * var 1 ^ 9 + num 60 * var 1 ^ 10 + num 12 * var 1 ^ 11 + var 1 ^ 12; num 0 - num 3 - num 24 * var 1 - num 48 * var 1 ^ 2 - num 68 * var 1 ^ 3 - num 9 * var 1 ^ 4 + num 72 * var 1 ^ 5 + num 132 * var 1 ^ 6 + num 216 * var 1 ^ 7 + num 243 * var 1 ^ 8 + num 160 * var 1 ^ 9 + num 60 * var 1 ^ 10 + num 12 * var 1 ^ 11 + var 1 ^ 12]%formula : list expr).
  pose (known := [([1], [0]); ([0; 1], [0; 0]); ([0; 0; 3], [12; 0; 0]); ([0; 2; 0], [6; 0; 0]); ([0; 0; 0; 1; 1], [6; 2; 3; 0; 0])] : list (list nat * list nat)).
  pose (c := (rational_curve s [(var 1); (var 1) ^ 2] (number 1 + (var 1)) [])%formula : curve expr).
  assert (N : all_nonzero K l atoms).
  { repeat apply Forall_cons; try apply Forall_nil.
    - apply (explicit_nonzero K t Hz Ht 1). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 0). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 4). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 12). vm_cast_no_check (eq_refl true).
    - apply (explicit_nonzero K t Hz Ht 12). vm_cast_no_check (eq_refl true). }
  assert (H0 : value K l (w c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (H1 : value K l (f2 c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  assert (U : value K l (curvature_squared c - curvature_squared_inverted c : expr)%formula <> zero K).
  { apply (unit_nonzero K l explicit_rules R [] I atoms known N). vm_cast_no_check (eq_refl true). }
  split; [vm_cast_no_check H0|].
  split; [vm_cast_no_check H1|].
  apply different; vm_cast_no_check U.
Qed.

(** C4.3c, §4.3, beside eq. (12). *)
Theorem C43c_curvature_radius_squared_curvature_squared_inverted : every_plane_curve (fun K c =>
  f2 c <> zero K ->
  number 2 <> zero K ->
  curvature_radius_squared c = curvature_squared_inverted c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 2; var 3 * var 5 - var 2 * var 6; var 2 ^ 2 + var 5 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([2; 2], [0; 0]); ([0; 0; 3], [0; 0; 0]); ([0; 2; 0], [0; 0; 3]); ([0; 2; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (f2 c : expr)%formula (num 0 - var 7 ^ 3)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 * var 5 - var 2 * var 6) ^ 2)%formula (num 4 * var 3 ^ 2 + num 4 * var 6 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 5 * var 6)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (E : value K l (curvature_radius_squared c : expr)%formula = value K l (curvature_squared_inverted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** C4.3d, §4.3, footnote b. *)
Theorem C43d_evolute_by_frenet_evolute : every_plane_curve (fun K c =>
  f2 c <> zero K ->
  number 2 <> zero K ->
  evolute_by_frenet c = evolute c).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [num 2; var 3 * var 5 - var 2 * var 6; var 2 ^ 2 + var 5 ^ 2]%formula : list expr).
  pose (known := [([1], [0]); ([2; 2], [0; 0]); ([0; 0; 1], [0; 0; 0]); ([0; 0; 2], [0; 0; 0]); ([0; 0; 3], [0; 0; 0]); ([0; 2; 0], [0; 0; 3]); ([0; 1; 0], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (f2 c : expr)%formula (num 0 - var 7 ^ 3)%formula (var 3 * var 5 - var 2 * var 6)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). apply (differential_factor_nonzero K l r R roots Q (firstn 2 atoms) known N (num 4 * (var 3 * var 5 - var 2 * var 6) ^ 2)%formula (num 4 * var 3 ^ 2 + num 4 * var 6 ^ 2)%formula (num 0 - num 2 * var 2 * var 3 - num 2 * var 5 * var 6)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | apply (unit_nonzero K l r R roots Q (firstn 2 atoms) known N); vm_cast_no_check (eq_refl true)]. }
  clear N. rename N3 into N.
  assert (E : map (value K l) (evolute_by_frenet c : list expr)%formula = map (value K l) (evolute c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
