(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S3, ours. *)
Theorem S3_parabolic_parabolic_lifted : every_surface (fun K c =>
  parabolic c = number 1 / w c ^ 8 * parabolic_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := [var 19]%formula : list expr).
  pose (known := [([8], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (parabolic c : expr)%formula = value K l (number 1 / w c ^ 8 * parabolic_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S3, ours. *)
Theorem S3_gaussian_curvature_gaussian_curvature_lifted : every_surface (fun K c =>
  area_squared_lifted c <> zero K ->
  gaussian_curvature c = gaussian_curvature_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw H1.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := [var 3 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 3 ^ 2 * var 14 ^ 2 + var 9 ^ 2 * var 14 ^ 2 - num 2 * var 2 * var 3 * var 14 * var 15 - num 2 * var 8 * var 9 * var 14 * var 15 + var 2 ^ 2 * var 15 ^ 2 + var 8 ^ 2 * var 15 ^ 2; var 19]%formula : list expr).
  pose (known := [([2], [0]); ([2; 12], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (area_squared_lifted c : expr)%formula (var 19 ^ 6)%formula (var 3 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 3 ^ 2 * var 14 ^ 2 + var 9 ^ 2 * var 14 ^ 2 - num 2 * var 2 * var 3 * var 14 * var 15 - num 2 * var 8 * var 9 * var 14 * var 15 + var 2 ^ 2 * var 15 ^ 2 + var 8 ^ 2 * var 15 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact Hw. }
  clear N. rename N2 into N.
  assert (E : value K l (gaussian_curvature c : expr)%formula = value K l (gaussian_curvature_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S3, ours. *)
Theorem S3_parabolic_brioschi : every_surface (fun K c =>
  number 2 <> zero K ->
  parabolic c = brioschi c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw P2.
  pose (l := partials 3 x_ ++ partials 3 y_ ++ partials 3 z_ ++ partials 3 w_).
  pose (r := of_parameters (grid 1 3 0 ++ grid 11 3 0 ++ grid 21 3 0 ++ grid 31 3 0) (grid 1 3 1 ++ grid 11 3 1 ++ grid 21 3 1 ++ grid 31 3 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 11; var 21] (var 31) [])).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : value K l (parabolic c : expr)%formula = value K l (brioschi c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S4, ours. *)
Theorem S4_minimality_minimality_lifted : every_surface (fun K c =>
  minimality c = number 1 / w c ^ 8 * minimality_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := [var 19]%formula : list expr).
  pose (known := [([8], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (minimality c : expr)%formula = value K l (number 1 / w c ^ 8 * minimality_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S4, ours. *)
Theorem S4_mean_curvature_squared_mean_curvature_squared_lifted : every_surface (fun K c =>
  area_squared_lifted c <> zero K ->
  number 2 <> zero K ->
  mean_curvature_squared c = mean_curvature_squared_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw H1 P2.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := [num 2; var 3 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 3 ^ 2 * var 14 ^ 2 + var 9 ^ 2 * var 14 ^ 2 - num 2 * var 2 * var 3 * var 14 * var 15 - num 2 * var 8 * var 9 * var 14 * var 15 + var 2 ^ 2 * var 15 ^ 2 + var 8 ^ 2 * var 15 ^ 2; var 19]%formula : list expr).
  pose (known := [([2; 3], [0; 0]); ([2; 3; 18], [0; 0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 1 atoms) known N (area_squared_lifted c : expr)%formula (var 19 ^ 6)%formula (var 3 ^ 2 * var 8 ^ 2 - num 2 * var 2 * var 3 * var 8 * var 9 + var 2 ^ 2 * var 9 ^ 2 + var 3 ^ 2 * var 14 ^ 2 + var 9 ^ 2 * var 14 ^ 2 - num 2 * var 2 * var 3 * var 14 * var 15 - num 2 * var 8 * var 9 * var 14 * var 15 + var 2 ^ 2 * var 15 ^ 2 + var 8 ^ 2 * var 15 ^ 2)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check H1]. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). exact Hw. }
  clear N. rename N3 into N.
  assert (E : value K l (mean_curvature_squared c : expr)%formula = value K l (mean_curvature_squared_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S4, ours. *)
Theorem S4_minimality_of_spheres_minimality_lifted : every_surface (fun K c =>
  minimality_of_spheres c = number (-1) * w c ^ 4 * minimality_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (minimality_of_spheres c : expr)%formula = value K l (number (-1) * w c ^ 4 * minimality_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
