(** Rational surfaces: the open question of the paper: its claims.

    Written by [exactspline prove --emit-coq]; do not edit. *)

Require Import ZArith List.
From ExactSpline Require Import Base Reflection Proofs.
From ExactSpline.formulas Require Import surfaces.
Import ListNotations.
Local Open Scope formula_scope.

(** S5, ours. *)
Theorem S5_umbilicity_of_forms_line_discriminant_of_forms : every_two_forms (fun K c =>
  umbilicity_of_forms c = line_discriminant_of_forms c).
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
  assert (E : value K l (umbilicity_of_forms c : expr)%formula = value K l (line_discriminant_of_forms c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S5, ours. *)
Theorem S5_umbilicity_times_square_umbilicity_as_squares : every_two_forms (fun K c =>
  umbilicity_times_square c = umbilicity_as_squares c).
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
  assert (E : value K l (umbilicity_times_square c : expr)%formula = value K l (umbilicity_as_squares c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S6, ours. *)
Theorem S6_line_relation_of_forms : every_two_forms (fun K c =>
  line_relation_of_forms c = zero K).
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
  assert (E : value K l (line_relation_of_forms c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S6, ours. *)
Theorem S6_line_relation_of_second_form : every_two_forms (fun K c =>
  line_relation_of_second_form c = zero K).
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
  assert (E : value K l (line_relation_of_second_form c : expr)%formula = value K l (num 0 : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S9, ours. *)
Theorem S9_ridges_by_definition_ridges_of_forms : every_two_forms (fun K c =>
  number 2 <> zero K ->
  ridges_by_definition c = number 64 * line_uu_of_forms c * area_of_forms c ^ 2 * ridges_of_forms c).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C P2.
  pose (l := partials 1 E_ ++ partials 1 F_ ++ partials 1 G_ ++ partials 1 L_ ++ partials 1 M_ ++ partials 1 N_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0 ++ grid 13 1 0 ++ grid 16 1 0 ++ grid 19 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1 ++ grid 13 1 1 ++ grid 16 1 1 ++ grid 19 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 19) []) [var 1; var 4; var 7; var 10; var 13; var 16]).
  pose (atoms := [num 2]%formula : list expr).
  pose (known := [([1], [0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). exact P2. }
  clear N. rename N1 into N.
  assert (E : value K l (ridges_by_definition c : expr)%formula = value K l (number 64 * line_uu_of_forms c * area_of_forms c ^ 2 * ridges_of_forms c : expr)%formula).
  { apply (one_value K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.

(** S9, ours. *)
Theorem S9_ridge_cubic_over_weight_ridge_cubic_weighted : every_two_forms (fun K c =>
  number 2 <> zero K ->
  w c ^ 4 <> zero K ->
  ridge_cubic_over_weight c = vmul (number 1 / w c ^ 13) (ridge_cubic_weighted c)).
Proof.
  unfold every_two_forms; intros K E_ F_ G_ L_ M_ N_ w_ C P2 D1.
  pose (l := partials 1 E_ ++ partials 1 F_ ++ partials 1 G_ ++ partials 1 L_ ++ partials 1 M_ ++ partials 1 N_ ++ partials 1 w_).
  pose (r := of_parameters (grid 1 1 0 ++ grid 4 1 0 ++ grid 7 1 0 ++ grid 10 1 0 ++ grid 13 1 0 ++ grid 16 1 0 ++ grid 19 1 0) (grid 1 1 1 ++ grid 4 1 1 ++ grid 7 1 1 ++ grid 10 1 1 ++ grid 13 1 1 ++ grid 16 1 1 ++ grid 19 1 1)).
  assert (R : forall q, rules_hold K l q (r q)) by rules_by_computation.
  pose (roots := [] : list expr).
  assert (Q : roots_hold K l roots) by exact I.
  pose (c := Accompanied (rational_curve s [] (var 19) []) [var 1; var 4; var 7; var 10; var 13; var 16]).
  pose (atoms := [var 19; num 2]%formula : list expr).
  pose (known := [([4], [0]); ([0; 1], [0; 0]); ([13; 0], [0; 0])] : list (list nat * list nat)).
  assert (N : all_nonzero K l (firstn 0 atoms)) by apply Forall_nil.
  assert (N1 : all_nonzero K l (firstn 1 atoms)).
  { apply (and_nonzero K l (firstn 0 atoms) (nth 0 atoms (num 0)) N). apply (factor_nonzero K l r R roots Q (firstn 0 atoms) known N (w c ^ 4 : expr)%formula (var 19 ^ 3)%formula (var 19)%formula); [vm_cast_no_check (eq_refl true) | vm_cast_no_check D1]. }
  clear N. rename N1 into N.
  assert (N2 : all_nonzero K l (firstn 2 atoms)).
  { apply (and_nonzero K l (firstn 1 atoms) (nth 1 atoms (num 0)) N). exact P2. }
  clear N. rename N2 into N.
  assert (E : map (value K l) (ridge_cubic_over_weight c : list expr)%formula = map (value K l) (vmul (number 1 / w c ^ 13) (ridge_cubic_weighted c) : list expr)%formula).
  { apply (one_vector K l r R roots Q atoms known N). vm_cast_no_check (eq_refl true). }
  vm_cast_no_check E.
Qed.
