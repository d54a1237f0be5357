(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S13, ours. *)
Theorem S13_second_form_of_asymptotic : every_two_forms (fun K c =>
  second_form_of_asymptotic c = [zero K; zero K]).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C.
  pose (l := partials 0 E_ ++ partials 0 F_ ++ partials 0 G_ ++ partials 0 L_ ++ partials 0 M_ ++ partials 0 N_ ++ partials 0 w_).
  pose (r := of_parameters (grid 1 0 0 ++ grid 2 0 0 ++ grid 3 0 0 ++ grid 4 0 0 ++ grid 5 0 0 ++ grid 6 0 0 ++ grid 7 0 0) (grid 1 0 1 ++ grid 2 0 1 ++ grid 3 0 1 ++ grid 4 0 1 ++ grid 5 0 1 ++ grid 6 0 1 ++ grid 7 0 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 7) []) [var 1; var 2; var 3; var 4; var 5; var 6]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (second_form_of_asymptotic c : list expr)%formula = map (value K l) ([num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_second_form_of_other_asymptotic : every_two_forms (fun K c =>
  second_form_of_other_asymptotic c = [zero K; zero K]).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C.
  pose (l := partials 0 E_ ++ partials 0 F_ ++ partials 0 G_ ++ partials 0 L_ ++ partials 0 M_ ++ partials 0 N_ ++ partials 0 w_).
  pose (r := of_parameters (grid 1 0 0 ++ grid 2 0 0 ++ grid 3 0 0 ++ grid 4 0 0 ++ grid 5 0 0 ++ grid 6 0 0 ++ grid 7 0 0) (grid 1 0 1 ++ grid 2 0 1 ++ grid 3 0 1 ++ grid 4 0 1 ++ grid 5 0 1 ++ grid 6 0 1 ++ grid 7 0 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 7) []) [var 1; var 2; var 3; var 4; var 5; var 6]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (second_form_of_other_asymptotic c : list expr)%formula = map (value K l) ([num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_asymptotic_charts : every_two_forms (fun K c =>
  asymptotic_charts c = [zero K; zero K]).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C.
  pose (l := partials 0 E_ ++ partials 0 F_ ++ partials 0 G_ ++ partials 0 L_ ++ partials 0 M_ ++ partials 0 N_ ++ partials 0 w_).
  pose (r := of_parameters (grid 1 0 0 ++ grid 2 0 0 ++ grid 3 0 0 ++ grid 4 0 0 ++ grid 5 0 0 ++ grid 6 0 0 ++ grid 7 0 0) (grid 1 0 1 ++ grid 2 0 1 ++ grid 3 0 1 ++ grid 4 0 1 ++ grid 5 0 1 ++ grid 6 0 1 ++ grid 7 0 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 7) []) [var 1; var 2; var 3; var 4; var 5; var 6]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (asymptotic_charts c : list expr)%formula = map (value K l) ([num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_asymptotic_pair_squared_asymptotic_pair_by_parabolic : every_two_forms (fun K c =>
  asymptotic_pair_squared c = asymptotic_pair_by_parabolic c).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C.
  pose (l := partials 0 E_ ++ partials 0 F_ ++ partials 0 G_ ++ partials 0 L_ ++ partials 0 M_ ++ partials 0 N_ ++ partials 0 w_).
  pose (r := of_parameters (grid 1 0 0 ++ grid 2 0 0 ++ grid 3 0 0 ++ grid 4 0 0 ++ grid 5 0 0 ++ grid 6 0 0 ++ grid 7 0 0) (grid 1 0 1 ++ grid 2 0 1 ++ grid 3 0 1 ++ grid 4 0 1 ++ grid 5 0 1 ++ grid 6 0 1 ++ grid 7 0 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 7) []) [var 1; var 2; var 3; var 4; var 5; var 6]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (asymptotic_pair_squared c : expr)%formula = value K l (asymptotic_pair_by_parabolic c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_second_form_times_L_second_form_as_squares : every_curve_on_a_surface (fun K c =>
  second_form_times_L c = second_form_as_squares c).
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
  assert (E : value K l (second_form_times_L c : expr)%formula = value K l (second_form_as_squares c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_L_bending_of_u_line : every_surface (fun K c =>
  L c = bending_of_u_line c).
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
  assert (E : value K l (L c : expr)%formula = value K l (bending_of_u_line c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_N_bending_of_v_line : every_surface (fun K c =>
  N_ c = bending_of_v_line c).
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
  assert (E : value K l (N_ c : expr)%formula = value K l (bending_of_v_line c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_bending_off_surface_second_form_times_speed : every_curve_on_a_surface (fun K c =>
  bending_off_surface c = second_form_times_speed c).
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
  assert (E : value K l (bending_off_surface c : expr)%formula = value K l (second_form_times_speed c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_first_form_lifted_first_form : every_curve_on_a_surface (fun K c =>
  first_form_lifted c = w c ^ 4 * first_form c).
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
  assert (E : value K l (first_form_lifted c : expr)%formula = value K l (w c ^ 4 * first_form c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_second_form_lifted_second_form_of_lifted : every_curve_on_a_surface (fun K c =>
  second_form_lifted c = second_form_of_lifted c).
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
  assert (E : value K l (second_form_lifted c : expr)%formula = value K l (second_form_of_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S13, ours. *)
Theorem S13_normal_curvature_squared_normal_curvature_squared_lifted : every_curve_on_a_surface (fun K c =>
  first_form c ^ 2 * area_squared c <> zero K ->
  first_form_lifted c ^ 2 * area_squared_lifted c <> zero K ->
  normal_curvature_squared c = normal_curvature_squared_lifted c).
Proof.
  apply curve_on_a_surface_by_position; intros K u_ v_ x_ y_ z_ w_ C Fx Fy Fz Fw Hw D1 D2.
  pose (l := jets time 2 u_ ++ jets time 2 v_ ++ partials 2 x_ ++ partials 2 y_ ++ partials 2 z_ ++ partials 2 w_).
  pose (r := of_three_parameters (grid 7 2 0 ++ grid 13 2 0 ++ grid 19 2 0 ++ grid 25 2 0) (grid 7 2 1 ++ grid 13 2 1 ++ grid 19 2 1 ++ grid 25 2 1) (chain 1 2 ++ chain 4 2 ++ chained 7 2 2 5 ++ chained 13 2 2 5 ++ chained 19 2 2 5 ++ chained 25 2 2 5)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Path (Patch (homogeneous time [var 7; var 13; var 19] (var 25) [])) [var 1; var 4]).
  pose (atoms := [first_form c ^ 2 * area_squared c; first_form_lifted c ^ 2 * area_squared_lifted c]%formula : list expr).
  pose (known := [([1], []); ([0; 1], [])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). vm_cast_no_check D1. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). vm_cast_no_check D2. }
  clear N. rename N2 into N.
  assert (E : value K l (normal_curvature_squared c : expr)%formula = value K l (normal_curvature_squared_lifted c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
