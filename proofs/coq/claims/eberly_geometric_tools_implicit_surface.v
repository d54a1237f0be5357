(** Geometric Tools: curves and implicit surfaces: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require chen_riesenfeld_cohen_2007.
From ExactSpline.formulas Require Import eberly_geometric_tools.
Import ListNotations.
Local Open Scope formula_scope.

(** GT4a, ImplicitSurface3.h. *)
Theorem GT4a_mean_in_the_code_mean_in_the_comment : every_implicit_surface (fun K c =>
  mean_in_the_code c = mean_in_the_comment c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (mean_in_the_code c : expr)%formula = value K l (mean_in_the_comment c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4b, ImplicitSurface3.h. *)
Theorem GT4b_gauss_in_the_code_gauss_in_the_comment : every_implicit_surface (fun K c =>
  gauss_in_the_code c = gauss_in_the_comment c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (gauss_in_the_code c : expr)%formula = value K l (gauss_in_the_comment c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4c, ImplicitSurface3.h. *)
Theorem GT4c_adjugate_1_minors_1 : every_implicit_surface (fun K c =>
  adjugate_1 c = minors_1 c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (adjugate_1 c : list expr)%formula = map (value K l) (minors_1 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4c, ImplicitSurface3.h. *)
Theorem GT4c_adjugate_2_minors_2 : every_implicit_surface (fun K c =>
  adjugate_2 c = minors_2 c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (adjugate_2 c : list expr)%formula = map (value K l) (minors_2 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4c, ImplicitSurface3.h. *)
Theorem GT4c_adjugate_3_minors_3 : every_implicit_surface (fun K c =>
  adjugate_3 c = minors_3 c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (adjugate_3 c : list expr)%formula = map (value K l) (minors_3 c : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4d, ImplicitSurface3.h. *)
Theorem GT4d_height_over_the_surface_form_along : every_implicit_surface (fun K c =>
  height_over_the_surface c = form_along c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 2 cutx_ ++ jets s 2 cuty_ ++ jets s 2 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 2 ++ chain 4 2 ++ chain 7 2 ++ [(10%positive, (var 14 * var 7 - var 15 * var 4)); (11%positive, (var 15 * var 1 - var 13 * var 7)); (12%positive, (var 13 * var 4 - var 14 * var 1)); (13%positive, var 16 * (var 14 * var 7 - var 15 * var 4) + var 17 * (var 15 * var 1 - var 13 * var 7) + var 18 * (var 13 * var 4 - var 14 * var 1)); (14%positive, var 17 * (var 14 * var 7 - var 15 * var 4) + var 19 * (var 15 * var 1 - var 13 * var 7) + var 20 * (var 13 * var 4 - var 14 * var 1)); (15%positive, var 18 * (var 14 * var 7 - var 15 * var 4) + var 20 * (var 15 * var 1 - var 13 * var 7) + var 21 * (var 13 * var 4 - var 14 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 10; var 11; var 12] (number 1) []) [var 1; var 4; var 7] [var 13; var 14; var 15] [[var 16; var 17; var 18]; [var 17; var 19; var 20]; [var 18; var 20; var 21]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (height_over_the_surface c : expr)%formula = value K l (form_along c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4e, ImplicitSurface3.h. *)
Theorem GT4e_sum_of_the_form_mean_in_the_comment : every_implicit_surface (fun K c =>
  sum_of_the_form c = chen_riesenfeld_cohen_2007.speed_squared c * mean_in_the_comment c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 1 cutx_ ++ jets s 1 cuty_ ++ jets s 1 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ [(7%positive, (var 11 * var 5 - var 12 * var 3)); (8%positive, (var 12 * var 1 - var 10 * var 5)); (9%positive, (var 10 * var 3 - var 11 * var 1)); (10%positive, var 13 * (var 11 * var 5 - var 12 * var 3) + var 14 * (var 12 * var 1 - var 10 * var 5) + var 15 * (var 10 * var 3 - var 11 * var 1)); (11%positive, var 14 * (var 11 * var 5 - var 12 * var 3) + var 16 * (var 12 * var 1 - var 10 * var 5) + var 17 * (var 10 * var 3 - var 11 * var 1)); (12%positive, var 15 * (var 11 * var 5 - var 12 * var 3) + var 17 * (var 12 * var 1 - var 10 * var 5) + var 18 * (var 10 * var 3 - var 11 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 7; var 8; var 9] (number 1) []) [var 1; var 3; var 5] [var 10; var 11; var 12] [[var 13; var 14; var 15]; [var 14; var 16; var 17]; [var 15; var 17; var 18]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (sum_of_the_form c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.speed_squared c * mean_in_the_comment c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4f, ImplicitSurface3.h. *)
Theorem GT4f_determinant_of_the_form_gauss_in_the_comment : every_implicit_surface (fun K c =>
  determinant_of_the_form c = chen_riesenfeld_cohen_2007.speed_squared c ^ 2 * gauss_in_the_comment c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 1 cutx_ ++ jets s 1 cuty_ ++ jets s 1 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 1 ++ chain 3 1 ++ chain 5 1 ++ [(7%positive, (var 11 * var 5 - var 12 * var 3)); (8%positive, (var 12 * var 1 - var 10 * var 5)); (9%positive, (var 10 * var 3 - var 11 * var 1)); (10%positive, var 13 * (var 11 * var 5 - var 12 * var 3) + var 14 * (var 12 * var 1 - var 10 * var 5) + var 15 * (var 10 * var 3 - var 11 * var 1)); (11%positive, var 14 * (var 11 * var 5 - var 12 * var 3) + var 16 * (var 12 * var 1 - var 10 * var 5) + var 17 * (var 10 * var 3 - var 11 * var 1)); (12%positive, var 15 * (var 11 * var 5 - var 12 * var 3) + var 17 * (var 12 * var 1 - var 10 * var 5) + var 18 * (var 10 * var 3 - var 11 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 7; var 8; var 9] (number 1) []) [var 1; var 3; var 5] [var 10; var 11; var 12] [[var 13; var 14; var 15]; [var 14; var 16; var 17]; [var 15; var 17; var 18]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (determinant_of_the_form c : expr)%formula = value K l (chen_riesenfeld_cohen_2007.speed_squared c ^ 2 * gauss_in_the_comment c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4g, ImplicitSurface3.h. *)
Theorem GT4g_gradient_on_shape : every_implicit_surface (fun K c =>
  gradient_on_shape c = [zero K; zero K; zero K]).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : map (value K l) (gradient_on_shape c : list expr)%formula = map (value K l) ([num 0; num 0; num 0] : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4h, ImplicitSurface3.h. *)
Theorem GT4h_trace_of_shape_mean_in_the_code : every_implicit_surface (fun K c =>
  trace_of_shape c = number (-1) * mean_in_the_code c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (trace_of_shape c : expr)%formula = value K l (number (-1) * mean_in_the_code c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** GT4i, ImplicitSurface3.h. *)
Theorem GT4i_minors_of_shape_gauss_in_the_code : every_implicit_surface (fun K c =>
  minors_of_shape c = length_squared c * gauss_in_the_code c).
Proof.
  apply implicit_surface_by_position; intros K x_ y_ z_ cutx_ cuty_ cutz_ fx_ fy_ fz_ fxx_ fxy_ fxz_ fyy_ fyz_ fzz_ dx_ dy_ dz_ Hx Hy Hz Hfx Hfy Hfz.
  pose (l := jets s 0 cutx_ ++ jets s 0 cuty_ ++ jets s 0 cutz_ ++ [x_; y_; z_; fx_; fy_; fz_; fxx_; fxy_; fxz_; fyy_; fyz_; fzz_]).
  pose (r := of_parameters (chain 1 0 ++ chain 2 0 ++ chain 3 0 ++ [(4%positive, (var 8 * var 3 - var 9 * var 2)); (5%positive, (var 9 * var 1 - var 7 * var 3)); (6%positive, (var 7 * var 2 - var 8 * var 1)); (7%positive, var 10 * (var 8 * var 3 - var 9 * var 2) + var 11 * (var 9 * var 1 - var 7 * var 3) + var 12 * (var 7 * var 2 - var 8 * var 1)); (8%positive, var 11 * (var 8 * var 3 - var 9 * var 2) + var 13 * (var 9 * var 1 - var 7 * var 3) + var 14 * (var 7 * var 2 - var 8 * var 1)); (9%positive, var 12 * (var 8 * var 3 - var 9 * var 2) + var 14 * (var 9 * var 1 - var 7 * var 3) + var 15 * (var 7 * var 2 - var 8 * var 1))]%formula) ([])).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Implicit (homogeneous s [var 4; var 5; var 6] (number 1) []) [var 1; var 2; var 3] [var 7; var 8; var 9] [[var 10; var 11; var 12]; [var 11; var 13; var 14]; [var 12; var 14; var 15]]).
  pose (atoms := []%formula : list expr).
  pose (known := [] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (E : value K l (minors_of_shape c : expr)%formula = value K l (length_squared c * gauss_in_the_code c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
