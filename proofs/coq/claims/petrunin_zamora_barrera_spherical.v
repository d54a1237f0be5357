(** What is differential geometry: curves and surfaces: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import petrunin_zamora_barrera.
Import ListNotations.
Local Open Scope formula_scope.

(** PZ4a, ch. Torsion. *)
Theorem PZ4a_spherical_distance : every_plane_curve (fun K c =>
  (dot (p c) (p c) + w c ^ 2) <> zero K ->
  spherical_distance c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw D1.
  pose (l := jets s 0 x_ ++ jets s 0 y_ ++ jets s 0 w_).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 2] (var 3) []).
  pose (atoms := [var 1 ^ 2 + var 2 ^ 2 + num 1; var 3]%formula : list expr).
  pose (known := [([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (p c) (p c) + w c ^ 2 : expr)%formula (var 3 ^ 2)%formula (var 1 ^ 2 + var 2 ^ 2 + num 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (spherical_distance c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ4b, ch. Torsion. *)
Theorem PZ4b_spherical_tangent_on_radius : every_plane_curve (fun K c =>
  (dot (p c) (p c) + w c ^ 2) <> zero K ->
  spherical_tangent_on_radius c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw D1.
  pose (l := jets s 1 x_ ++ jets s 1 y_ ++ jets s 1 w_).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 3] (var 5) []).
  pose (atoms := [var 1 ^ 2 + var 3 ^ 2 + num 1; var 5]%formula : list expr).
  pose (known := [([1; 2], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (p c) (p c) + w c ^ 2 : expr)%formula (var 5 ^ 2)%formula (var 1 ^ 2 + var 3 ^ 2 + num 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (spherical_tangent_on_radius c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ4c, ch. Torsion. *)
Theorem PZ4c_spherical_frame_sum : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  (dot (p c) (p c) + w c ^ 2) <> zero K ->
  spherical_frame_sum c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2 D1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 1 ^ 2 + var 4 ^ 2 + num 1; var 7; num 2; var 2 ^ 2 + var 5 ^ 2]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([0; 0; 4; 2], [4; 0; 0; 0]); ([0; 0; 2; 1], [2; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (p c) (p c) + w c ^ 2 : expr)%formula (var 7 ^ 2)%formula (var 1 ^ 2 + var 4 ^ 2 + num 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact P2. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : value K l (spherical_frame_sum c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** PZ4d, ch. Torsion. *)
Theorem PZ4d_spherical_normal_on_radius : every_plane_curve (fun K c =>
  chen_riesenfeld_cohen_2007.D1_squared c <> zero K ->
  number 2 <> zero K ->
  (dot (p c) (p c) + w c ^ 2) <> zero K ->
  spherical_normal_on_radius c = zero K).
Proof.
  apply plane_by_position; intros K x_ y_ w_ Hw H1 P2 D1.
  pose (l := jets s 2 x_ ++ jets s 2 y_ ++ jets s 2 w_).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := homogeneous s [var 1; var 4] (var 7) []).
  pose (atoms := [var 1 ^ 2 + var 4 ^ 2 + num 1; var 7; num 2; var 2 ^ 2 + var 5 ^ 2]%formula : list expr).
  pose (known := [([1; 2], [0; 0]); ([0; 0; 4; 2], [4; 0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (dot (p c) (p c) + w c ^ 2 : expr)%formula (var 7 ^ 2)%formula (var 1 ^ 2 + var 4 ^ 2 + num 1)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact P2. }
  clear N. rename N3 into N.
  assert (N4 : all_nonzero K l (firstn 4 atoms)).
  { apply (and_nonzero K l (firstn 3 atoms) (nth 3 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 3 atoms) known N (chen_riesenfeld_cohen_2007.D1_squared c : expr)%formula (var 7 ^ 4)%formula (var 2 ^ 2 + var 5 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N4 into N.
  assert (E : value K l (spherical_normal_on_radius c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
