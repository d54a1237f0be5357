(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S14, ours. *)
Theorem S14_gaussian_of_forms_by_u_change_of_forms_by_u : every_two_forms (fun K c =>
  area_of_forms c ^ 2 <> zero K ->
  gaussian_of_forms_by_u c = number 1 / area_of_forms c ^ 3 * change_of_forms_by_u c).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C D1.
  pose (l := partials 1 E_ ++ partials 1 F_ ++ partials 1 G_ ++ partials 1 L_ ++ partials 1 M_ ++ partials 1 N_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0 ++ grid 13 1 0 ++ grid 16 1 0 ++ grid 19 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1 ++ grid 13 1 1 ++ grid 16 1 1 ++ grid 19 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 19) []) [var 1; var 4; var 7; var 10; var 13; var 16]).
  pose (atoms := [var 4 ^ 2 - var 1 * var 7]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (area_of_forms c ^ 2 : expr)%formula (var 4 ^ 2 - var 1 * var 7)%formula (var 4 ^ 2 - var 1 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (E : value K l (gaussian_of_forms_by_u c : expr)%formula = value K l (number 1 / area_of_forms c ^ 3 * change_of_forms_by_u c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S14, ours. *)
Theorem S14_gaussian_weighted_by_u_change_weighted_by_u : every_two_forms (fun K c =>
  area_of_forms c ^ 2 <> zero K ->
  gaussian_weighted_by_u c = w c ^ 3 / area_of_forms c ^ 3 * change_weighted_by_u c).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C D1.
  pose (l := partials 1 E_ ++ partials 1 F_ ++ partials 1 G_ ++ partials 1 L_ ++ partials 1 M_ ++ partials 1 N_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0 ++ grid 13 1 0 ++ grid 16 1 0 ++ grid 19 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1 ++ grid 13 1 1 ++ grid 16 1 1 ++ grid 19 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 19) []) [var 1; var 4; var 7; var 10; var 13; var 16]).
  pose (atoms := [var 4 ^ 2 - var 1 * var 7]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (area_of_forms c ^ 2 : expr)%formula (var 4 ^ 2 - var 1 * var 7)%formula (var 4 ^ 2 - var 1 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (E : value K l (gaussian_weighted_by_u c : expr)%formula = value K l (w c ^ 3 / area_of_forms c ^ 3 * change_weighted_by_u c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S14, ours. *)
Theorem S14_gaussian_of_forms_by_v_change_of_forms_by_v : every_two_forms (fun K c =>
  area_of_forms c ^ 2 <> zero K ->
  gaussian_of_forms_by_v c = number 1 / area_of_forms c ^ 3 * change_of_forms_by_v c).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C D1.
  pose (l := partials 1 E_ ++ partials 1 F_ ++ partials 1 G_ ++ partials 1 L_ ++ partials 1 M_ ++ partials 1 N_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0 ++ grid 13 1 0 ++ grid 16 1 0 ++ grid 19 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1 ++ grid 13 1 1 ++ grid 16 1 1 ++ grid 19 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 19) []) [var 1; var 4; var 7; var 10; var 13; var 16]).
  pose (atoms := [var 4 ^ 2 - var 1 * var 7]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (area_of_forms c ^ 2 : expr)%formula (var 4 ^ 2 - var 1 * var 7)%formula (var 4 ^ 2 - var 1 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (E : value K l (gaussian_of_forms_by_v c : expr)%formula = value K l (number 1 / area_of_forms c ^ 3 * change_of_forms_by_v c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S14, ours. *)
Theorem S14_gaussian_weighted_by_v_change_weighted_by_v : every_two_forms (fun K c =>
  area_of_forms c ^ 2 <> zero K ->
  gaussian_weighted_by_v c = w c ^ 3 / area_of_forms c ^ 3 * change_weighted_by_v c).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C D1.
  pose (l := partials 1 E_ ++ partials 1 F_ ++ partials 1 G_ ++ partials 1 L_ ++ partials 1 M_ ++ partials 1 N_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0 ++ grid 13 1 0 ++ grid 16 1 0 ++ grid 19 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1 ++ grid 13 1 1 ++ grid 16 1 1 ++ grid 19 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 19) []) [var 1; var 4; var 7; var 10; var 13; var 16]).
  pose (atoms := [var 4 ^ 2 - var 1 * var 7]%formula : list expr).
  pose (known := [([2], [0]); ([3], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (area_of_forms c ^ 2 : expr)%formula (var 4 ^ 2 - var 1 * var 7)%formula (var 4 ^ 2 - var 1 * var 7)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (E : value K l (gaussian_weighted_by_v c : expr)%formula = value K l (w c ^ 3 / area_of_forms c ^ 3 * change_weighted_by_v c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
