(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S1, ours. *)
Theorem S1_E_E_reduced : every_surface (fun K c =>
  E_ c = number 1 / w c ^ 4 * E_reduced c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (E_ c : expr)%formula = value K l (number 1 / w c ^ 4 * E_reduced c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S1, ours. *)
Theorem S1_F_F_reduced : every_surface (fun K c =>
  F c = number 1 / w c ^ 4 * F_reduced c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (F c : expr)%formula = value K l (number 1 / w c ^ 4 * F_reduced c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S1, ours. *)
Theorem S1_G_G_reduced : every_surface (fun K c =>
  G c = number 1 / w c ^ 4 * G_reduced c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (G c : expr)%formula = value K l (number 1 / w c ^ 4 * G_reduced c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S1, ours. *)
Theorem S1_normal_normal_lifted_of_surface : every_surface (fun K c =>
  normal c = vmul (number 1 / w c ^ 3) (normal_lifted_of_surface c)).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : map (value K l) (normal c : list expr)%formula = map (value K l) (vmul (number 1 / w c ^ 3) (normal_lifted_of_surface c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S1, ours. *)
Theorem S1_normal_squared_area_squared : every_surface (fun K c =>
  normal_squared c = area_squared c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (normal_squared c : expr)%formula = value K l (area_squared c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S1, ours. *)
Theorem S1_area_squared_area_squared_lifted : every_surface (fun K c =>
  area_squared c = number 1 / w c ^ 6 * area_squared_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4; var 7] (var 10) [])).
  pose (atoms := [var 10]%formula : list expr).
  pose (known := [([6], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (area_squared c : expr)%formula = value K l (number 1 / w c ^ 6 * area_squared_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S2, ours. *)
Theorem S2_L_L_lifted : every_surface (fun K c =>
  L c = number 1 / w c ^ 4 * L_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := [var 19]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (L c : expr)%formula = value K l (number 1 / w c ^ 4 * L_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S2, ours. *)
Theorem S2_M_M_lifted : every_surface (fun K c =>
  M c = number 1 / w c ^ 4 * M_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := [var 19]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (M c : expr)%formula = value K l (number 1 / w c ^ 4 * M_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S2, ours. *)
Theorem S2_N_N_lifted : every_surface (fun K c =>
  N_ c = number 1 / w c ^ 4 * N_lifted c).
Proof.
  apply surface_by_position; intros K x_ y_ z_ w_ C Hw.
  pose (l := partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_parameters (grid 1 2 0 ++ grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0) (grid 1 2 1 ++ grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 7; var 13] (var 19) [])).
  pose (atoms := [var 19]%formula : list expr).
  pose (known := [([4], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (N_ c : expr)%formula = value K l (number 1 / w c ^ 4 * N_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S2, ours. *)
Theorem S2_jacobian_jacobian_lifted : every_planar_map (fun K c =>
  jacobian c = number 1 / w c ^ 3 * jacobian_lifted c).
Proof.
  apply planar_map_by_position; intros K x_ y_ w_ C Hw.
  pose (l := partials 1 x_ ++ partials 1 y_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Patch (homogeneous s [var 1; var 4] (var 7) [])).
  pose (atoms := [var 7]%formula : list expr).
  pose (known := [([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact Hw. }
  clear N. rename N1 into N.
  assert (E : value K l (jacobian c : expr)%formula = value K l (number 1 / w c ^ 3 * jacobian_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
