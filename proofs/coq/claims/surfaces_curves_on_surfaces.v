(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S8, ours. *)
Theorem S8_speed_squared_first_form : every_curve_on_a_surface (fun K c =>
  chen_riesenfeld_cohen_2007.speed_squared c = first_form c).
Proof.
  apply curve_on_a_surface_by_position; intros K u_ v_ x_ y_ z_ w_ C Fx Fy Fz Fw Hw.
  pose (l := jets time 1 u_ ++ jets time 1 v_ ++ partials 1 x_ ++ partials 1 y_ ++ partials 1 z_ ++ partials 1 w_).
  pose (r := of_three_parameters (grid 5 1 0 ++ grid 8 1 0 ++ grid 11 1 0 ++ grid 14 1 0) (grid 5 1 1 ++ grid 8 1 1 ++ grid 11 1 1 ++ grid 14 1 1) (chain 1 1 ++ chain 3 1 ++ chained 5 1 2 4 ++ chained 8 1 2 4 ++ chained 11 1 2 4 ++ chained 14 1 2 4)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Path (Patch (homogeneous time [var 5; var 8; var 11] (var 14) [])) [var 1; var 3]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (chen_riesenfeld_cohen_2007.speed_squared c : expr)%formula = value K l (first_form c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S8, ours. *)
Theorem S8_acceleration_on_normal_second_form : every_curve_on_a_surface (fun K c =>
  acceleration_on_normal c = second_form c).
Proof.
  apply curve_on_a_surface_by_position; intros K u_ v_ x_ y_ z_ w_ C Fx Fy Fz Fw Hw.
  pose (l := jets time 2 u_ ++ jets time 2 v_ ++ partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_three_parameters (grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0 ++ grid 25 2 0) (grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1 ++ grid 25 2 1) (chain 1 2 ++ chain 4 2 ++ chained 7 2 2 5 ++ chained 13 2 2 5 ++ chained 19 2 2 5 ++ chained 25 2 2 5)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Path (Patch (homogeneous time [var 7; var 13; var 19] (var 25) [])) [var 1; var 4]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (acceleration_on_normal c : expr)%formula = value K l (second_form c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S8, ours. *)
Theorem S8_second_form_lifted_second_form : every_curve_on_a_surface (fun K c =>
  second_form_lifted c = w c ^ 4 * second_form c).
Proof.
  apply curve_on_a_surface_by_position; intros K u_ v_ x_ y_ z_ w_ C Fx Fy Fz Fw Hw.
  pose (l := jets time 2 u_ ++ jets time 2 v_ ++ partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_three_parameters (grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0 ++ grid 25 2 0) (grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1 ++ grid 25 2 1) (chain 1 2 ++ chain 4 2 ++ chained 7 2 2 5 ++ chained 13 2 2 5 ++ chained 19 2 2 5 ++ chained 25 2 2 5)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Path (Patch (homogeneous time [var 7; var 13; var 19] (var 25) [])) [var 1; var 4]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (second_form_lifted c : expr)%formula = value K l (w c ^ 4 * second_form c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S8, ours. *)
Theorem S8_turning_of_normal_line_form : every_curve_on_a_surface (fun K c =>
  turning_of_normal c = line_form c).
Proof.
  apply curve_on_a_surface_by_position; intros K u_ v_ x_ y_ z_ w_ C Fx Fy Fz Fw Hw.
  pose (l := jets time 2 u_ ++ jets time 2 v_ ++ partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_three_parameters (grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0 ++ grid 25 2 0) (grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1 ++ grid 25 2 1) (chain 1 2 ++ chain 4 2 ++ chained 7 2 2 5 ++ chained 13 2 2 5 ++ chained 19 2 2 5 ++ chained 25 2 2 5)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Path (Patch (homogeneous time [var 7; var 13; var 19] (var 25) [])) [var 1; var 4]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (turning_of_normal c : expr)%formula = value K l (line_form c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S8, ours. *)
Theorem S8_space_curvature_squared_curvature_from_surface : every_curve_on_a_surface (fun K c =>
  chen_riesenfeld_cohen_2007.speed_squared c ^ 3 <> zero K ->
  first_form c ^ 2 * area_squared c <> zero K ->
  first_form c ^ 3 * area_squared c <> zero K ->
  chen_riesenfeld_cohen_2007.space_curvature_squared c = curvature_from_surface c).
Proof.
  apply curve_on_a_surface_by_position; intros K u_ v_ x_ y_ z_ w_ C Fx Fy Fz Fw Hw D1 D2 D3.
  pose (l := jets time 2 u_ ++ jets time 2 v_ ++ partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_three_parameters (grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0 ++ grid 25 2 0) (grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1 ++ grid 25 2 1) (chain 1 2 ++ chain 4 2 ++ chained 7 2 2 5 ++ chained 13 2 2 5 ++ chained 19 2 2 5 ++ chained 25 2 2 5)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Path (Patch (homogeneous time [var 7; var 13; var 19] (var 25) [])) [var 1; var 4]).
  pose (atoms := [chen_riesenfeld_cohen_2007.speed_squared c ^ 3; first_form c ^ 2 * area_squared c; first_form c ^ 3 * area_squared c]%formula : list expr).
  pose (known := [([1], []); ([0; 1], []); ([0; 0; 1], [])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). vm_cast_no_check D1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). vm_cast_no_check D2. }
  clear N. rename N2 into N.
  assert (N3 : all_nonzero K l (firstn 3 atoms)).
  { apply (and_nonzero K l (firstn 2 atoms) (nth 2 atoms (num 0)) N). vm_cast_no_check D3. }
  clear N. rename N3 into N.
  pose (a := vder time (gamma c)).
  pose (b := vders time 2 (gamma c)).
  assert (O : value K l (dot a (normal c)) = value K l (num 0)).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (F : value K l (dot a a) = value K l (first_form c : expr)).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (S : value K l (dot b (normal c)) = value K l (second_form c : expr)).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  assert (A : value K l (dot (normal c) (normal c)) = value K l (area_squared c : expr)).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  pose (x := fun (v : list expr) i => value K l (component i v)).
  vm_cast_no_check (curvature_by_the_normal K (x a 0) (x a 1) (x a 2) (x b 0) (x b 1) (x b 2)
    (x (normal c) 0) (x (normal c) 1) (x (normal c) 2) _ _ _ O F S A D2).
Qed.

(** S8, ours. *)
Theorem S8_geodesic_determinant_geodesic_determinant_of_first_form : every_curve_on_a_surface (fun K c =>
  number 2 <> zero K ->
  geodesic_determinant c = geodesic_determinant_of_first_form c).
Proof.
  apply curve_on_a_surface_by_position; intros K u_ v_ x_ y_ z_ w_ C Fx Fy Fz Fw Hw P2.
  pose (l := jets time 2 u_ ++ jets time 2 v_ ++ partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_three_parameters (grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0 ++ grid 25 2 0) (grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1 ++ grid 25 2 1) (chain 1 2 ++ chain 4 2 ++ chained 7 2 2 5 ++ chained 13 2 2 5 ++ chained 19 2 2 5 ++ chained 25 2 2 5)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Path (Patch (homogeneous time [var 7; var 13; var 19] (var 25) [])) [var 1; var 4]).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : value K l (geodesic_determinant c : expr)%formula = value K l (geodesic_determinant_of_first_form c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
